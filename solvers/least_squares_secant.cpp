#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/numbers.h"
#include "solvers/arrow_squares.h"
#include "solvers/least_squares.h"

namespace thenar::internal {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Entries of z that one part of the residuals reads.
VectorXd read_by(const ArrowLayout& layout, int block, const VectorXd& z) {
  if (block < 0) return z.head(layout.shared);
  VectorXd some(layout.shared + layout.own);
  some << z.head(layout.shared), z.segment(layout.first(block), layout.own);
  return some;
}

/// Residuals of all parts at a point.
struct SecantPoint {
  VectorXd z, gradient;          // (n)
  double cost = 0;               // [1]
  std::vector<Residuals> parts;  // with Jacobians
};

/// @return nothing where residuals are not finite
std::optional<SecantPoint> secant_point(const ResidualBlocks& of, VectorXd z) {
  SecantPoint at;
  at.gradient = VectorXd::Zero(z.size());
  const ArrowLayout& layout = of.layout;
  for (const ResidualPart& part : of.parts) {
    at.parts.push_back(part.residuals(z, WithJacobian::kYes));
    const Residuals& out = at.parts.back();
    at.cost += 0.5 * out.r.squaredNorm();
    const VectorXd slopes = out.J.transpose() * out.r;
    at.gradient.head(layout.shared) += slopes.head(layout.shared);
    if (part.block >= 0)
      at.gradient.segment(layout.first(part.block), layout.own) += slopes.tail(layout.own);
  }
  at.z = std::move(z);
  if (!std::isfinite(at.cost) || !at.gradient.allFinite()) return {};
  return at;
}

/// The curvature of the residuals of one part, S for sum_i r_i d2r_i, as rows added and taken away:
/// S = plus'plus - minus'minus.
struct PartCurvature {
  MatrixXd plus, minus;  // (steps that have shown some, coordinates that the part reads)

  [[nodiscard]] VectorXd times(const VectorXd& step) const {
    return plus.transpose() * (plus * step) - minus.transpose() * (minus * step);
  }

  /// Adds  a b' + b a'  as  (t a + b/t)(t a + b/t)'/2 - (t a - b/t)(t a - b/t)'/2.
  void add(const VectorXd& a, const VectorXd& b) {
    const double t = std::sqrt(b.norm() / a.norm());
    if (!(t > 0) || !std::isfinite(t)) return;  // one of them is zero
    const auto grow = [](MatrixXd& rows, const VectorXd& row) {
      rows.conservativeResize(rows.rows() + 1, row.size());
      rows.bottomRows(1) = std::sqrt(0.5) * row.transpose();
    };
    grow(plus, t * a + b / t);
    grow(minus, t * a - b / t);
  }
};

/// The search: points that get better, and the curvature of each part's residuals as the last
/// steps have shown it.
class SecantSearch {
 public:
  SecantSearch(const LeastSquares& problem, ResidualBlocks blocks, SecantPoint start)
      : problem_(problem),
        blocks_(std::move(blocks)),
        best_(std::move(start)),
        curvatures_(blocks_.parts.size()),
        gauss_newton_(blocks_.layout) {
    assemble();
  }

  [[nodiscard]] const SecantPoint& best() const { return best_; }
  /// Whether no step lowers the cost, however short.
  [[nodiscard]] bool exhausted() const { return damping_ > kMostDamping; }

  /// What full steps would still gain, at the largest: with the curvature and by J'J alone, which
  /// is not asked where the first is above `enough` [1].
  [[nodiscard]] double gain(double enough = kInfinity) const {
    return gain(best_.gradient, enough);
  }

  /// Tries a step: one evaluation of the residuals.
  void advance() {
    std::optional<ArrowSquaresFactor> factor = damped_factor();
    for (; !factor && !exhausted(); factor = damped_factor()) shorten();
    if (!factor) return;
    const VectorXd next =
        (best_.z - factor->solve(best_.gradient)).cwiseMax(problem_.lower).cwiseMin(problem_.upper);
    std::optional<SecantPoint> now = secant_point(blocks_, next);
    if (!now) return shorten();
    const bool better = is_better(*now);
    learn(*now, better ? now->parts : best_.parts);
    if (better) {
      best_ = std::move(*now);
      constexpr double kLittle = 0.02;
      damping_ = damping_ > kLittle ? damping_ / 4 : 0;
    } else {
      shorten();
    }
    assemble();
  }

 private:
  static constexpr double kMostDamping = 1e6;  // of J'J [1]

  [[nodiscard]] double gain(const VectorXd& gradient, double enough) const {
    const auto by = [&](const std::optional<ArrowSquaresFactor>& factor) {
      return factor ? 0.5 * gradient.dot(factor->solve(gradient)) : kInfinity;
    };
    const double curved = by(newton_);
    if (curved > enough) return curved;
    return std::max(curved, by(ArrowSquaresFactor::factor(gauss_newton_, free_)));
  }

  /// By the cost, or by what is left to gain where rounding hides the change of the cost.
  [[nodiscard]] bool is_better(const SecantPoint& next) const {
    constexpr double kRounding = 1e-14;  // of the cost [1]
    if (std::abs(next.cost - best_.cost) > kRounding * best_.cost) return next.cost < best_.cost;
    return gain(next.gradient, kInfinity) < gain();
  }

  void shorten() { damping_ = std::max(0.1, 4 * damping_); }

  /// Of the Hessian and as many J'J as damp it; nothing where that is not positive definite.
  [[nodiscard]] std::optional<ArrowSquaresFactor> damped_factor() const {
    return damping_ == 0 ? newton_ : ArrowSquaresFactor::factor(hessian(damping_), free_);
  }

  /// (1 + damping) J'J + S.
  [[nodiscard]] ArrowSquares hessian(double damping) const {
    ArrowSquares out = gauss_newton_;
    out.scale(1 + damping);
    for (std::size_t k = 0; k < curvatures_.size(); ++k) {
      if (curvatures_[k].plus.size() == 0) continue;
      out.add(blocks_.parts[k].block, curvatures_[k].plus);
      out.take(blocks_.parts[k].block, curvatures_[k].minus);
    }
    return out;
  }

  /// Changes the curvature of each part by what the Jacobians at both ends of a step tell:
  /// S step = (J_next - J)' r,  and otherwise as little as can be in units of  M = J'J + I:
  ///   S += m v' + v m' - (m'step) v v',  m what S misses, v = M step / (step' M step).
  void learn(const SecantPoint& next, const std::vector<Residuals>& at) {
    for (std::size_t k = 0; k < blocks_.parts.size(); ++k) {
      const MatrixXd& J = best_.parts[k].J;
      const VectorXd step = read_by(blocks_.layout, blocks_.parts[k].block, next.z - best_.z);
      VectorXd miss = (next.parts[k].J - J).transpose() * at[k].r;
      PartCurvature& S = curvatures_[k];
      if (S.plus.size() == 0 && miss.isZero(0)) continue;  // it is linear
      if (S.plus.size() > 0) miss -= S.times(step);
      VectorXd v = J.transpose() * (J * step) + step;
      const double length = v.dot(step);
      if (!(length > 0)) continue;  // it does not read what has moved
      v /= length;
      S.add(miss - v * (0.5 * miss.dot(step)), v);
    }
  }

  /// J'J and the factor of the Hessian at the best point, over the coordinates that no bound holds.
  void assemble() {
    gauss_newton_ = ArrowSquares(blocks_.layout);
    for (std::size_t k = 0; k < blocks_.parts.size(); ++k)
      gauss_newton_.add(blocks_.parts[k].block, best_.parts[k].J);
    free_ = free_coordinates(problem_, best_.z, best_.gradient);
    newton_ = ArrowSquaresFactor::factor(hessian(0), free_);
  }

  const LeastSquares& problem_;
  ResidualBlocks blocks_;
  SecantPoint best_;
  std::vector<PartCurvature> curvatures_;  // of each part; no rows: none was seen
  ArrowSquares gauss_newton_;
  std::vector<bool> free_;
  std::optional<ArrowSquaresFactor> newton_;  // of the Hessian; none: it is not positive definite
  double damping_ = 0;
};

}  // namespace

bool held(const LeastSquares& problem, const VectorXd& z, double gradient, Eigen::Index i) {
  const double width = problem.upper[i] - problem.lower[i];
  if (width == 0) return true;
  const double on = 1e-6 * std::min(1.0, width);  // interior-point solvers stop a little short [1]
  return (z[i] < problem.lower[i] + on && gradient > 0) ||
         (z[i] > problem.upper[i] - on && gradient < 0);
}

std::vector<bool> free_coordinates(const LeastSquares& problem, const VectorXd& z,
                                   const VectorXd& gradient) {
  std::vector<bool> free;
  for (Eigen::Index i = 0; i < z.size(); ++i) free.push_back(!held(problem, z, gradient[i], i));
  return free;
}

ResidualBlocks blocks_of(const LeastSquares& problem) {
  if (!problem.parts.empty()) return {problem.layout, problem.parts};
  return {{static_cast<int>(problem.lower.size())}, {{-1, problem.residuals}}};
}

bool search_by_secants(const LeastSquares& problem, const SolveOptions& options, int most,
                       Solution& solution) {
  ResidualBlocks blocks = blocks_of(problem);
  std::optional<SecantPoint> start = secant_point(blocks, solution.z);
  ++solution.evaluations;
  if (!start) return false;
  SecantSearch search(problem, std::move(blocks), std::move(*start));
  bool near = false, stopped = false;
  double left = kInfinity;  // to gain
  for (int calls = 0; calls < most && !search.exhausted() && !near && !stopped; ++calls) {
    const double allowed = options.tolerance * search.best().cost;
    left = search.gain(allowed);
    near = left <= allowed;
    search.advance();  // once more from near, for a gradient as small as steps make it
    ++solution.evaluations;
    options.progress(static_cast<double>(calls) / most, "secants");
    stopped = options.progress.stop();
  }
  solution.z = search.best().z;
  solution.cost = search.best().cost;
  if (!near && !stopped) return false;
  solution.status = near ? Status::kSolved : Status::kStopped;
  if (near)
    solution.message = fmt::format("the last full step was to lower the cost by {:.1g}", left);
  return true;
}

}  // namespace thenar::internal
