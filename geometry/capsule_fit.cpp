#include "geometry/capsule_fit.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include "base/error.h"
#include "geometry/primitives.h"
#include "geometry/shape_union.h"

namespace thenar {
namespace {

using Eigen::Vector3d;
using Ends = Eigen::Matrix<double, 8, 1>;  // centres of both balls, then their radii [m]

constexpr int kMaxRounds = 100;      // maximum number of rounds
constexpr double kSlopeStep = 1e-7;  // finite-difference step [m]
constexpr double kMinGain = 1e-12;   // relative decrease of the sum of squares at which it ends [1]

ShapeSpec capsule_between(const Ends& ends) {
  const Vector3d from = ends.segment<3>(0), to = ends.segment<3>(3);
  ShapeSpec shape;
  shape.kind = ShapeKind::kTaperedCapsule;
  shape.size = {ends[6], ends[7], (to - from).norm()};
  shape.X_BS.R = basis_along((to - from).normalized());
  shape.X_BS.p = (from + to) / 2;
  return shape;
}

/// Signed distances of points from the capsule (points).
Eigen::VectorXd distances_from(const Ends& ends, const Eigen::Matrix3Xd& points) {
  const ShapeSpec spec = capsule_between(ends);
  const auto shape = build_tapered_capsule(spec.size[0], spec.size[1], spec.size[2]);
  const Pose<double> X_SB = spec.X_BS.inverse();
  Eigen::VectorXd out(points.cols());
  for (Eigen::Index i = 0; i < points.cols(); ++i)
    out[i] = shape->distance(X_SB * Vector3d(points.col(i)));
  return out;
}

/// Balls that are as thick as the vertices and reach as far, along the direction of most variance.
Ends first_ends(const Eigen::Matrix3Xd& points) {
  const Vector3d mean = points.rowwise().mean();
  const Eigen::Matrix3Xd from_mean = points.colwise() - mean;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(from_mean * from_mean.transpose());
  const Vector3d along = axes.eigenvectors().col(2);
  const Eigen::VectorXd height = from_mean.transpose() * along;
  const double across = axes.eigenvalues()[0] + axes.eigenvalues()[1];
  const double radius = std::sqrt(across / static_cast<double>(points.cols()));
  require(radius > 1e-6 * (height.maxCoeff() - height.minCoeff()),
          "vertices in one line are not a surface, radius {} m", radius);
  const double low = std::min(height.minCoeff() + radius, -0.1 * radius);
  const double high = std::max(height.maxCoeff() - radius, 0.1 * radius);
  Ends ends;
  ends << mean + low * along, mean + high * along, radius, radius;
  return ends;
}

}  // namespace

CapsuleFit fit_tapered_capsule(const TriangleMesh& mesh) {
  const Eigen::Matrix3Xd& points = mesh.vertices;
  require(points.cols() >= 8, "a capsule has eight numbers, the mesh {} vertices", points.cols());
  Ends ends = first_ends(points);
  const double min_radius = 1e-3 * ends[6];
  Eigen::VectorXd apart = distances_from(ends, points);
  Eigen::Matrix<double, Eigen::Dynamic, 8> slope(points.cols(), 8);
  double damping = 1e-3;
  for (int round = 0; round < kMaxRounds; ++round) {
    for (int k = 0; k < 8; ++k) {
      Ends moved = ends;
      moved[k] += kSlopeStep;
      slope.col(k) = (distances_from(moved, points) - apart) / kSlopeStep;
    }
    Eigen::Matrix<double, 8, 8> normal = slope.transpose() * slope;
    normal.diagonal() *= 1 + damping;
    normal.diagonal().array() += 1e-12 * normal.diagonal().maxCoeff();
    Ends next = ends - normal.ldlt().solve(slope.transpose() * apart);
    next.tail<2>() = next.tail<2>().cwiseMax(min_radius);
    const Eigen::VectorXd then = distances_from(next, points);
    if (!(then.squaredNorm() < apart.squaredNorm())) {
      if ((damping *= 10) > 1e8) break;
      continue;
    }
    const double gain = 1 - then.squaredNorm() / apart.squaredNorm();
    ends = next;
    apart = then;
    damping = std::max(0.1 * damping, 1e-12);
    if (gain < kMinGain) break;
  }
  return {capsule_between(ends), apart.cwiseAbs().maxCoeff(),
          std::sqrt(apart.squaredNorm() / static_cast<double>(apart.size()))};
}

}  // namespace thenar
