#pragma once

/// Drives whose targets are tables over time.

#include <string>
#include <vector>

#include "data/io/scene/scene.h"
#include "dynamics/stepping/moving_scene.h"

namespace thenar {

/// Where a coordinate is to be over time: straight between rows, constant before the first and
/// after the last. Two rows of one time are a jump.
struct TargetTable {
  Eigen::VectorXd time;    // never falling [s] (rows)
  Eigen::VectorXd target;  // [rad] or [m] (rows)
};

/// Reads the column of a drive from a table as CSV: it is called after the drive's name with its
/// unit, "wrist_deg". Others may belong to other drives.
/// @throws DataError as parse_time_table(), or if there is no such column, or it has two units.
[[nodiscard]] TargetTable parse_target_table(const std::string& text, const std::string& path,
                                             const SceneDriveSpec& drive);

/// A drive as several, one after the other, with a target that moves on evenly in each:
///   target(t) = target_k + (target_k+1 - target_k) (t - t_k) / (t_k+1 - t_k),   t_k <= t < t_k+1.
/// @param drive  its `target` and `speed` mean nothing
[[nodiscard]] std::vector<SceneDrive> follow_table(const SceneDrive& drive,
                                                   const TargetTable& table);

}  // namespace thenar
