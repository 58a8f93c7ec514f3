#pragma once

/// Area of a patch of contact, as a continuous function of pressure and gap.

#include <array>
#include <vector>

#include "pads/press_step.h"

namespace thenar {

/// Deformed area of the patch [m^2]. Its edge is found between nodes that touch and nodes that do
/// not, by the pressure of the ones and the gap of the others: at a distance s within and beyond a
/// sharp edge of frictionless contact, pressure is A sqrt(s) and the gap 4 A / (3 E*) s^(3/2),
/// with E* = 2 mu / (1 - nu). Sides of cells cross it obliquely, in proportion to the cosine c of
/// their angle with its normal, so that their length across it is the integral of c^2 over that of
/// c, pi / 4, of the whole. Around a node alone, or a single row of nodes, the patch is Hertz's
/// strip. Nodes at the edge get how far inside of it they are, the mean over their sides, other
/// nodes 1 or -1; the patch is where a function that runs linearly between nodes is above 0.
/// Hertz's circle is met within 3 % (a radius of 5 cells) and 6 % (1.6 to 4 cells), where shares
/// of nodes that touch are 15 to 50 % too large. Where tissue is stretched, mu is that of its
/// tangent, instantaneous.
///
/// Where an edge of the object lies over a face, points of the skin count that are inside of the
/// object, or that face it and are nearer to it than  p h / 12 mu,  by which the patch of a cube
/// is within 3 % of that of finer meshes.
/// @param tissues  of the regions of the mesh
/// @param skin     whether a node is on the surface that may touch (nodes of the mesh)
/// Source: [Johnson1985] sec. 4.2 for pressure, sec. 5.1 for the edge.
[[nodiscard]] double contact_area(const HexMesh& mesh, const TissueBody& body,
                                  const std::vector<Tissue>& tissues, const std::vector<bool>& skin,
                                  const ContactSurface& surface, const RigidObject& object,
                                  const PressState& state);

/// Share of a triangle where a linear function is above 0 [1].
/// @param values  at its corners, not all 0
[[nodiscard]] double positive_share(const std::array<double, 3>& values);

}  // namespace thenar
