#include "grasp/quality/manipulability.h"

#include <Eigen/QR>
#include <Eigen/SVD>

#include "base/error.h"

namespace thenar {

Manipulability manipulability(const Eigen::MatrixXd& M) {
  require(M.allFinite(), "the map must be finite");
  if (M.size() == 0) return {0, 0, 0, 0};
  const Eigen::VectorXd sigma = Eigen::JacobiSVD<Eigen::MatrixXd>(M).singularValues();
  const double largest = sigma(0);
  const int rank = static_cast<int>((sigma.array() > 1e-12 * largest).count());
  if (rank < M.rows()) return {0, 0, 0, rank};  // what is left is rounding
  const double least = sigma(sigma.size() - 1);
  return {sigma.prod(), least, least / largest, rank};
}

Eigen::MatrixXd hand_object_jacobian(const Eigen::Matrix<double, 6, Eigen::Dynamic>& G,
                                     const Eigen::MatrixXd& J) {
  require(G.cols() == J.rows(), "G has {} force components, J {}", G.cols(), J.rows());
  require(G.allFinite() && J.allFinite(), "G and J must be finite");
  if (J.size() == 0) return Eigen::MatrixXd::Zero(6, J.cols());
  const Eigen::MatrixXd Gt = G.transpose();
  return Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd>(Gt).solve(J);
}

}  // namespace thenar
