#pragma once

/// Augmented contact laws of surface nodes, and their stiffness.

#include <vector>

#include <Eigen/Core>

#include "pads/press_iterate.h"

namespace thenar {

/// Updates the contact forces by the augmented Lagrangian: from the forces of the last iterate, the
/// gaps and the slips. At a solution they equal those of the last iterate.
/// Sources: [AlartCurnier1991], [SimoLaursen1992].
void update_contacts(PressIterate& iterate);

/// Returns the normal forces on the surface nodes [N] (3, nodes).
[[nodiscard]] Eigen::Matrix3Xd normal_forces(const PressIterate& iterate);

/// Action that follows the assessment of an iterate: take a step, evaluate again because the object
/// was moved, or end.
enum class IterateAction { kStep, kMoved, kEnded };

/// Updates the contacts and measures the residual. Accepts a converged iterate, and moves an object
/// that seeks a force to where it touches.
/// @param u  displacements of all nodes [m] (3, nodes)
[[nodiscard]] IterateAction assess_iterate(PressIterate& iterate, const Eigen::Matrix3Xd& u,
                                           PressOutcome& out);

/// Returns the symmetric stiffness of a node's contact by its own motion, which is added to the
/// tangent [N/m] (3, 3). The dependence of friction on the normal force, which is not symmetric, is
/// left out.
[[nodiscard]] Eigen::Matrix3d own_stiffness(const PressIterate& iterate, std::size_t k);
/// Adds own_stiffness() of all nodes to the tangent.
void add_own_stiffness(PressIterate& iterate);

/// Returns the loss of friction on a touching node as it moves and loses normal force [N] (3). The
/// slope of sliding friction is that of [HueeberStadlerWohlmuth2008], without which nodes alternate
/// between stick and slip.
/// @param moved  motion of the node [m] (3)
/// @param lost   normal force lost [N]
[[nodiscard]] Eigen::Vector3d lost_friction(const PressIterate& iterate, std::size_t k,
                                            const Eigen::Vector3d& moved, double lost);

/// Returns the loss of contact forces as nodes move [N] (3, nodes); symmetric without slip.
/// @param moved  motion of the nodes [m] (3, nodes)
[[nodiscard]] Eigen::Matrix3Xd contact_force_loss(const PressIterate& iterate,
                                                  const Eigen::Matrix3Xd& moved);

enum class ContactState { kOpen, kSticks, kSlips };

/// Returns the contact state of each surface node.
[[nodiscard]] std::vector<ContactState> contact_states(const PressIterate& iterate);
/// Returns whether a node slides under friction.
[[nodiscard]] bool has_sliding_nodes(const PressIterate& iterate);

}  // namespace thenar
