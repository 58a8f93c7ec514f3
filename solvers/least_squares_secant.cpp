#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/numbers.h"
#include "solvers/arrow_matrix.h"
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

/// The search: points that get better, and the curvature of each part's residuals as the last
/// steps have shown it.
class SecantSearch {
 public:
  SecantSearch(const LeastSquares& problem, ResidualBlocks blocks, SecantPoint start)
      : problem_(problem), blocks_(std::move(blocks)), best_(std::move(start)) {
    curvatures_.resize(blocks_.parts.size());
    assemble();
  }

  [[nodiscard]] const SecantPoint& best() const { return best_; }
  /// Whether no step lowers the cost, however short.
  [[nodiscard]] bool exhausted() const { return damping_ > kMostDamping; }

  /// What full steps would still gain, at the largest: by J'J alone and with the curvature [1].
  [[nodiscard]] double gain() const { return gain(best_.gradient); }

  /// Tries a step: one evaluation of the residuals.
  void advance() {
    std::optional<ArrowCholesky> factor = damped_factor();
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

  [[nodiscard]] double gain(const VectorXd& gradient) const {
    const auto by = [&](const ArrowMatrix& hessian) {
      const auto factor = ArrowCholesky::factor(hessian, free_);
      return factor ? 0.5 * gradient.dot(factor->solve(gradient)) : kInfinity;
    };
    return std::max(by(gauss_newton_), by(hessian_));
  }

  /// By the cost, or by what is left to gain where rounding hides the change of the cost.
  [[nodiscard]] bool is_better(const SecantPoint& next) const {
    constexpr double kRounding = 1e-14;  // of the cost [1]
    if (std::abs(next.cost - best_.cost) > kRounding * best_.cost) return next.cost < best_.cost;
    return gain(next.gradient) < gain();
  }

  void shorten() { damping_ = std::max(0.1, 4 * damping_); }

  /// Of the Hessian and as many J'J as damp it; nothing where that is not positive definite.
  [[nodiscard]] std::optional<ArrowCholesky> damped_factor() const {
    ArrowMatrix damped = hessian_;
    damped.add(gauss_newton_, damping_);
    return ArrowCholesky::factor(damped, free_);
  }

  /// Changes the curvature of each part, S for sum_i r_i d2r_i, by what the Jacobians at both ends
  /// of a step tell:  S step = (J_next - J)' r,  and otherwise as little as can be in units of
  /// M = J'J + I:  S += m v' + v m' - (m'step) v v',  m what S misses, v = M step / (step' M step).
  void learn(const SecantPoint& next, const std::vector<Residuals>& at) {
    for (std::size_t k = 0; k < blocks_.parts.size(); ++k) {
      const MatrixXd& J = best_.parts[k].J;
      const VectorXd step = read_by(blocks_.layout, blocks_.parts[k].block, next.z - best_.z);
      VectorXd miss = (next.parts[k].J - J).transpose() * at[k].r;
      MatrixXd& S = curvatures_[k];
      if (S.size() == 0 && miss.isZero(0)) continue;  // it is linear
      if (S.size() == 0) S = MatrixXd::Zero(step.size(), step.size());
      miss -= S * step;
      VectorXd v = J.transpose() * (J * step) + step;
      const double length = v.dot(step);
      if (!(length > 0)) continue;  // it does not read what has moved
      v /= length;
      const VectorXd half = miss - v * (0.5 * miss.dot(step));
      S.noalias() += half * v.transpose() + v * half.transpose();
    }
  }

  /// J'J and the Hessian at the best point, and the coordinates that no bound holds.
  void assemble() {
    gauss_newton_ = hessian_ = ArrowMatrix(blocks_.layout);
    for (std::size_t k = 0; k < blocks_.parts.size(); ++k) {
      const int block = blocks_.parts[k].block;
      const MatrixXd squares = best_.parts[k].J.transpose() * best_.parts[k].J;
      gauss_newton_.add(block, squares);
      hessian_.add(block, curvatures_[k].size() == 0 ? squares : squares + curvatures_[k]);
    }
    free_.clear();
    for (Eigen::Index i = 0; i < best_.z.size(); ++i)
      free_.push_back(!held(problem_, best_.z, best_.gradient[i], i));
  }

  const LeastSquares& problem_;
  ResidualBlocks blocks_;
  SecantPoint best_;
  std::vector<MatrixXd> curvatures_;  // of each part; empty: none was seen
  ArrowMatrix gauss_newton_, hessian_;
  std::vector<bool> free_;
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

ResidualBlocks blocks_of(const LeastSquares& problem) {
  if (!problem.parts.empty()) return {problem.layout, problem.parts};
  return {{static_cast<int>(problem.lower.size())}, {{-1, problem.residuals}}};
}

bool search_by_secants(const LeastSquares& problem, const SolveOptions& options,
                       Solution& solution) {
  constexpr int kMost = 200;  // evaluations [1]
  ResidualBlocks blocks = blocks_of(problem);
  std::optional<SecantPoint> start = secant_point(blocks, solution.z);
  ++solution.evaluations;
  if (!start) return false;
  SecantSearch search(problem, std::move(blocks), std::move(*start));
  bool near = false, stopped = false;
  for (int calls = 0; calls < kMost && !search.exhausted() && !near && !stopped; ++calls) {
    near = search.gain() <= options.tolerance * search.best().cost;
    search.advance();  // once more from near, for a gradient as small as steps make it
    ++solution.evaluations;
    options.progress(static_cast<double>(calls) / kMost, "secants");
    stopped = options.progress.stop();
  }
  solution.z = search.best().z;
  solution.cost = search.best().cost;
  if (!near && !stopped) return false;
  solution.status = near ? Status::kSolved : Status::kStopped;
  if (near) solution.message = fmt::format("full steps would gain {:.1g}", search.gain());
  return true;
}

}  // namespace thenar::internal
