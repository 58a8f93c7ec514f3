#pragma once

/// Convex polyhedra: clipping by planes, intersections and mass moments.

#include <vector>

#include <Eigen/Geometry>

#include "geometry/mass_properties.h"

namespace thenar {

/// Additive moments at unit density about the origin of their frame.
struct Moments {
  double volume = 0;                                 // [m^3]
  Eigen::Vector3d first{0, 0, 0};                    // integral of x [m^4] (3)
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();  // integral of x x^T [m^5] (3, 3)

  Moments& operator+=(const Moments& other);
  Moments& operator-=(const Moments& other);
};

/// Converts mass properties at unit density to moments.
[[nodiscard]] Moments moments_of(const MassProperties& mass);
/// Converts moments to mass properties at unit density.
[[nodiscard]] MassProperties mass_of(const Moments& moments);

/// The half space  n . x <= offset.
struct HalfSpace {
  Eigen::Vector3d n;  // unit (3)
  double offset = 0;  // [m]
};

/// A convex polyhedron by its faces, each a convex polygon, counterclockwise seen from outside.
struct ConvexBody {
  std::vector<std::vector<Eigen::Vector3d>> faces;  // corners of each face [m]
  std::vector<HalfSpace> sides;                     // half-spaces whose intersection it is
  Eigen::AlignedBox3d box;                          // bounding box [m]

  [[nodiscard]] bool empty() const { return faces.size() < 4; }
};

/// Returns a box as a polyhedron.
[[nodiscard]] ConvexBody convex_box(const Eigen::AlignedBox3d& box);

/// Converts a mesh to a polyhedron. @param mesh  watertight, outward
/// @return empty if it is not convex: if a corner is more than 1e-6 of the extent, the rounding of
/// files in single precision, above the plane of a triangle; or if it has more than 3e7 pairs of
/// corners and triangles.
[[nodiscard]] ConvexBody convex_body(const TriangleMesh& mesh);

/// Removes the part outside of a half space, unless it is less than `tolerance` high [m].
void clip(ConvexBody& body, const HalfSpace& side, double tolerance);

/// Computes the intersection of two polyhedra.
[[nodiscard]] ConvexBody intersection(const ConvexBody& a, const ConvexBody& b, double tolerance);

/// Computes the moments of a polyhedron.
[[nodiscard]] Moments moments_of(const ConvexBody& body);

/// Result of union_moments().
struct UnionMoments {
  Moments moments;       // moments; zero unless complete
  bool complete = true;  // false: the limit of work was reached
  double work = 0;       // number of faces processed [1]
};

/// Computes the moments of the union of polyhedra, exact to rounding:
///   m(P_1 u .. u P_n) = sum_i m(P_i less all P_j with j < i),
/// each difference as convex pieces that share only faces. Thus n coincident bodies cost n
/// comparisons, and others no more pieces than those into which the planes of all bodies divide
/// space.
/// @param max_work  approximate limit of processed faces; 1e6 take some tenths of a second
/// @throws Stopped where end_if_stopped() does
[[nodiscard]] UnionMoments union_moments(const std::vector<ConvexBody>& bodies, double tolerance,
                                         double max_work);

}  // namespace thenar
