#include "grasp/contact/contact_patch.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <Eigen/Eigenvalues>

#include "base/error.h"
#include "base/lists.h"
#include "base/numbers.h"
#include "geometry/collision/patch_reduction.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

constexpr double kMinRegionCosine = 0.86602540378443865;  // 30 degrees between normals [1]
constexpr double kPointReach = 1e-4;  // distance within which faces belong to a point [m]
constexpr double kFitStep = 2e-4;     // finite-difference step around a nearest point [m]
constexpr double kMaxFitStep = 1e-3;  // maximum step to a nearest point [m]
constexpr double kMinCurvature = 1;   // curvature above which a distance has a minimum [1/m]
constexpr double kMinFitStep = 1e-8;  // step below which a contact is not moved [m]
constexpr int kPointRefinements = 3;  // maximum number of steps to a nearest point
constexpr double kCoarseRatio = 4;    // resolution of the first search over that of the rim [1]

/// A connected group of pieces of A that are near B.
struct Region {
  Ball ball;  // bounding ball of the points [m]
  PatchPoint nearest;
  Vector3d normal;  // into B, at the nearest point (3)
};

/// A piece of A with its contact normal.
struct Pressing {
  PatchPiece piece;
  Vector3d normal;  // into B, at its nearest point (3)
};

bool are_neighbours(const Pressing& x, const Pressing& y, double link) {
  const Ball &a = x.piece.ball, &b = y.piece.ball;
  return (a.c - b.c).norm() <= a.r + b.r + link && x.normal.dot(y.normal) >= kMinRegionCosine;
}

/// Groups pieces joined by chains of neighbours: entry i is the group of piece i.
std::vector<std::size_t> group_pieces(const std::vector<Pressing>& pieces, double link) {
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
      if (root(i) != root(j) && are_neighbours(pieces[i], pieces[j], link))
        group[root(i)] = root(j);
  for (std::size_t i = 0; i < pieces.size(); ++i) group[i] = root(i);
  return group;
}

/// Returns the region of one group of pieces.
Region region_of(const std::vector<Pressing>& pieces, const std::vector<std::size_t>& group,
                 std::size_t wanted) {
  Eigen::AlignedBox3d box;
  Region region{{}, pieces[wanted].piece.points.front(), pieces[wanted].normal};
  // Bounding box of all balls of the group, and the nearest of their points.
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

/// Projects contacts onto the plane perpendicular to a normal (2, points) [m].
Eigen::Matrix2Xd project_contacts(const std::vector<HandContact>& contacts,
                                  const Vector3d& normal) {
  const Tangents t = tangents(normal);
  return as_columns(contacts, [&](const HandContact& each) {
    return Eigen::Vector2d(t.e1.dot(each.contact.p), t.e2.dot(each.contact.p));
  });
}

/// Returns the gap between two ranges of numbers; negative: they overlap.
double gap_between(const Eigen::RowVectorXd& x, const Eigen::RowVectorXd& y) {
  return std::max(y.minCoeff() - x.maxCoeff(), x.minCoeff() - y.maxCoeff());
}

/// Returns the distance of the convex hulls of points in a plane, 0 or less if they meet: the
/// maximum separation along the lines between points and perpendicular to them (separating axes).
double hull_distance(const Eigen::Matrix2Xd& x, const Eigen::Matrix2Xd& y) {
  Eigen::Matrix2Xd all(2, x.cols() + y.cols());
  all << x, y;
  double widest = -kInfinity;
  for (Eigen::Index i = 0; i < all.cols(); ++i)
    for (Eigen::Index j = 0; j < i; ++j) {
      const Eigen::Vector2d along = all.col(i) - all.col(j);
      if (along.isZero(0)) continue;
      for (const Eigen::Vector2d& axis : {along, Eigen::Vector2d(-along.y(), along.x())})
        widest =
            std::max(widest, gap_between(axis.transpose() * x, axis.transpose() * y) / axis.norm());
    }
  return std::isfinite(widest) ? widest : 0;  // all points coincide
}

/// Finds A's triangles at a point in A's frame.
std::vector<const SweptTriangle*> triangles_at(const CollisionTree& a, const Vector3d& p) {
  std::vector<const SweptTriangle*> triangles;
  std::vector<int> nodes{0};
  // Descend into balls that are near the point.
  while (!nodes.empty()) {
    const CollisionNode& node = a.nodes[nodes.back()];
    nodes.pop_back();
    if ((node.ball.c - p).norm() > node.ball.r + kPointReach) continue;
    if (node.triangle < 0) {
      nodes.push_back(node.left);
      nodes.push_back(node.right);
      continue;
    }
    // Leaf: keep the triangle if it is near enough.
    const SweptTriangle& t = a.triangles[node.triangle];
    if ((internal::nearest_in_triangle(t.corners, p) - p).norm() <= kPointReach)
      triangles.push_back(&t);
  }
  return triangles;
}

/// Returns the step in a plane to the minimum of a quadratic model of the distance to B at p, along
/// axes with positive curvature; zero along others (2) [m].
Eigen::Vector2d step_to_minimum(const Shape& b, const Vector3d& p, const Tangents& plane) {
  Eigen::Matrix<double, 3, 2> axes_of_plane;
  axes_of_plane << plane.e1, plane.e2;
  // Finite differences of normals, which are slopes of the distance.
  const Vector3d n = b.nearest(p).normal;
  Eigen::Matrix2d curve;
  for (int k = 0; k < 2; ++k)
    curve.col(k) = axes_of_plane.transpose() *
                   (b.nearest(p + kFitStep * axes_of_plane.col(k)).normal - n) / kFitStep;
  const Eigen::Vector2d slope = axes_of_plane.transpose() * n;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> axes(
      Eigen::MatrixXd((curve + curve.transpose()) / 2));
  // Newton step along axes with positive curvature.
  Eigen::Vector2d step = Eigen::Vector2d::Zero();
  for (int k = 0; k < 2; ++k)
    if (axes.eigenvalues()[k] > kMinCurvature)
      step -= axes.eigenvectors().col(k) *
              (axes.eigenvectors().col(k).dot(slope) / axes.eigenvalues()[k]);
  return step.norm() > kMaxFitStep ? Eigen::Vector2d(step * (kMaxFitStep / step.norm())) : step;
}

/// Search for contact patches in B's frame.
class PatchFinder {
 public:
  PatchFinder(const CollisionTree& a, const Pose<double>& X_BA, const Shape& b, double friction,
              const ContactPatchOptions& options)
      : a_(a), X_BA_(X_BA), b_(b), friction_(friction), options_(options) {}

  ContactPatches run() {
    if (is_far()) return std::move(result_);
    // Coarse search for all pieces of A within the tolerance of B.
    PatchQuery coarse;
    coarse.level = options_.tolerance;
    coarse.resolution = kCoarseRatio * options_.resolution;
    coarse.max_evaluations = options_.max_evaluations;
    std::vector<Pressing> pieces;
    for (PatchPiece& piece : search(coarse)) {
      const Vector3d n = normal_at(piece.points.front());
      pieces.push_back({std::move(piece), n});
    }
    // Neighbouring pieces with similar normals form one region, and each region one patch.
    const std::vector<std::size_t> group = group_pieces(pieces, options_.resolution);
    for (std::size_t i = 0; i < pieces.size(); ++i)
      if (group[i] == i) add_patch(region_of(pieces, group, i));
    std::sort(result_.patches.begin(), result_.patches.end(),
              [](const ContactPatch& x, const ContactPatch& y) { return x.distance < y.distance; });
    return std::move(result_);
  }

 private:
  /// Returns whether the bodies are certainly too far apart to touch; this is cheaper than a search
  /// for pieces.
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

  /// Reduces a region to a patch.
  void add_patch(Region region) {
    if (is_slope(region)) return;
    find_nearest(region);
    refine(region);
    // Project the contact points of the region onto its tangent plane.
    const std::vector<PatchPoint> points = touching_points(region);
    const Tangents t = tangents(region.normal);
    const Eigen::Matrix2Xd flat = as_columns(points, [&](const PatchPoint& point) {
      return Eigen::Vector2d(t.e1.dot(point.on_b), t.e2.dot(point.on_b));
    });
    // Reduce them to corners of their convex hull.
    const ReducedPoints reduced = reduce_points(flat, options_.merge, options_.max_points);
    ContactPatch patch{{}, region.nearest.distance, reduced.loss, region.normal};
    for (const int i : reduced.kept) patch.contacts.push_back(contact_at(points[i]));
    // The boundary that gives several corners is only known to the resolution.
    if (reduced.kept.size() > 1) patch.loss += options_.resolution;
    result_.patches.push_back(std::move(patch));
  }

  /// Finds the points of a region within the band above its nearest point, which comes first.
  std::vector<PatchPoint> touching_points(const Region& region) {
    // Fine search in the region.
    PatchQuery fine;
    fine.level = region.nearest.distance + std::max(options_.band, 2 * b_.accuracy());
    fine.aim = region.nearest.distance + options_.band / 2;
    fine.resolution = options_.resolution;
    fine.within = region.ball;
    fine.max_evaluations = options_.max_evaluations;
    fine.halvings = kRimHalvings;
    std::vector<PatchPoint> points{region.nearest};
    // Points with opposite normals, like those around an edge, belong to another region.
    for (const PatchPiece& piece : search(fine))
      for (const PatchPoint& point : piece.points)
        if (-point.normal.dot(region.normal) >= kMinRegionCosine ||
            normal_at(point).dot(region.normal) >= kMinRegionCosine)
          points.push_back(point);
    return points;
  }

  /// Finds the nearest point of A within a ball, to a fraction of the band; any point if it exceeds
  /// the cutoff.
  PatchPoint nearest_within(const Ball& ball, double cutoff) {
    SignedDistanceOptions exactly;
    exactly.tolerance = options_.band / 5;
    exactly.cutoff = cutoff;
    exactly.within = ball;
    exactly.max_evaluations = options_.max_evaluations;
    const SignedDistance s = signed_distance(a_, X_BA_, b_, exactly);
    const double radius = a_.triangles[s.triangle].radius;
    return {s.on_a + radius * s.normal, s.distance, s.on_b, s.normal, radius};
  }

  /// Returns whether the region is only the slope towards a nearer point of another region.
  bool is_slope(const Region& region) {
    const double nearer = region.nearest.distance - options_.band;
    const PatchPoint around =
        nearest_within({region.nearest.core, kCoarseRatio * options_.resolution}, nearer);
    return around.distance < nearer && normal_at(around).dot(region.normal) < kMinRegionCosine;
  }

  /// Replaces the nearest point of a region by that of a finer search, if it has a similar normal.
  void find_nearest(Region& region) {
    const PatchPoint point = nearest_within(region.ball, region.nearest.distance);
    if (point.distance >= region.nearest.distance) return;
    const Vector3d n = normal_at(point);
    if (n.dot(region.normal) >= kMinRegionCosine) region.nearest = point, region.normal = n;
  }

  /// Moves the nearest point to the minimum of the distance in its triangle: the search ends within
  /// a fraction of the band, which on a ball of 25 mm is up to 0.2 mm beside the minimum.
  void refine(Region& region) const {
    if (b_.accuracy() > 0) return;
    PatchPoint point = region.nearest;
    for (int k = 0; k < kPointRefinements; ++k) {
      const PatchPoint last = point;
      // On an edge or corner the point may continue in any adjacent triangle.
      for (const SweptTriangle* t : triangles_at(a_, X_BA_.inverse() * last.core))
        if (const PatchPoint moved = moved_within(*t, last); moved.distance < point.distance)
          point = moved;
      if (point.distance >= last.distance) break;
    }
    if (normal_at(point).dot(region.normal) >= kMinRegionCosine)
      region.nearest = point, region.normal = normal_at(point);
  }

  /// Returns the minimum of a quadratic model of the distance around a point of a triangle.
  [[nodiscard]] PatchPoint moved_within(const SweptTriangle& triangle,
                                        const PatchPoint& point) const {
    if (triangle.n.isZero()) return point;
    const Tangents t = tangents(X_BA_.R * triangle.n);
    const Eigen::Vector2d step = step_to_minimum(b_, point.core, t);
    if (step.norm() < kMinFitStep) return point;
    const Vector3d goal = point.core + step[0] * t.e1 + step[1] * t.e2;
    const Vector3d core =
        X_BA_ * internal::nearest_in_triangle(triangle.corners, X_BA_.inverse() * goal);
    return patch_point(core, b_.nearest(core), point.radius);
  }

  [[nodiscard]] Vector3d normal_at(const PatchPoint& point) const {
    return contact_normal(point, a_, X_BA_, b_);
  }

  [[nodiscard]] HandContact contact_at(const PatchPoint& point) const {
    return {{point.on_b, normal_at(point), friction_, 0}, -1, std::max(0.0, -point.distance)};
  }

  static constexpr int kRimHalvings = 5;  // number of bisections of a side at the rim

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
  if (x.normal.dot(y.normal) < kMinRegionCosine) return {};
  const ContactPatch& nearer = x.distance <= y.distance ? x : y;
  const Eigen::Matrix2Xd on_x = project_contacts(x.contacts, nearer.normal),
                         on_y = project_contacts(y.contacts, nearer.normal);
  // Heights of the contacts along the common normal.
  const auto along_normal = [&](const ContactPatch& patch) {
    Eigen::RowVectorXd heights(static_cast<Eigen::Index>(patch.contacts.size()));
    for (std::size_t i = 0; i < patch.contacts.size(); ++i)
      heights[i] = nearer.normal.dot(patch.contacts[i].contact.p);
    return heights;
  };
  // Patches that are apart along the normal or in the plane are not merged.
  if (gap_between(along_normal(x), along_normal(y)) > options.resolution ||
      hull_distance(on_x, on_y) > options.resolution)
    return {};

  // Reduce the points of both to the corners of one hull.
  std::vector<HandContact> all = nearer.contacts;
  const ContactPatch& other = &nearer == &x ? y : x;
  append_all(all, other.contacts);
  const ReducedPoints reduced =
      reduce_points(project_contacts(all, nearer.normal), options.merge, options.max_points);
  ContactPatch merged{{}, nearer.distance, std::max(x.loss, y.loss) + reduced.loss, nearer.normal};
  for (const int i : reduced.kept) merged.contacts.push_back(all[i]);
  return merged;
}

std::vector<HandContact> number_patch_contacts(const std::vector<ContactPatch>& patches) {
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

constexpr double kMaxFaceCosine = 0.984807753012208;  // cosine of 10 degrees between faces [1]
constexpr double kMinEdgeSine = 0.17364817766693;     // sine of 10 degrees between edges [1]
constexpr double kSharpCosine = kMinRegionCosine;     // cosine of 30 degrees at an edge [1]
constexpr double kMinMeanNormal = 0.1;  // norm of a sum of normals that has a direction [1]

/// Normals of B at a contact point and around it.
struct Around {
  std::vector<Vector3d> normals;  // unit (3)
  Vector3d middle;                // mean of the normals, unit (3)
  bool sharp = false;             // whether it is an edge or a corner, and not a groove
};

/// Evaluates the normals of B around a contact point.
Around around(const PatchPoint& point, const Shape& b) {
  const Tangents t = tangents(point.normal);
  const std::vector<Vector3d> directions{t.e1, -t.e1, t.e2, -t.e2};
  Around result{{}, point.normal, false};
  std::vector<Vector3d>& normals = result.normals;
  // Normals of B at four points around the contact.
  for (const Vector3d& direction : directions) {
    normals.push_back(b.nearest(point.on_b + kPointReach * direction).normal);
    result.middle += normals.back();
  }
  // It is sharp if two normals diverge in the direction of their points; in a groove they converge.
  for (std::size_t i = 0; i < directions.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (normals[i].dot(normals[j]) < kSharpCosine &&
          (normals[i] - normals[j]).dot(directions[i] - directions[j]) > 0)
        result.sharp = true;
  // Normals that cancel out have no mean: use that of the nearest point.
  const double length = result.middle.norm();
  result.middle = length > kMinMeanNormal ? (result.middle / length).eval() : point.normal;
  return result;
}

/// Returns the normals of A's triangles at a point in A's frame.
std::vector<Vector3d> normals_of(const CollisionTree& a, const Vector3d& p) {
  return transformed(triangles_at(a, p), [](const SweptTriangle* t) { return t->n; });
}

/// Returns the mean of the normals; zero if two of them differ too much, or a segment or point has
/// none.
Vector3d mean_normal(const std::vector<Vector3d>& normals) {
  Vector3d sum = Vector3d::Zero();
  for (const Vector3d& x : normals) {
    for (const Vector3d& y : normals)
      if (!(x.dot(y) >= kSharpCosine)) return Vector3d::Zero();
    sum += x;
  }
  return sum.stableNormalized();
}

/// An edge between two faces, by their outward normals.
struct Edge {
  Vector3d first, second;  // the two normals that differ most, unit (3)
  Vector3d along;          // direction of the edge, unit; zero: a corner or a face (3)

  /// Returns whether a direction perpendicular to the edge points outwards between its faces.
  [[nodiscard]] bool points_out(const Vector3d& direction) const {
    const Vector3d turn = first.cross(second);
    return first.cross(direction).dot(turn) > 0 && direction.cross(second).dot(turn) > 0;
  }
};

/// Finds the edge of two normals that differ most.
Edge edge_of(const std::vector<Vector3d>& normals) {
  Edge edge{Vector3d::Zero(), Vector3d::Zero(), Vector3d::Zero()};
  double min_cosine = kSharpCosine;
  for (const Vector3d& x : normals)
    for (const Vector3d& y : normals)
      if (x.dot(y) < min_cosine) min_cosine = x.dot(y), edge.first = x, edge.second = y;
  edge.along = edge.first.cross(edge.second).stableNormalized();
  // A corner has normals off the plane of these two.
  for (const Vector3d& n : normals)
    if (std::abs(n.dot(edge.along)) > kMinEdgeSine) edge.along.setZero();
  return edge;
}

/// Returns the direction perpendicular to two edges that cross, into B; zero if there are no edges,
/// or they are parallel or do not face each other.
Vector3d normal_of_edges(const Around& near, const Eigen::Matrix3d& R_BA,
                         const std::vector<Vector3d>& normals_A) {
  const Edge of_a = edge_of(normals_A), of_b = edge_of(near.normals);
  Vector3d n = (R_BA * of_a.along).cross(of_b.along);
  if (n.norm() < kMinEdgeSine) return Vector3d::Zero();
  n.normalize();
  if (n.dot(near.middle) > 0) n = -n;
  // The orientation of A's triangles is unknown.
  const Vector3d n_A = R_BA.transpose() * n;
  const bool faces = (of_a.points_out(n_A) || of_a.points_out(-n_A)) && of_b.points_out(-n);
  return faces ? n : Vector3d::Zero();
}

/// Returns the contact normal of two sharp features. First choice: normal of the face of A that is
/// most nearly on a face of B. Second: inward normal of the face of B that is most nearly parallel
/// to a face of A, like the sides of flush blocks. Third: the normal of two edges. Last: the mean
/// normal into B.
Vector3d normal_of_sharp_features(const Around& near, const Eigen::Matrix3d& R_BA,
                                  const std::vector<Vector3d>& normals_A) {
  const Vector3d crossing = normal_of_edges(near, R_BA, normals_A);
  Vector3d on = -near.middle, beside = crossing.isZero(0) ? Vector3d(-near.middle) : crossing;
  double max_on = kMaxFaceCosine, max_beside = kMaxFaceCosine;
  for (const Vector3d& n : near.normals)
    for (const Vector3d& of_a : normals_A) {
      const Vector3d n_A = R_BA * of_a;
      // Opposite faces are on each other; parallel ones are flush.
      const double same = n.dot(n_A);
      if (-same > max_on) on = n_A, max_on = -same;
      if (same > max_beside) beside = -n, max_beside = same;
    }
  return max_on > kMaxFaceCosine ? on : beside;
}

}  // namespace

Vector3d contact_normal(const PatchPoint& point, const CollisionTree& a, const Pose<double>& X_BA,
                        const Shape& b) {
  // A rounded core is outside of B: its direction is the normal of both.
  if (point.radius > 0 && point.distance + point.radius > 0) return -point.normal;
  const Around near = around(point, b);
  // A smooth B has one normal.
  if (!near.sharp) return -point.normal;
  const std::vector<Vector3d> normals_A = normals_of(a, X_BA.inverse() * point.core);
  // On a sharp B the normal of a smooth A is used, with the sign that points into B.
  const Vector3d n = X_BA.R * mean_normal(normals_A);
  if (n.isZero()) return normal_of_sharp_features(near, X_BA.R, normals_A);
  return n.dot(near.middle) > 0 ? (-n).eval() : n;
}

}  // namespace thenar
