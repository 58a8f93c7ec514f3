#include "grasp/quality/epsilon_start.h"

#include <algorithm>
#include <cmath>

#include <Eigen/SVD>

namespace thenar::internal {
namespace {

/// The unit vector least along the first `count` orthonormal columns, made orthogonal to them.
Wrench across(const Eigen::Matrix<double, 6, 6>& basis, int count) {
  const auto used = basis.leftCols(count);
  Eigen::Index axis = 0;
  used.rowwise().squaredNorm().minCoeff(&axis);
  Wrench u = Wrench::Unit(axis);
  for (int again = 0; again < 2; ++again) u = (u - used * (used.transpose() * u)).normalized();
  return u;
}

}  // namespace

Span span_of(const WrenchSet& set) {
  Eigen::Matrix<double, 6, Eigen::Dynamic> all(6, 0);
  for (const WrenchCap& cap : set.caps) {
    all.conservativeResize(6, all.cols() + 1 + cap.A.cols());
    all.rightCols(1 + cap.A.cols()) << cap.c, cap.A;
  }
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(all, Eigen::ComputeFullU);
  const Eigen::VectorXd& sigma = svd.singularValues();
  return {static_cast<int>((sigma.array() > kFlat * sigma(0)).count()), svd.matrixU()};
}

FirstSimplex first_simplex(const Support& support, double flat) {
  FirstSimplex out{{}, false, 1};
  out.points[0] = support(Wrench::Unit(0)).p;
  Eigen::Matrix<double, 6, 6> basis = Eigen::Matrix<double, 6, 6>::Zero();
  for (int k = 0; k < 6; ++k) {
    const Wrench u = across(basis, k);
    const Wrench plus = support(u).p, minus = support(-u).p;
    out.supports += 2;
    const double rise = u.dot(plus - out.points[0]), fall = u.dot(out.points[0] - minus);
    if (std::max(rise, fall) <= flat * support.size()) return out;
    const auto next = static_cast<std::size_t>(k + 1);
    out.points[next] = rise > fall ? plus : minus;
    Wrench edge = out.points[next] - out.points[0];
    const auto used = basis.leftCols(k);
    for (int again = 0; again < 2; ++again) edge -= used * (used.transpose() * edge);
    basis.col(k) = edge.normalized();
  }
  out.found = true;
  return out;
}

}  // namespace thenar::internal
