#pragma once

/// Parts of a triangle below the planes of a convex object, and the ridges between them.

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include <Eigen/Core>

namespace thenar::internal {

/// Convex part of a triangle.
struct TrianglePart {
  std::array<Eigen::Vector3d, 16> corners;  // barycentric coordinates of the corners [1]: 3, and at
                                            // most one more for each of 8 planes
  std::size_t size = 0;                     // number of corners
  /// Appends a corner; ignores it if there are 16. By rounding a plane may cross the boundary of a
  /// sliver more than twice, whose further corners make no difference.
  void add(const Eigen::Vector3d& p) {
    if (size < corners.size()) corners[size++] = p;
  }
};

[[nodiscard]] TrianglePart whole_triangle();

/// Returns the part where a linear function is 0 or more.
/// @param values  function at the triangle's corners (3)
[[nodiscard]] TrianglePart clipped(const TrianglePart& part, const Eigen::Vector3d& values);

/// Returns the area of a triangle of barycentric coordinates, over that of the whole [1].
[[nodiscard]] double area_share(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                const Eigen::Vector3d& c);
[[nodiscard]] double area_share(const TrianglePart& part);

/// Calls a function with the Gauss points of a part and their weights, shares of the triangle [1].
/// The rule is exact for products of two linear functions.
template <class Call>
void for_each_gauss_point(const TrianglePart& part, const Call& call) {
  for (std::size_t i = 1; i + 1 < part.size; ++i) {
    const std::array<Eigen::Vector3d, 3> fan{part.corners[0], part.corners[i], part.corners[i + 1]};
    const double share = area_share(fan[0], fan[1], fan[2]) / 3;
    for (const Eigen::Vector3d& corner : fan)
      call(Eigen::Vector3d((fan[0] + fan[1] + fan[2]) / 6 + corner / 2), share);
  }
}

/// Distances of a triangle's corners to a plane, and the plane's normal.
struct TrianglePlane {
  Eigen::Vector3d values;  // [m] (3)
  Eigen::Vector3d normal;
};

/// Part of a ridge between two planes that lies over the triangle, inside the object. Lengths are
/// in barycentric coordinates, in which the triangle has the area 1/2.
struct PlaneRidge {
  std::array<Eigen::Vector3d, 2> points;  // Gauss points, exact for products of three functions
  double length = 0;                      // [1]
  double difference_slope = 0;            // slope of the planes' difference across the ridge [m]
};

/// Planes of a convex object over a triangle. Inside the object, the distance to the object is the
/// largest signed distance to its planes.
class TrianglePlanes {
 public:
  /// Starts with the distinct planes at the corners.
  void reset(const std::array<TrianglePlane, 3>& corner_planes);
  void add(const TrianglePlane& plane) { planes_.push_back(plane); }

  /// Computes the part of the triangle where each plane is inside and has the largest distance.
  void update_parts();
  /// Removes planes without a part, which touch the edge between two others.
  void remove_empty_parts();

  [[nodiscard]] std::size_t size() const { return planes_.size(); }
  [[nodiscard]] const TrianglePlane& plane(std::size_t p) const { return planes_[p]; }
  [[nodiscard]] const TrianglePart& part(std::size_t p) const { return parts_[p]; }

  /// Returns the ridge between two planes; none if no part of it is inside the object, or another
  /// plane has a larger distance.
  [[nodiscard]] std::optional<PlaneRidge> ridge(std::size_t p, std::size_t q) const;

 private:
  std::vector<TrianglePlane> planes_;
  std::vector<TrianglePart> parts_;
};

}  // namespace thenar::internal
