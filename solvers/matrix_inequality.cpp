#include "solvers/matrix_inequality.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

namespace thenar::internal {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

// Weights of the objective against the barrier: first, largest, and their ratio [1]
constexpr double kFirstWeight = 1, kMaxWeight = 1e15, kGrowth = 8;
constexpr int kMaxNewtonSteps = 30;  // maximum number of Newton steps for one weight
// Squared decrement below which full steps converge [1]
constexpr double kQuadraticDecrement = 0.06;
// Squared decrement below which the weight may grow [1]
constexpr double kCentredDecrement = 1e-3;
constexpr double kHessianShift = 1e-14;  // addition to the diagonal of the scaled Hessian [1]
constexpr int kMaxHalvings = 50;         // maximum number of halvings of a step

/// Gradient and Hessian.
struct Slope {
  VectorXd g;
  MatrixXd H;
};

/// Computes gradient and Hessian of the barrier.
Slope slope_at(const std::vector<MatrixInequality>& inequalities, const VectorXd& y) {
  Slope out{VectorXd::Zero(y.size()), MatrixXd::Zero(y.size(), y.size())};
  for (const MatrixInequality& each : inequalities) {
    // Z_k = L^-1 M_k L^-T: trace(Z_k) and trace(Z_k Z_l) are the derivatives of log det.
    const Eigen::LLT<MatrixXd> factor(value_at(each, y));
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

bool holds(const std::vector<MatrixInequality>& inequalities, const VectorXd& y) {
  return std::all_of(inequalities.begin(), inequalities.end(), [&](const MatrixInequality& each) {
    return Eigen::LLT<MatrixXd>(value_at(each, y)).info() == Eigen::Success;
  });
}

/// Takes a feasible Newton step. @return squared decrement before the step; 0: no step was possible
double step(const std::vector<MatrixInequality>& inequalities, VectorXd& y, int which,
            double weight) {
  // Gradient and Hessian of the weighted objective with the barrier.
  Slope slope = slope_at(inequalities, y);
  slope.g(which) -= weight;
  // Scaled Newton step.
  const VectorXd D = slope.H.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  MatrixXd scaled = D.asDiagonal() * slope.H * D.asDiagonal();
  scaled.diagonal().array() += kHessianShift;
  const VectorXd way = -D.cwiseProduct(scaled.ldlt().solve(D.cwiseProduct(slope.g)));
  const double decrement = -slope.g.dot(way);
  if (!(decrement > 0) || !way.allFinite()) return 0;
  // Damp the step, and halve it until it is feasible.
  double length = decrement < kQuadraticDecrement ? 1 : 1 / (1 + std::sqrt(decrement));
  for (int i = 0; i < kMaxHalvings; ++i, length /= 2)
    if (const VectorXd next = y + length * way; holds(inequalities, next)) {
      y = next;
      return decrement;
    }
  return 0;
}

}  // namespace

MatrixXd value_at(const MatrixInequality& inequality, const VectorXd& y) {
  MatrixXd value = inequality.C;
  for (const auto& [k, M] : inequality.terms) value += y(k) * M;
  return value;
}

MaximisedComponent maximise_component(const std::vector<MatrixInequality>& inequalities, VectorXd y,
                                      int which, double enough) {
  // Increase the weight; each centre bounds the remaining increase of the unknown.
  Eigen::Index rows = 0;
  for (const MatrixInequality& each : inequalities) rows += each.C.rows();
  for (double weight = kFirstWeight; weight < kMaxWeight; weight *= kGrowth) {
    double decrement = 1;
    for (int i = 0; i < kMaxNewtonSteps && decrement > kCentredDecrement; ++i) {
      decrement = step(inequalities, y, which, weight);
      if (y(which) > enough) return {y, true};
    }
    // Stop if twice the bound of the remaining increase is too small.
    if (decrement <= kCentredDecrement &&
        y(which) + 2 * static_cast<double>(rows) / weight < enough)
      break;
  }
  return {y, false};
}

}  // namespace thenar::internal
