#pragma once

/// The demo's look at grasping.

#include <string>

#include <nlohmann/json.hpp>

#include "base/progress.h"

namespace thenar {

/// Lets three hands go at two objects, a few seconds' work, and writes their comparison as
/// OUTPUT/hands.html. Returns the section that tells of it and leads there.
/// @param data  folder with robots/ and objects/
[[nodiscard]] nlohmann::json compare_hands(const std::string& data, const std::string& output,
                                           const Progress& progress);

}  // namespace thenar
