#include "hand/tip_manipulability.h"

#include <limits>

#include <Eigen/SVD>

#include "base/error.h"

namespace thenar {

TipManipulability tip_manipulability(const Eigen::Ref<const Eigen::Matrix3Xd>& J) {
  require(J.cols() > 0, "a tip that no joint moves has no mobility");
  require(J.allFinite(), "a tip Jacobian must be finite");
  // Singular values of the Jacobian, those of a straight finger set to zero.
  const Eigen::MatrixXd matrix = J;
  Eigen::JacobiSVD<Eigen::MatrixXd> svd(matrix, Eigen::ComputeFullU);
  svd.setThreshold(internal::kRankTolerance);
  TipManipulability mobility{Eigen::Vector3d::Zero(), svd.matrixU(), static_cast<int>(svd.rank()),
                             std::numeric_limits<double>::infinity()};
  mobility.speed.head(mobility.rank) = svd.singularValues().head(mobility.rank);
  if (mobility.rank == 3) mobility.condition = mobility.speed[0] / mobility.speed[2];
  return mobility;
}

}  // namespace thenar
