#pragma once

/// Convex polyhedra: cuts by planes, intersections and mass moments.

#include <vector>

#include <Eigen/Geometry>

#include "geometry/mass_properties.h"

namespace thenar {

/// Moments at unit density about the origin of their frame; they add up.
struct Moments {
  double volume = 0;                                 // [m^3]
  Eigen::Vector3d first{0, 0, 0};                    // integral of x [m^4] (3)
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();  // integral of x x^T [m^5] (3, 3)

  Moments& operator+=(const Moments& other);
  Moments& operator-=(const Moments& other);
};

[[nodiscard]] Moments moments_of(const MassProperties& mass);
[[nodiscard]] MassProperties mass_of(const Moments& moments);

/// The half space  n . x <= offset.
struct HalfSpace {
  Eigen::Vector3d n;  // unit (3)
  double offset = 0;  // [m]
};

/// A convex polyhedron by its faces, each a convex polygon, counterclockwise seen from outside.
struct ConvexBody {
  std::vector<std::vector<Eigen::Vector3d>> faces;  // corners [m]
  std::vector<HalfSpace> sides;                     // whose intersection it is
  Eigen::AlignedBox3d box;

  [[nodiscard]] bool empty() const { return faces.size() < 4; }
};

[[nodiscard]] ConvexBody convex_box(const Eigen::AlignedBox3d& box);

/// The polyhedron of a mesh. @param mesh  watertight, outward
/// @return empty if it is not convex: if a corner stands more than 1e-6 of the extent, which is
/// what files of single precision leave, above the plane of a triangle; or if it has more than 3e7
/// pairs of both.
[[nodiscard]] ConvexBody convex_body(const TriangleMesh& mesh);

/// Cuts off the part outside of a half space, unless it is less than `tolerance` high [m].
void cut(ConvexBody& body, const HalfSpace& side, double tolerance);

/// The intersection of two polyhedra.
[[nodiscard]] ConvexBody intersection(const ConvexBody& a, const ConvexBody& b, double tolerance);

[[nodiscard]] Moments moments_of(const ConvexBody& body);

struct UnionMoments {
  Moments moments;       // of nothing unless complete
  bool complete = true;  // false: there were too many cuts to make
  double work = 0;       // faces that were looked at [1]
};

/// Moments of the union of some polyhedra, exact to rounding:
///   m(P_1 u .. u P_n) = sum_i m(P_i less all P_j with j < i),
/// each difference as convex pieces that share no more than faces. So n bodies that coincide cost n
/// looks at each other, and others no more pieces than the planes of all cut space into.
/// @param most  faces that may be looked at, about; 1e6 take some tenths of a second
/// @throws Stopped where end_if_stopped() does
[[nodiscard]] UnionMoments union_moments(const std::vector<ConvexBody>& bodies, double tolerance,
                                         double most);

}  // namespace thenar
