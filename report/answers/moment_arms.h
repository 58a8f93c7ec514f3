#pragma once

/// Moment arms and length changes of tendons as words, JSON and rows.

#include <string>

#include "api/moment_arms.h"
#include "report/fields.h"

namespace thenar {

[[nodiscard]] std::string text_of(const MomentArmResult& answer);
[[nodiscard]] Fields fields_of(const MomentArmResult& answer);
/// Returns a table with a row for each muscle at each posture.
[[nodiscard]] Table table_of(const MomentArmResult& answer);

/// Returns the positive sense of each joint: "flexion + at MCP3_FE, PIP3; abduction + at MCP3_AA".
[[nodiscard]] std::string sign_words(const std::vector<std::string>& joints);

/// Returns the posture of zero length change in words: "with all joints at 0", or its angles.
[[nodiscard]] std::string reference_words(const MomentArmResult& answer);

}  // namespace thenar
