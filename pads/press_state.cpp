#include "pads/press_state.h"

namespace thenar {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using Eigen::VectorXd;

bool node_sticks(const PressState& state, Eigen::Index node, double friction) {
  return state.friction_force.col(node).norm() <
         (1 - kSlipMargin) * friction * state.normal_force[node];
}

PressState rest_state(const TissueBody& body, const ContactSurface& surface,
                      const Pose<double>& X_PO) {
  PressState state;
  state.x = VectorXd::Zero(body.unknowns());
  state.X_PO = X_PO;
  const auto nodes = static_cast<Eigen::Index>(surface.nodes.size());
  state.normal_force = VectorXd::Zero(nodes);
  state.friction_force = Matrix3Xd::Zero(3, nodes);
  state.anchor.resize(3, nodes);
  for (Eigen::Index k = 0; k < nodes; ++k)
    state.anchor.col(k) = X_PO.inverse() * Vector3d(surface.rest_positions.col(k));
  return state;
}

}  // namespace thenar
