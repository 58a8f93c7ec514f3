#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/numbers.h"
#include "solvers/arrow_squares.h"
#include "solvers/bounded_least_squares.h"
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
  /// Returns whether no step lowers the cost, however short.
  [[nodiscard]] bool exhausted() const { return damping_ > kMostDamping; }

  /// Returns the larger gain of two full steps, with the curvature and by J'J alone [1]; the second
  /// is not computed if the first is above `enough`.
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
      constexpr double kLittleStep = 0.02;
      damping_ = damping_ > kLittleStep ? damping_ / 4 : 0;
    } else {
      shorten();
    }
    assemble();
  }

 private:
  static constexpr double kMostDamping = 1e6;  // Largest factor of J'J in the damped Hessian [1]

  [[nodiscard]] double gain(const VectorXd& gradient, double enough) const {
    const auto by = [&](const std::optional<ArrowSquaresFactor>& factor) {
      return factor ? 0.5 * gradient.dot(factor->solve(gradient)) : kInfinity;
    };
    const double curved = by(newton_);
    if (curved > enough) return curved;
    return std::max(curved, by(ArrowSquaresFactor::factor(gauss_newton_, free_)));
  }

  /// Returns whether a point is better, by the cost, or by the gain that is left where rounding
  /// hides the change of the cost.
  [[nodiscard]] bool is_better(const SecantPoint& next) const {
    // Relative change of the cost that rounding explains [1]
    constexpr double kCostRounding = 1e-14;
    if (std::abs(next.cost - best_.cost) > kCostRounding * best_.cost)
      return next.cost < best_.cost;
    return gain(next.gradient, kInfinity) < gain();
  }

  void shorten() { damping_ = std::max(0.1, 4 * damping_); }

  /// Factors the Hessian plus `damping_` times J'J; nothing where this is not positive definite.
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

// Searches that end at a kink, where slopes jump.

namespace {

/// Shares of points, each >= 0 and 1 in sum, whose mean is nearest to the origin  (points).
/// @param products  inner products of the points (points, points)
VectorXd nearest_mean(const MatrixXd& products) {
  // min |P y|^2 + (sum y - 1)^2 over y >= 0 has the same direction, and y <= 1.
  constexpr double kRegularization = 1e-12;  // Added to the diagonal, over its largest entry [1]
  const Eigen::Index n = products.rows();
  MatrixXd H = products + MatrixXd::Ones(n, n);
  H.diagonal().array() += kRegularization * H.diagonal().maxCoeff();
  const VectorXd y =
      bounded_quadratic(H, VectorXd::Constant(n, -2), VectorXd::Zero(n), VectorXd::Ones(n));
  return y / y.sum();
}

/// A search near a kink: its best point, and gradients of the cost on all sides of it.
class KinkSearch {
 public:
  KinkSearch(const LeastSquares& problem, VectorXd z, CostDerivatives at) : problem_(problem) {
    move_to(std::move(z), std::move(at));
  }

  [[nodiscard]] const VectorXd& z() const { return z_; }
  [[nodiscard]] double cost() const { return at_.cost; }
  [[nodiscard]] int evaluations() const { return evaluations_; }
  [[nodiscard]] std::size_t sides() const { return sides_.size(); }
  /// Length of the step that is left: of the smallest mean of the gradients [sds].
  [[nodiscard]] double left() const { return left_; }
  /// Returns whether J'J cannot be factored, so that nothing is known of steps.
  [[nodiscard]] bool lost() const { return !factor_; }

  /// A step downhill; where there is none, the gradient across the kink that is in the way.
  /// @return whether there was either
  bool advance() {
    // Least fall of the cost, over the fall that the slope predicts [1]
    constexpr double kFallShare = 0.05;
    constexpr std::size_t kMost = 30;  // sides
    const double shortest = 0.5 * kKinkDistance / left_;
    for (double part = 1;; part = std::max(part / 4, shortest)) {
      VectorXd next = (z_ + part * step_).cwiseMax(problem_.lower).cwiseMin(problem_.upper);
      CostDerivatives there = cost_derivatives(problem_, next);
      ++evaluations_;
      const bool finite = std::isfinite(there.cost) && there.gradient.allFinite();
      if (finite && there.cost < at_.cost - kFallShare * part * left_ * left_) {
        move_to(std::move(next), std::move(there));
        return true;
      }
      if (part > shortest) continue;
      if (!finite || sides_.size() >= kMost) return false;
      add(std::move(there.gradient), std::move(next));
      return true;
    }
  }

 private:
  // Sides of one kink are at most this far apart [sds]
  static constexpr double kKinkDistance = 1e-3;

  /// Begins anew at a point, with what is known of the sides near to it.
  void move_to(VectorXd z, CostDerivatives at) {
    z_ = std::move(z);
    at_ = std::move(at);
    // J'J over what no bound holds.
    ArrowSquares hessian(at_.layout);
    for (const ArrowRows& rows : at_.rows) {
      MatrixXd J = rows.shared;
      if (rows.block >= 0) {
        J.conservativeResize(Eigen::NoChange, at_.layout.shared + at_.layout.own);
        J.rightCols(at_.layout.own) = rows.own;
      }
      hessian.add(rows.block, J);
    }
    free_ = free_coordinates(problem_, z_, at_.gradient);
    factor_ = ArrowSquaresFactor::factor(hessian, free_);
    // Sides that are still near, and the one on which the point lies.
    std::vector<Side> known;
    std::swap(known, sides_);
    if (!factor_) return;
    for (Side& side : known)
      if (length(side.z - z_) < kKinkDistance) sides_.push_back(std::move(side));
    add(at_.gradient, z_);
  }

  void add(VectorXd gradient, VectorXd z) {
    for (Eigen::Index i = 0; i < gradient.size(); ++i)
      if (!free_[i]) gradient[i] = 0;
    sides_.push_back({std::move(z), std::move(gradient)});
    // The mean of all sides that is smallest in sds.
    const auto n = static_cast<Eigen::Index>(sides_.size());
    MatrixXd G(z_.size(), n), solved(z_.size(), n);
    for (Eigen::Index i = 0; i < n; ++i) {
      G.col(i) = sides_[i].gradient;
      solved.col(i) = factor_->solve(G.col(i));
    }
    const MatrixXd products = G.transpose() * solved;
    const VectorXd shares = nearest_mean(0.5 * (products + products.transpose()));
    step_ = -solved * shares;
    left_ = std::sqrt(std::max(0.0, shares.dot(products * shares)));
  }

  /// |J step| at the best point [sds].
  [[nodiscard]] double length(const VectorXd& step) const {
    double squares = 0;
    for (const ArrowRows& rows : at_.rows) {
      VectorXd moved = rows.shared * step.head(at_.layout.shared);
      if (rows.block >= 0)
        moved += rows.own * step.segment(at_.layout.first(rows.block), at_.layout.own);
      squares += moved.squaredNorm();
    }
    return std::sqrt(squares);
  }

  /// A gradient, and where it was found.
  struct Side {
    VectorXd z, gradient;  // (n)
  };

  const LeastSquares& problem_;
  VectorXd z_;          // best point (n)
  CostDerivatives at_;  // there
  std::vector<Side> sides_;
  std::optional<ArrowSquaresFactor> factor_;  // of J'J
  std::vector<bool> free_;                    // coordinates that no bound holds (n)
  VectorXd step_;                             // that is left (n)
  double left_ = 0;                           // its length [sds]
  int evaluations_ = 0;
};

}  // namespace

bool search_at_kink(const LeastSquares& problem, const SolveOptions& options, Solution& solution) {
  constexpr int kMost = 200;  // evaluations [1]
  // The search ends when the step that is left is shorter [sds]
  constexpr double kLeftStep = 0.003;
  CostDerivatives start = cost_derivatives(problem, solution.z);
  ++solution.evaluations;
  if (!std::isfinite(start.cost) || !start.gradient.allFinite()) return false;
  KinkSearch search(problem, solution.z, std::move(start));
  bool stopped = false, going = true;
  while (going && !stopped && !search.lost() && search.left() > kLeftStep &&
         search.evaluations() < kMost) {
    going = search.advance();
    options.progress(static_cast<double>(search.evaluations()) / kMost, "kinks");
    stopped = options.progress.stop();
  }
  solution.evaluations += search.evaluations();
  solution.z = search.z();
  solution.cost = search.cost();
  if (stopped) solution.status = Status::kStopped;
  if (stopped || search.lost() || search.left() > kLeftStep) return stopped;
  solution.status = Status::kSolved;
  solution.newton_step = search.left();
  solution.sides = static_cast<int>(search.sides());
  solution.message =
      fmt::format("a step of {:.1g} sds is left, from {}", search.left(),
                  search.sides() > 1 ? fmt::format("slopes on {} sides of a kink", search.sides())
                                     : "the slope");
  return true;
}

}  // namespace thenar::internal
