#include "solvers/matrix_inequality.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

namespace thenar::internal {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

// Weights of the objective against the barrier: first, largest, and their ratio [1]
constexpr double kInitialWeight = 1, kMaxWeight = 1e15, kWeightGrowth = 8;
constexpr int kMaxNewtonSteps = 30;  // maximum number of Newton steps for one weight
// Squared decrement below which full steps converge [1]
constexpr double kQuadraticDecrement = 0.06;
// Squared decrement below which the weight may grow [1]
constexpr double kCentredDecrement = 1e-3;
constexpr double kHessianShift = 1e-14;  // addition to the diagonal of the scaled Hessian [1]
constexpr int kMaxHalvings = 50;         // maximum number of halvings of a step

/// Gradient and Hessian.
struct Derivatives {
  VectorXd g;
  MatrixXd H;
};

/// Computes gradient and Hessian of the barrier.
Derivatives barrier_derivatives(const std::vector<MatrixInequality>& inequalities,
                                const VectorXd& y) {
  Derivatives out{VectorXd::Zero(y.size()), MatrixXd::Zero(y.size(), y.size())};
  for (const MatrixInequality& each : inequalities) {
    // Z_k = L^-1 M_k L^-T: trace(Z_k) and trace(Z_k Z_l) are the derivatives of log det.
    const Eigen::LLT<MatrixXd> factor(evaluate(each, y));
    std::vector<MatrixXd> Z;
    for (const auto& [k, M] : each.terms) {
      const MatrixXd half = factor.matrixL().solve(M);
      Z.emplace_back(factor.matrixL().solve(half.transpose()));
      out.g(k) -= Z.back().trace();
    }
    // Add the symmetric second derivatives.
    for (std::size_t a = 0; a < Z.size(); ++a)
      for (std::size_t b = 0; b <= a; ++b) {
        const double entry = Z[a].cwiseProduct(Z[b]).sum();
        const int k = each.terms[a].first, l = each.terms[b].first;
        out.H(k, l) += entry;
        if (k != l) out.H(l, k) += entry;
      }
  }
  return out;
}

bool is_positive_definite(const std::vector<MatrixInequality>& inequalities, const VectorXd& y) {
  return std::all_of(inequalities.begin(), inequalities.end(), [&](const MatrixInequality& each) {
    return Eigen::LLT<MatrixXd>(evaluate(each, y)).info() == Eigen::Success;
  });
}

/// Takes a feasible Newton step. @return squared decrement before the step; 0: no step was possible
double newton_step(const std::vector<MatrixInequality>& inequalities, VectorXd& y, int index,
                   double weight) {
  // Gradient and Hessian of the weighted objective with the barrier.
  Derivatives derivatives = barrier_derivatives(inequalities, y);
  derivatives.g(index) -= weight;
  // Scaled Newton step.
  const VectorXd D = derivatives.H.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  MatrixXd scaled = D.asDiagonal() * derivatives.H * D.asDiagonal();
  scaled.diagonal().array() += kHessianShift;
  const VectorXd direction = -D.cwiseProduct(scaled.ldlt().solve(D.cwiseProduct(derivatives.g)));
  const double decrement = -derivatives.g.dot(direction);
  if (!(decrement > 0) || !direction.allFinite()) return 0;
  // Damp the step, and halve it until it is feasible.
  double length = decrement < kQuadraticDecrement ? 1 : 1 / (1 + std::sqrt(decrement));
  for (int i = 0; i < kMaxHalvings; ++i, length /= 2)
    if (const VectorXd next = y + length * direction; is_positive_definite(inequalities, next)) {
      y = next;
      return decrement;
    }
  return 0;
}

}  // namespace

MatrixXd evaluate(const MatrixInequality& inequality, const VectorXd& y) {
  MatrixXd value = inequality.C;
  for (const auto& [k, M] : inequality.terms) value += y(k) * M;
  return value;
}

MaximisedComponent maximise_component(const std::vector<MatrixInequality>& inequalities, VectorXd y,
                                      int index, double target) {
  // Increase the weight; each centre bounds the remaining increase of the unknown.
  Eigen::Index rows = 0;
  for (const MatrixInequality& each : inequalities) rows += each.C.rows();
  for (double weight = kInitialWeight; weight < kMaxWeight; weight *= kWeightGrowth) {
    double decrement = 1;
    for (int i = 0; i < kMaxNewtonSteps && decrement > kCentredDecrement; ++i) {
      decrement = newton_step(inequalities, y, index, weight);
      if (y(index) > target) return {y, true};
    }
    // Stop if twice the bound of the remaining increase is too small.
    if (decrement <= kCentredDecrement &&
        y(index) + 2 * static_cast<double>(rows) / weight < target)
      break;
  }
  return {y, false};
}

}  // namespace thenar::internal
