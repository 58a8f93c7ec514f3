#pragma once

/// A string of beads that contracts over surfaces: slow, but it finds its way from anywhere.

#include <vector>

#include "tendons/wrapping/path_newton.h"

namespace thenar {

/// Replaces `chain` by the arcs where a string from a to b comes to rest: it starts over the side
/// of every surface and contracts, each bead to the middle of its neighbours and out of the
/// surfaces (Gauss and Seidel, over-relaxed). From a round side it may slip, as a string does. The
/// arcs are a start for straighten(), no answer; surfaces that the string leaves are left out.
/// @param a, b   world [m] (3)
/// @param sweeps  over all beads; a few hundred
/// @param chain  surfaces with their frames, in order; their arcs start at the point `side` each
void contract_beads(const Eigen::Vector3d& a, const Eigen::Vector3d& b, int sweeps,
                    std::vector<ChainArc>& chain);

}  // namespace thenar
