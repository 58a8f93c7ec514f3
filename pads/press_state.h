#pragma once

/// State of a press: displacements, pressure, history and contact forces.

#include <memory>
#include <vector>

#include <Eigen/Core>

#include "base/spatial.h"
#include "geometry/shape.h"
#include "pads/contact_surface.h"
#include "pads/press_goal.h"
#include "pads/tissue_body.h"

namespace thenar {

/// State of a press at the end of a step. Vectors are in the body's frame.
struct PressState {
  Eigen::VectorXd x;         // displacements of the free nodes [m] (3 free nodes)
  Pose<double> X_PO;         // of the object in the body's frame
  TissuePressure pressure;   // of the mixed problem; empty: that of x
  TissueHistory history;     // of relaxation
  Wrench push;               // of the object on the body, about the body's origin
  Eigen::VectorXd normal;    // force along the object's normal [N] (surface nodes)
  Eigen::Matrix3Xd shear;    // friction on the node [N] (3, surface nodes)
  Eigen::Matrix3Xd anchor;   // where a node was at the last step, object's frame [m] (3, nodes)
  bool by_springs = false;   // whether its forces are those of SkinSprings
  double spring_energy = 0;  // that these hold [J]
  std::vector<double> spring_stiffness;  // under nodes, once there were springs [N/m] (nodes)
};

/// Share of its cone's bound by which friction that sticks is below it [1].
inline constexpr double kSlipMargin = 1e-6;

/// Returns whether a node of the surface that touches holds: its friction is below its cone by more
/// than a millionth.
[[nodiscard]] bool node_sticks(const PressState& state, Eigen::Index node, double friction);

/// A body at rest that nothing touches.
[[nodiscard]] PressState rest_state(const TissueBody& body, const ContactSurface& surface,
                                    const Pose<double>& X_PO);

}  // namespace thenar
