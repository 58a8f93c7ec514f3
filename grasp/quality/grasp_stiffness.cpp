#include "grasp/quality/grasp_stiffness.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include "base/error.h"
#include "base/spatial.h"

namespace thenar {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Returns the wrenches of unit n, t1, t2 forces and of a unit torque about n, torque / scale.
Eigen::Matrix<double, 6, 4> unit_wrenches(const Contact& contact, const Eigen::Vector3d& centre,
                                          double torque_scale) {
  const Tangents t = tangents(contact.n);
  Eigen::Matrix<double, 6, 4> G = Eigen::Matrix<double, 6, 4>::Zero();
  G.topLeftCorner<3, 3>() << contact.n, t.e1, t.e2;
  for (int i = 0; i < 3; ++i)
    G.col(i).tail<3>() = (contact.p - centre).cross(G.col(i).head<3>()) / torque_scale;
  G.col(3).tail<3>() = contact.n / torque_scale;
  return G;
}

/// Springs of a grasp, with the wrench and the component index of each.
struct Springs {
  Eigen::Matrix<double, 6, Eigen::Dynamic> G;
  VectorXd k;
  std::vector<Index> component;
};

Springs springs_of(const std::vector<Contact>& contacts, const Eigen::Vector3d& centre,
                   double torque_scale, const std::vector<PadStiffness>& pads) {
  Springs springs{Eigen::Matrix<double, 6, Eigen::Dynamic>(6, 0), VectorXd(0), {}};
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    // Springs along n, t1, t2 and about n; components without stiffness are left out.
    const auto G = unit_wrenches(contacts[i], centre, torque_scale);
    const Eigen::Vector4d k(pads[i].normal, pads[i].tangential, pads[i].tangential,
                            pads[i].twisting);
    for (Index j = 0; j < 4; ++j) {
      require(k(j) >= 0, "a stiffness of pad {} is {}", i, k(j));
      if (k(j) == 0) continue;
      append_column(springs.G, G.col(j));
      append_entry(springs.k, k(j));
      springs.component.push_back(4 * static_cast<Index>(i) + j);
    }
  }
  return springs;
}

/// Computes J K_q^-1 J' for the components that have springs (springs, springs).
MatrixXd joint_compliance(const JointStiffness& joints, const Springs& springs, Index components) {
  require(joints.J.rows() == components && joints.J.cols() == joints.k.size(),
          "J is {} x {}, wanted {} x {}", joints.J.rows(), joints.J.cols(), components,
          joints.k.size());
  require(joints.J.allFinite() && (joints.k.array() > 0).all(),
          "J must be finite, joint stiffness > 0");
  const MatrixXd J = joints.J(springs.component, Eigen::all);
  return J * joints.k.cwiseInverse().asDiagonal() * J.transpose();
}

/// Computes K = G C^-1 G' of springs in series with the joints.
Eigen::Matrix<double, 6, 6> in_series(const Springs& springs, const MatrixXd& compliance) {
  if (springs.k.size() == 0) return Eigen::Matrix<double, 6, 6>::Zero();
  const Eigen::LDLT<MatrixXd> ldlt(compliance);
  const VectorXd pivots = ldlt.vectorD();
  require(pivots.minCoeff() > 1e-14 * pivots.maxCoeff(),
          "a rigid pad has no joint behind it that yields");
  return springs.G * ldlt.solve(MatrixXd(springs.G.transpose()));
}

}  // namespace

GraspStiffness grasp_stiffness(const std::vector<Contact>& contacts, const Eigen::Vector3d& centre,
                               double torque_scale, const std::vector<PadStiffness>& pads,
                               const std::optional<JointStiffness>& joints) {
  require(pads.size() == contacts.size(), "{} contacts but {} pads", contacts.size(), pads.size());
  (void)wrench_set(contacts, centre, torque_scale);  // refuses invalid contacts
  // Compliance of pads, plus that of the joints behind them.
  const Springs springs = springs_of(contacts, centre, torque_scale, pads);
  MatrixXd compliance = springs.k.cwiseInverse().asDiagonal();
  if (joints)
    compliance += joint_compliance(*joints, springs, 4 * static_cast<Index>(contacts.size()));
  // The smallest eigenvalue is the softest direction.
  const Eigen::Matrix<double, 6, 6> K = in_series(springs, compliance);
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(MatrixXd{K});
  const Eigen::Matrix<double, 6, 1> softest = eigen.eigenvectors().col(0);
  return {K, eigen.eigenvalues()(0), {softest.head<3>(), softest.tail<3>()}};
}

}  // namespace thenar
