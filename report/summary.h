#pragma once

/// Summary of a thing and its content, in a line.

#include <string>

#include "api/named/things.h"

namespace thenar {

/// Returns the kind, name and content: "subject 'an_chao_middle': 5 segments, 4 joints, 6 muscles,
/// 1 digit (middle)".
[[nodiscard]] std::string summary_of(const Thing& thing);

}  // namespace thenar
