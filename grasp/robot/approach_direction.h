#pragma once

/// Direction of approach of a hand, by the axes about which its digits close and by flat faces.

#include <optional>

#include <Eigen/Core>

namespace thenar {

/// Directions that follow from the axes or slides of closing digits.
struct ClosingAxes {
  std::optional<Eigen::Vector3d> normal;  // across all of them, where they span a plane, unit (3)
  std::optional<Eigen::Vector3d> line;    // along all of them, where they are parallel, unit (3)
};

/// Finds whether axes are parallel, or span a plane. Signs of axes do not matter.
/// @param axes  unit vectors (3, axes)
[[nodiscard]] ClosingAxes find_closing_axes(const Eigen::Matrix3Xd& axes);

/// The direction near a rough one in which flat faces look; across a line, one along a face does,
/// too. Nothing where no face of a twentieth of the area is that near, or two of similar area
/// disagree, as those of a rounded surface.
/// @param faces   outward normals times areas (3, faces) [m^2]
/// @param cosine  least cosine to the rough direction
/// @param line    unit, across which the direction lies; nothing: any direction (3)
[[nodiscard]] std::optional<Eigen::Vector3d> facing_direction(
    const Eigen::Matrix3Xd& faces, const Eigen::Vector3d& rough, double cosine,
    const std::optional<Eigen::Vector3d>& line);

/// The part of a direction across a line, unit; the direction itself where nothing is left. (3)
[[nodiscard]] Eigen::Vector3d across(const Eigen::Vector3d& direction, const Eigen::Vector3d& line);

/// The direction without the rounding of a file's numbers: an axis of the frame within 1e-5 rad.
/// (3)
[[nodiscard]] Eigen::Vector3d without_rounding(const Eigen::Vector3d& direction);

}  // namespace thenar
