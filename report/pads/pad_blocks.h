#pragma once

/// Blocks that pages of pads share.

#include <string>
#include <vector>

#include "report/json.h"

namespace thenar {

/// Returns a banner with the ending of an answer, and its warnings.
/// @param refusal   why it is not the whole answer; empty: it is
/// @param warnings  doubts and assumptions
/// @param title     if it is
[[nodiscard]] Json pad_banner(const std::string& refusal, const std::vector<std::string>& warnings,
                              const std::string& failed_title, const std::string& title);

}  // namespace thenar
