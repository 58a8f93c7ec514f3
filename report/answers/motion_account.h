#pragma once

/// Reliability of a motion, as words and fields.

#include <vector>

#include "api/scenes/scene_account.h"
#include "report/fields.h"

namespace thenar {

/// Returns each with `joint` and `beyond`, in rad or m.
[[nodiscard]] std::vector<Fields> limit_fields(const std::vector<PassedLimit>& limits);

/// Returns a table with a row for each measure of how far a run is to be believed.
[[nodiscard]] Table account_table(const SceneResult& scene);

}  // namespace thenar
