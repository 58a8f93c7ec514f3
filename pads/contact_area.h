#pragma once

/// Area of a contact patch as a continuous function of pressure and gap.

#include <array>
#include <vector>

#include "pads/press_step.h"

namespace thenar {

/// Returns the deformed area of the patch [m^2].
///
/// The edge of the patch lies between touching and open nodes, at a distance that follows from the
/// pressure of the former and the gap of the latter: at a distance s within and beyond a sharp edge
/// of frictionless contact, pressure is A sqrt(s) and the gap 4 A / (3 E*) s^(3/2), with
/// E* = 2 mu / (1 - nu). Sides of cells cross the edge obliquely, in proportion to the cosine c of
/// their angle with its normal, so their mean length across it is the integral of c^2 over that of
/// c, pi / 4 of the whole. Around a single node or row of nodes the patch is Hertz's strip. Nodes
/// at the edge get their depth inside the patch, the mean over their sides; other nodes get 1 or
/// -1. The patch is where the linear interpolation between nodes is above 0. The area of Hertz's
/// circle is met within 3 % (a radius of 5 cells) and 6 % (1.6 to 4 cells), where the areas of
/// touching nodes are 15 to 50 % too large. In stretched tissue, mu is that of the instantaneous
/// tangent.
///
/// Where an edge of the object lies over a face, the area is that of sampled points of the skin
/// that are inside the object, or that face it and are nearer to it than  p h / 12 mu.  The patch
/// of a cube is within 3 % of that on finer meshes.
/// @param tissues  tissues of the regions of the mesh
/// @param skin     whether a node is on the surface that may touch (nodes of the mesh)
/// Source: [Johnson1985] sec. 4.2 for pressure, sec. 5.1 for the edge.
[[nodiscard]] double contact_area(const HexMesh& mesh, const TissueBody& body,
                                  const std::vector<Tissue>& tissues, const std::vector<bool>& skin,
                                  const ContactSurface& surface, const RigidObject& object,
                                  const PressState& state);

/// Returns the share of a triangle where a linear function is above 0 [1].
/// @param values  function at the corners, not all 0
[[nodiscard]] double positive_share(const std::array<double, 3>& values);

}  // namespace thenar
