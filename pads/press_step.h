#pragma once

/// Equilibrium of a tissue body in contact with a rigid object, step by step.

#include <Eigen/Core>

#include "pads/press_problem.h"

namespace thenar {

/// Solves one step,  d(energy)/dx = contact forces,  with  0 <= gap _|_ normal force >= 0,
/// |friction| <= mu normal force,  and friction opposed to the slip since the last step. On kSolved
/// `state` is the new state; otherwise it is unchanged (kStopped: the caller stopped the step).
///
/// The method depends on the contact:
/// - Where an edge of the object lies over the skin, contact is by stiff springs spread over the
///   skin (SkinSprings), whose compliance is below a hundredth of that of the tissue, and Newton's
///   method.
/// - Elsewhere gaps of nodes are means over the true surface around them (MeanGaps). Without
///   friction, and where many nodes touch, Newton's method on the augmented Lagrangian comes first.
///   Its slope of sliding friction is that of [HueeberStadlerWohlmuth2008], without which nodes
///   alternate between stick and slip.
/// - Where few nodes touch, each iteration linearizes the body and solves for its equilibrium under
///   exact friction cones (ContactCones), with a tangent that is reused while it converges well.
/// If one of the last two methods fails, the other follows.
///
/// A tangent that is not positive definite, as that of a body held by its contacts alone, gets
/// springs that shorten steps. A solution in which object and tissue have passed through each other
/// is rejected. The tissue pressure is a separate unknown (element_response()).
/// @throws InputError if a pose, a time or a force makes no sense, or the state belongs to another
///         body.
/// Sources: [AlartCurnier1991], [SimoLaursen1992], [HueeberStadlerWohlmuth2008].
[[nodiscard]] PressOutcome press_step(const TissueBody& body, const ContactSurface& surface,
                                      const RigidObject& object, const PressGoal& goal,
                                      const PressOptions& options, PressFactors& factors,
                                      PressState& state);

/// Returns the slope of the object's wrench by its motion at a solved state, without relaxation:
/// sticking nodes move with the object, slipping nodes stay on their cones (contact_stiffness()).
/// @return moment and rotation first, about the body's origin (6, 6); zero where nothing touches
/// @throws InputError if the state belongs to another body.
[[nodiscard]] Eigen::Matrix<double, 6, 6> press_stiffness(
    const TissueBody& body, const ContactSurface& surface, const RigidObject& object,
    const PressOptions& options, PressFactors& factors, const PressState& state);

}  // namespace thenar
