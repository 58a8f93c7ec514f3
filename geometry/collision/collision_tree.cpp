#include "geometry/collision/collision_tree.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "base/error.h"
#include "geometry/mesh_distance.h"

namespace thenar {
namespace {

/// Builder of the nodes of a collision tree by recursive median splits.
class TreeBuilder {
 public:
  explicit TreeBuilder(CollisionTree& body) : body_(body) {}

  /// Builds the nodes of triangles[first, last) and returns the index of their root.
  // NOLINTNEXTLINE(misc-no-recursion): the depth is logarithmic in the number of triangles
  int build(int first, int last) {
    const int index = static_cast<int>(body_.nodes.size());
    body_.nodes.emplace_back();
    // Store one swept triangle in a leaf, with the ball around it.
    if (last - first == 1) {
      CollisionNode& leaf = body_.nodes.back();
      leaf.triangle = first;
      leaf.ball = internal::smallest_ball(triangle(first).corners);
      leaf.ball.r += triangle(first).radius;
      return index;
    }
    // Otherwise divide at the median into two children.
    const Eigen::AlignedBox3d box = box_around(first, last);
    const int middle = split(first, last, box);
    const int left = build(first, middle), right = build(middle, last);
    body_.nodes[index] = {ball_around(first, last, box.center()), left, right, -1};
    return index;
  }

 private:
  SweptTriangle& triangle(int i) { return body_.triangles[i]; }

  Eigen::AlignedBox3d box_around(int first, int last) {
    Eigen::AlignedBox3d box;
    for (int i = first; i < last; ++i)
      for (int k = 0; k < 3; ++k) box.extend(triangle(i).corners.col(k));
    return box;
  }

  Ball ball_around(int first, int last, const Eigen::Vector3d& c) {
    double r = 0;
    for (int i = first; i < last; ++i)
      r = std::max(
          r, std::sqrt((triangle(i).corners.colwise() - c).colwise().squaredNorm().maxCoeff()) +
                 triangle(i).radius);
    return {c, r};
  }

  /// Partitions triangles about the median along the longest side of their box.
  int split(int first, int last, const Eigen::AlignedBox3d& box) {
    Eigen::Index axis = 0;
    box.sizes().maxCoeff(&axis);
    const int middle = (first + last) / 2;
    const auto begin = body_.triangles.begin();
    std::nth_element(begin + first, begin + middle, begin + last,
                     [axis](const SweptTriangle& a, const SweptTriangle& b) {
                       return a.corners.row(axis).sum() < b.corners.row(axis).sum();
                     });
    return middle;
  }

  CollisionTree& body_;
};

SweptTriangle swept_triangle(const Eigen::Matrix3d& corners, double radius, int source) {
  const Eigen::Vector3d cross =
      (corners.col(1) - corners.col(0)).cross(corners.col(2) - corners.col(0));
  return {corners, radius, cross.stableNormalized(), source};
}

constexpr double kBallTolerance = 1e-9;  // relative error of a radius that counts as rounding [1]
constexpr double kOffBoundaryRatio =
    1.001;  // depth over size from which it is off the boundary [1]

}  // namespace

Ball internal::smallest_ball(const Eigen::Matrix3d& corners) {
  // Try the ball over the longest side, if it contains the third corner.
  double longest = -1;
  Ball ball;
  Eigen::Vector3d third = corners.col(0);
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3d a = corners.col(k), b = corners.col((k + 1) % 3);
    const double length = (b - a).norm();
    if (!(length > longest)) continue;
    longest = length;
    ball = {(a + b) / 2, length / 2};
    third = corners.col((k + 2) % 3);
  }
  if ((third - ball.c).norm() > (1 + kBallTolerance) * ball.r) {
    // All angles are acute: use the circle through the corners.
    const Eigen::Vector3d u = corners.col(1) - corners.col(0), v = corners.col(2) - corners.col(0);
    const Eigen::Vector3d w = u.cross(v);
    ball.c = corners.col(0) +
             (u.squaredNorm() * v.cross(w) + v.squaredNorm() * w.cross(u)) / (2 * w.squaredNorm());
  }
  ball.r = std::sqrt((corners.colwise() - ball.c).colwise().squaredNorm().maxCoeff());
  return ball;
}

namespace {

/// Returns whether no point of a triangle of a mesh is on the boundary of its part, which happens
/// where a surface intersects itself: the depth or distance of its centre exceeds the distance of
/// its corners from there.
bool is_off_boundary(const SolidPart& part, const Eigen::Matrix3d& corners) {
  const Eigen::Vector3d middle = corners.rowwise().mean();
  const double reach = (corners.colwise() - middle).colwise().norm().maxCoeff();
  return std::abs(part.shape->distance(part.spec.X_BS.inverse() * middle)) >
         kOffBoundaryRatio * reach;
}

}  // namespace

CollisionTree collision_tree(const Solid& solid) {
  CollisionTree body;
  const bool known = solid.parts.size() == solid.collision.size();
  // Check and copy the triangles of all collision surfaces.
  for (std::size_t part = 0; part < solid.collision.size(); ++part) {
    const RoundedMesh& mesh = solid.collision[part];
    const bool crossed = known && goes_through_itself(*solid.parts[part].shape);
    require(mesh.radius >= 0 && std::isfinite(mesh.radius),
            "the radius of a touch surface must be finite and >= 0, got {}", mesh.radius);
    for (Eigen::Index i = 0; i < mesh.core.triangles.cols(); ++i) {
      Eigen::Matrix3d corners;
      for (int k = 0; k < 3; ++k) {
        const int vertex = mesh.core.triangles(k, i);
        require(vertex >= 0 && vertex < mesh.core.vertices.cols(),
                "triangle {} has vertex {}, but there are {}", i, vertex,
                mesh.core.vertices.cols());
        corners.col(k) = mesh.core.vertices.col(vertex);
      }
      require(corners.allFinite(), "triangle {} of a touch surface is not finite", i);
      if (crossed && is_off_boundary(solid.parts[part], corners)) continue;
      body.triangles.push_back(
          swept_triangle(corners, mesh.radius, static_cast<int>(body.triangles.size())));
    }
  }
  require(!body.triangles.empty(), "a touch surface must have {} triangle or more", 1);
  // Build the tree over them.
  body.nodes.reserve(2 * body.triangles.size());
  TreeBuilder(body).build(0, static_cast<int>(body.triangles.size()));
  return body;
}

Eigen::Vector3d internal::nearest_in_segment(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                                             const Eigen::Vector3d& p) {
  const Eigen::Vector3d axis = to - from;
  const double square = axis.squaredNorm();
  if (!(square > 0)) return from;
  return from + std::clamp((p - from).dot(axis) / square, 0.0, 1.0) * axis;
}

Eigen::Vector3d internal::nearest_in_triangle(const Eigen::Matrix3d& corners,
                                              const Eigen::Vector3d& p) {
  const Eigen::Vector3d a = corners.col(0), b = corners.col(1), c = corners.col(2);
  const Eigen::Vector3d n = (b - a).cross(c - a);
  // Project a point inside the prism over the triangle onto its plane.
  const double square = n.squaredNorm();
  if (square > 0 && n.cross(b - a).dot(p - a) >= 0 && n.cross(c - b).dot(p - b) >= 0 &&
      n.cross(a - c).dot(p - c) >= 0)
    return p - n.dot(p - a) / square * n;
  // Otherwise the nearest point is on a side.
  Eigen::Vector3d best = nearest_in_segment(a, b, p);
  for (const Eigen::Vector3d& q : {nearest_in_segment(b, c, p), nearest_in_segment(c, a, p)})
    if ((q - p).squaredNorm() < (best - p).squaredNorm()) best = q;
  return best;
}

std::array<Eigen::Matrix3d, 2> internal::bisect_triangle(const Eigen::Matrix3d& corners) {
  // Find the longest side and move each of its ends to the middle.
  int from = 0;
  double longest = -1;
  for (int k = 0; k < 3; ++k) {
    const double square = (corners.col(k) - corners.col((k + 1) % 3)).squaredNorm();
    if (square > longest) longest = square, from = k;
  }
  const int to = (from + 1) % 3;
  std::array<Eigen::Matrix3d, 2> halves{corners, corners};
  halves[0].col(to) = halves[1].col(from) = (corners.col(from) + corners.col(to)) / 2;
  return halves;
}

}  // namespace thenar
