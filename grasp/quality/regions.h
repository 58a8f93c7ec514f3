#pragma once

/// Which points of contact belong together.

#include <vector>

#include "grasp/contact/contact.h"

namespace thenar {

/// Numbers of regions, 0, 1, .. in the order of their first points: points with one `patch` >= 0
/// share a number, and so do points without one that stand at one place (within 1e-9 of the
/// farthest point's distance from the first) with one normal (within 1e-9).
[[nodiscard]] std::vector<int> regions(const std::vector<Contact>& contacts);

}  // namespace thenar
