#include "contact/scaled_contacts.h"

#include "base/numbers.h"
#include "contact/friction_cone.h"

namespace thenar::internal {

void ScaledContacts::add_block(const ContactBlock& block, int start, double s) {
  const int rows = row_count(block.law);
  s_.segment(start, rows).setConstant(s);
  if (rows == 1) {
    const auto [lower, upper] = impulse_bounds(block);
    blocks_.push_back({start, 1, -1, lower / s, upper / s});
    return;
  }
  // One cone of the rows that friction can load; every other row is an interval.
  const double e = block.torsion_radius;
  int loaded = block.friction > 0 ? 3 : 1;
  if (rows == 4 && block.friction > 0 && e > 0) loaded = 4;
  if (loaded == 4) s_(start + 3) = s * e;
  if (loaded > 1)
    blocks_.push_back({start, loaded, block.friction, 0, 0});
  else
    blocks_.push_back({start, 1, -1, 0, kInfinity});
  for (int k = loaded; k < rows; ++k) blocks_.push_back({start + k, 1, -1, 0, 0});
}

void ScaledContacts::assign(const ContactProblem& problem) {
  // Grow the storage if needed.
  rows_ = problem.b.size();
  if (rows_ > b_.size()) {
    A_.resize(rows_, rows_);
    b_.resize(rows_);
    s_.resize(rows_);
  }
  // Set the blocks and the scales of their rows.
  blocks_.clear();
  int start = 0;
  const double minimum = min_diagonal(problem);
  for (const ContactBlock& block : problem.blocks) {
    add_block(block, start, block_scale(problem, block, start, minimum));
    start += row_count(block.law);
  }
  // Scale the problem: A = s W s and b' = s b.
  for (Eigen::Index j = 0; j < rows_; ++j)
    A_.col(j).head(rows_) = s_(j) * problem.W.col(j).cwiseProduct(s());
  b_.head(rows_) = problem.b.cwiseProduct(s());
  // Scale of the natural map: largest |s b| of rows that are not fixed, and |P(0) / s|.
  scale_ = 0;
  for (const ScaledBlock& block : blocks_) {
    if (block.is_cone()) {
      scale_ = std::max(scale_, b().segment(block.start, block.rows).lpNorm<Eigen::Infinity>());
      continue;
    }
    if (block.lower < block.upper) scale_ = std::max(scale_, std::abs(b_(block.start)));
    scale_ = std::max(scale_, std::abs(std::clamp(0.0, block.lower, block.upper)));
  }
}

double ScaledContacts::residual(const Eigen::Ref<const Eigen::VectorXd>& f,
                                const Eigen::Ref<const Eigen::VectorXd>& u) const {
  double out = 0;
  for (const ScaledBlock& block : blocks_) {
    const int i = block.start;
    // Natural map of the block; NaN counts as infinite.
    double entry = 0;
    if (block.rows == 1)
      entry = std::abs(interval_natural_map(f(i), u(i), block.lower, block.upper));
    else if (block.rows == 3)
      entry =
          cone_natural_map<3>(f.segment<3>(i), u.segment<3>(i), block.mu).lpNorm<Eigen::Infinity>();
    else
      entry =
          cone_natural_map<4>(f.segment<4>(i), u.segment<4>(i), block.mu).lpNorm<Eigen::Infinity>();
    out = entry >= out ? entry : std::isnan(entry) ? kInfinity : out;
  }
  return out > 0 ? out / scale_ : 0;
}

double ScaledContacts::rounding(const Eigen::Ref<const Eigen::VectorXd>& f) const {
  const double sum = f.cwiseAbs().dot(A().diagonal().cwiseMax(0).cwiseSqrt());
  return std::min(kRoundingUnits * std::numeric_limits<double>::epsilon() * sum / scale_,
                  kMaxRounding);
}

}  // namespace thenar::internal
