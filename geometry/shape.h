#pragma once

/// Solid body defined by its signed distance.

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace thenar {

/// Nearest surface as seen from a point.
struct NearestSurface {
  double distance = 0;     // distance of the point from the surface, negative inside [m]
  Eigen::Vector3d normal;  // unit, outward: gradient of the distance (3)
  bool supports = false;   // whether no part of the solid is beyond the plane  n . (q - p) =
                           // -distance: its distance from any q is at least  distance + n . (q - p)
};

/// A closed solid in a frame of its own.
///
/// The distance is exact to `accuracy()` and changes by at most the distance moved (|d(p) - d(q)|
/// <= |p - q| + 2 accuracy), on which all searches for contacts rely. A point in a cavity that is
/// open to the outside is outside.
class Shape {
 public:
  virtual ~Shape() = default;

  /// Returns the signed distance of a point, negative inside [m]. @param p  (3) [m]
  [[nodiscard]] virtual double distance(const Eigen::Vector3d& p) const = 0;

  /// Returns the distance and outward normal. If several surface points are nearest, one of them is
  /// used.
  [[nodiscard]] virtual NearestSurface nearest(const Eigen::Vector3d& p) const = 0;

  /// Returns a bounding box of the solid [m].
  [[nodiscard]] virtual Eigen::AlignedBox3d bounds() const = 0;

  /// Returns the maximum error of distance() anywhere [m]; 0: rounding only. Inside unions the
  /// depth is only a lower bound, regardless of this value.
  [[nodiscard]] virtual double accuracy() const { return 0; }
};

}  // namespace thenar
