#include "contact/contact_problem.h"

#include <cmath>

#include "base/error.h"
#include "contact/friction_cone.h"

namespace thenar {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using Row = Eigen::Ref<const VectorXd>;

// Largest difference of mirrored entries of W, over its largest entry [1]
constexpr double kSymmetryError = 1e-9;
// Smallest mean diagonal of a mobile block, over the largest diagonal entry of W [1]
constexpr double kMinDiagonalRatio = 1e-16;

/// Checks the numbers of a block. @return the block
ContactBlock checked(const ContactBlock& block) {
  require(block.law != ConstraintLaw::kBox || block.lower <= block.upper,
          "bounds of a box must be in order, got {} to {}", block.lower, block.upper);
  require(block.law != ConstraintLaw::kBox || (block.lower < kInfinity && block.upper > -kInfinity),
          "a box must hold a finite impulse, got {} to {}", block.lower, block.upper);
  require(block.friction >= 0 && block.friction < kInfinity, "friction must be >= 0, got {}",
          block.friction);
  require(block.torsion_radius >= 0 && block.torsion_radius < kInfinity,
          "a torsion radius must be >= 0, got {} m", block.torsion_radius);
  return block;
}

/// Adds the row of an interval to the residual.
void add_interval(double lower, double upper, double f, double u, ContactResidual* out) {
  out->outside = std::max({out->outside, lower - f, f - upper});
  if (lower == -kInfinity && upper == kInfinity) {
    out->bilateral = std::max(out->bilateral, std::abs(u));
    return;
  }
  if (upper == kInfinity) out->approach = std::max(out->approach, -u);
  // Bound at which the impulse would be complementary to u.
  const double bound = u > 0 ? lower : upper;
  if (std::isfinite(bound)) out->complementarity = std::max(out->complementarity, u * (f - bound));
}

/// Adds the rows of a contact to the residual; torsion is scaled to the units of the tangents,
/// torque / e and e spin.
template <int Rows>
void add_cone(const Eigen::Matrix<double, Rows, 1>& f, const Eigen::Matrix<double, Rows, 1>& u,
              double mu, ContactResidual* out) {
  const auto ft = f.template tail<Rows - 1>(), ut = u.template tail<Rows - 1>();
  out->outside = std::max({out->outside, ft.norm() - mu * f(0), -f(0)});
  out->approach = std::max(out->approach, -u(0));
  out->complementarity = std::max(out->complementarity, std::abs(f(0) * u(0)));
  out->alignment = std::max(out->alignment, ft.dot(ut) + mu * f(0) * ut.norm());
}

/// Adds the rows of a contact to `out`, and returns the largest entry of its natural map.
template <int Rows>
double add_contact(const ContactBlock& block, const Row& f, const Row& u, double s,
                   ContactResidual* out) {
  // Scale torsion to the units of the tangents, torque / e and e spin, so that the cone is round.
  Eigen::Matrix<double, Rows, 1> f_row = f, u_row = u;
  const double e = block.torsion_radius;
  double unloadable = 0;
  if (Rows == 4) {
    // Torsion without a radius must be zero, and its spin is free.
    if (e == 0) unloadable = std::abs(f_row(Rows - 1));
    f_row(Rows - 1) = e > 0 ? f_row(Rows - 1) / e : 0;
    u_row(Rows - 1) *= e;
  }
  // Residuals in the problem's units, then the natural map in the block's scale.
  add_cone<Rows>(f_row, u_row, block.friction, out);
  out->outside = std::max(out->outside, unloadable);
  const double natural = internal::cone_natural_map<Rows>(f_row / s, u_row * s, block.friction)
                             .template lpNorm<Eigen::Infinity>();
  return std::max(natural, unloadable / s);
}

/// Returns the largest |s b| and |P(0) / s| of a block [sqrt(J)].
double residual_scale(const ContactBlock& block, const Row& b, double s) {
  if (b.size() == 1) {
    // Interval: where lower == upper the velocity is free, and only P(0) counts.
    const auto [lower, upper] = internal::impulse_bounds(block);
    const double nearest = std::clamp(0.0, lower, upper);
    return std::max(lower == upper ? 0 : std::abs(s * b(0)), std::abs(nearest / s));
  }
  // Cone: rows that friction cannot load have a free velocity and do not count.
  double out = std::abs(b(0));
  if (block.friction > 0) out = b.head<3>().lpNorm<Eigen::Infinity>();
  if (b.size() == 4 && block.friction > 0)
    out = std::max(out, block.torsion_radius * std::abs(b(3)));
  return s * out;
}

}  // namespace

bool ContactResidual::is_within(double tolerance) const {
  return natural <= std::max(tolerance, std::min(rounding, internal::kMaxRounding));
}

ContactBlock bilateral_block() { return {ConstraintLaw::kBilateral}; }
ContactBlock unilateral_block() { return {ConstraintLaw::kUnilateral}; }
ContactBlock box_block(double lower, double upper) {
  return checked({ConstraintLaw::kBox, lower, upper});
}
ContactBlock coulomb_block(double friction) {
  return checked({ConstraintLaw::kCoulomb, 0, 0, friction});
}
ContactBlock soft_finger_block(double friction, double torsion_radius) {
  return checked({ConstraintLaw::kSoftFinger, 0, 0, friction, torsion_radius});
}

int row_count(ConstraintLaw law) {
  if (law == ConstraintLaw::kCoulomb) return 3;
  return law == ConstraintLaw::kSoftFinger ? 4 : 1;
}

void check_contact_problem(const ContactProblem& problem) {
  Index rows = 0;
  // Check the blocks, and the sum of their rows against W and b.
  for (const ContactBlock& block : problem.blocks) rows += row_count(checked(block).law);
  require(problem.b.size() == rows, "blocks have {} rows, b has {}", rows, problem.b.size());
  require(problem.W.rows() == rows && problem.W.cols() == rows,
          "blocks have {} rows, W is {} by {}", rows, problem.W.rows(), problem.W.cols());

  // Check that all numbers are finite, by their sum, and that W is symmetric.
  double largest = 0, sum = problem.b.sum(), difference = 0;
  for (Index j = 0; j < rows; ++j) {
    const auto column = problem.W.col(j);
    sum += column.sum();
    largest = std::max(largest, column.lpNorm<Eigen::Infinity>());
    for (Index i = j + 1; i < rows; ++i)
      difference = std::max(difference, std::abs(problem.W(i, j) - problem.W(j, i)));
  }
  require(std::isfinite(sum), "W and b must be finite");
  require(difference <= kSymmetryError * largest,
          "W must be symmetric, mirrored entries differ by {}", difference);
}

namespace internal {

std::pair<double, double> impulse_bounds(const ContactBlock& block) {
  if (block.law == ConstraintLaw::kBilateral) return {-kInfinity, kInfinity};
  if (block.law == ConstraintLaw::kUnilateral) return {0, kInfinity};
  return {block.lower, block.upper};
}

double min_diagonal(const ContactProblem& problem) {
  const double largest = problem.W.rows() > 0 ? problem.W.diagonal().maxCoeff() : 0;
  return kMinDiagonalRatio * std::max(largest, 0.0);
}

double block_scale(const ContactProblem& problem, const ContactBlock& block, Index start,
                   double minimum) {
  const int rows = row_count(block.law);
  // Mean diagonal of W over the rows that count; torsion enters as e^2 W, and not at all for e = 0.
  double sum = 0;
  int counted = 0;
  for (int k = 0; k < rows; ++k) {
    const double e = k == 3 ? block.torsion_radius : 1;
    sum += e * e * problem.W(start + k, start + k);
    counted += e > 0 ? 1 : 0;
  }
  // An immobile block has the scale of the largest diagonal entry, or 1 if W is zero.
  const double mean = sum / counted;
  return mean > minimum ? 1 / std::sqrt(mean) : minimum > 0 ? 1 / std::sqrt(minimum * 1e16) : 1;
}

ContactResidual contact_residual_at(const ContactProblem& problem, const Row& f, const Row& u) {
  ContactResidual out;
  double natural = 0;
  Index start = 0;
  const double minimum = min_diagonal(problem);
  for (const ContactBlock& block : problem.blocks) {
    const int rows = row_count(block.law);
    const double s = block_scale(problem, block, start, minimum);
    // Scale of the natural map: the largest |s b| and |P(0) / s|.
    out.scale = std::max(out.scale, residual_scale(block, problem.b.segment(start, rows), s));
    // Natural map in the block's scale; the other residuals are in the problem's units.
    double entry = 0;
    if (rows == 1) {
      const auto [lower, upper] = internal::impulse_bounds(block);
      add_interval(lower, upper, f(start), u(start), &out);
      entry = std::abs(interval_natural_map(f(start) / s, u(start) * s, lower / s, upper / s));
    } else if (rows == 3) {
      entry = add_contact<3>(block, f.segment<3>(start), u.segment<3>(start), s, &out);
    } else {
      entry = add_contact<4>(block, f.segment<4>(start), u.segment<4>(start), s, &out);
    }
    // NaN counts as infinite; std::max would drop it.
    natural = entry >= natural ? entry : std::isnan(entry) ? kInfinity : natural;
    start += rows;
  }
  // Make them relative; the rounding error is that of the sums W f.
  out.natural = natural > 0 ? natural / out.scale : 0;
  if (natural > 0)
    out.rounding = kRoundingUnits * std::numeric_limits<double>::epsilon() / out.scale *
                   f.cwiseAbs().dot(problem.W.diagonal().cwiseMax(0).cwiseSqrt());
  return out;
}

}  // namespace internal

ContactResidual contact_residual(const ContactProblem& problem, const Row& f) {
  require(f.size() == problem.b.size(), "b has {} rows, f has {}", problem.b.size(), f.size());
  const VectorXd u = problem.W * f + problem.b;
  return internal::contact_residual_at(problem, f, u);
}

}  // namespace thenar
