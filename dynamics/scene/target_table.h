#pragma once

/// Reads target tables of drives over time.

#include <string>

#include "data/io/scene/scene.h"
#include "dynamics/stepping/moving_scene.h"

namespace thenar {

/// Reads the target of a drive from a CSV table over time. Its column is named after the drive and
/// a unit, "wrist_deg"; other columns may belong to other drives.
/// @throws DataError as parse_time_table(), or if the drive has no column or columns in two units,
/// two rows are closer in time than the shortest step, or a target is too large.
[[nodiscard]] TargetTable parse_target_table(const std::string& text, const std::string& path,
                                             const SceneDriveSpec& drive);

/// Returns the table without knots that lie, up to rounding, on a straight line through their
/// neighbours, so that no step has to end there.
[[nodiscard]] TargetTable without_straight_knots(const TargetTable& table);

}  // namespace thenar
