#include "geometry/manifold/box_contact.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/numbers.h"
#include "geometry/manifold/convex_distance.h"

namespace thenar::internal {
namespace {

using Eigen::Matrix3d, Eigen::Vector3d;

/// Two boxes in B's frame.
struct BoxPair {
  Matrix3d R;       // R_BA
  Vector3d c;       // centre of A [m] (3)
  Vector3d ha, hb;  // half edges [m] (3)
};

/// A direction that may separate the boxes.
struct BoxAxis {
  Vector3d n{0, 0, 1};      // unit, from B to A (3)
  double gap = -kInfinity;  // gap of the boxes along n [m]
  int index = -1;           // 0-2: faces of B, 3-5: faces of A, 6-14: edges of B across edges of A
};

// Sine of the angle between edges below which they are parallel [1]
constexpr double kParallelEdges = 1e-7;
// Gaps by which faces of A, and crossing edges, must exceed the best one before them [m]
constexpr double kFacePreference = 1e-12, kEdgePreference = 1e-9;
// Depth by which another direction must be better than the last: absolute [m], relative [1]
constexpr double kKeepDepth = 1e-5, kKeepRatio = 0.02;

/// Returns half the extent of a box along a direction [m].
double extent(const Vector3d& half, const Vector3d& n) { return half.dot(n.cwiseAbs()); }

double gap_along(const BoxPair& boxes, const Vector3d& n) {
  return n.dot(boxes.c) - extent(boxes.hb, n) - extent(boxes.ha, boxes.R.transpose() * n);
}

/// Returns the direction of an index, with its gap; no gap for parallel edges.
BoxAxis axis_of(const BoxPair& boxes, int index) {
  Vector3d n;
  if (index < 3) {
    n = Vector3d::Unit(index);
  } else if (index < 6) {
    n = boxes.R.col(index - 3);
  } else {
    n = Vector3d::Unit((index - 6) / 3).cross(boxes.R.col((index - 6) % 3));
    const double sine = n.norm();
    if (sine < kParallelEdges) return {};  // faces separate parallel edges
    n /= sine;
  }
  if (n.dot(boxes.c) < 0) n = -n;
  return {n, gap_along(boxes, n), index};
}

/// Finds the direction with the largest gap, or the smallest depth.
BoxAxis best_axis(const BoxPair& boxes, int last) {
  const Matrix3d share = boxes.R.cwiseAbs();
  const Vector3d in_a = boxes.R.transpose() * boxes.c;
  // Try faces of B, faces of A, then edges, which must be better by more than rounding errors.
  const Vector3d of_b = boxes.c.cwiseAbs() - boxes.hb - share * boxes.ha;
  const Vector3d of_a = in_a.cwiseAbs() - boxes.ha - share.transpose() * boxes.hb;
  int index = -1;
  double gap = -kInfinity;
  for (int k = 0; k < 3; ++k)
    if (of_b(k) > gap) gap = of_b(k), index = k;
  for (int k = 0; k < 3; ++k)
    if (of_a(k) > gap + kFacePreference) gap = of_a(k), index = 3 + k;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const int i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
      const double sine = std::sqrt(
          std::max(0.0, boxes.R(i1, j) * boxes.R(i1, j) + boxes.R(i2, j) * boxes.R(i2, j)));
      if (sine < kParallelEdges) continue;
      const double reach = boxes.hb(i1) * share(i2, j) + boxes.hb(i2) * share(i1, j) +
                           boxes.ha(j1) * share(i, j2) + boxes.ha(j2) * share(i, j1);
      const double offset = std::abs(boxes.c(i2) * boxes.R(i1, j) - boxes.c(i1) * boxes.R(i2, j));
      const double edge_gap = (offset - reach) / sine;
      if (edge_gap > gap + kEdgePreference) gap = edge_gap, index = 6 + 3 * i + j;
    }
  // Keep the last direction of overlapping boxes, unless another is clearly better.
  if (gap < 0 && last >= 0 && last != index) {
    const BoxAxis kept = axis_of(boxes, last);
    if (kept.gap > gap - kKeepDepth + kKeepRatio * gap) return kept;
  }
  return axis_of(boxes, index);
}

// Corners and edges by number: a corner by its signs, an edge by its direction and two signs.

int corner_number(const Vector3d& signs) {
  return (signs.x() > 0 ? 1 : 0) + (signs.y() > 0 ? 2 : 0) + (signs.z() > 0 ? 4 : 0);
}

Vector3d corner_of(const Vector3d& half, int number) {
  return {number & 1 ? half.x() : -half.x(), number & 2 ? half.y() : -half.y(),
          number & 4 ? half.z() : -half.z()};
}

/// Returns the number of the edge between two neighbouring corners.
int edge_number(int corner, int other) {
  const int direction = (corner ^ other) == 1 ? 0 : (corner ^ other) == 2 ? 1 : 2;
  return 8 * direction + (corner & other);
}

/// Returns the corners of the face across axis k, counterclockwise seen from outside.
std::array<int, 4> face_corners(int k, bool positive) {
  const int u = 1 << (k + 1) % 3, v = 1 << (k + 2) % 3, base = positive ? 1 << k : 0;
  if (positive) return {base, base | u, base | u | v, base | v};
  return {base, base | v, base | u | v, base | u};
}

/// A corner of the clipped polygon, with the line from it to the next.
struct CutCorner {
  Vector3d p;  // [m] (3)
  int line;    // 0-3: side of the clipped face; 4-7: plane through a side of the clipping face
};

/// Polygon of a face that is clipped.
struct CutPolygon {
  std::array<CutCorner, 12> corners;
  int count = 0;
  void add(const Vector3d& p, int line) { corners[count++] = {p, line}; }
};

/// Returns the part of a polygon with  n.x <= offset.
CutPolygon clip(const CutPolygon& polygon, const Vector3d& n, double offset, int line) {
  CutPolygon kept;
  for (int i = 0; i < polygon.count; ++i) {
    const CutCorner& from = polygon.corners[i];
    const CutCorner& to = polygon.corners[(i + 1) % polygon.count];
    const double here = n.dot(from.p) - offset, there = n.dot(to.p) - offset;
    if (here <= 0) {
      // Leaving the half-space: the corner, then the point on the plane, where the plane's line
      // begins.
      kept.add(from.p, from.line);
      if (there > 0) kept.add(from.p + here / (here - there) * (to.p - from.p), line);
    } else if (there <= 0) {
      kept.add(from.p + here / (here - there) * (to.p - from.p), from.line);
    }
  }
  return kept;
}

/// A box in B's frame.
struct PosedBox {
  Matrix3d R;
  Vector3d c, half;
  [[nodiscard]] Vector3d corner(int number) const { return R * corner_of(half, number) + c; }
};

/// A face of a box.
struct BoxFace {
  int axis;
  bool positive;
  double alignment;  // cosine of its normal with the given direction [1]
};

/// Finds the face of a box whose normal is nearest to n.
BoxFace face_along(const PosedBox& box, const Vector3d& n) {
  const Vector3d local = box.R.transpose() * n;
  Eigen::Index axis;
  const double alignment = local.cwiseAbs().maxCoeff(&axis);
  return {static_cast<int>(axis), local(axis) > 0, alignment};
}

/// Clips the face of one box by the sides of a face of the other.
class FaceCut {
 public:
  FaceCut(const PosedBox& cutting, const BoxFace& face, const PosedBox& box, const BoxFace& other)
      : outer_(face_corners(face.axis, face.positive)),
        inner_(face_corners(other.axis, other.positive)) {
    normal_ = (face.positive ? 1 : -1) * cutting.R.col(face.axis);
    offset_ = normal_.dot(cutting.c) + cutting.half(face.axis);
    for (int i = 0; i < 4; ++i) polygon_.add(box.corner(inner_[i]), i);
    // Clip by the planes through the sides of the clipping face.
    for (int i = 0; i < 4 && polygon_.count > 0; ++i) {
      const int from = outer_[i], to = outer_[(i + 1) % 4];
      const int along = (from ^ to) == 1   ? 0
                        : (from ^ to) == 2 ? 1
                                           : 2,
                across = 3 - along - face.axis;
      const bool positive = (from >> across) & 1;
      const Vector3d n = (positive ? 1 : -1) * cutting.R.col(across);
      polygon_ = clip(polygon_, n, n.dot(cutting.c) + cutting.half(across), 4 + i);
    }
  }

  [[nodiscard]] int count() const { return polygon_.count; }
  [[nodiscard]] const Vector3d& at(int i) const { return polygon_.corners[i].p; }
  [[nodiscard]] const Vector3d& normal() const { return normal_; }
  /// Returns the height of a corner above the clipping face [m].
  [[nodiscard]] double height(int i) const { return normal_.dot(at(i)) - offset_; }

  /// Returns the key of the features that meet in a corner of the polygon.
  /// @param flipped  whether the clipping box is A
  [[nodiscard]] std::uint64_t feature(int i, bool flipped) const {
    const int before = polygon_.corners[(i + polygon_.count - 1) % polygon_.count].line;
    const int after = polygon_.corners[i].line;
    const auto corner = [](const std::array<int, 4>& face, int side) { return face[side % 4]; };
    if (before < 4 && after < 4)
      return feature_key(flipped ? FeatureKind::kVertexB : FeatureKind::kVertexA,
                         corner(inner_, after), 0);
    if (before >= 4 && after >= 4) {
      // Name the corner that both sides share, where two clipping planes meet.
      const int side = (before - 4 + 1) % 4 == after - 4 ? after - 4 : before - 4;
      return feature_key(flipped ? FeatureKind::kVertexA : FeatureKind::kVertexB,
                         corner(outer_, side), 0);
    }
    // Otherwise name the crossing of a side of the clipped face and a side of the clipping one.
    const int of_cut = std::min(before, after), of_cutting = std::max(before, after) - 4;
    const int inner = edge_number(corner(inner_, of_cut), corner(inner_, of_cut + 1));
    const int outer = edge_number(corner(outer_, of_cutting), corner(outer_, of_cutting + 1));
    return feature_key(FeatureKind::kEdges, flipped ? outer : inner, flipped ? inner : outer);
  }

 private:
  std::array<int, 4> outer_, inner_;  // corners of the clipping and of the clipped face
  Vector3d normal_;
  double offset_;
  CutPolygon polygon_;
};

constexpr double kMinClippingCosine = 0.98;  // cosine to the normal of a face that clips [1]
// Difference of cosines from which the reference face changes, 1 - cos 0.01 [1]
constexpr double kReferenceStep = 5e-5;

/// Adds points by clipping faces. @return the smallest gap among them, infinite if there is none
/// [m]
double add_face_points(const PosedBox& a, const PosedBox& b, const BoxAxis& axis, double margin,
                       PartMemory& memory, std::vector<ManifoldPoint>& points) {
  const BoxFace on_b = face_along(b, axis.n), on_a = face_along(a, -axis.n);
  // Select the face that clips; the last one is kept unless the other is better aligned.
  double least = kInfinity;
  int reference = on_b.alignment >= on_a.alignment ? 1 : 0;
  if (memory.reference >= 0 && std::abs(on_b.alignment - on_a.alignment) < kReferenceStep)
    reference = memory.reference;
  memory.reference = reference;
  const bool flipped = reference == 0;
  if ((flipped ? on_a : on_b).alignment < kMinClippingCosine) return least;
  const FaceCut cut = flipped ? FaceCut(a, on_a, b, on_b) : FaceCut(b, on_b, a, on_a);
  for (int i = 0; i < cut.count(); ++i) {
    // Take one point on the clipped face, the other below it on the clipping face.
    ManifoldPoint point;
    const Vector3d below = cut.at(i) - cut.height(i) * cut.normal();
    point.on_a = flipped ? below : cut.at(i);
    point.on_b = flipped ? cut.at(i) : below;
    point.normal = axis.n;
    point.gap = (point.on_a - point.on_b).dot(axis.n);
    least = std::min(least, point.gap);
    if (point.gap > margin) continue;
    point.feature = cut.feature(i, flipped);
    points.push_back(point);
  }
  return least;
}

/// Returns the corner of a box farthest along a direction.
int farthest_corner(const PosedBox& box, const Vector3d& n) {
  return corner_number(box.R.transpose() * n);
}

/// Computes the contact point where two edges cross, seen along n. The edges pass through the
/// corners farthest along n.
ManifoldPoint edge_point(const PosedBox& a, const PosedBox& b, const BoxAxis& axis) {
  const int k = (axis.index - 6) / 3, j = (axis.index - 6) % 3;
  const int corner_a = farthest_corner(a, -axis.n), corner_b = farthest_corner(b, axis.n);
  const Vector3d u = a.R.col(j), w = b.R.col(k);
  // Compute the centres of both edges, then the nearest points of their lines.
  Vector3d la = corner_of(a.half, corner_a), lb = corner_of(b.half, corner_b);
  la(j) = lb(k) = 0;
  const Vector3d pa = a.R * la + a.c, pb = b.R * lb + b.c, r = pa - pb;
  const double uw = u.dot(w), turn = 1 - uw * uw;
  const double s = std::clamp((uw * w.dot(r) - u.dot(r)) / turn, -a.half(j), a.half(j));
  const double t = std::clamp((w.dot(r) - uw * u.dot(r)) / turn, -b.half(k), b.half(k));
  const Vector3d on_a = pa + s * u, on_b = pb + t * w;
  return {on_a, on_b, axis.n, (on_a - on_b).dot(axis.n),
          feature_key(FeatureKind::kEdges, edge_number(corner_a & ~(1 << j), corner_a | 1 << j),
                      edge_number(corner_b & ~(1 << k), corner_b | 1 << k))};
}

constexpr double kDistanceError = 1e-7;  // error of the distance of nearest points [m]
constexpr double kGjkTolerance = 1e-10;  // tolerance of convex_distance() [m]

/// Finds the nearest points of two boxes.
ConvexDistance nearest_points(const PosedBox& a, const PosedBox& b, const Vector3d& guess,
                              double enough) {
  return convex_distance(
      [&](const Vector3d& n) {
        return SupportPoints{a.corner(farthest_corner(a, -n)), b.corner(farthest_corner(b, n))};
      },
      guess, kGjkTolerance, enough);
}

}  // namespace

double box_on_box(const CollisionPart& part_a, const CollisionPart& part_b,
                  const Pose<double>& X_BA, double margin, PartMemory& memory,
                  std::vector<ManifoldPoint>& points) {
  const BoxPair boxes{X_BA.R, X_BA.p, part_a.half, part_b.half};
  BoxAxis axis = best_axis(boxes, memory.overlapped ? memory.axis : -1);
  memory.axis = axis.index;
  memory.overlapped = axis.gap < 0;
  if (axis.gap > margin) return axis.gap;

  // Add points of faces, along the separating direction.
  const PosedBox a{X_BA.R, X_BA.p, part_a.half},
      b{Matrix3d::Identity(), Vector3d::Zero(), part_b.half};
  const std::size_t first = points.size();
  double least = add_face_points(a, b, axis, margin, memory, points);
  if (least <= axis.gap + kDistanceError) return axis.gap;
  // Add a crossing of edges, if it has the distance of that direction.
  if (axis.index >= 6) {
    const ManifoldPoint point = edge_point(a, b, axis);
    if (std::abs((point.on_a - point.on_b).norm() - std::abs(axis.gap)) < kDistanceError) {
      points.push_back(point);
      return axis.gap;
    }
  }
  if (axis.gap < 0) {
    if (points.size() > first) return axis.gap;
    // For an overlap without a face in between, add the deepest corner along the direction.
    const Vector3d deepest = a.corner(farthest_corner(a, -axis.n));
    points.push_back({deepest, deepest - axis.gap * axis.n, axis.n, axis.gap,
                      feature_key(FeatureKind::kWitness, 0, 0)});
    return axis.gap;
  }
  // If the nearest points are at a corner or edge, find them, and faces along their direction.
  const ConvexDistance near = nearest_points(a, b, axis.n, margin);
  if (near.n.isZero(0)) return axis.gap;
  points.resize(first);
  if (near.lower > margin) return near.lower;
  axis.n = near.n;
  axis.gap = near.distance;
  least = add_face_points(a, b, axis, margin, memory, points);
  if (least <= near.distance + kDistanceError) return near.distance;
  points.push_back({near.points.on_a, near.points.on_b, near.n, near.distance,
                    feature_key(FeatureKind::kWitness, 0, 0)});
  return near.distance;
}

}  // namespace thenar::internal
