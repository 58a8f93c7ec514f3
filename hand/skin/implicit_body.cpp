#include "hand/skin/implicit_body.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace thenar {
namespace {

using Eigen::Vector3d;

/// Computes the exact distance to the convex hull of two balls. Source: [Quilez2013].
double round_cone(const Vector3d& a, const Vector3d& b, double ra, double rb, const Vector3d& p) {
  const Vector3d ba = b - a, pa = p - a;
  const double length = ba.norm(), drop = ra - rb;
  // Return the distance to the larger ball if it contains the other.
  if (length <= std::abs(drop)) return ra >= rb ? pa.norm() - ra : (p - b).norm() - rb;
  const double along = pa.dot(ba) / length;
  const double across = std::sqrt(std::max(0.0, pa.squaredNorm() - along * along));
  // Use the flank in the plane of the axis: a line inclined by asin(drop / length).
  const double sine = drop / length, cosine = std::sqrt(1 - sine * sine);
  const double foot = along * cosine - across * sine;
  if (foot < 0) return pa.norm() - ra;
  if (foot > length * cosine) return (p - b).norm() - rb;
  return across * cosine + along * sine - ra;
}

/// Computes the distance to a triangle.
double triangle_distance(const std::array<Vector3d, 3>& t, const Vector3d& p) {
  // Take the distance to the sides, or to the plane within all of them.
  const Vector3d normal = (t[1] - t[0]).cross(t[2] - t[0]);
  bool within = normal.squaredNorm() > 0;
  double edge = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    const Vector3d &a = t[i], side = t[(i + 1) % 3] - a;
    const double part = std::clamp((p - a).dot(side) / side.squaredNorm(), 0.0, 1.0);
    edge = std::min(edge, (p - a - part * side).norm());
    within = within && side.cross(p - a).dot(normal) >= 0;
  }
  return within ? std::abs((p - t[0]).dot(normal)) / normal.norm() : edge;
}

/// Computes the height of a point above one lump.
double lump_height(const Lump& lump, const Vector3d& p) {
  if (lump.sheet) return triangle_distance(lump.core, p) - lump.radius[0];
  // Stretch space so that the flattened capsule becomes round; division by the stretch keeps the
  // height below the distance.
  const double wide = std::sqrt(lump.aspect);
  const auto press = [&](const Vector3d& x) -> Vector3d {
    const Vector3d from = x - lump.core[0];
    return from + (lump.aspect - 1) * lump.flat.dot(from) * lump.flat;
  };
  return round_cone(Vector3d::Zero(), press(lump.core[1]), wide * lump.radius[0],
                    wide * lump.radius[1], press(p)) /
         lump.aspect;
}

}  // namespace

double implicit_height(const ImplicitBody& body, const Vector3d& p) {
  double height = std::numeric_limits<double>::infinity();
  // Take the smooth minimum over the lumps.
  for (const Lump& lump : body) {
    const double next = lump_height(lump, p);
    const double near =
        lump.blend > 0 ? std::max(1 - std::abs(height - next) / lump.blend, 0.0) : 0;
    height = std::min(height, next) - near * near * lump.blend / 4;
  }
  return height;
}

Eigen::AlignedBox3d implicit_bounds(const ImplicitBody& body) {
  Eigen::AlignedBox3d box;
  // Extend the box by each lump with its thickness and its blend.
  for (const Lump& lump : body) {
    const double thick = std::sqrt(std::max(lump.aspect, 1 / lump.aspect)) *
                             std::max(lump.radius[0], lump.sheet ? 0 : lump.radius[1]) +
                         lump.blend / 4;
    for (int i = 0; i < (lump.sheet ? 3 : 2); ++i) {
      box.extend(lump.core[i] - Vector3d::Constant(thick));
      box.extend(lump.core[i] + Vector3d::Constant(thick));
    }
  }
  return box;
}

}  // namespace thenar
