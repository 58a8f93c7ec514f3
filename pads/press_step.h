#pragma once

/// Equilibrium of a tissue body in contact with a rigid object, step by step.

#include <Eigen/Core>

#include "pads/press_problem.h"

namespace thenar {

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

}  // namespace thenar
