#include "hand/tip_manipulability.h"

#include <cmath>
#include <limits>

#include <Eigen/Geometry>
#include <Eigen/SVD>

#include "base/error.h"

namespace thenar {

TipManipulability tip_manipulability(const Eigen::Ref<const Eigen::Matrix3Xd>& J) {
  require(J.cols() > 0, "a tip that no joint moves has no mobility");
  require(J.allFinite(), "a tip Jacobian must be finite");
  // Decompose the Jacobian, with the zero singular values of a straight finger made exact.
  const Eigen::MatrixXd matrix = J;
  Eigen::JacobiSVD<Eigen::MatrixXd> svd(matrix, Eigen::ComputeFullU);
  svd.setThreshold(internal::kRankTolerance);
  TipManipulability mobility{Eigen::Vector3d::Zero(), svd.matrixU(), static_cast<int>(svd.rank()),
                             std::numeric_limits<double>::infinity()};
  mobility.speed.head(mobility.rank) = svd.singularValues().head(mobility.rank);
  if (mobility.rank == 3) mobility.condition = mobility.speed[0] / mobility.speed[2];
  return mobility;
}

TipManipulability tip_manipulability(const Eigen::Ref<const Eigen::Matrix3Xd>& J,
                                     const Eigen::Ref<const Eigen::Matrix3Xd>& W) {
  TipManipulability mobility = tip_manipulability(J);
  if (!plane_normal(J, W)) return mobility;
  mobility.possible = 2;
  if (mobility.rank == 2) mobility.condition = mobility.speed[0] / mobility.speed[1];
  return mobility;
}

std::optional<Eigen::Vector3d> plane_normal(const Eigen::Ref<const Eigen::Matrix3Xd>& J,
                                            const Eigen::Ref<const Eigen::Matrix3Xd>& W) {
  constexpr double kRounding = 1e-12;  // rounding of unit axes after a few rotations [1]
  std::optional<Eigen::Vector3d> normal;
  for (Eigen::Index k = 0; k < W.cols(); ++k) {
    const double turns = W.col(k).norm();
    if (turns < kRounding) continue;
    const Eigen::Vector3d axis = W.col(k) / turns;
    if (!normal) normal = axis;
    if (normal->cross(axis).norm() > kRounding) return {};
  }
  // Check that joints that move the tip without rotating it slide it in the plane.
  for (Eigen::Index k = 0; k < W.cols() && normal; ++k)
    if (W.col(k).norm() < kRounding &&
        std::abs(normal->dot(J.col(k))) > kRounding * J.col(k).norm())
      return {};
  return normal;
}

}  // namespace thenar
