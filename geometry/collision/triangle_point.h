#pragma once

/// Points and halves of triangles.

#include <array>

#include <Eigen/Core>

namespace thenar {

/// The point of a triangle nearest to p; the triangle may be a segment or a point.
/// @param corners  columns [m] (3, 3);  @param p  [m] (3)
[[nodiscard]] Eigen::Vector3d nearest_in_triangle(const Eigen::Matrix3d& corners,
                                                  const Eigen::Vector3d& p);

/// The point of a segment nearest to p; its ends may coincide.
[[nodiscard]] Eigen::Vector3d nearest_in_segment(const Eigen::Vector3d& from,
                                                 const Eigen::Vector3d& to,
                                                 const Eigen::Vector3d& p);

/// The two halves of a triangle cut across its longest side. @param corners  columns [m] (3, 3)
[[nodiscard]] std::array<Eigen::Matrix3d, 2> halves(const Eigen::Matrix3d& corners);

}  // namespace thenar
