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

/// Returns the entries of z that one part of the residuals reads.
VectorXd gather_entries(const ArrowLayout& layout, int block, const VectorXd& z) {
  if (block < 0) return z.head(layout.shared);
  VectorXd entries(layout.shared + layout.own);
  entries << z.head(layout.shared), z.segment(layout.first_index(block), layout.own);
  return entries;
}

/// Point of the search, with the residuals of all parts.
struct SecantPoint {
  VectorXd z, gradient;          // (n)
  double cost = 0;               // [1]
  std::vector<Residuals> parts;  // residuals and Jacobian of each part
};

/// Evaluates all parts at z. @return nothing if residuals are not finite
std::optional<SecantPoint> secant_point(const ResidualBlocks& blocks, VectorXd z) {
  SecantPoint at;
  at.gradient = VectorXd::Zero(z.size());
  const ArrowLayout& layout = blocks.layout;
  for (const ResidualPart& part : blocks.parts) {
    at.parts.push_back(part.residuals(z, WithJacobian::kYes));
    const Residuals& out = at.parts.back();
    at.cost += 0.5 * out.r.squaredNorm();
    const VectorXd slopes = out.J.transpose() * out.r;
    at.gradient.head(layout.shared) += slopes.head(layout.shared);
    if (part.block >= 0)
      at.gradient.segment(layout.first_index(part.block), layout.own) += slopes.tail(layout.own);
  }
  at.z = std::move(z);
  if (!std::isfinite(at.cost) || !at.gradient.allFinite()) return {};
  return at;
}

/// Secant estimate S of the curvature sum_i r_i d2r_i of one part, stored as S = plus'plus -
/// minus'minus.
struct PartCurvature {
  MatrixXd plus, minus;  // (updates, coordinates that the part reads)

  [[nodiscard]] VectorXd multiply(const VectorXd& step) const {
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

/// Structured secant search: best point, and secant curvatures of each part's residuals.
class SecantSearch {
 public:
  SecantSearch(const LeastSquares& problem, ResidualBlocks blocks, SecantPoint start)
      : problem_(problem),
        blocks_(std::move(blocks)),
        best_(std::move(start)),
        curvatures_(blocks_.parts.size()),
        gauss_newton_(blocks_.layout) {
    factorise_hessian();
  }

  [[nodiscard]] const SecantPoint& best() const { return best_; }
  /// Returns whether damping has become so large that no step lowers the cost.
  [[nodiscard]] bool exhausted() const { return damping_ > kMaxDamping; }

  /// Returns the larger predicted decrease of two full steps, by the Hessian and by J'J [1]; the
  /// second is not computed if the first exceeds `sufficient`.
  [[nodiscard]] double gain(double sufficient = kInfinity) const {
    return gain(best_.gradient, sufficient);
  }

  /// Tries a step, with one evaluation of the residuals.
  void advance() {
    // Compute the damped step.
    std::optional<ArrowSquaresFactor> factor = damped_factor();
    for (; !factor && !exhausted(); factor = damped_factor()) increase_damping();
    if (!factor) return;
    const VectorXd next =
        (best_.z - factor->solve(best_.gradient)).cwiseMax(problem_.lower).cwiseMin(problem_.upper);
    // Evaluate it, and update the curvatures and the damping.
    std::optional<SecantPoint> now = secant_point(blocks_, next);
    if (!now) return increase_damping();
    const bool better = is_better(*now);
    update_curvatures(*now, better ? now->parts : best_.parts);
    if (better) {
      best_ = std::move(*now);
      constexpr double kNewtonDamping = 0.02;
      damping_ = damping_ > kNewtonDamping ? damping_ / 4 : 0;
    } else {
      increase_damping();
    }
    factorise_hessian();
  }

 private:
  static constexpr double kMaxDamping = 1e6;  // maximum factor of J'J in the damped Hessian [1]

  [[nodiscard]] double gain(const VectorXd& gradient, double sufficient) const {
    const auto gain_of = [&](const std::optional<ArrowSquaresFactor>& factor) {
      return factor ? 0.5 * gradient.dot(factor->solve(gradient)) : kInfinity;
    };
    const double newton_gain = gain_of(newton_);
    if (newton_gain > sufficient) return newton_gain;
    return std::max(newton_gain, gain_of(ArrowSquaresFactor::factor(gauss_newton_, free_)));
  }

  /// Returns whether a point is better by its cost or, if rounding hides the change of the cost, by
  /// the predicted decrease.
  [[nodiscard]] bool is_better(const SecantPoint& next) const {
    // Relative change of the cost that rounding may cause [1]
    constexpr double kCostRounding = 1e-14;
    if (std::abs(next.cost - best_.cost) > kCostRounding * best_.cost)
      return next.cost < best_.cost;
    return gain(next.gradient, kInfinity) < gain();
  }

  void increase_damping() { damping_ = std::max(0.1, 4 * damping_); }

  /// Factorises the Hessian plus `damping_` times J'J; nothing if it is not positive definite.
  [[nodiscard]] std::optional<ArrowSquaresFactor> damped_factor() const {
    return damping_ == 0 ? newton_ : ArrowSquaresFactor::factor(hessian(damping_), free_);
  }

  /// Returns (1 + damping) J'J + S.
  [[nodiscard]] ArrowSquares hessian(double damping) const {
    ArrowSquares out = gauss_newton_;
    out.scale(1 + damping);
    for (std::size_t k = 0; k < curvatures_.size(); ++k) {
      if (curvatures_[k].plus.size() == 0) continue;
      out.add(blocks_.parts[k].block, curvatures_[k].plus);
      out.subtract(blocks_.parts[k].block, curvatures_[k].minus);
    }
    return out;
  }

  /// Updates the curvature of each part from the change of its Jacobian along a step: the secant
  /// equation is S step = (J_next - J)' r,  and the change is minimal in the metric  M = J'J + I:
  ///   S += m v' + v m' - (m'step) v v',  m the residual of the secant equation, v = M step /
  ///   (step' M step).
  void update_curvatures(const SecantPoint& next, const std::vector<Residuals>& at) {
    for (std::size_t k = 0; k < blocks_.parts.size(); ++k) {
      const MatrixXd& J = best_.parts[k].J;
      const VectorXd step =
          gather_entries(blocks_.layout, blocks_.parts[k].block, next.z - best_.z);
      VectorXd error = (next.parts[k].J - J).transpose() * at[k].r;
      PartCurvature& S = curvatures_[k];
      if (S.plus.size() == 0 && error.isZero(0)) continue;  // the part is linear
      if (S.plus.size() > 0) error -= S.multiply(step);
      VectorXd v = J.transpose() * (J * step) + step;
      const double length = v.dot(step);
      if (!(length > 0)) continue;  // the part does not depend on the step
      v /= length;
      S.add(error - v * (0.5 * error.dot(step)), v);
    }
  }

  /// Computes J'J and the factor of the Hessian at the best point, over the free coordinates.
  void factorise_hessian() {
    gauss_newton_ = ArrowSquares(blocks_.layout);
    for (std::size_t k = 0; k < blocks_.parts.size(); ++k)
      gauss_newton_.add(blocks_.parts[k].block, best_.parts[k].J);
    free_ = free_coordinates(problem_, best_.z, best_.gradient);
    newton_ = ArrowSquaresFactor::factor(hessian(0), free_);
  }

  const LeastSquares& problem_;
  ResidualBlocks blocks_;
  SecantPoint best_;
  std::vector<PartCurvature> curvatures_;  // curvature of each part; empty: none was observed
  ArrowSquares gauss_newton_;
  std::vector<bool> free_;
  std::optional<ArrowSquaresFactor> newton_;  // factor of the Hessian; none: not positive definite
  double damping_ = 0;
};

}  // namespace

bool is_held(const LeastSquares& problem, const VectorXd& z, double gradient, Eigen::Index i) {
  const double width = problem.upper[i] - problem.lower[i];
  if (width == 0) return true;
  // Interior-point solvers stop close to the bound.
  const double on = 1e-6 * std::min(1.0, width);
  return (z[i] < problem.lower[i] + on && gradient > 0) ||
         (z[i] > problem.upper[i] - on && gradient < 0);
}

std::vector<bool> free_coordinates(const LeastSquares& problem, const VectorXd& z,
                                   const VectorXd& gradient) {
  std::vector<bool> free;
  for (Eigen::Index i = 0; i < z.size(); ++i) free.push_back(!is_held(problem, z, gradient[i], i));
  return free;
}

ResidualBlocks blocks_of(const LeastSquares& problem) {
  if (!problem.parts.empty()) return {problem.layout, problem.parts};
  return {{static_cast<int>(problem.lower.size())}, {{-1, problem.residuals}}};
}

bool search_by_secants(const LeastSquares& problem, const SolveOptions& options,
                       int max_evaluations, Solution& solution) {
  ResidualBlocks blocks = blocks_of(problem);
  std::optional<SecantPoint> start = secant_point(blocks, solution.z);
  ++solution.evaluations;
  if (!start) return false;
  SecantSearch search(problem, std::move(blocks), std::move(*start));
  bool converged = false, stopped = false;
  double predicted = kInfinity;  // predicted decrease of a full step
  // Take steps until the predicted decrease is below the tolerance.
  for (int calls = 0; calls < max_evaluations && !search.exhausted() && !converged && !stopped;
       ++calls) {
    const double allowed = options.tolerance * search.best().cost;
    predicted = search.gain(allowed);
    converged = predicted <= allowed;
    search.advance();  // one more step reduces the gradient to rounding
    ++solution.evaluations;
    options.progress(static_cast<double>(calls) / max_evaluations, "secants");
    stopped = options.progress.stop();
  }
  // Return the best point.
  solution.z = search.best().z;
  solution.cost = search.best().cost;
  if (!converged && !stopped) return false;
  solution.status = converged ? Status::kSolved : Status::kStopped;
  if (converged)
    solution.message = fmt::format("the last full step was to lower the cost by {:.1g}", predicted);
  return true;
}

// Search for minima at kinks, where gradients jump.

namespace {

/// Returns weights, each >= 0 and with sum 1, of the convex combination nearest to the origin
/// (points).
/// @param products  inner products of the points (points, points)
VectorXd min_norm_weights(const MatrixXd& products) {
  // min |P y|^2 + (sum y - 1)^2 over y >= 0 has the same direction, and y <= 1.
  constexpr double kRegularization = 1e-12;  // addition to the diagonal, over its largest entry [1]
  const Eigen::Index n = products.rows();
  MatrixXd H = products + MatrixXd::Ones(n, n);
  H.diagonal().array() += kRegularization * H.diagonal().maxCoeff();
  const VectorXd y =
      bounded_quadratic(H, VectorXd::Constant(n, -2), VectorXd::Zero(n), VectorXd::Ones(n));
  return y / y.sum();
}

/// Search near a kink: its best point, and the gradients of the cost on all sides of it.
class KinkSearch {
 public:
  KinkSearch(const LeastSquares& problem, VectorXd z, CostDerivatives at) : problem_(problem) {
    move_to(std::move(z), std::move(at));
  }

  [[nodiscard]] const VectorXd& z() const { return z_; }
  [[nodiscard]] double cost() const { return at_.cost; }
  [[nodiscard]] int evaluations() const { return evaluations_; }
  [[nodiscard]] std::size_t sides() const { return sides_.size(); }
  /// Returns the length of the remaining step, that of the min-norm convex combination of gradients
  /// [sds].
  [[nodiscard]] double remaining_step() const { return remaining_step_; }
  /// Returns whether J'J cannot be factorised, so that no step can be computed.
  [[nodiscard]] bool is_singular() const { return !factor_; }

  /// Takes a descent step or, if there is none, adds the gradient on the other side of the kink.
  /// @return whether either was possible
  bool advance() {
    // Minimum decrease of the cost, over the decrease predicted by the gradient [1]
    constexpr double kMinDecreaseRatio = 0.05;
    constexpr std::size_t kMaxSides = 30;  // maximum number of sides
    // Backtrack until the cost decreases, or the step is as short as a kink is wide.
    const double shortest = 0.5 * kKinkDistance / remaining_step_;
    for (double part = 1;; part = std::max(part / 4, shortest)) {
      VectorXd next = (z_ + part * step_).cwiseMax(problem_.lower).cwiseMin(problem_.upper);
      CostDerivatives trial = cost_derivatives(problem_, next);
      ++evaluations_;
      const bool finite = std::isfinite(trial.cost) && trial.gradient.allFinite();
      if (finite &&
          trial.cost < at_.cost - kMinDecreaseRatio * part * remaining_step_ * remaining_step_) {
        move_to(std::move(next), std::move(trial));
        return true;
      }
      if (part > shortest) continue;
      if (!finite || sides_.size() >= kMaxSides) return false;
      add_side(std::move(trial.gradient), std::move(next));
      return true;
    }
  }

 private:
  // Maximum distance of the sides of one kink [sds]
  static constexpr double kKinkDistance = 1e-3;

  /// Moves to a point, and keeps the sides near to it.
  void move_to(VectorXd z, CostDerivatives at) {
    z_ = std::move(z);
    at_ = std::move(at);
    // Factorise J'J over the free coordinates.
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
    // Keep the sides that are still near, and add that of the point.
    std::vector<Side> previous_sides;
    std::swap(previous_sides, sides_);
    if (!factor_) return;
    for (Side& side : previous_sides)
      if (length(side.z - z_) < kKinkDistance) sides_.push_back(std::move(side));
    add_side(at_.gradient, z_);
  }

  /// Adds a side, and computes the remaining step.
  void add_side(VectorXd gradient, VectorXd z) {
    for (Eigen::Index i = 0; i < gradient.size(); ++i)
      if (!free_[i]) gradient[i] = 0;
    sides_.push_back({std::move(z), std::move(gradient)});
    // Find the convex combination of all sides with minimum norm.
    const auto n = static_cast<Eigen::Index>(sides_.size());
    MatrixXd G(z_.size(), n), solved(z_.size(), n);
    for (Eigen::Index i = 0; i < n; ++i) {
      G.col(i) = sides_[i].gradient;
      solved.col(i) = factor_->solve(G.col(i));
    }
    const MatrixXd products = G.transpose() * solved;
    const VectorXd shares = min_norm_weights(0.5 * (products + products.transpose()));
    step_ = -solved * shares;
    remaining_step_ = std::sqrt(std::max(0.0, shares.dot(products * shares)));
  }

  /// Returns |J step| at the best point [sds].
  [[nodiscard]] double length(const VectorXd& step) const {
    double squares = 0;
    for (const ArrowRows& rows : at_.rows) {
      VectorXd moved = rows.shared * step.head(at_.layout.shared);
      if (rows.block >= 0)
        moved += rows.own * step.segment(at_.layout.first_index(rows.block), at_.layout.own);
      squares += moved.squaredNorm();
    }
    return std::sqrt(squares);
  }

  /// Gradient on one side of a kink, and the point where it was computed.
  struct Side {
    VectorXd z, gradient;  // (n)
  };

  const LeastSquares& problem_;
  VectorXd z_;          // best point (n)
  CostDerivatives at_;  // derivatives at z_
  std::vector<Side> sides_;
  std::optional<ArrowSquaresFactor> factor_;  // factor of J'J
  std::vector<bool> free_;                    // coordinates that no bound holds (n)
  VectorXd step_;                             // remaining step (n)
  double remaining_step_ = 0;                 // length of the remaining step [sds]
  int evaluations_ = 0;
};

}  // namespace

bool search_at_kink(const LeastSquares& problem, const SolveOptions& options, Solution& solution) {
  constexpr int kMaxEvaluations = 200;  // maximum number of evaluations [1]
  // Length of the remaining step below which the search has converged [sds]
  constexpr double kStepTolerance = 0.003;
  CostDerivatives start = cost_derivatives(problem, solution.z);
  ++solution.evaluations;
  if (!std::isfinite(start.cost) || !start.gradient.allFinite()) return false;
  KinkSearch search(problem, solution.z, std::move(start));
  // Search until the remaining step is short.
  bool stopped = false, progressed = true;
  while (progressed && !stopped && !search.is_singular() &&
         search.remaining_step() > kStepTolerance && search.evaluations() < kMaxEvaluations) {
    progressed = search.advance();
    options.progress(static_cast<double>(search.evaluations()) / kMaxEvaluations, "kinks");
    stopped = options.progress.stop();
  }
  // Return the best point, and its status.
  solution.evaluations += search.evaluations();
  solution.z = search.z();
  solution.cost = search.cost();
  if (stopped) solution.status = Status::kStopped;
  if (stopped || search.is_singular() || search.remaining_step() > kStepTolerance) return stopped;
  solution.status = Status::kSolved;
  solution.newton_step = search.remaining_step();
  solution.kink_sides = static_cast<int>(search.sides());
  solution.message =
      fmt::format("a step of {:.1g} sds is left, from {}", search.remaining_step(),
                  search.sides() > 1 ? fmt::format("slopes on {} sides of a kink", search.sides())
                                     : "the slope");
  return true;
}

}  // namespace thenar::internal
