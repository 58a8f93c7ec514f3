#pragma once

/// Meshes that robot files name: where they are, and as shapes.

#include <string>
#include <vector>

#include "data/io/mesh/mesh_file.h"
#include "geometry/shape_spec.h"

namespace thenar::internal {

/// A mesh file as a robot file names it: a plain path, file://, package://NAME/.. or
/// model://NAME/.. Looked for beside the robot file and from there in the folders above it; NAME
/// may be one of these folders or stand in one of them. Empty if there is none.
[[nodiscard]] std::string find_mesh(const std::string& name, const std::string& robot_file);

/// A mesh carried into the frame of its shape, p -> A p + b. Where A only scales, the same way
/// along x, y and z, and b is zero, the shape keeps the name of its file, else it is the surface
/// alone. A mirrored surface is turned right side out.
struct MeshPlacement {
  Eigen::Matrix3d A = Eigen::Matrix3d::Identity();  // [m] per unit of the file (3, 3)
  Eigen::Vector3d b{0, 0, 0};                       // [m] (3)
};

/// What reads the meshes that a robot file names.
struct NamedMeshes {
  const std::string& robot_file;
  MeshReader& reader;
};

/// A mesh, or where the file holds one exact shape (MeshContent) and is only scaled, that shape.
/// @param file  as find_mesh() gives it
/// @throws DataError if the file cannot be read.
[[nodiscard]] ShapeSpec mesh_shape(const std::string& file, const MeshPlacement& placement,
                                   MeshReader& reader);

/// mesh_shape() of a mesh by the name that a robot file gives it, put into `shape`, whose X_BS is
/// where the frame of the file stands.
/// @return false if there is no such file or it cannot be read; `warnings` then says that `link`
/// goes without it.
[[nodiscard]] bool try_mesh(ShapeSpec& shape, const std::string& name,
                            const MeshPlacement& placement, const NamedMeshes& from,
                            const std::string& link, std::vector<std::string>& warnings);

}  // namespace thenar::internal
