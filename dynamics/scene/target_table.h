#pragma once

/// Drives whose targets are tables over time.

#include <string>
#include <vector>

#include "data/io/scene/scene.h"
#include "dynamics/stepping/moving_scene.h"

namespace thenar {

/// Reads the column of a drive from a table as CSV: it is called after the drive's name with its
/// unit, "wrist_deg". Others may belong to other drives.
/// @throws DataError as parse_time_table(), or if there is no such column, or it has two units.
[[nodiscard]] TargetTable parse_target_table(const std::string& text, const std::string& path,
                                             const SceneDriveSpec& drive);

/// A table without the knots that lie on a straight line through their neighbours, to some last
/// bits: no step needs to end there.
[[nodiscard]] TargetTable without_straight_knots(const TargetTable& table);

}  // namespace thenar
