#pragma once

/// Tensions of many muscles on rigid tendons, computed together.

#include <memory>
#include <vector>

#include "tendons/muscle/contraction.h"

namespace thenar {

/// Returns a solver for rigid_tendon_tension() and rigid_tendon_derivatives() of all muscles. It
/// caches the terms that depend on lengths alone.
[[nodiscard]] std::unique_ptr<TensionSolver> rigid_tensions(
    const std::vector<Musculotendon>& muscles, const HillOptions& options);

}  // namespace thenar
