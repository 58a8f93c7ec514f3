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
  // Below full rank all measures are rounding errors.
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

namespace {

// Singular values of G below this share of the largest are zero [1]
constexpr double kRankShare = 1e-9;

using Svd = Eigen::JacobiSVD<Eigen::MatrixXd>;

constexpr double kMotionRounding = 1e-12;  // Rounding of (G')^+ J, over |J| / (least of G) [1]

/// Sets singular values up to rounding errors to 0.
void drop_rounding(Eigen::MatrixXd& M, double rounding) {
  if (M.size() == 0) return;
  const Svd svd(M, Eigen::ComputeThinU | Eigen::ComputeThinV);
  Eigen::VectorXd sigma = svd.singularValues();
  if (sigma(sigma.size() - 1) > rounding) return;
  for (double& each : sigma)
    if (each <= rounding) each = 0;
  M = svd.matrixU() * sigma.asDiagonal() * svd.matrixV().transpose();
}

double largest_singular_value(const Eigen::MatrixXd& M) { return Svd(M).singularValues()(0); }

}  // namespace

NoSlipMobility no_slip_mobility(const Eigen::Matrix<double, 6, Eigen::Dynamic>& G,
                                const Eigen::MatrixXd& J, double tolerance) {
  require(G.cols() == J.rows(), "G has {} force components, J {}", G.cols(), J.rows());
  require(G.allFinite() && J.allFinite(), "G and J must be finite");
  // Without full rank the contacts do not constrain the object.
  const Svd of_contacts(G.transpose(), Eigen::ComputeThinU);
  const Eigen::VectorXd& sigma = of_contacts.singularValues();
  require(sigma.size() == 6 && sigma(5) > kRankShare * sigma(0),
          "the contacts leave the object free to move by itself");
  if (J.cols() == 0) return {Eigen::MatrixXd(0, 0), Eigen::MatrixXd(6, 0)};

  // Drive speeds in the null space of contact motions that no motion of the object can follow.
  const Eigen::MatrixXd& U = of_contacts.matrixU();
  const Svd beside(J - U * (U.transpose() * J), Eigen::ComputeFullV);
  const double zero = tolerance * largest_singular_value(J);
  const Eigen::Index stuck = (beside.singularValues().array() > zero).count();
  NoSlipMobility found;
  // Motion of the object by least squares, whose residual is now zero.
  found.drives = beside.matrixV().rightCols(J.cols() - stuck);
  found.object = hand_object_jacobian(G, J * found.drives);
  drop_rounding(found.object, kMotionRounding * largest_singular_value(J) / sigma(5));
  return found;
}

}  // namespace thenar
