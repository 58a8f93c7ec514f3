#pragma once

/// Bodies of one shape, made in a program.

#include <string>

#include <Eigen/Core>

#include "data/io/world/world.h"

namespace thenar {

/// Return shapes about the origin of a body; sizes as in ShapeSpec.
[[nodiscard]] ShapeSpec box_shape(const Eigen::Vector3d& edges);       // full edges [m] (3)
[[nodiscard]] ShapeSpec ball_shape(double radius);                     // [m]
[[nodiscard]] ShapeSpec cylinder_shape(double radius, double height);  // axis along z [m]
[[nodiscard]] ShapeSpec mesh_shape(TriangleMesh mesh);  // a closed surface [m], its own frame

/// Returns a body of one shape.
/// @param mass      spread evenly over it [kg]; 0: by the density of its material, where that has
///         one
/// @param material  of built_in_materials() or of a table of the caller's
/// @throws InputError if a size or the mass is negative or not finite, a mesh is empty, or the name
///         is.
[[nodiscard]] BodySpec make_body(std::string name, ShapeSpec shape, double mass = 0,
                                 std::string material = "wood");

}  // namespace thenar
