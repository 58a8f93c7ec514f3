#pragma once

/// Mesh files named in robot files: finding them, and reading them as shapes.

#include <string>
#include <vector>

#include "data/io/mesh/mesh_file.h"
#include "geometry/shape_spec.h"

namespace thenar::internal {

/// Finds a mesh file named in a robot file: a plain path, file://, package://NAME/.. or
/// model://NAME/.. It is searched beside the robot file and in all folders above; NAME may be one
/// of these folders or be in one of them. Empty if it is missing.
[[nodiscard]] std::string find_mesh(const std::string& name, const std::string& robot_file);

/// Affine map of a mesh into the frame of its shape, p -> A p + b. If A only scales, equally along
/// x, y and z, and b is zero, the shape keeps the name of its file; otherwise it is the surface
/// alone. A mirrored surface is turned right side out.
struct MeshPlacement {
  Eigen::Matrix3d A = Eigen::Matrix3d::Identity();  // [m] per unit of the file (3, 3)
  Eigen::Vector3d b{0, 0, 0};                       // [m] (3)
};

/// The robot file and the reader of its meshes; both must outlive it.
struct NamedMeshes {
  const std::string& robot_file;
  MeshReader& reader;
};

/// Reads the mesh of a name in the robot file into `shape`, whose X_BS is the pose of the file's
/// frame.
/// @returns false if the file is missing or cannot be read; `warnings` then say that `link` lacks
///         it.
[[nodiscard]] bool try_mesh(ShapeSpec& shape, const std::string& name,
                            const MeshPlacement& placement, const NamedMeshes& from,
                            const std::string& link, std::vector<std::string>& warnings);

}  // namespace thenar::internal
