#pragma once

/// Reliability of a motion, as words and fields.

#include <vector>

#include "api/scenes/scene_account.h"
#include "report/fields.h"

namespace thenar {

/// Returns the fields `joint` and `beyond` of each exceeded limit [rad] or [m].
[[nodiscard]] std::vector<Fields> limit_fields(const std::vector<PassedLimit>& limits);

/// Returns a table with a row for each measure of a run's reliability.
[[nodiscard]] Table account_table(const SceneResult& scene);

}  // namespace thenar
