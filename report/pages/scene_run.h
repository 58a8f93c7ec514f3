#pragma once

/// Pages of scenes that were simulated.

#include "api/simulate_scene.h"
#include "report/blocks.h"

namespace thenar {

/// The scene in space, to be played, contact forces as arrows; energies, places and forces over
/// time.
[[nodiscard]] Json page_of(const SimulatedScene& scene);

/// Slip, penetration and energy of all runs.
[[nodiscard]] Json page_of(const SceneSweep& sweep);

}  // namespace thenar
