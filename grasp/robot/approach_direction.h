#pragma once

/// Direction of approach of a hand, from the axes about which its digits close and from flat faces.

#include <optional>

#include <Eigen/Core>

namespace thenar {

/// Directions defined by the axes of rotation or translation of closing digits.
struct ClosingAxes {
  std::optional<Eigen::Vector3d> normal;  // normal to all axes, where they span a plane, unit (3)
  /// Common direction of all axes, where they are parallel, unit (3).
  std::optional<Eigen::Vector3d> line;
};

/// Finds out if axes are parallel, or span a plane. Signs of axes do not matter.
/// @param axes  unit vectors (3, axes)
[[nodiscard]] ClosingAxes find_closing_axes(const Eigen::Matrix3Xd& axes);

/// Finds the direction near a rough one in which flat faces are oriented; if a line is given, a
/// direction along a face counts too. Returns nothing if no face of at least 1/20 of the area is
/// near enough, or if two of similar area disagree, like those of a rounded surface.
/// @param faces   outward normals times areas (3, faces) [m^2]
/// @param cosine  minimum cosine to the rough direction
/// @param line    unit line to which the result is perpendicular; nothing: any direction (3)
[[nodiscard]] std::optional<Eigen::Vector3d> facing_direction(
    const Eigen::Matrix3Xd& faces, const Eigen::Vector3d& rough, double cosine,
    const std::optional<Eigen::Vector3d>& line);

/// Returns the unit component of a direction perpendicular to a line; the direction itself if that
/// vanishes. (3)
[[nodiscard]] Eigen::Vector3d perpendicular_direction(const Eigen::Vector3d& direction,
                                                      const Eigen::Vector3d& line);

/// Removes the rounding of a file's numbers: returns an axis of the frame if the direction is
/// within 1e-5 rad of it, otherwise the direction. (3)
[[nodiscard]] Eigen::Vector3d snap_to_axis(const Eigen::Vector3d& direction);

}  // namespace thenar
