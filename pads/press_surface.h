#pragma once

/// Skin of a pressed pad: deformed positions, pressure and contact states.

#include <array>
#include <vector>

#include <Eigen/Core>

namespace thenar {

class PadPress;

/// Contact state of a node of the skin: open, sticking or slipping.
enum class SkinContact : unsigned char { kFree, kSticks, kSlips };

/// Skin at one instant, in the pad's frame.
struct PressedSkin {
  Eigen::Matrix3Xd places;                // deformed positions of nodes [m] (3, nodes)
  Eigen::Matrix3Xd at_rest;               // rest positions of the same nodes [m] (3, nodes)
  std::vector<std::array<int, 4>> faces;  // quadrilaterals, corners in order around them
  Eigen::VectorXd pressure;               // normal force over the node's area of deformed faces;
                                          // hanging nodes: mean of their masters [Pa] (nodes)
  Eigen::VectorXd normal;                 // normal force, 0 on hanging nodes [N] (nodes)
  std::vector<SkinContact> contact;       // (nodes)
};

/// Renumbers the nodes of faces in the order in which the faces list them.
/// @param nodes  number of nodes before
/// @return old numbers of the nodes of the faces
[[nodiscard]] std::vector<int> renumber(std::vector<std::array<int, 4>>& faces, int nodes);

/// Returns the skin at the present state of a press. A node's area is a quarter of each of its
/// deformed faces, as of node_areas(); areas of hanging nodes are assigned to their masters.
/// @param friction  Coulomb coefficient of the object [1]
[[nodiscard]] PressedSkin pressed_skin(const PadPress& press, double friction);

}  // namespace thenar
