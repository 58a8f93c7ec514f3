#pragma once

/// Poses and shapes in data files; docs/data_format.md describes their keys.

#include <string>
#include <vector>

#include "base/provenance.h"
#include "base/spatial.h"
#include "data/io/toml_table.h"
#include "geometry/shape_spec.h"

namespace thenar {

/// Reads a pose from keys of a table: `position` with `rotation` (three rows), `quaternion_wxyz`,
/// `rpy`, or `axis` and `angle`. The identity if there are none.
/// @throws DataError if a rotation is invalid, or given twice.
[[nodiscard]] Pose<double> read_pose_keys(TomlTable& table);

/// Reads a [[shape]]. @param path  of the file, beside which its meshes are
/// @throws DataError if a key, a size or the mesh is wrong.
[[nodiscard]] ShapeSpec read_shape_table(TomlTable& table, const std::string& path);

/// Returns the mesh files of shapes that read_shape_table() read. @param path  of the file that
/// names them
/// @throws DataError if one of them is gone.
[[nodiscard]] FileDigests mesh_files(const std::vector<ShapeSpec>& shapes, const std::string& path);

/// Returns the lines `key = value` of a pose or shape, without loss; defaults of the readers are
/// left out. A mesh with a file is named, others are written out.
[[nodiscard]] std::vector<std::string> toml_of(const Pose<double>& X);
[[nodiscard]] std::vector<std::string> toml_of(const ShapeSpec& shape);

}  // namespace thenar
