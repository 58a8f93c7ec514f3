#pragma once

/// Augmented contact laws of nodes, and their slopes.

#include <vector>

#include <Eigen/Core>

#include "pads/press_iterate.h"

namespace thenar {

/// Sets the forces that the laws of contact make of the last ones, of gaps and of slips: at an
/// answer they are the last ones. Sources: [AlartCurnier1991], [SimoLaursen1992].
void find_contacts(PressIterate& at);

/// Forces along normals on nodes of the surface [N] (3, nodes).
[[nodiscard]] Eigen::Matrix3Xd normal_forces(const PressIterate& at);

/// Way on from an iterate: by a step, from where the object was moved to, or nowhere.
enum class IterateTurn { kStep, kMoved, kEnded };

/// Finds contacts and measures what is out of balance: ends what is solved, and moves an object
/// that seeks a force to where it touches.
/// @param u  displacements of all nodes [m] (3, nodes)
[[nodiscard]] IterateTurn judge_iterate(PressIterate& at, const Eigen::Matrix3Xd& u,
                                        PressOutcome& out);

/// Part of the slope of contact forces that a factor takes: a node's own, less the friction that a
/// normal force brings, which is not symmetric [N/m] (3, 3).
[[nodiscard]] Eigen::Matrix3d own_slope(const PressIterate& at, std::size_t k);
/// Adds it of all nodes to the tangent.
void add_own_slopes(PressIterate& at);

/// Loss of friction on a node that touches, as it moves and loses normal force [N] (3). Its slope
/// of sliding friction is that of [HueeberStadlerWohlmuth2008], without which nodes turn from stick
/// to slip and back for ever.
[[nodiscard]] Eigen::Vector3d lost_shear(const PressIterate& at, std::size_t k,
                                         const Eigen::Vector3d& moved, double lost);

/// Loss of contact forces as nodes move [N] (3, nodes); symmetric without slip.
[[nodiscard]] Eigen::Matrix3Xd contact_loss(const PressIterate& at, const Eigen::Matrix3Xd& moved);

/// State of each node: open (0), sticks (1) or slips (2).
[[nodiscard]] std::vector<int> contact_states(const PressIterate& at);
/// Returns whether friction follows normal forces somewhere.
[[nodiscard]] bool some_slip(const PressIterate& at);

}  // namespace thenar
