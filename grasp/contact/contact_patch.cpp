#include "grasp/contact/contact_patch.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "base/error.h"
#include "geometry/collision/collision_tree.h"
#include "geometry/collision/patch_reduction.h"
#include "geometry/collision/patch_search.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

// Normals of one region turn by at most 30 degrees: its cosine [1]
constexpr double kCosTurn = 0.86602540378443865;
constexpr double kPointReach = 1e-4;  // Faces within this distance of a point count as its own [m]
constexpr double kFitStep = 2e-4;     // Step that measures the surroundings of a nearest point [m]
constexpr double kLongestFit = 1e-3;  // Longest step to a nearest point [m]
constexpr double kLeastCurve = 1;     // Least curvature of distances that have a minimum [1/m]
constexpr double kStillStep = 1e-8;   // Shorter steps move no contact [m]
constexpr int kPointRefinements = 3;  // Refinements of a nearest point
constexpr double kCoarseRatio = 4;    // Resolution of the first search, over that of the rim [1]

/// A connected group of pieces of A that are near B.
struct Region {
  Ball ball;  // around their points [m]
  PatchPoint nearest;
  Vector3d normal;  // into B, at the nearest point (3)
};

/// A piece of A and the direction in which it presses.
struct Pressing {
  PatchPiece piece;
  Vector3d normal;  // into B, at its nearest point (3)
};

bool neighbours(const Pressing& x, const Pressing& y, double link) {
  const Ball &a = x.piece.ball, &b = y.piece.ball;
  return (a.c - b.c).norm() <= a.r + b.r + link && x.normal.dot(y.normal) >= kCosTurn;
}

/// Groups of pieces joined by chains of neighbours: entry i is the group of piece i.
std::vector<std::size_t> groups_of(const std::vector<Pressing>& pieces, double link) {
  std::vector<std::size_t> group(pieces.size());
  std::iota(group.begin(), group.end(), std::size_t{0});
  // Union-find with path halving.
  const auto root = [&](std::size_t i) {
    while (group[i] != i) i = group[i] = group[group[i]];
    return i;
  };
  // Join every pair of neighbours.
  for (std::size_t i = 0; i < pieces.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (root(i) != root(j) && neighbours(pieces[i], pieces[j], link)) group[root(i)] = root(j);
  for (std::size_t i = 0; i < pieces.size(); ++i) group[i] = root(i);
  return group;
}

Region region_of(const std::vector<Pressing>& pieces, const std::vector<std::size_t>& group,
                 std::size_t wanted) {
  Eigen::AlignedBox3d box;
  Region region{{}, pieces[wanted].piece.points.front(), pieces[wanted].normal};
  // The box around all balls of the group, and its nearest point.
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (group[i] != wanted) continue;
    const auto& [ball, points] = pieces[i].piece;
    box.extend((ball.c.array() - ball.r).matrix());
    box.extend((ball.c.array() + ball.r).matrix());
    if (points.front().distance < region.nearest.distance)
      region.nearest = points.front(), region.normal = pieces[i].normal;
  }
  region.ball = {box.center(), box.diagonal().norm() / 2};
  return region;
}

/// Points of contact in the plane across a normal (2, points) [m].
Eigen::Matrix2Xd flat(const std::vector<HandContact>& contacts, const Vector3d& normal) {
  const Tangents t = tangents(normal);
  Eigen::Matrix2Xd points(2, static_cast<Eigen::Index>(contacts.size()));
  for (std::size_t i = 0; i < contacts.size(); ++i)
    points.col(static_cast<Eigen::Index>(i)) << t.e1.dot(contacts[i].contact.p),
        t.e2.dot(contacts[i].contact.p);
  return points;
}

/// Width of the gap between two ranges of numbers; negative: they overlap.
double between(const Eigen::RowVectorXd& x, const Eigen::RowVectorXd& y) {
  return std::max(y.minCoeff() - x.maxCoeff(), x.minCoeff() - y.maxCoeff());
}

/// Distance of the convex hulls of points in a plane, 0 or less if they meet: the largest
/// separation along the lines between points and across these lines (separating axes).
double distance_of_hulls(const Eigen::Matrix2Xd& x, const Eigen::Matrix2Xd& y) {
  Eigen::Matrix2Xd all(2, x.cols() + y.cols());
  all << x, y;
  double widest = -std::numeric_limits<double>::infinity();
  for (Eigen::Index i = 0; i < all.cols(); ++i)
    for (Eigen::Index j = 0; j < i; ++j) {
      const Eigen::Vector2d along = all.col(i) - all.col(j);
      if (along.isZero(0)) continue;
      for (const Eigen::Vector2d& axis : {along, Eigen::Vector2d(-along.y(), along.x())})
        widest =
            std::max(widest, between(axis.transpose() * x, axis.transpose() * y) / axis.norm());
    }
  return std::isfinite(widest) ? widest : 0;  // all points coincide
}

/// A's triangles at a point of A's frame.
std::vector<const SweptTriangle*> triangles_at(const CollisionTree& a, const Vector3d& p) {
  std::vector<const SweptTriangle*> triangles;
  std::vector<int> nodes{0};
  // Descend into the balls that come near the point.
  while (!nodes.empty()) {
    const CollisionNode& node = a.nodes[static_cast<std::size_t>(nodes.back())];
    nodes.pop_back();
    if ((node.ball.c - p).norm() > node.ball.r + kPointReach) continue;
    if (node.triangle < 0) {
      nodes.push_back(node.left);
      nodes.push_back(node.right);
      continue;
    }
    // Leaf: keep the triangle if it is near enough.
    const SweptTriangle& t = a.triangles[static_cast<std::size_t>(node.triangle)];
    if ((internal::nearest_in_triangle(t.corners, p) - p).norm() <= kPointReach)
      triangles.push_back(&t);
  }
  return triangles;
}

/// Step in a plane to where the distance to B is least by its quadratic at p, along axes on which
/// it is curved; zero where it is not (2) [m].
Eigen::Vector2d step_to_least(const Shape& b, const Vector3d& p, const Tangents& plane) {
  Eigen::Matrix<double, 3, 2> axes_of_plane;
  axes_of_plane << plane.e1, plane.e2;
  // Normals are slopes of the distance.
  const Vector3d n = b.nearest(p).normal;
  Eigen::Matrix2d curve;
  for (int k = 0; k < 2; ++k)
    curve.col(k) = axes_of_plane.transpose() *
                   (b.nearest(p + kFitStep * axes_of_plane.col(k)).normal - n) / kFitStep;
  const Eigen::Vector2d slope = axes_of_plane.transpose() * n;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes((curve + curve.transpose()) / 2);
  Eigen::Vector2d step = Eigen::Vector2d::Zero();
  for (int k = 0; k < 2; ++k)
    if (axes.eigenvalues()[k] > kLeastCurve)
      step -= axes.eigenvectors().col(k) *
              (axes.eigenvectors().col(k).dot(slope) / axes.eigenvalues()[k]);
  return step.norm() > kLongestFit ? Eigen::Vector2d(step * (kLongestFit / step.norm())) : step;
}

/// Patches in B's frame.
class PatchFinder {
 public:
  PatchFinder(const CollisionTree& a, const Pose<double>& X_BA, const Shape& b, double friction,
              const ContactPatchOptions& options)
      : a_(a), X_BA_(X_BA), b_(b), friction_(friction), options_(options) {}

  ContactPatches run() {
    if (is_far()) return std::move(result_);
    // Coarse search: all pieces of A within the tolerance of B.
    PatchQuery coarse;
    coarse.level = options_.tolerance;
    coarse.resolution = kCoarseRatio * options_.resolution;
    coarse.max_evaluations = options_.max_evaluations;
    std::vector<Pressing> pieces;
    for (PatchPiece& piece : search(coarse)) {
      const Vector3d n = into(piece.points.front());
      pieces.push_back({std::move(piece), n});
    }
    // Pieces that are neighbours and press alike form one region, and each region one patch.
    const std::vector<std::size_t> group = groups_of(pieces, options_.resolution);
    for (std::size_t i = 0; i < pieces.size(); ++i)
      if (group[i] == i) add_patch(region_of(pieces, group, i));
    std::sort(result_.patches.begin(), result_.patches.end(),
              [](const ContactPatch& x, const ContactPatch& y) { return x.distance < y.distance; });
    return std::move(result_);
  }

 private:
  /// Returns whether the bodies are surely too far apart to touch: cheaper than to search for
  /// pieces.
  bool is_far() {
    SignedDistanceOptions roughly;
    roughly.tolerance = options_.tolerance;
    roughly.cutoff = options_.tolerance;
    roughly.max_evaluations = options_.max_evaluations;
    const SignedDistance s = signed_distance(a_, X_BA_, b_, roughly);
    return s.distance > options_.tolerance &&
           (std::isinf(s.error) || s.distance - s.error > options_.tolerance);
  }

  std::vector<PatchPiece> search(const PatchQuery& query) {
    PatchPieces found = near_pieces(a_, X_BA_, b_, query);
    result_.complete = result_.complete && found.complete;
    return std::move(found.pieces);
  }

  void add_patch(Region region) {
    if (is_slope(region)) return;
    find_nearest(region);
    refine(region);
    // Contact points of the region in its tangent plane.
    const std::vector<PatchPoint> points = touching(region);
    const Tangents t = tangents(region.normal);
    Eigen::Matrix2Xd flat(2, static_cast<Eigen::Index>(points.size()));
    for (std::size_t i = 0; i < points.size(); ++i)
      flat.col(static_cast<Eigen::Index>(i)) << t.e1.dot(points[i].on_b), t.e2.dot(points[i].on_b);
    // Corners of their convex hull, merged where they are near each other.
    const ReducedPoints reduced = reduce_points(flat, options_.merge, options_.max_points);
    ContactPatch patch{{}, region.nearest.distance, reduced.loss, region.normal};
    for (const int i : reduced.kept)
      patch.contacts.push_back(contact_at(points[static_cast<std::size_t>(i)]));
    // Several corners come from a rim that is found to the resolution only.
    if (reduced.kept.size() > 1) patch.loss += options_.resolution;
    result_.patches.push_back(std::move(patch));
  }

  /// Points of a region in the band above its nearest, which comes first.
  std::vector<PatchPoint> touching(const Region& region) {
    // Fine search in the region: the points within the band above its nearest point.
    PatchQuery fine;
    fine.level = region.nearest.distance + std::max(options_.band, 2 * b_.accuracy());
    fine.aim = region.nearest.distance + options_.band / 2;
    fine.resolution = options_.resolution;
    fine.within = region.ball;
    fine.max_evaluations = options_.max_evaluations;
    fine.halvings = kRimHalvings;
    std::vector<PatchPoint> points{region.nearest};
    // Points that press the other way, like those round an edge, belong to another region.
    for (const PatchPiece& piece : search(fine))
      for (const PatchPoint& point : piece.points)
        if (-point.normal.dot(region.normal) >= kCosTurn ||
            into(point).dot(region.normal) >= kCosTurn)
          points.push_back(point);
    return points;
  }

  /// Nearest point of A within a ball, to a fraction of the band; any point if it exceeds the
  /// cutoff.
  PatchPoint nearest_within(const Ball& ball, double cutoff) {
    SignedDistanceOptions exactly;
    exactly.tolerance = options_.band / 5;
    exactly.cutoff = cutoff;
    exactly.within = ball;
    exactly.max_evaluations = options_.max_evaluations;
    const SignedDistance s = signed_distance(a_, X_BA_, b_, exactly);
    const double radius = a_.triangles[static_cast<std::size_t>(s.triangle)].radius;
    return {s.on_a + radius * s.normal, s.distance, s.on_b, s.normal, radius};
  }

  /// Returns whether the region is only the slope towards a nearer point of another region.
  bool is_slope(const Region& region) {
    const double nearer = region.nearest.distance - options_.band;
    const PatchPoint around =
        nearest_within({region.nearest.core, kCoarseRatio * options_.resolution}, nearer);
    return around.distance < nearer && into(around).dot(region.normal) < kCosTurn;
  }

  void find_nearest(Region& region) {
    // A finer search may find a nearer point of the same region.
    const PatchPoint point = nearest_within(region.ball, region.nearest.distance);
    if (point.distance >= region.nearest.distance) return;
    const Vector3d n = into(point);
    if (n.dot(region.normal) >= kCosTurn) region.nearest = point, region.normal = n;
  }

  /// Moves the nearest point to where the distance is least within its triangle: the search ends
  /// within a fraction of the band, on a ball of 25 mm up to 0.2 mm beside the place.
  void refine(Region& region) const {
    if (b_.accuracy() > 0) return;
    PatchPoint point = region.nearest;
    for (int k = 0; k < kPointRefinements; ++k) {
      const PatchPoint last = point;
      // On a side or a corner of triangles each of them may go on.
      for (const SweptTriangle* t : triangles_at(a_, X_BA_.inverse() * last.core))
        if (const PatchPoint moved = moved_within(*t, last); moved.distance < point.distance)
          point = moved;
      if (point.distance >= last.distance) break;
    }
    if (into(point).dot(region.normal) >= kCosTurn)
      region.nearest = point, region.normal = into(point);
  }

  /// The point where the distance is least by its quadratic around a point of a triangle.
  [[nodiscard]] PatchPoint moved_within(const SweptTriangle& triangle,
                                        const PatchPoint& point) const {
    if (triangle.n.isZero()) return point;
    const Tangents t = tangents(X_BA_.R * triangle.n);
    const Eigen::Vector2d step = step_to_least(b_, point.core, t);
    if (step.norm() < kStillStep) return point;
    const Vector3d goal = point.core + step[0] * t.e1 + step[1] * t.e2;
    const Vector3d core =
        X_BA_ * internal::nearest_in_triangle(triangle.corners, X_BA_.inverse() * goal);
    const NearestSurface at = b_.nearest(core);
    return {core,
            at.distance - point.radius,
            core - at.distance * at.normal,
            at.normal,
            point.radius,
            at.supports};
  }

  [[nodiscard]] Vector3d into(const PatchPoint& point) const {
    return contact_normal(point, a_, X_BA_, b_);
  }

  [[nodiscard]] HandContact contact_at(const PatchPoint& point) const {
    return {{point.on_b, into(point), friction_, 0}, -1, std::max(0.0, -point.distance)};
  }

  static constexpr int kRimHalvings = 5;  // Most halvings of a triangle at the rim

  const CollisionTree& a_;
  const Pose<double> X_BA_;
  const Shape& b_;
  const double friction_;
  const ContactPatchOptions options_;
  ContactPatches result_{{}, true};
};

}  // namespace

ContactPatches contact_patches(const CollisionTree& a, const Pose<double>& X_WA, const Solid& b,
                               const Pose<double>& X_WB, double friction,
                               const ContactPatchOptions& options) {
  require(friction >= 0 && std::isfinite(friction), "friction must be finite and >= 0, got {}",
          friction);
  require(options.tolerance > 0 && options.resolution > 0 && options.band > 0,
          "tolerance, resolution and band must be positive, got {}, {} and {} m", options.tolerance,
          options.resolution, options.band);
  require(b.shape != nullptr, "a solid without a {} cannot be touched", "shape");
  return PatchFinder(a, X_WB.inverse() * X_WA, *b.shape, friction, options).run();
}

std::optional<ContactPatch> merge_patches(const ContactPatch& x, const ContactPatch& y,
                                          const ContactPatchOptions& options) {
  if (x.normal.dot(y.normal) < kCosTurn) return {};
  const ContactPatch& nearer = x.distance <= y.distance ? x : y;
  const Eigen::Matrix2Xd on_x = flat(x.contacts, nearer.normal),
                         on_y = flat(y.contacts, nearer.normal);
  // Heights of the contacts along the common normal.
  const auto along_normal = [&](const ContactPatch& patch) {
    Eigen::RowVectorXd heights(static_cast<Eigen::Index>(patch.contacts.size()));
    for (std::size_t i = 0; i < patch.contacts.size(); ++i)
      heights[static_cast<Eigen::Index>(i)] = nearer.normal.dot(patch.contacts[i].contact.p);
    return heights;
  };
  // Patches that are apart along the normal or in the plane stay two.
  if (between(along_normal(x), along_normal(y)) > options.resolution ||
      distance_of_hulls(on_x, on_y) > options.resolution)
    return {};

  // Reduce the points of both to the corners of one hull.
  std::vector<HandContact> all = nearer.contacts;
  const ContactPatch& other = &nearer == &x ? y : x;
  all.insert(all.end(), other.contacts.begin(), other.contacts.end());
  const ReducedPoints reduced =
      reduce_points(flat(all, nearer.normal), options.merge, options.max_points);
  ContactPatch one{{}, nearer.distance, std::max(x.loss, y.loss) + reduced.loss, nearer.normal};
  for (const int i : reduced.kept) one.contacts.push_back(all[static_cast<std::size_t>(i)]);
  return one;
}

std::vector<HandContact> contacts_of(const std::vector<ContactPatch>& patches) {
  std::vector<HandContact> contacts;
  int number = 0;
  for (const ContactPatch& patch : patches) {
    for (HandContact contact : patch.contacts) {
      contact.contact.patch = number;
      contacts.push_back(contact);
    }
    ++number;
  }
  return contacts;
}

namespace {

using Eigen::Vector3d;

constexpr double kCosFlat = 0.984807753012208;     // Cosine of 10 degrees [1]
constexpr double kSinFlat = 0.17364817766693;      // Sine of 10 degrees [1]
constexpr double kCosSharp = 0.86602540378443865;  // Cosine of 30 degrees [1]

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
  // Normals of B at four points around the contact.
  for (const Vector3d& way : ways) {
    normals.push_back(b.nearest(point.on_b + kPointReach * way).normal);
    result.middle += normals.back();
  }
  // Sharp: two normals diverge in the direction of their points, as at an edge; in a groove they
  // converge.
  for (std::size_t i = 0; i < ways.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (normals[i].dot(normals[j]) < kCosSharp &&
          (normals[i] - normals[j]).dot(ways[i] - ways[j]) > 0)
        result.sharp = true;
  // Normals that cancel out have no mean: take the nearest point's.
  const double length = result.middle.norm();
  result.middle = length > 0.1 ? (result.middle / length).eval() : point.normal;
  return result;
}

/// Normals of A's triangles at a point of A's frame.
std::vector<Vector3d> normals_of(const CollisionTree& a, const Vector3d& p) {
  std::vector<Vector3d> normals;
  for (const SweptTriangle* t : triangles_at(a, p)) normals.push_back(t->n);
  return normals;
}

/// Mean of the normals; zero if two of them differ too much, or if a segment or point has none.
Vector3d common(const std::vector<Vector3d>& normals) {
  Vector3d sum = Vector3d::Zero();
  for (const Vector3d& x : normals) {
    for (const Vector3d& y : normals)
      if (!(x.dot(y) >= kCosSharp)) return Vector3d::Zero();
    sum += x;
  }
  return sum.stableNormalized();
}

/// An edge between two faces, by their outward normals.
struct Edge {
  Vector3d first, second;  // normals that differ most, unit (3)
  Vector3d along;          // unit, or zero: no edge, but a corner or a face (3)

  /// Returns whether a direction across the edge points out between its faces.
  [[nodiscard]] bool lets_out(const Vector3d& way) const {
    const Vector3d turn = first.cross(second);
    return first.cross(way).dot(turn) > 0 && way.cross(second).dot(turn) > 0;
  }
};

Edge edge_of(const std::vector<Vector3d>& normals) {
  Edge edge{Vector3d::Zero(), Vector3d::Zero(), Vector3d::Zero()};
  double least = kCosSharp;
  for (const Vector3d& x : normals)
    for (const Vector3d& y : normals)
      if (x.dot(y) < least) least = x.dot(y), edge.first = x, edge.second = y;
  edge.along = edge.first.cross(edge.second).stableNormalized();
  // A corner has normals beside the plane of these two.
  for (const Vector3d& n : normals)
    if (std::abs(n.dot(edge.along)) > kSinFlat) edge.along.setZero();
  return edge;
}

/// Direction across two edges that cross, into B; zero where there are none, or they are parallel
/// or do not face each other.
Vector3d across_edges(const Around& near, const Eigen::Matrix3d& R_BA,
                      const std::vector<Vector3d>& normals_A) {
  const Edge of_a = edge_of(normals_A), of_b = edge_of(near.normals);
  Vector3d n = (R_BA * of_a.along).cross(of_b.along);
  if (n.norm() < kSinFlat) return Vector3d::Zero();
  n.normalize();
  if (n.dot(near.middle) > 0) n = -n;
  // Triangles of A may be flipped.
  const Vector3d n_A = R_BA.transpose() * n;
  const bool face = (of_a.lets_out(n_A) || of_a.lets_out(-n_A)) && of_b.lets_out(-n);
  return face ? n : Vector3d::Zero();
}

/// Contact direction between two sharp places. First choice: normal of the face of A that lies most
/// nearly on a face of B. Second: the inward normal of the face of B that looks most nearly as a
/// face of A does, as the sides of flush blocks do. Third: across two edges. Last: the mean normal
/// into B.
Vector3d of_face(const Around& near, const Eigen::Matrix3d& R_BA,
                 const std::vector<Vector3d>& normals_A) {
  const Vector3d across = across_edges(near, R_BA, normals_A);
  Vector3d on = -near.middle, beside = across.isZero(0) ? Vector3d(-near.middle) : across;
  double most_on = kCosFlat, most_beside = kCosFlat;
  for (const Vector3d& n : near.normals)
    for (const Vector3d& of_a : normals_A) {
      const Vector3d n_A = R_BA * of_a;
      // Opposite faces lie on each other; parallel ones are flush.
      const double same = n.dot(n_A);
      if (-same > most_on) on = n_A, most_on = -same;
      if (same > most_beside) beside = -n, most_beside = same;
    }
  return most_on > kCosFlat ? on : beside;
}

}  // namespace

Vector3d contact_normal(const PatchPoint& point, const CollisionTree& a, const Pose<double>& X_BA,
                        const Shape& b) {
  // A rounded core sees B from outside: its direction is the normal of both.
  if (point.radius > 0 && point.distance + point.radius > 0) return -point.normal;
  const Around near = around(point, b);
  // A smooth B has one normal.
  if (!near.sharp) return -point.normal;
  const std::vector<Vector3d> normals_A = normals_of(a, X_BA.inverse() * point.core);
  // On a sharp B the normal of a smooth A counts, in the sense that points into B.
  const Vector3d n = X_BA.R * common(normals_A);
  if (n.isZero()) return of_face(near, X_BA.R, normals_A);
  return n.dot(near.middle) > 0 ? (-n).eval() : n;
}

}  // namespace thenar
