#pragma once

/// Poses and shapes in data files; their keys are in docs/data_format.md.

#include <string>
#include <vector>

#include "base/spatial.h"
#include "data/io/toml_table.h"
#include "geometry/shape_spec.h"

namespace thenar {

/// `position` with `rotation` (three rows), `quaternion_wxyz`, `rpy`, or `axis` and `angle`: keys
/// of the table that stands there. The identity if there is none.
/// @throws DataError if a rotation is none, or given twice.
[[nodiscard]] Pose<double> read_pose_keys(TomlTable& table);

/// A [[shape]]. @param path  of the file it stands in, beside which meshes are found
/// @throws DataError if a key, a size or the mesh is wrong.
[[nodiscard]] ShapeSpec read_shape_table(TomlTable& table, const std::string& path);

/// `key = value` each, without loss; what the readers assume anyway is left out. A mesh with a file
/// is named, others are written out.
[[nodiscard]] std::vector<std::string> toml_of(const Pose<double>& X);
[[nodiscard]] std::vector<std::string> toml_of(const ShapeSpec& shape);

}  // namespace thenar
