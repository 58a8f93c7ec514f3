#pragma once

/// Surfaces that searches for nearest points get wrong.

#include <cmath>
#include <vector>

#include "base/units.h"
#include "geometry/mesh_from_distance.h"
#include "geometry/primitives.h"
#include "geometry/shape_union.h"
#include "geometry/tessellate.h"

namespace thenar {

/// A mug of 80 mm by 100 mm with a wall of 4 mm, open above; long thin triangles.
[[nodiscard]] inline TriangleMesh mug(int sides = 60) {
  return surface_of_revolution(
      {{0, -0.05}, {0.04, -0.05}, {0.04, 0.05}, {0.036, 0.05}, {0.036, -0.046}, {0, -0.046}},
      sides);
}

/// 100 mm by 60 mm by 0.5 mm.
[[nodiscard]] inline TriangleMesh thin_plate() { return box_mesh({0.1, 0.06, 0.0005}); }

/// A mug with a handle; small triangles, thousands of them.
class HandledMug final : public Shape {
 public:
  double distance(const Eigen::Vector3d& p) const override { return nearest(p).distance; }
  NearestSurface nearest(const Eigen::Vector3d& p) const override {
    const double e = 1e-7;
    const auto gradient = [&](int k) {
      return (value(p + e * Eigen::Vector3d::Unit(k)) - value(p - e * Eigen::Vector3d::Unit(k)));
    };
    return {value(p), Eigen::Vector3d(gradient(0), gradient(1), gradient(2)).normalized()};
  }
  Eigen::AlignedBox3d bounds() const override { return {low_, high_}; }

 private:
  const Eigen::Vector3d low_{-0.04, -0.04, -0.05}, high_{0.075, 0.04, 0.05};
  static double value(const Eigen::Vector3d& p) {
    const auto cylinder = [&](double radius, double low, double high) {
      return std::max(p.head<2>().norm() - radius, std::max(low - p.z(), p.z() - high));
    };
    const double ring = std::hypot(p.x() - 0.045, p.z()) - 0.024;
    const double handle = std::max(std::hypot(ring, p.y()) - 0.006, 0.0365 - p.x());
    const double cup = std::max(cylinder(0.04, -0.05, 0.05), -cylinder(0.034, -0.044, 1));
    return std::min(cup, handle);
  }
};
[[nodiscard]] inline TriangleMesh handled_mug(double cell = 0.004) {
  return mesh_from_distance(HandledMug(), cell);
}

/// A ring whose hole is a cavity open on both sides.
[[nodiscard]] inline TriangleMesh ring() {
  TriangleMesh mesh{Eigen::Matrix3Xd(3, 24 * 12), Eigen::Matrix3Xi(3, 2 * 24 * 12)};
  for (int i = 0; i < 24; ++i)
    for (int j = 0; j < 12; ++j) {
      const double u = 2 * kPi * i / 24, v = 2 * kPi * j / 12, rho = 0.03 + 0.008 * std::cos(v);
      mesh.vertices.col(12 * i + j) << rho * std::cos(u), rho * std::sin(u), 0.008 * std::sin(v);
      const int a = 12 * i + j, b = 12 * ((i + 1) % 24) + j;
      const int c = 12 * ((i + 1) % 24) + (j + 1) % 12, d = 12 * i + (j + 1) % 12;
      mesh.triangles.col(2 * a) << a, b, c;
      mesh.triangles.col(2 * a + 1) << a, c, d;
    }
  return mesh;
}

}  // namespace thenar
