#pragma once

/// Tensions of many muscles on rigid tendons at once.

#include <memory>
#include <vector>

#include "tendons/muscle/contraction.h"

namespace thenar {

/// rigid_tendon_tension() and rigid_tendon_derivatives() of all muscles. What depends on lengths
/// alone is kept while they stay.
[[nodiscard]] std::unique_ptr<TensionSolver> rigid_tensions(
    const std::vector<Musculotendon>& muscles, const HillOptions& options);

}  // namespace thenar
