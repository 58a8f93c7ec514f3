#include "geometry/collision/contact_normal.h"

#include <cmath>
#include <vector>

#include "geometry/collision/triangle_point.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

constexpr double kAround = 1e-4;                   // [m]
constexpr double kCosFlat = 0.984807753012208;     // of 10 degrees [1]
constexpr double kCosSharp = 0.86602540378443865;  // of 30 degrees [1]

/// Normals of B at a point and around it.
struct Around {
  std::vector<Vector3d> normals;  // unit (3)
  Vector3d middle;                // of them all, unit (3)
  bool sharp = false;             // an edge or a corner, not a groove
};

Around around(const PatchPoint& point, const Shape& b) {
  const Tangents t = tangents(point.normal);
  const std::vector<Vector3d> ways{t.e1, -t.e1, t.e2, -t.e2};
  Around result{{}, point.normal, false};
  std::vector<Vector3d>& normals = result.normals;
  for (const Vector3d& way : ways) {
    normals.push_back(b.nearest(point.on_b + kAround * way).normal);
    result.middle += normals.back();
  }
  for (std::size_t i = 0; i < ways.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (normals[i].dot(normals[j]) < kCosSharp &&
          (normals[i] - normals[j]).dot(ways[i] - ways[j]) > 0)
        result.sharp = true;
  const double length = result.middle.norm();
  result.middle = length > 0.1 ? (result.middle / length).eval() : point.normal;
  return result;
}

/// Normals of A's triangles at a point of A's frame.
std::vector<Vector3d> normals_of(const TouchBody& a, const Vector3d& p) {
  std::vector<Vector3d> normals;
  std::vector<int> nodes{0};
  while (!nodes.empty()) {
    const TouchNode& node = a.nodes[static_cast<std::size_t>(nodes.back())];
    nodes.pop_back();
    if ((node.ball.c - p).norm() > node.ball.r + kAround) continue;
    if (node.triangle < 0) {
      nodes.push_back(node.left);
      nodes.push_back(node.right);
      continue;
    }
    const TouchTriangle& t = a.triangles[static_cast<std::size_t>(node.triangle)];
    if ((nearest_in_triangle(t.corners, p) - p).norm() <= kAround) normals.push_back(t.n);
  }
  return normals;
}

/// Their mean, or zero if they differ too much, or one is that of a segment or a point.
Vector3d common(const std::vector<Vector3d>& normals) {
  Vector3d sum = Vector3d::Zero();
  for (const Vector3d& x : normals) {
    for (const Vector3d& y : normals)
      if (!(x.dot(y) >= kCosSharp)) return Vector3d::Zero();
    sum += x;
  }
  return sum.stableNormalized();
}

/// The way from the face of A that lies on one of B most nearly; else into the face of B that looks
/// most nearly as one of A does, as the sides of flush blocks do; else the middle way into B.
Vector3d of_face(const Around& near, const Eigen::Matrix3d& R_BA,
                 const std::vector<Vector3d>& normals_A) {
  Vector3d on = -near.middle, beside = -near.middle;
  double most_on = kCosFlat, most_beside = kCosFlat;
  for (const Vector3d& n : near.normals)
    for (const Vector3d& of_a : normals_A) {
      const Vector3d n_A = R_BA * of_a;
      const double same = n.dot(n_A);
      if (-same > most_on) on = n_A, most_on = -same;
      if (same > most_beside) beside = -n, most_beside = same;
    }
  return most_on > kCosFlat ? on : beside;
}

}  // namespace

Vector3d into_b(const PatchPoint& point, const TouchBody& a, const Pose<double>& X_BA,
                const Shape& b) {
  if (point.radius > 0 && point.distance + point.radius > 0) return -point.normal;
  const Around near = around(point, b);
  if (!near.sharp) return -point.normal;
  const std::vector<Vector3d> normals_A = normals_of(a, X_BA.inverse() * point.core);
  const Vector3d n = X_BA.R * common(normals_A);
  if (n.isZero()) return of_face(near, X_BA.R, normals_A);
  return n.dot(near.middle) > 0 ? (-n).eval() : n;
}

}  // namespace thenar
