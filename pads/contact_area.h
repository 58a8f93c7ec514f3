#pragma once

/// Area of a patch of contact, as a continuous function of pressure and gap.

#include <array>
#include <vector>

#include "pads/press_step.h"

namespace thenar {

/// Deformed area of the patch [m^2]. On each face a function runs linearly between nodes: pressure
/// over  20 mu / h  where a node touches, minus the gap where it does not; the patch is where it is
/// above 0. So the area moves while its edge is between nodes, as fits need it.
///
/// At a distance s within and beyond a sharp edge of frictionless contact, pressure is A sqrt(s)
/// and the gap 4 A / (3 E*) s^(3/2), with E* = 4 mu of an incompressible body: 6 mu / h would put
/// an edge right that lies half-way between two nodes at the distance h. Forces on nodes blur
/// edges, and that area is 8 to 16 % too large; with 20 mu / h it is off by -3 to 7 % for Hertz's
/// circle of 3 to 4 cells radius, while the shares of nodes that touch are 15 to 50 % too large.
/// Where tissue is stretched, mu is that of its tangent, instantaneous.
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
