#pragma once

/// State of a press: displacements, pressure, relaxation history and contact forces.

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
  Eigen::VectorXd x;                // displacements of the free nodes [m] (3 free nodes)
  Pose<double> X_PO;                // pose of the object in the body's frame
  TissuePressure pressure;          // unknown of the mixed problem; empty: the pressure at x
  TissueHistory history;            // relaxation of the tissue
  Wrench push;                      // wrench of the object on the body, about the body's origin
  Eigen::VectorXd normal_force;     // force along the object's normal [N] (surface nodes)
  Eigen::Matrix3Xd friction_force;  // friction force on the node [N] (3, surface nodes)
  Eigen::Matrix3Xd anchor;  // position of the node at the last step, object's frame [m] (3, nodes)
  bool uses_skin_springs = false;        // contact forces are those of SkinSprings
  double spring_energy = 0;              // energy of the skin springs [J]
  std::vector<double> spring_stiffness;  // stiffness of the skin springs at each node [N/m]
                                         // (nodes); empty until a step has used springs
};

/// Margin below the friction cone within which a node counts as slipping, over the bound of the
/// cone [1].
inline constexpr double kSlipMargin = 1e-6;

/// Returns whether a surface node sticks: its friction force lies below the friction cone by more
/// than kSlipMargin.
[[nodiscard]] bool node_sticks(const PressState& state, Eigen::Index node, double friction);

/// Returns the state of a body at rest that nothing touches.
[[nodiscard]] PressState rest_state(const TissueBody& body, const ContactSurface& surface,
                                    const Pose<double>& X_PO);

}  // namespace thenar
