#include "grasp/quality/min_norm.h"

#include <algorithm>
#include <limits>
#include <vector>

#include <Eigen/QR>

namespace thenar::internal {
namespace {

constexpr int kMostSupports = 2000;
constexpr double kZero = 1e-14;  // of |x|, in parts of the size [1]

/// Weights of the point of least norm in the affine hull of the columns: y = w0 + D a, w0 the last.
Eigen::VectorXd affine_weights(const Eigen::Matrix<double, 6, Eigen::Dynamic>& points) {
  const Eigen::Index edges = points.cols() - 1;
  Eigen::VectorXd weights = Eigen::VectorXd::Ones(points.cols());
  if (edges == 0) return weights;
  const Wrench last = points.rightCols<1>();
  const Eigen::MatrixXd D = points.leftCols(edges).colwise() - last;
  weights.head(edges) = D.completeOrthogonalDecomposition().solve(-last);
  weights(edges) = 1 - weights.head(edges).sum();
  return weights;
}

/// Few points and how their nearest one is mixed from them.
struct Corral {
  Eigen::Matrix<double, 6, Eigen::Dynamic> points;
  Eigen::VectorXd weights;  // >= 0, sum 1

  void add(const Wrench& p) {
    points.conservativeResize(6, points.cols() + 1);
    points.rightCols<1>() = p;
    weights.conservativeResize(points.cols());
    weights(points.cols() - 1) = 0;
  }

  void drop(Eigen::Index i) {
    const Eigen::Index last = points.cols() - 1;
    points.col(i) = points.col(last);
    weights(i) = weights(last);
    points.conservativeResize(6, last);
    weights.conservativeResize(last);
  }

  /// Wolfe's minor cycle: to the nearest point of the hull, dropping what it does not need.
  void settle() {
    for (;;) {
      const Eigen::VectorXd wanted = affine_weights(points);
      if (wanted.minCoeff() >= 0) {
        weights = wanted;
        return;
      }
      double step = 1;
      Eigen::Index leaving = 0;
      for (Eigen::Index i = 0; i < wanted.size(); ++i) {
        if (wanted(i) >= 0) continue;
        const double to_zero = weights(i) / (weights(i) - wanted(i));
        if (to_zero <= step) {
          step = to_zero;
          leaving = i;
        }
      }
      weights += step * (wanted - weights);
      drop(leaving);
    }
  }
};

}  // namespace

MinNorm min_norm(const Support& support, double gap) {
  const Wrench start = Wrench::Constant(1 / std::sqrt(6.0));
  MinNorm out{support(start).p, start, std::numeric_limits<double>::infinity(), 1};
  Corral corral;
  corral.add(out.x);
  corral.weights(0) = 1;
  Wrench x = out.x;
  while (out.supports < kMostSupports) {
    const double length = x.norm();
    if (length < out.x.norm()) out.x = x;
    if (length <= kZero * support.size()) break;
    const Wrench u = -x / length;
    const Reach reach = support(u);
    ++out.supports;
    if (reach.h < out.reach) {
      out.reach = reach.h;
      out.away = u;
    }
    if (out.x.norm() + out.reach <= std::max(gap, support.rounding())) break;
    if (length + reach.h <= support.rounding()) break;  // no progress left
    corral.add(reach.p);
    corral.settle();
    x = corral.points * corral.weights;
  }
  return out;
}

}  // namespace thenar::internal
