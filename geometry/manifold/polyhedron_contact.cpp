#include "geometry/manifold/polyhedron_contact.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/manifold/ball_hull.h"

namespace thenar::internal {
namespace {

using Eigen::Vector3d;

// Distance beyond the margin within which features are searched [m]
constexpr double kFeatureReach = 1e-3;
constexpr double kMaxReach = 3e-3;          // maximum of this distance, for deep edges [m]
constexpr std::size_t kManyFeatures = 300;  // number of features above which it is divided by four
constexpr double kMinDownSine = -0.5;       // sine below which an edge leads down from a corner [1]
constexpr double kMaxArcDistance = 0.1;     // distance of a normal from the arc of an edge [1]
constexpr double kMaxEdgeDepth = 2e-4;      // depth up to which edges need no further test [m]
constexpr double kMinCrossingSine = 1e-4;   // sine of the angle from which edges cross [1]
constexpr double kMinArm = 1e-12;           // distance below which a direction is undefined [m]

/// Returns whether no edge leads down from a corner, seen along n.
bool is_lowest(const Polyhedron& body, const PolyhedronCorner& corner, const Vector3d& n) {
  for (int k = 0; k < corner.count; ++k)
    if (body.directions[corner.first + k].dot(n) < kMinDownSine) return false;
  return true;
}

/// Returns whether n, perpendicular to an edge, is between the normals of its faces.
bool is_between(const PolyhedronEdge& edge, const Vector3d& along, const Vector3d& n) {
  const double turn = edge.normals[0].cross(edge.normals[1]).dot(along);
  const double sign = turn < 0 ? -1 : 1;
  return sign * edge.normals[0].cross(n).dot(along) > -kMaxArcDistance &&
         sign * n.cross(edge.normals[1]).dot(along) > -kMaxArcDistance &&
         n.dot(edge.normals[0] + edge.normals[1]) > 0;
}

/// Contact points of near features, in B's frame.
class FeatureContacts {
 public:
  FeatureContacts(const CollisionPart& a, const CollisionPart& b, const Pose<double>& X_BA,
                  double margin, std::vector<ManifoldPoint>& points)
      : a_(a), b_(b), X_BA_(X_BA), X_AB_(X_BA.inverse()), margin_(margin), points_(points) {}

  /// Adds the points of all features. @return the smallest signed distance of all [m]
  double add(const NearFeatures& near) {
    for (const int i : near.corners_a) add_corner_a(i);
    for (const int i : near.corners_b) add_corner_b(i);
    for (const auto& pair : near.edges) add_edges(pair[0], pair[1]);
    // Add the deepest corner of bodies that overlap without a local contact.
    if (deepest_ == 0 && covered_.distance < 0)
      add_point(covered_.on_a, covered_.on_b, covered_.n, FeatureKind::kWitness, 0, 0);
    return least_;
  }

  [[nodiscard]] double deepest() const { return deepest_; }

 private:
  /// A corner of either body as a contact.
  struct Corner {
    Vector3d on_a{0, 0, 0}, on_b{0, 0, 0}, n{0, 0, 1};
    double distance = 0;
  };

  void add_corner_a(int i) {
    const PolyhedronCorner& corner = a_.polyhedron->corners[i];
    const Vector3d p = X_BA_ * corner.p;
    const NearestSurface seen = b_.shape->nearest(p);
    least_ = std::min(least_, seen.distance);
    if (seen.distance > margin_) return;
    add_corner({p, p - seen.distance * seen.normal, seen.normal, seen.distance},
               is_lowest(*a_.polyhedron, corner, X_AB_.R * seen.normal), FeatureKind::kVertexA, i);
  }

  void add_corner_b(int i) {
    const PolyhedronCorner& corner = b_.polyhedron->corners[i];
    const Vector3d p = X_AB_ * corner.p;
    const NearestSurface seen = a_.shape->nearest(p);
    least_ = std::min(least_, seen.distance);
    if (seen.distance > margin_) return;
    const Vector3d n = X_BA_.R * seen.normal;
    add_corner({corner.p - seen.distance * n, corner.p, -n, seen.distance},
               is_lowest(*b_.polyhedron, corner, n), FeatureKind::kVertexB, i);
  }

  /// Adds a corner from which no edge leads down; of the others the deepest is kept.
  void add_corner(const Corner& corner, bool lowest, FeatureKind kind, int number) {
    if (lowest)
      add_point(corner.on_a, corner.on_b, corner.n, kind, number, 0);
    else if (corner.distance < covered_.distance)
      covered_ = corner;
  }

  void add_edges(int i, int j) {
    const PolyhedronEdge& a = a_.polyhedron->edges[i];
    const PolyhedronEdge& b = b_.polyhedron->edges[j];
    const Vector3d from = X_BA_ * a.from, axis = X_BA_.R * a.axis;
    const SegmentParameters at = nearest_on_segments(from, axis, b.from, b.axis);
    const Vector3d on_a = from + at.s * axis, on_b = b.from + at.t * b.axis;
    if (!(at.s > 0 && at.s < 1 && at.t > 0 && at.t < 1))
      return;  // corners are contacts of their own
    const double distance = (on_a - on_b).norm();
    // Compute the common normal, out of B and into A.
    Vector3d n = axis.cross(b.axis);
    const double sine = n.norm();
    if (sine < kMinCrossingSine * std::sqrt(axis.squaredNorm() * b.axis.squaredNorm())) return;
    n /= sine;
    if (n.dot(b.normals[0] + b.normals[1]) < 0) n = -n;
    if (!is_between(b, b.axis.normalized(), n) ||
        !is_between(a, a.axis.normalized(), -(X_AB_.R * n))) {
      least_ = std::min(least_, distance);
      return;
    }
    const double gap = (on_a - on_b).dot(n);
    // For deep edges, the point of each must be inside the other body.
    if (gap < -kMaxEdgeDepth &&
        (b_.shape->distance(on_a) > 0 || a_.shape->distance(X_AB_ * on_b) > 0))
      return;
    least_ = std::min(least_, gap);
    if (gap <= margin_) add_point(on_a, on_b, n, FeatureKind::kEdges, i, j);
  }

  void add_point(const Vector3d& on_a, const Vector3d& on_b, const Vector3d& n, FeatureKind kind,
                 int i, int j) {
    const double gap = (on_a - on_b).dot(n);
    deepest_ = std::min(deepest_, gap);
    points_.push_back({on_a, on_b, n, gap, feature_key(kind, i, j)});
  }

  const CollisionPart &a_, &b_;
  Pose<double> X_BA_, X_AB_;
  double margin_;
  std::vector<ManifoldPoint>& points_;
  double least_ = std::numeric_limits<double>::infinity();
  double deepest_ = 0;
  Corner covered_{};  // deepest corner from which an edge leads down
};

}  // namespace

double polyhedron_on_polyhedron(const CollisionPart& a, const CollisionPart& b,
                                const Pose<double>& X_BA, double margin, PartMemory& memory,
                                std::vector<ManifoldPoint>& points) {
  NearFeatures& near = memory.near;
  const std::size_t first = points.size();
  double moved = near.found ? motion_bound(a.ball, b.ball, near.X_BA, X_BA) : 0;
  const bool many =
      near.corners_a.size() + near.corners_b.size() + near.edges.size() > kManyFeatures;
  double reach = margin + (many ? kFeatureReach / 4 : kFeatureReach);
  bool search = !near.found || moved + margin > near.reach;
  for (;;) {
    // Search again if the bodies have moved too far, or edges are deeper than the last search.
    if (search) {
      find_near_features(*a.polyhedron, *b.polyhedron, X_BA, reach, near);
      add_deep_corners(*a.polyhedron, X_BA, *b.shape, reach, near.corners_a);
      add_deep_corners(*b.polyhedron, X_BA.inverse(), *a.shape, reach, near.corners_b);
      moved = 0;
    }
    FeatureContacts contacts(a, b, X_BA, margin, points);
    const double least = contacts.add(near), deepest = contacts.deepest();
    if (-2 * deepest <= near.reach - moved || near.reach >= margin + kMaxReach) {
      memory.overlapped = deepest < 0;
      // Bound other features by the distance of the search.
      return std::min(least, near.reach - moved);
    }
    points.resize(first);
    reach = margin + std::min(kMaxReach, kFeatureReach - 4 * deepest);
    search = true;
  }
}

namespace {

/// Contact points of the hull of two balls on a polyhedron, in B's frame.
class RoundContacts {
 public:
  RoundContacts(const CollisionPart& a, const Polyhedron& b, const Pose<double>& X_BA,
                double margin, std::vector<ManifoldPoint>& points)
      : a_(a, X_BA), b_(b), margin_(margin), points_(points) {}

  /// Adds the points of all near features. @return the smallest gap of all [m]
  double add(const NearFeatures& near) {
    for (const int i : near.faces_b) {
      const PolyhedronFace& face = b_.faces[i];
      for (int end = 0; end < (a_.length > 0 ? 2 : 1); ++end) add_face(face, end);
      for (const int e : face.own_edges)
        if (e >= 0) add_edge(e);
      for (const int c : face.own_corners)
        if (c >= 0) add_corner(c);
    }
    return least_;
  }

 private:
  /// Adds the ball at an end, if it is above a face.
  void add_face(const PolyhedronFace& face, int end) {
    const Vector3d c = a_.centre(end);
    const double height = face.n.dot(c - face.corners.col(0));
    if (height < 0 || height - a_.radius(end) > margin_ + kFeatureReach) return;
    for (int k = 0; k < 3; ++k) {
      const Vector3d side = face.corners.col((k + 1) % 3) - face.corners.col(k);
      if (face.n.cross(side).dot(c - face.corners.col(k)) < 0) return;
    }
    add_point(end, c - height * face.n, face.n, height, end, 1 << 23U | face.plane);
  }

  /// Adds the ball nearest to an edge, and those at the ends if they are above it.
  void add_edge(int e) {
    const PolyhedronEdge& edge = b_.edges[e];
    const double square = edge.axis.squaredNorm();
    const auto add_above = [&](double s, double t, int feature) {
      if (!(t > 0 && t < 1)) return;
      const Vector3d on_b = edge.from + t * edge.axis, arm = a_.centre(s) - on_b;
      const double distance = arm.norm();
      if (distance < kMinArm || !is_between(edge, edge.axis / std::sqrt(square), arm / distance))
        return;
      add_point(s, on_b, arm / distance, distance, feature, e);
    };
    for (int end = 0; end < (a_.length > 0 ? 2 : 1); ++end)
      add_above(end, edge.axis.dot(a_.centre(end) - edge.from) / square, end);
    if (a_.length == 0) return;
    const SegmentParameters nearest = nearest_balls(a_, {edge.from, edge.axis});
    if (nearest.s > 0 && nearest.s < 1) add_above(nearest.s, nearest.t, kBetween);
  }

  /// Adds the ball nearest to a corner.
  void add_corner(int c) {
    const PolyhedronCorner& corner = b_.corners[c];
    const double s = nearest_balls(a_, {corner.p, Vector3d::Zero()}).s;
    const Vector3d arm = a_.centre(s) - corner.p;
    const double distance = arm.norm();
    if (distance < kMinArm) return;
    for (int k = 0; k < corner.count; ++k)
      if (b_.directions[corner.first + k].dot(arm) > kMaxArcDistance * distance) return;
    add_point(s, corner.p, arm / distance, distance, axis_feature(s), 1 << 22U | c);
  }

  void add_point(double s, const Vector3d& on_b, const Vector3d& n, double height, int of_a,
                 int of_b) {
    const double gap = height - a_.radius(s);
    least_ = std::min(least_, gap);
    if (gap <= margin_)
      points_.push_back(
          {on_b + gap * n, on_b, n, gap, feature_key(FeatureKind::kBalls, of_a, of_b)});
  }

  BallHull a_;
  const Polyhedron& b_;
  double margin_;
  std::vector<ManifoldPoint>& points_;
  double least_ = std::numeric_limits<double>::infinity();
};

/// Returns the contact of the ball at s with the surface nearest to its centre.
ManifoldPoint ball_within(const BallHull& a, const Shape& b, double s) {
  ManifoldPoint point = ball_on_shape(a, b, s);
  point.feature = feature_key(FeatureKind::kWitness, axis_feature(s), 0);
  return point;
}

}  // namespace

double round_on_polyhedron(const CollisionPart& a, const CollisionPart& b, const Pose<double>& X_BA,
                           double margin, PartMemory& memory, std::vector<ManifoldPoint>& points) {
  NearFeatures& near = memory.near;
  double moved = near.found ? motion_bound(a.ball, b.ball, near.X_BA, X_BA) : 0;
  const BallHull hull(a, X_BA);
  const Vector3d from = hull.centre(0), to = hull.centre(1);
  if (!near.found || moved + margin > near.reach) {
    near.found = true;
    near.X_BA = X_BA;
    near.reach = margin + kFeatureReach;
    moved = 0;
    find_near_faces(from, to, *b.polyhedron, std::max(a.radius[0], a.radius[1]) + near.reach, near);
  }
  // Use the faces only while the axis is outside.
  const double inside_from = b.shape->distance(from);
  const double inside_to = a.half_length > 0 ? b.shape->distance(to) : inside_from;
  double least = near.reach - moved;
  if (inside_from >= 0 && inside_to >= 0) {
    const std::size_t first = points.size();
    least = std::min(least, RoundContacts(a, *b.polyhedron, X_BA, margin, points).add(near));
    memory.overlapped = least < 0;
    // Test balls between the ends, which may touch while both ends are outside.
    if (points.size() > first || a.half_length == 0) return least;
    for (const double s : {0.25, 0.5, 0.75}) {
      const ManifoldPoint point = ball_within(hull, *b.shape, s);
      least = std::min(least, point.gap);
      if (point.gap <= margin) points.push_back(point);
    }
    return least;
  }
  for (const double s : {0.0, 1.0, 0.25, 0.5, 0.75}) {
    if (a.half_length == 0 && s > 0) break;
    const ManifoldPoint point = ball_within(hull, *b.shape, s);
    least = std::min(least, point.gap);
    if (point.gap <= margin && (s == 0 || s == 1 || point.gap <= least)) points.push_back(point);
  }
  memory.overlapped = true;
  return least;
}

}  // namespace thenar::internal
