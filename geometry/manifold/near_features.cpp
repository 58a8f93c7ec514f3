#include "geometry/manifold/near_features.h"

#include <algorithm>
#include <cmath>

namespace thenar::internal {
namespace {

using Eigen::Vector3d;

/// Returns whether a ball is within a distance of a triangle.
bool ball_near_face(const Vector3d& c, double reach, const PolyhedronFace& face) {
  // Exclude most by the distance from the plane.
  if (std::abs(face.n.dot(c - face.corners.col(0))) > reach) return false;
  return (nearest_in_triangle(face.corners, c) - c).squaredNorm() <= reach * reach;
}

void sort_unique(std::vector<int>& list) {
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
}

/// Search for features of pairs of faces, by both trees.
class PairSearch {
 public:
  PairSearch(const Polyhedron& a, const Polyhedron& b, const Pose<double>& X_BA, double reach,
             NearFeatures& near)
      : a_(a), b_(b), X_BA_(X_BA), X_AB_(X_BA.inverse()), reach_(reach), near_(near) {}

  void run() {
    near_.stack.push_back({0, 0});
    while (!near_.stack.empty()) {
      const std::array<int, 2> top = near_.stack.back();
      near_.stack.pop_back();
      visit(top[0], top[1]);
    }
    sort_unique(near_.corners_a);
    sort_unique(near_.corners_b);
  }

 private:
  /// Visits a pair of nodes: adds features of leaves, or pushes children.
  void visit(int node_a, int node_b) {
    const CollisionNode& a = a_.nodes[node_a];
    const CollisionNode& b = b_.nodes[node_b];
    const double apart = a.ball.r + b.ball.r + reach_;
    if ((X_BA_ * a.ball.c - b.ball.c).squaredNorm() > apart * apart) return;
    // Add two leaves as a pair of faces.
    const bool leaf_a = a.triangle >= 0, leaf_b = b.triangle >= 0;
    if (leaf_a && leaf_b) return add_faces(a, b);
    // For a large face, its triangle excludes more than its ball.
    if (leaf_a && !ball_near_face(X_AB_ * b.ball.c, b.ball.r + reach_, a_.faces[a.triangle]))
      return;
    if (leaf_b && !ball_near_face(X_BA_ * a.ball.c, a.ball.r + reach_, b_.faces[b.triangle]))
      return;
    // Replace the larger node by its children.
    if (!leaf_a && (leaf_b || a.ball.r > b.ball.r)) {
      near_.stack.push_back({a.left, node_b});
      near_.stack.push_back({a.right, node_b});
    } else {
      near_.stack.push_back({node_a, b.left});
      near_.stack.push_back({node_a, b.right});
    }
  }

  void add_faces(const CollisionNode& node_a, const CollisionNode& node_b) {
    const PolyhedronFace& a = a_.faces[node_a.triangle];
    const PolyhedronFace& b = b_.faces[node_b.triangle];
    if (!ball_near_face(X_BA_ * node_a.ball.c, node_a.ball.r + reach_, b) ||
        !ball_near_face(X_AB_ * node_b.ball.c, node_b.ball.r + reach_, a))
      return;
    // Add corners near the other's face, and edges near the other's edges.
    for (const int i : a.own_corners)
      if (i >= 0 && ball_near_face(X_BA_ * a_.corners[i].p, reach_, b))
        near_.corners_a.push_back(i);
    for (const int i : b.own_corners)
      if (i >= 0 && ball_near_face(X_AB_ * b_.corners[i].p, reach_, a))
        near_.corners_b.push_back(i);
    for (const int i : a.own_edges)
      for (const int j : b.own_edges)
        if (i >= 0 && j >= 0) add_edges(i, j);
  }

  void add_edges(int i, int j) {
    const PolyhedronEdge& a = a_.edges[i];
    const PolyhedronEdge& b = b_.edges[j];
    const Vector3d from = X_BA_ * a.from, way = X_BA_.R * a.axis;
    const SegmentParameters at = nearest_on_segments(from, way, b.from, b.axis);
    if ((from + at.s * way - b.from - at.t * b.axis).squaredNorm() <= reach_ * reach_)
      near_.edges.push_back({i, j});
  }

  const Polyhedron &a_, &b_;
  Pose<double> X_BA_, X_AB_;
  double reach_;
  NearFeatures& near_;
};

}  // namespace

SegmentParameters nearest_on_segments(const Vector3d& from_a, const Vector3d& way_a,
                                      const Vector3d& from_b, const Vector3d& way_b) {
  const Vector3d r = from_a - from_b;
  const double aa = way_a.squaredNorm(), bb = way_b.squaredNorm();
  if (aa == 0) return {0, bb == 0 ? 0 : std::clamp(way_b.dot(r) / bb, 0.0, 1.0)};
  const double c = way_a.dot(r);
  if (bb == 0) return {std::clamp(-c / aa, 0.0, 1.0), 0};
  const double f = way_b.dot(r), ab = way_a.dot(way_b), turn = aa * bb - ab * ab;
  // Find the nearest points of lines that are not parallel, then clamp them to both segments.
  double s = turn > 1e-14 * aa * bb ? std::clamp((ab * f - c * bb) / turn, 0.0, 1.0) : 0.5;
  double t = (ab * s + f) / bb;
  if (t < 0 || t > 1) {
    t = std::clamp(t, 0.0, 1.0);
    s = std::clamp((ab * t - c) / aa, 0.0, 1.0);
  }
  return {s, t};
}

void add_deep_corners(const Polyhedron& body, const Pose<double>& X_SP, const Shape& shape,
                      double depth, std::vector<int>& corners) {
  // Visit nodes that may be deep enough: depth changes by at most the distance moved.
  const auto visit = [&](const auto& self, int index) -> void {
    const CollisionNode& node = body.nodes[index];
    const Vector3d c = X_SP * node.ball.c;
    const double box = std::sqrt(shape.bounds().squaredExteriorDistance(c));
    if (box > node.ball.r || shape.distance(c) - node.ball.r > -depth) return;
    if (node.triangle < 0) {
      self(self, node.left);
      self(self, node.right);
      return;
    }
    for (const int i : body.faces[node.triangle].own_corners)
      if (i >= 0 && shape.distance(X_SP * body.corners[i].p) < -depth) corners.push_back(i);
  };
  visit(visit, 0);
  sort_unique(corners);
}

void find_near_features(const Polyhedron& a, const Polyhedron& b, const Pose<double>& X_BA,
                        double reach, NearFeatures& near) {
  near.corners_a.clear();
  near.corners_b.clear();
  near.edges.clear();
  near.found = true;
  near.X_BA = X_BA;
  near.reach = reach;
  PairSearch(a, b, X_BA, reach, near).run();
}

void find_near_faces(const Vector3d& from, const Vector3d& to, const Polyhedron& b, double reach,
                     NearFeatures& near) {
  near.faces_b.clear();
  near.stack.push_back({0, 0});
  while (!near.stack.empty()) {
    const CollisionNode& node = b.nodes[near.stack.back()[0]];
    near.stack.pop_back();
    // Exclude balls around faces that are far from the segment, then the faces.
    const Vector3d nearest = nearest_in_segment(from, to, node.ball.c);
    const double apart = node.ball.r + reach;
    if ((nearest - node.ball.c).squaredNorm() > apart * apart) continue;
    if (node.triangle < 0) {
      near.stack.push_back({node.left, 0});
      near.stack.push_back({node.right, 0});
      continue;
    }
    const PolyhedronFace& face = b.faces[node.triangle];
    const double h0 = face.n.dot(from - face.corners.col(0)),
                 h1 = face.n.dot(to - face.corners.col(0));
    if (std::min(h0, h1) > reach || std::max(h0, h1) < -reach) continue;
    near.faces_b.push_back(node.triangle);
  }
  std::sort(near.faces_b.begin(), near.faces_b.end());
}

}  // namespace thenar::internal
