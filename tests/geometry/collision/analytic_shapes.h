#pragma once

/// Small solids with closed-form distances, for tests of contacts.

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include <Eigen/Geometry>

#include "geometry/solid.h"

namespace thenar {

/// A shape given by its distance alone; the normal is its gradient, by central differences.
template <typename Distance>
class DistanceShape : public Shape {
 public:
  explicit DistanceShape(Distance d) : d_(std::move(d)) {}

  [[nodiscard]] double distance(const Eigen::Vector3d& p) const override { return d_(p); }
  [[nodiscard]] NearestSurface nearest(const Eigen::Vector3d& p) const override {
    constexpr double kStep = 1e-7;  // [m]
    Eigen::Vector3d g;
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d e = kStep * Eigen::Vector3d::Unit(k);
      g(k) = d_(p + e) - d_(p - e);
    }
    return {d_(p), g.norm() > 0 ? g.normalized().eval() : Eigen::Vector3d::UnitZ().eval()};
  }
  [[nodiscard]] Eigen::AlignedBox3d bounds() const override {
    return {Eigen::Vector3d::Constant(-1), Eigen::Vector3d::Constant(1)};
  }

 private:
  Distance d_;
};

/// A solid that is only asked for distances.
template <typename Distance>
Solid solid_of(Distance d) {
  return {std::make_shared<DistanceShape<Distance>>(std::move(d)), {}, {}};
}

inline Solid ball_solid(double radius) {
  return solid_of([radius](const Eigen::Vector3d& p) { return p.norm() - radius; });
}

/// z <= 0.
inline Solid ground_solid() {
  return solid_of([](const Eigen::Vector3d& p) { return p.z(); });
}

/// Full edges about the origin.
inline double box_distance(const Eigen::Vector3d& edges, const Eigen::Vector3d& p) {
  const Eigen::Vector3d q = p.cwiseAbs() - edges / 2;
  return q.cwiseMax(0).norm() + std::min(q.maxCoeff(), 0.0);
}
inline Solid box_shape(const Eigen::Vector3d& edges) {
  return solid_of([edges](const Eigen::Vector3d& p) { return box_distance(edges, p); });
}

/// A cup about z, open at the top: outer and inner radius, height above z = 0, floor as thick as
/// the wall. Its section is exact: a distance to two rectangles.
inline Solid mug_solid(double outer, double inner, double height) {
  return solid_of([=](const Eigen::Vector3d& p) {
    const double rho = std::hypot(p.x(), p.y()), wall = outer - inner;
    const auto rectangle = [&](double r0, double r1, double z0, double z1) {
      const double x = std::abs(rho - (r0 + r1) / 2) - (r1 - r0) / 2;
      const double z = std::abs(p.z() - (z0 + z1) / 2) - (z1 - z0) / 2;
      return std::hypot(std::max(x, 0.0), std::max(z, 0.0)) + std::min(std::max(x, z), 0.0);
    };
    return std::min(rectangle(inner, outer, 0, height), rectangle(-outer, outer, 0, wall));
  });
}

/// A mesh of one triangle; corners are columns.
inline RoundedMesh one_triangle(const Eigen::Matrix3d& corners, double radius = 0) {
  return {{corners, Eigen::Vector3i(0, 1, 2)}, radius};
}

/// A point with a radius, as a ball touches.
inline RoundedMesh rounded_point(const Eigen::Vector3d& p, double radius) {
  return {{p, Eigen::Vector3i(0, 0, 0)}, radius};
}

/// A segment with a radius, as a capsule touches.
inline RoundedMesh rounded_segment(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                                   double radius) {
  Eigen::Matrix3Xd ends(3, 2);
  ends << from, to;
  return {{ends, Eigen::Vector3i(0, 1, 1)}, radius};
}

/// The surface of a box of full edges about the origin, 12 triangles.
inline TriangleMesh block_mesh(const Eigen::Vector3d& edges) {
  TriangleMesh mesh{Eigen::Matrix3Xd(3, 8), Eigen::Matrix3Xi(3, 12)};
  for (int i = 0; i < 8; ++i)
    mesh.vertices.col(i) = edges.cwiseProduct(
        Eigen::Vector3d((i & 1) - 0.5, ((i >> 1) & 1) - 0.5, ((i >> 2) & 1) - 0.5));
  mesh.triangles << 0, 0, 4, 4, 0, 0, 2, 2, 0, 0, 1, 1,  //
      2, 3, 5, 7, 1, 5, 6, 7, 4, 6, 3, 7,                //
      3, 1, 7, 6, 5, 4, 7, 3, 6, 2, 7, 5;
  return mesh;
}

/// A solid that only touches.
inline Solid touching(std::vector<RoundedMesh> touch) { return {nullptr, std::move(touch), {}}; }

}  // namespace thenar
