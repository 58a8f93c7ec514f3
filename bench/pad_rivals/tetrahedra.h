#pragma once

/// A pad of linear tetrahedra under a plane: what a plain finite-element code would do.

#include <cstddef>

#include "pads/pad_shape.h"
#include "pads/tissue.h"

namespace thenar::bench {

/// A press of tetrahedra.
struct TetrahedraPress {
  bool solved = false;
  double force = 0;  // of the plane on the pad, along -z [N]
  std::size_t elements = 0, unknowns = 0;
  int factorisations = 0;
};

/// Presses a pad from rest by a plane without friction that moves along -z to the height `plane`.
///
/// Each cell of an even mesh is cut in six tetrahedra with displacements of four nodes and one
/// quadrature point, neo-Hookean with the energies of Tissue. Newton's method to the residual that
/// PressOptions asks for; each matrix is factored by Eigen's SimplicialLDLT, whose pattern is
/// analysed once. A node that touches has its height set to that of the plane, and those that touch
/// are found by an active set: there is no penalty. Steps that fail are
/// halved. Pressure is kept apart in the tangent as our own elements do, or large steps would fail.
/// @param tissue  neo-Hookean, elastic
/// @param plane   height at the end [m]
[[nodiscard]] TetrahedraPress press_tetrahedra(const PadShape& shape, const PadCells& cells,
                                               const Tissue& tissue, double plane);

}  // namespace thenar::bench
