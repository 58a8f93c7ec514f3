#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "solvers/arrow_squares.h"
#include "solvers/bounded_least_squares.h"
#include "solvers/least_squares.h"

namespace thenar::internal {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Shares of points, each >= 0 and 1 in sum, whose mean is nearest to the origin  (points).
/// @param products  inner products of the points (points, points)
VectorXd nearest_mean(const MatrixXd& products) {
  // min |P y|^2 + (sum y - 1)^2 over y >= 0 has the same direction, and y <= 1.
  constexpr double kRegular = 1e-12;  // of the largest product [1]
  const Eigen::Index n = products.rows();
  MatrixXd H = products + MatrixXd::Ones(n, n);
  H.diagonal().array() += kRegular * H.diagonal().maxCoeff();
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
  /// Whether J'J cannot be factored, so that nothing is known of steps.
  [[nodiscard]] bool lost() const { return !factor_; }

  /// A step downhill; where there is none, the gradient across the kink that is in the way.
  /// @return whether there was either
  bool advance() {
    constexpr double kEnough = 0.05;   // of the fall that the slope promises [1]
    constexpr std::size_t kMost = 30;  // sides
    const double shortest = 0.5 * kNear / left_;
    for (double part = 1;; part = std::max(part / 4, shortest)) {
      VectorXd next = (z_ + part * step_).cwiseMax(problem_.lower).cwiseMin(problem_.upper);
      CostDerivatives there = cost_derivatives(problem_, next);
      ++evaluations_;
      const bool finite = std::isfinite(there.cost) && there.gradient.allFinite();
      if (finite && there.cost < at_.cost - kEnough * part * left_ * left_) {
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
  static constexpr double kNear = 1e-3;  // sides of one kink are as near to each other [sds]

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
      if (length(side.z - z_) < kNear) sides_.push_back(std::move(side));
    add(at_.gradient, z_);
  }

  void add(VectorXd gradient, VectorXd z) {
    for (Eigen::Index i = 0; i < gradient.size(); ++i)
      if (!free_[static_cast<std::size_t>(i)]) gradient[i] = 0;
    sides_.push_back({std::move(z), std::move(gradient)});
    // The mean of all sides that is smallest in sds.
    const auto n = static_cast<Eigen::Index>(sides_.size());
    MatrixXd G(z_.size(), n), solved(z_.size(), n);
    for (Eigen::Index i = 0; i < n; ++i) {
      G.col(i) = sides_[static_cast<std::size_t>(i)].gradient;
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
  constexpr int kMost = 200;       // evaluations [1]
  constexpr double kLeft = 0.003;  // step that may be left [sds]
  CostDerivatives start = cost_derivatives(problem, solution.z);
  ++solution.evaluations;
  if (!std::isfinite(start.cost) || !start.gradient.allFinite()) return false;
  KinkSearch search(problem, solution.z, std::move(start));
  bool stopped = false, going = true;
  while (going && !stopped && !search.lost() && search.left() > kLeft &&
         search.evaluations() < kMost) {
    going = search.advance();
    options.progress(static_cast<double>(search.evaluations()) / kMost, "kinks");
    stopped = options.progress.stop();
  }
  solution.evaluations += search.evaluations();
  solution.z = search.z();
  solution.cost = search.cost();
  if (stopped) solution.status = Status::kStopped;
  if (stopped || search.lost() || search.left() > kLeft) return stopped;
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
