#pragma once

/// Equilibrium of a tissue body in contact with a rigid object, step by step.

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "base/spatial.h"
#include "geometry/shape.h"
#include "pads/contact_cones.h"
#include "pads/contact_surface.h"
#include "pads/tissue_body.h"
#include "solvers/status.h"

namespace thenar {

/// A rigid object that presses on a body.
struct RigidObject {
  std::shared_ptr<const Shape> shape;  // in its own frame
  double friction = 0;                 // Coulomb, of the exact cone [1]
};

/// Where a press is. Vectors are in the body's frame.
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

/// How far to go in a step.
struct PressGoal {
  Pose<double> X_PO;                // of the object at the end
  std::optional<double> force;      // instead: moved from there along `along` until the
  Eigen::Vector3d along{0, 0, -1};  // object's push along it is so large [N]; unit (3)
  double time = 0;                  // of the step, for relaxation [s]
};

struct PressOptions {
  double force_tolerance = 1e-9;  // of residuals, over the sum of contact forces [1]
  double gap_tolerance = 1e-9;    // of touching nodes [m]
  int max_iterations = 60;
  std::function<bool()> stop;  // asked before each iteration: true ends the step; empty: never
};

/// Tangents of a body that its steps factor.
struct PressFactors {
  explicit PressFactors(const TissueBody& body) : moment(body), cones(body) {}
  CondensedBody moment;  // of the moment, with contacts or without
  ContactCones cones;    // kept from step to step
};

/// How a step ended.
struct [[nodiscard]] PressOutcome {
  Status status = Status::kStalled;
  std::string message;
  int iterations = 0;
  double residual = 0;  // largest entry of forces out of balance [N]
  double gap = 0;       // largest |gap| of a touching node [m]
  Wrench push;          // of the object on the body, about the body's origin
};

/// Solves  d(energy)/dx = contact forces  with 0 <= gap _|_ normal >= 0, |shear| <= friction
/// normal, and shear against the slip since the last step, to the tolerances; on kSolved `state` is
/// the new state, otherwise it is as it was (kStopped: it was asked to stop).
///
/// Where an edge of the object lies over the skin, contact is by stiff springs spread over it
/// (SkinSprings), which give way by less than a hundredth of what tissue does, and Newton's method.
/// Elsewhere gaps of nodes are means over the true surface around them (MeanGaps). Without
/// friction, and where many nodes touch, Newton's method on the augmented Lagrangian goes first;
/// its slope of sliding friction is that of [HueeberStadlerWohlmuth2008], without which nodes turn
/// from stick to slip and back for ever. Where few touch, each iteration brings the body, linear at
/// where it is, to rest under exact cones (ContactCones), by a tangent that is kept while it
/// serves; where one way fails, the other. A tangent that is not positive definite, as of a body
/// that its contacts alone hold, gets springs that shorten steps. An object that came through a
/// thin plate of skin, or skin through a thin object, is no answer. Tissue pressure is an unknown
/// of its own (element_response()).
/// @throws InputError if a pose, a time or a force makes no sense, or the state is of another body.
/// Sources: [AlartCurnier1991], [SimoLaursen1992], [HueeberStadlerWohlmuth2008].
[[nodiscard]] PressOutcome press_step(const TissueBody& body, const ContactSurface& surface,
                                      const RigidObject& object, const PressGoal& goal,
                                      const PressOptions& options, PressFactors& factors,
                                      PressState& state);

/// Slope of the push by motions of the object at a solved state, at once: what relaxes does not
/// count, nodes that stick go with the object, those that slip keep their cone
/// (contact_stiffness()).
/// @return moment and turn first, about the body's origin (6, 6); zero where nothing touches
/// @throws InputError if the state is of another body.
[[nodiscard]] Eigen::Matrix<double, 6, 6> press_stiffness(
    const TissueBody& body, const ContactSurface& surface, const RigidObject& object,
    const PressOptions& options, PressFactors& factors, const PressState& state);

/// Whether a node of the surface that touches holds: its friction is below its cone by more than a
/// millionth.
[[nodiscard]] bool node_sticks(const PressState& state, Eigen::Index node, double friction);

/// A body at rest that nothing touches.
[[nodiscard]] PressState rest_state(const TissueBody& body, const ContactSurface& surface,
                                    const Pose<double>& X_PO);

}  // namespace thenar
