#pragma once

/// A solid body as its signed distance.

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace thenar {

/// Nearest surface as seen from a point.
struct NearestSurface {
  double distance;         // of the point to the surface, negative inside [m]
  Eigen::Vector3d normal;  // unit, outward: gradient of the distance (3)
  bool supports = false;   // no part of the solid lies beyond the plane  n . (q - p) = -distance:
                           // its distance from any q is at least  distance + n . (q - p)
};

/// A closed solid in a frame of its own.
///
/// The distance is exact to `accuracy()` and changes by no more than the way gone
/// (|d(p) - d(q)| <= |p - q| + 2 accuracy), on which every search for contacts leans. Inside a
/// cavity that is open to the outside a point is outside.
class Shape {
 public:
  virtual ~Shape() = default;

  /// Signed distance of a point, negative inside [m]. @param p  (3) [m]
  [[nodiscard]] virtual double distance(const Eigen::Vector3d& p) const = 0;

  /// Distance and outward normal. Where several surface points are nearest, one of them counts.
  [[nodiscard]] virtual NearestSurface nearest(const Eigen::Vector3d& p) const = 0;

  /// A box that holds the solid [m].
  [[nodiscard]] virtual Eigen::AlignedBox3d bounds() const = 0;

  /// Largest error of distance() anywhere [m]; 0: rounding only. Inside unions the depth is a lower
  /// bound, whatever this says.
  [[nodiscard]] virtual double accuracy() const { return 0; }
};

}  // namespace thenar
