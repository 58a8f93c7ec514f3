#pragma once

#include <string>
#include <vector>

#include "sampling/ranks.h"

namespace thenar::internal {

/// The strings of all ranks, in their order; every rank gets all of them.
[[nodiscard]] std::vector<std::string> gather_bytes(const Ranks& ranks, const std::string& mine);

}  // namespace thenar::internal
