#include "geometry/winding_number.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <Eigen/Geometry>

#include "base/units.h"

namespace thenar::internal {
namespace {

using Eigen::Vector3d;

// Differences below this share of their products are no area [1]
constexpr double kGrazingShare = 1e-11;

struct Ray {
  Vector3d from;
  Vector3d way;       // unit
  Vector3d inverse;   // 1 / way
  Vector3d side, up;  // across the way

  Ray(const Vector3d& p, const Vector3d& direction)
      : from(p), way(direction.normalized()), inverse(way.cwiseInverse()) {
    side = way.unitOrthogonal();
    up = way.cross(side);
  }

  [[nodiscard]] bool reaches(const Eigen::AlignedBox3d& box) const {
    const Eigen::Array3d low = (box.min() - from).array() * inverse.array();
    const Eigen::Array3d high = (box.max() - from).array() * inverse.array();
    const double enter = low.min(high).maxCoeff(), leave = low.max(high).minCoeff();
    const double rounding = 1e-12 * std::max(std::abs(enter), std::abs(leave));
    return leave >= -rounding && enter <= leave + rounding;
  }

  /// 1 where it leaves by a triangle, -1 where it comes in, 0 where it misses; nothing where it
  /// passes an edge or lies in the plane within rounding.
  [[nodiscard]] std::optional<int> crossing(const TriangleForm& form) const {
    // Project the corners along the ray; compute twice the areas that they span with the ray.
    std::array<double, 3> x{}, y{};
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector3d arm = form.corner[k] - from;
      x[k] = side.dot(arm), y[k] = up.dot(arm);
    }
    int left = 0, right = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3;
      const double plus = x[k] * y[next], minus = x[next] * y[k];
      const double area = plus - minus, least = kGrazingShare * (std::abs(plus) + std::abs(minus));
      if (area > least) ++left;
      if (area < -least) ++right;
    }
    if (left > 0 && right > 0) return 0;
    if (left + right < 3) return std::nullopt;
    // Count it only ahead of the point.
    const int sign = left == 3 ? 1 : -1;
    return sign * form.normal.dot(form.corner[0] - from) > 0 ? sign : 0;
  }
};

/// Returns the winding number along a ray; nothing if the ray passes an edge.
std::optional<int> along(const TriangleTree& tree, const Ray& ray) {
  std::array<int, 64> stack{};  // as deep as the tree of 2^63 triangles
  int waiting = 0, sum = 0;
  stack[waiting++] = 0;
  while (waiting > 0) {
    const int at = stack[--waiting];
    const TriangleTree::Node& node = tree.nodes()[at];
    if (!ray.reaches(node.box)) continue;
    for (int i = node.first; i < node.first + node.count; ++i) {
      const std::optional<int> crossed = ray.crossing(tree.forms()[i]);
      if (!crossed) return std::nullopt;
      sum += *crossed;
    }
    if (node.count > 0) continue;
    stack[waiting++] = at + 1;
    stack[waiting++] = node.second;
  }
  return sum;
}

/// Solid angle that a triangle covers, seen from the origin. Source: [VanOosterom1983].
double solid_angle(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  const double u = a.norm(), v = b.norm(), w = c.norm();
  return 2 * std::atan2(a.dot(b.cross(c)), u * v * w + a.dot(b) * w + b.dot(c) * u + c.dot(a) * v);
}

}  // namespace

int winding_number(const TriangleTree& tree, const Vector3d& p) {
  if (!tree.bounds().contains(p)) return 0;
  // Use directions that lie in no common plane of symmetry.
  static const std::array<Vector3d, 6> directions{
      Vector3d(0.3541, 0.7713, 0.5289),  Vector3d(-0.6173, 0.2867, 0.7327),
      Vector3d(0.8219, -0.4363, 0.3671), Vector3d(0.1931, 0.5483, -0.8137),
      Vector3d(-0.4721, -0.2389, 0.849), Vector3d(0.2791, -0.9091, -0.3093)};
  for (const Vector3d& direction : directions)
    if (const std::optional<int> found = along(tree, Ray(p, direction))) return *found;
  // Sum solid angles if the point is on an edge of the surface, or next to it.
  double sum = 0;
  for (const TriangleForm& form : tree.forms())
    sum += solid_angle(form.corner[0] - p, form.corner[1] - p, form.corner[2] - p);
  return static_cast<int>(std::lround(sum / (4 * kPi)));
}

}  // namespace thenar::internal
