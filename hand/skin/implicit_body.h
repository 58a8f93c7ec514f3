#pragma once

/// Flesh as an implicit surface: rounded lumps that blend into each other.

#include <array>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace thenar {

/// Lump: a tapered capsule, flattened, or a triangle with thickness.
struct Lump {
  std::array<Eigen::Vector3d, 3> core;  // ends of the capsule, or corners of the triangle [m]
  /// Radius at either end; half thickness of a triangle: the first [m].
  std::array<double, 2> radius{0, 0};
  bool sheet = false;             // true: a triangle
  Eigen::Vector3d flat{0, 0, 1};  // unit direction in which it is flattened (3)
  double aspect = 1;              // breadth over depth, at constant area of the section [1]
  double blend = 0;               // distance within which it blends into those before it [m]
};

/// Lumps in order; each is blended with the union of those before it.
using ImplicitBody = std::vector<Lump>;

/// Computes the height of a point above the skin: zero on it, negative inside; never more than the
/// distance.
///
/// A section of mean radius r is an ellipse of semi-axes  r sqrt(aspect), r / sqrt(aspect).  Lumps
/// are joined by the polynomial smooth minimum
///   min(a, b) - h^2 k / 4,   h = max(k - |a - b|, 0) / k,
/// k the blend. Source: [Quilez2013].
/// @param p  (3) [m]
[[nodiscard]] double implicit_height(const ImplicitBody& body, const Eigen::Vector3d& p);

/// Computes a box that contains the body [m].
[[nodiscard]] Eigen::AlignedBox3d implicit_bounds(const ImplicitBody& body);

}  // namespace thenar
