#pragma once

/// Blocks that pages of pads share.

#include <string>
#include <vector>

#include "report/json.h"

namespace thenar {

/// Returns a banner with the outcome of a result and its warnings.
/// @param refusal   why the result is incomplete; empty: it is complete
/// @param warnings  doubts and assumptions
/// @param title     title of a complete result
[[nodiscard]] Json pad_banner(const std::string& refusal, const std::vector<std::string>& warnings,
                              const std::string& failed_title, const std::string& title);

}  // namespace thenar
