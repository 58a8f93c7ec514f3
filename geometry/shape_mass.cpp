#include "geometry/shape_mass.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "base/error.h"
#include "base/lists.h"
#include "base/stop_scope.h"
#include "base/units.h"
#include "geometry/convex_body.h"
#include "geometry/mesh_check.h"
#include "geometry/mesh_parts.h"
#include "geometry/solid.h"

namespace thenar {
namespace {

Eigen::Matrix3d diagonal(double x, double y, double z) {
  return Eigen::Vector3d(x, y, z).asDiagonal();
}

MassProperties ellipsoid(const Eigen::Vector3d& s) {
  const double m = 4 * kPi / 3 * s.prod();
  const Eigen::Vector3d q = s.cwiseAbs2();
  return {m, {0, 0, 0}, m / 5 * diagonal(q.y() + q.z(), q.x() + q.z(), q.x() + q.y())};
}

MassProperties box(const Eigen::Vector3d& edges) {
  const double m = edges.prod();
  const Eigen::Vector3d q = edges.cwiseAbs2();
  return {m, {0, 0, 0}, m / 12 * diagonal(q.y() + q.z(), q.x() + q.z(), q.x() + q.y())};
}

MassProperties cylinder(double r, double height) {
  const double m = kPi * r * r * height, across = m * (3 * r * r + height * height) / 12;
  return {m, {0, 0, 0}, diagonal(across, across, m * r * r / 2)};
}

/// Returns the mass of a cylinder and two half balls, with centroids 3/8 r from their flat sides.
MassProperties capsule(double r, double height) {
  // Sum the cylinder and both half balls about the middle.
  MassProperties body = cylinder(r, height);
  const double m = 4 * kPi / 3 * r * r * r, h = height / 2;
  const double across = m * (2 * r * r / 5 + h * h + 3 * h * r / 4);
  body.mass += m;
  body.inertia += diagonal(across, across, m * 2 * r * r / 5);
  return body;
}

/// Mass properties of a superellipsoid, with B the beta function, by Dirichlet's integrals over  x
/// = a cos^e1 cos^e2, y = b cos^e1 sin^e2, z = c sin^e1:
///   volume = 2 abc e1 e2 B(e1/2, e1 + 1) B(e2/2, e2/2 + 1),
///   integral of x^2 = 1/2 a^3 bc e1 e2 B(3/2 e2, e2/2) B(e1/2, 2 e1 + 1),  of y^2 alike,
///   integral of z^2 = 2 ab c^3 e1 e2 B(e2/2, e2/2 + 1) B(3/2 e1, e1 + 1).
MassProperties superellipsoid(const Eigen::Vector3d& s, const Eigen::Vector2d& e) {
  // Compute volume and second moments by Dirichlet's integrals.
  const double size = s.prod() * e.prod(), turn = std::beta(e[1] / 2, e[1] / 2 + 1);
  const double across =
      size / 2 * std::beta(1.5 * e[1], e[1] / 2) * std::beta(e[0] / 2, 2 * e[0] + 1);
  const double x = s.x() * s.x() * across, y = s.y() * s.y() * across;
  const double z = 2 * size * s.z() * s.z() * turn * std::beta(1.5 * e[0], e[0] + 1);
  return {
      2 * size * std::beta(e[0] / 2, e[0] + 1) * turn, {0, 0, 0}, diagonal(y + z, x + z, x + y)};
}

/// Triangles that face inwards are turned first: each takes away twice what it holds.
MassProperties enclosed(const TriangleMesh& mesh) {
  if (mesh.empty()) return {};
  // Integrate a sound mesh directly, others part by part.
  const MeshReport found = check_mesh(mesh);
  if (found.watertight() && found.volume > 0) return signed_moments(mesh);
  std::vector<MassProperties> parts;
  for (const TriangleMesh& part : solids_or_none(mesh)) parts.push_back(signed_moments(part));
  return sum_of_masses(parts);
}

MassProperties in_own_frame(const ShapeSpec& shape) {
  const Eigen::Vector3d& s = shape.size;
  switch (shape.kind) {
    case ShapeKind::kSphere:
      return ellipsoid(Eigen::Vector3d::Constant(s.x()));
    case ShapeKind::kBox:
      return box(s);
    case ShapeKind::kCylinder:
      return cylinder(s.x(), s.y());
    case ShapeKind::kCapsule:
      return capsule(s.x(), s.y());
    case ShapeKind::kEllipsoid:
      return ellipsoid(s);
    case ShapeKind::kMesh:
      return enclosed(shape.mesh);
    case ShapeKind::kSuperellipsoid:
      return superellipsoid(s, shape.exponents);
    case ShapeKind::kTaperedCapsule:
      break;
  }
  throw InputError(fmt::format("the mass of a {} has no closed form here", name_of(shape.kind)));
}

}  // namespace

MassProperties mass_at_unit_density(const ShapeSpec& shape) {
  const MassProperties own = in_own_frame(shape);
  const Eigen::Matrix3d& R = shape.X_BS.R;
  return {own.mass, shape.X_BS * own.centre, R * own.inertia * R.transpose()};
}

MassProperties sum_of_masses(const std::vector<MassProperties>& parts) {
  // Compute the common centre.
  MassProperties sum;
  for (const MassProperties& part : parts) {
    sum.mass += part.mass;
    sum.centre += part.mass * part.centre;
  }
  if (sum.mass > 0) sum.centre /= sum.mass;
  // Compute the inertia about it by Steiner's theorem.
  for (const MassProperties& part : parts) {
    const Eigen::Vector3d r = part.centre - sum.centre;
    sum.inertia += part.inertia +
                   part.mass * (r.squaredNorm() * Eigen::Matrix3d::Identity() - r * r.transpose());
  }
  return sum;
}

namespace {

using Eigen::Vector3d;

constexpr int kTreeDepth = 7;            // maximum depth of the tree of cubes
constexpr int kFirstDepth = 3;           // minimum depth of the tree of cubes
constexpr double kTouchShare = 1e-9;     // overlap over the extent up to which parts only touch [1]
constexpr double kMaxFaces = 5e6;        // maximum number of faces of convex parts that are clipped
constexpr double kFaceCost = 0.3;        // cost of one such face, in evaluations of a distance [1]
constexpr std::size_t kFewParts = 2000;  // maximum number of parts that are compared in pairs
// Maximum number of distance evaluations of primitives at centres of cubes
constexpr double kMaxEvaluations = 1e7;
// Cost of a distance of a mesh or superellipsoid, in those of a primitive [1]
constexpr double kMeshCost = 10;
constexpr int kCoarseDepth = 4;  // depth for parts without a closed form if work is limited

/// One of the shapes of a union.
struct UnionPart {
  std::shared_ptr<const Shape> shape;  // body frame
  Eigen::AlignedBox3d box;
  bool has_moments = false;  // a closed form
  Moments moments;
  ConvexBody convex;  // empty: it is no convex polyhedron
  double look = 1;    // what one look at its distance counts
};

ConvexBody placed(ConvexBody body, const Pose<double>& X) {
  // Express corners, box and sides in the new frame.
  body.box.setEmpty();
  for (auto& face : body.faces)
    for (Vector3d& p : face) {
      p = X * p;
      body.box.extend(p);
    }
  for (HalfSpace& side : body.sides) {
    side.n = X.R * side.n;
    side.offset += side.n.dot(X.p);
  }
  return body;
}

UnionPart part_of(const ShapeSpec& spec) {
  // Set shape and box, and moments where there is a closed form.
  UnionPart part;
  part.shape = build_solid({spec}).shape;
  part.box = part.shape->bounds();
  part.has_moments = spec.kind != ShapeKind::kTaperedCapsule;
  if (part.has_moments) part.moments = moments_of(mass_at_unit_density(spec));
  if (spec.kind == ShapeKind::kMesh || spec.kind == ShapeKind::kSuperellipsoid)
    part.look = kMeshCost;
  // Store boxes and convex meshes as bodies that can be cut exactly.
  if (spec.kind == ShapeKind::kBox)
    part.convex = placed(convex_box({-spec.size / 2, spec.size / 2}), spec.X_BS);
  if (spec.kind == ShapeKind::kMesh) part.convex = placed(convex_body(spec.mesh), spec.X_BS);
  return part;
}

/// Returns whether two parts are the same points.
bool is_same(const ShapeSpec& a, const ShapeSpec& b) {
  return a.kind == b.kind && a.size == b.size && a.exponents == b.exponents &&
         a.X_BS.p == b.X_BS.p && a.X_BS.R == b.X_BS.R &&
         a.mesh.vertices.cols() == b.mesh.vertices.cols() &&
         a.mesh.triangles.cols() == b.mesh.triangles.cols() && a.mesh.vertices == b.mesh.vertices &&
         a.mesh.triangles == b.mesh.triangles;
}

/// Returns the shapes of a union without duplicates.
std::vector<UnionPart> parts_of(const std::vector<ShapeSpec>& shapes) {
  std::vector<UnionPart> parts;
  std::map<std::array<double, 6>, std::vector<ShapeSpec>> known;  // by the corners of their boxes
  const auto add = [&](const ShapeSpec& shape) {
    UnionPart part = part_of(shape);
    std::array<double, 6> corners;
    for (int k = 0; k < 3; ++k)
      corners[2 * k] = part.box.min()[k], corners[2 * k + 1] = part.box.max()[k];
    std::vector<ShapeSpec>& alike = known[corners];
    if (any_of(alike, [&](const ShapeSpec& other) { return is_same(other, shape); })) return;
    alike.push_back(shape);
    parts.push_back(std::move(part));
  };
  for (const ShapeSpec& shape : shapes) {
    if (shape.kind != ShapeKind::kMesh) {
      add(shape);
      continue;
    }
    // Replace a mesh by the solids that it bounds.
    for (TriangleMesh& mesh : solid_parts(shape.mesh)) {
      ShapeSpec one;
      one.kind = ShapeKind::kMesh;
      one.mesh = std::move(mesh);
      one.X_BS = shape.X_BS;
      add(one);
    }
  }
  return parts;
}

/// Returns the intersection of two boxes; empty if they only touch.
Eigen::AlignedBox3d common_box(const UnionPart& a, const UnionPart& b) {
  if (!a.box.intersects(b.box)) return {};
  const Eigen::AlignedBox3d box = a.box.intersection(b.box);
  const double least = kTouchShare * a.box.merged(b.box).diagonal().norm();
  return !box.isEmpty() && box.sizes().minCoeff() > least ? box : Eigen::AlignedBox3d();
}

using Parts = std::vector<const UnionPart*>;

/// Parts whose shadows on an axis overlap, directly or through others.
std::vector<Parts> split_along(int axis, Parts parts) {
  std::sort(parts.begin(), parts.end(), [&](const UnionPart* a, const UnionPart* b) {
    return a->box.min()[axis] < b->box.min()[axis];
  });
  std::vector<Parts> groups;
  double reach = 0;
  for (const UnionPart* part : parts) {
    if (groups.empty() || part->box.min()[axis] > reach) {
      groups.emplace_back();
      reach = part->box.max()[axis];
    }
    groups.back().push_back(part);
    reach = std::max(reach, part->box.max()[axis]);
  }
  return groups;
}

/// Groups of very many parts, between which nothing overlaps; within them something may not.
std::vector<Parts> coarse_clusters_of(const std::vector<UnionPart>& parts) {
  Parts all;
  for (const UnionPart& part : parts) all.push_back(&part);
  std::vector<Parts> groups{all};
  // Divide groups axis by axis, until none divides a group any more.
  for (int axis = 0, vain = 0; vain < 3; axis = (axis + 1) % 3) {
    std::vector<Parts> next;
    for (Parts& group : groups)
      for (Parts& part : split_along(axis, std::move(group))) next.push_back(std::move(part));
    vain = next.size() > groups.size() ? 0 : vain + 1;
    groups = std::move(next);
  }
  return groups;
}

/// Parts whose boxes overlap, directly or through others.
std::vector<Parts> clusters_of(const std::vector<UnionPart>& parts) {
  if (parts.size() > kFewParts) return coarse_clusters_of(parts);
  // Merge the groups of all parts that overlap.
  std::vector<std::size_t> group(parts.size());
  for (std::size_t i = 0; i < parts.size(); ++i) {
    group[i] = i;
    for (std::size_t j = 0; j < i; ++j) {
      if (group[j] == group[i] || common_box(parts[i], parts[j]).isEmpty()) continue;
      const std::size_t from = group[j], to = group[i];
      std::replace(group.begin(), group.begin() + i + 1, from, to);
    }
  }
  std::vector<Parts> clusters(parts.size());
  for (std::size_t i = 0; i < parts.size(); ++i) clusters[group[i]].push_back(&parts[i]);
  return clusters;
}

/// Sums over the cubes of a tree: the union of some parts, or how much more they are than it.
class CubeSum {
 public:
  /// @param excess  the sum of the parts less their union; else their union
  /// @param looks  that it may take
  CubeSum(const Parts& parts, bool excess, int depth, double looks)
      : parts_(parts), excess_(excess), depth_(depth), left_(looks) {}

  /// Returns whether it got to the end; else what it summed means nothing.
  [[nodiscard]] bool complete() const { return left_ >= 0; }
  /// Looks that it did not take.
  [[nodiscard]] double left() const { return left_; }

  Moments over(const Eigen::AlignedBox3d& box) {
    sum_ = {};
    tolerance_ = 1e-12 * box.diagonal().norm();
    add(box, 0, parts_);
    return sum_;
  }

 private:
  // NOLINTNEXTLINE(misc-no-recursion): as deep as cubes are halved
  void add(const Eigen::AlignedBox3d& box, int level, const Parts& above, int whole = 0) {
    // Count parts that fill the cube, and collect those whose surfaces may pass through it.
    const double reach = box.diagonal().norm() / 2;
    Parts through;
    end_if_stopped();
    left_ -= kPassWeight * static_cast<double>(above.size());
    if (!complete()) return;
    for (const UnionPart* part : above) {
      if (part->box.exteriorDistance(box.center()) > reach) continue;
      left_ -= part->look;
      const double distance = part->shape->distance(box.center()), slack = part->shape->accuracy();
      if (distance < -reach - slack) ++whole;
      if (!excess_ && whole > 0) break;
      if (std::abs(distance) <= reach + slack) through.push_back(part);
    }
    const auto passing = static_cast<int>(through.size());
    // Return if nothing counts in this cube.
    if (whole + passing < (excess_ ? 2 : 1)) return;
    // Add the whole cube if no surface passes through it.
    if (passing == 0 || (!excess_ && whole > 0)) {
      const Moments cube = moments_of(convex_box(box));
      for (int i = 0; i < (excess_ ? whole - 1 : 1); ++i) sum_ += cube;
      return;
    }
    if (level == depth_) {
      add_cut(box, through, whole);
      return;
    }
    // Otherwise its eight halves.
    const Vector3d half = box.sizes() / 2;
    for (int c = 0; c < 8; ++c) {
      const Vector3d low = box.min() + half.cwiseProduct(Vector3d(c & 1, c >> 1 & 1, c >> 2 & 1));
      add({low, low + half}, level + 1, through, whole);
    }
  }

  /// Adds a smallest cube, in which each part is the space below the plane nearest to the middle.
  void add_cut(const Eigen::AlignedBox3d& box, const Parts& through, int whole) {
    // Replace each part by the cube below its nearest plane.
    std::vector<ConvexBody> filled;
    for (const UnionPart* part : through) {
      const NearestSurface near = part->shape->nearest(box.center());
      ConvexBody body = convex_box(box);
      clip(body, {near.normal, near.normal.dot(box.center()) - near.distance}, tolerance_);
      if (!body.empty()) filled.push_back(std::move(body));
    }
    // Union of the parts in the cube, or how often it is counted too often.
    if (whole == 0) {
      const UnionMoments all = union_moments(filled, tolerance_, left_ / kFaceCost);
      left_ -= kFaceCost * all.work;
      if (!all.complete) left_ = -1;
      if (!excess_) sum_ += all.moments;
      if (excess_) sum_ -= all.moments;
    } else if (excess_) {
      const Moments cube = moments_of(convex_box(box));
      for (int i = 1; i < whole; ++i) sum_ += cube;
    }
    if (excess_)
      for (const ConvexBody& body : filled) sum_ += moments_of(body);
  }

  // Cost of passing by a part, in evaluations of a distance [1]
  static constexpr double kPassWeight = 0.1;

  const Parts& parts_;
  bool excess_;
  int depth_;
  double left_;
  double tolerance_ = 0;
  Moments sum_;
};

/// A cube around all that two parts may have in common, or around all parts.
Eigen::AlignedBox3d cube_around(const Parts& parts, bool excess) {
  Eigen::AlignedBox3d box;
  excess = excess && parts.size() <= kFewParts;
  for (const UnionPart* a : parts) {
    if (!excess) box.extend(a->box);
    for (const UnionPart* b : parts)
      if (excess && a < b) box.extend(common_box(*a, *b));
  }
  // Enlarge the cube, so that faces of the parts' boxes are not faces of cubes.
  const Vector3d half = Vector3d::Constant(0.5013 * box.sizes().maxCoeff());
  return {box.center() - half, box.center() + half};
}

struct Summed {
  Moments moments;
  double error = 0;  // [m^3]
};

/// Computes the moments of a part without a closed form by coarse cubes; if these take too long,
/// returns the moments of its box.
Moments coarse_moments(const UnionPart& part, double looks) {
  const Parts alone{&part};
  CubeSum cubes(alone, false, kCoarseDepth, looks);
  const Moments sum = cubes.over(cube_around(alone, false));
  return cubes.complete() ? sum : moments_of(convex_box(part.box));
}

/// Returns the sum of the parts, regardless of overlaps: their union contains the largest of them.
Summed upper_bound(const Parts& parts) {
  const double looks = kMaxEvaluations / static_cast<double>(parts.size());
  Summed result;
  double largest = 0;
  for (const UnionPart* part : parts) {
    const Moments own = part->has_moments ? part->moments : coarse_moments(*part, looks);
    result.moments += own;
    largest = std::max(largest, own.volume);
  }
  result.error = result.moments.volume - largest;
  return result;
}

/// Sums over finer and finer cubes, as far as the work goes; the change at the last step is the
/// error. Where not even coarse cubes can be summed it is the upper bound.
/// @param looks  that it may take
Summed sum_cubes(const Parts& parts, double looks) {
  Moments all;
  for (const UnionPart* part : parts) all += part->moments;
  // The excess of parts that overlap little is smaller than their union, and so is its error.
  bool excess = all_of(parts, [](const UnionPart* part) { return part->has_moments; });
  std::optional<Summed> result;
  double before = 0;  // volume of the sum at the depth before [m^3]
  for (int depth = kFirstDepth; depth <= kTreeDepth; ++depth) {
    CubeSum cubes(parts, excess, depth, looks);
    const Moments sum = cubes.over(cube_around(parts, excess));
    if (!cubes.complete()) break;
    looks = cubes.left();
    if (depth == kFirstDepth && excess && sum.volume > all.volume / 2) {
      // They overlap more than they are: their union is the smaller sum.
      excess = false;
      depth = kFirstDepth - 1;
      continue;
    }
    if (depth > kFirstDepth) {
      result = Summed{sum, std::abs(sum.volume - before)};
      if (excess) {
        result->moments = all;
        result->moments -= sum;
      }
    }
    before = sum.volume;
  }
  return result ? *result : upper_bound(parts);
}

/// @param share  of all work that these parts may take
Summed moments_of_cluster(const Parts& parts, double share) {
  // Compute a single part, or convex parts, exactly.
  if (parts.size() == 1 && parts[0]->has_moments) return {parts[0]->moments, 0};
  std::vector<ConvexBody> convex;
  double extent = 0;
  for (const UnionPart* part : parts) {
    if (part->convex.empty()) return sum_cubes(parts, share * kMaxEvaluations);
    convex.push_back(part->convex);
    extent = std::max(extent, part->box.diagonal().norm());
  }
  const UnionMoments exact = union_moments(convex, 1e-12 * extent, share * kMaxFaces);
  if (!exact.complete) return sum_cubes(parts, share * kMaxEvaluations);
  return {exact.moments, 0};
}

}  // namespace

UnionMass union_mass(const std::vector<ShapeSpec>& shapes) {
  require(!shapes.empty(), "a solid needs at least one shape");
  const std::vector<UnionPart> parts = parts_of(shapes);
  // Sum groups of overlapping parts, each with its share of the work.
  Moments sum;
  double error = 0;
  for (const Parts& cluster : clusters_of(parts)) {
    if (cluster.empty()) continue;
    const double share = static_cast<double>(cluster.size()) / static_cast<double>(parts.size());
    const Summed found = moments_of_cluster(cluster, share);
    sum += found.moments;
    error += found.error;
  }
  return {mass_of(sum), sum.volume > 0 ? error / sum.volume : 0};
}

}  // namespace thenar
