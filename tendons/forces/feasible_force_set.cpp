#include "tendons/forces/feasible_force_set.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <Eigen/QR>
#include <Eigen/SVD>

#include "base/lists.h"
#include "base/numbers.h"
#include "solvers/convex_hull.h"
#include "solvers/linear_program.h"
#include "tendons/forces/tip_balance.h"

namespace thenar {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Largest excess of the support over a facet, over the extent [1]
constexpr double kCertifiedExcess = 1e-9;
// Largest excess for a thin set, whose rounding is larger [1]
constexpr double kAcceptedExcess = 1e-6;
constexpr double kFlatWidth = 1e-9;  // width over size below which a set is flat [1]
constexpr double kPointSize = 1e-9;  // size below which a set is a point, in force units [1]
// Distance over extent below which support points coincide [1]
constexpr double kSamePoint = 1e-10;
constexpr double kStraightEdge = 1e-6;  // smallest sine of the angle of a corner [1]
// Largest relative difference of the volumes by x, y and z [1]
constexpr double kVolumeDifference = 1e-9;
constexpr int kMaxRounds = 200;  // rounds of hull growth; about 6 are needed

/// Point of the set, with activations that produce it.
struct Point {
  VectorXd phi;  // coordinates along the first r columns of U, in force units (r)
  VectorXd a;    // (m)
  double gap;    // bound of how much farther the set may reach, in the unit of the search direction
};

/// Oracle of the farthest point of the set in any direction.
class SupportOracle {
 public:
  explicit SupportOracle(const internal::TipBalance& balance)
      : r_(balance.rank),
        program_(internal::balance_program(balance, balance.force_part.leftCols(r_))) {}

  [[nodiscard]] Index dimension() const { return r_; }
  [[nodiscard]] Status worst() const { return worst_; }  // worst status of all results so far

  /// Finds the farthest point in a direction.
  Point farthest(const VectorXd& direction) {
    program_.objective.head(r_) = direction;
    LinearResult result = solve(program_);
    if (result.status != Status::kSolved) {
      worst_ = result.status;
      result.x.setZero();  // no such point
    }
    return {result.x.head(r_), result.x.tail(result.x.size() - r_), result.certificate.gap};
  }

 private:
  Index r_;
  LinearProgram program_;
  Status worst_ = Status::kSolved;
};

/// Orthonormal axes along which the set has width, and half that width.
struct Frame {
  VectorXd centre;  // (r)
  MatrixXd axes;    // (r, d)
  VectorXd half;    // (d)

  [[nodiscard]] VectorXd local(const VectorXd& phi) const {
    return (axes.transpose() * (phi - centre)).cwiseQuotient(half);
  }
  /// Computes u with u' phi = normal' local(phi) + constant: of order one over the set, however
  /// thin.
  [[nodiscard]] VectorXd outward(const VectorXd& local_normal) const {
    return axes * local_normal.cwiseQuotient(half);
  }
};

/// Appends a column.
void append(const VectorXd& column, MatrixXd& matrix) {
  matrix.conservativeResize(column.size(), matrix.cols() + 1);
  matrix.rightCols<1>() = column;
}

/// Computes the component of a - b across `known`, projected twice to remove rounding.
VectorXd across(const MatrixXd& known, const Point& a, const Point& b) {
  VectorXd difference = a.phi - b.phi;
  for (int twice = 0; twice < 2; ++twice) difference -= known * (known.transpose() * difference);
  return difference;
}

/// Returns the longest difference from the first point across `known`.
VectorXd widest_across(const MatrixXd& known, const std::vector<Point>& points) {
  VectorXd best = VectorXd::Zero(points.front().phi.size());
  for (const Point& point : points) {
    const VectorXd difference = across(known, point, points.front());
    if (difference.norm() > best.norm()) best = difference;
  }
  return best;
}

/// Returns some unit vector across `known`.
VectorXd any_across(const MatrixXd& known) {
  const Eigen::HouseholderQR<MatrixXd> qr(known);
  return MatrixXd(qr.householderQ()).col(known.cols());
}

/// Finds the affine hull: the set is flat across every direction that is not in the frame.
Frame span(SupportOracle& oracle, std::vector<Point>& points) {
  // Define how to add support points in both senses; returns the width between them.
  const Index r = oracle.dimension();
  const auto add_both_ways = [&](const VectorXd& u) {
    points.push_back(oracle.farthest(u));
    points.push_back(oracle.farthest(-u));
    return u.dot(points[points.size() - 2].phi - points.back().phi);
  };
  // Find support points along the axes, and the size of the set.
  for (Index i = 0; i < r; ++i) add_both_ways(VectorXd::Unit(r, i));
  double size = 0;
  for (const Point& point : points) size = std::max(size, point.phi.norm());
  const double flat = std::max(kFlatWidth * size, kPointSize);

  Frame frame{VectorXd::Zero(r), MatrixXd(r, 0), VectorXd(0)};
  // Add one direction after the other, each across those known.
  MatrixXd known(r, 0);
  while (known.cols() < r) {
    // Follow the longest difference; if there is none, some direction.
    VectorXd u = widest_across(known, points);
    bool wide = u.norm() > flat;
    u = wide ? u.normalized() : any_across(known);
    double width = add_both_ways(u);
    if (!wide && width > flat) {  // a difference of at least that length was found
      wide = true;
      u = across(known, points[points.size() - 2], points.back()).normalized();
      width = add_both_ways(u);
    }
    append(u, known);
    if (!wide) continue;
    append(u, frame.axes);
    frame.half.conservativeResize(frame.axes.cols());
    frame.half(frame.axes.cols() - 1) = width / 2;
  }
  // Compute the centre.
  for (const Point& point : points) frame.centre += point.phi / static_cast<double>(points.size());
  return frame;
}

/// Converts points to the frame.
MatrixXd local_points(const Frame& frame, const std::vector<Point>& points) {
  MatrixXd local(static_cast<Index>(points.size()), frame.half.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    local.row(static_cast<Index>(i)) = frame.local(points[i].phi);
  return local;
}

/// Adds a point unless it is there. @return whether it was added
bool add_new(const Frame& frame, const Point& point, std::vector<Point>& points) {
  const VectorXd local = frame.local(point.phi);
  for (const Point& old : points)
    if ((frame.local(old.phi) - local).norm() < kSamePoint) return false;
  points.push_back(point);
  return true;
}

std::vector<Point> distinct(const Frame& frame, const std::vector<Point>& points) {
  std::vector<Point> kept;
  for (const Point& point : points) add_new(frame, point, kept);
  return kept;
}

bool same_plane(const HullFacet& a, const HullFacet& b) {
  return (a.normal - b.normal).norm() < 1e-12 && std::abs(a.offset - b.offset) < 1e-12;
}

/// A hull, and the amount by which the set may exceed a facet of it, over the extent [1].
struct CertifiedHull {
  ConvexHull hull;
  double excess;
};

/// Grows the hull until the farthest point over every facet lies on it.
CertifiedHull grow(SupportOracle& oracle, const Frame& frame, std::vector<Point>& points) {
  std::vector<HullFacet> certified;
  double excess = 0;
  for (int round = 0; round < kMaxRounds; ++round) {
    // Compute the hull of the points so far.
    ConvexHull hull = convex_hull(local_points(frame, points));
    if (!hull.message.empty()) return {std::move(hull), excess};
    bool grown = false;
    double open = 0;  // excess over facets without a new point
    // Find the farthest point over every facet that is not certified yet.
    for (const HullFacet& facet : hull.facets) {
      if (any_of(certified, [&](const HullFacet& other) { return same_plane(facet, other); }))
        continue;
      const Point beyond = oracle.farthest(frame.outward(facet.normal));
      const double over = facet.normal.dot(frame.local(beyond.phi)) + beyond.gap - facet.offset;
      // Grow the hull by a new point.
      if (over > kCertifiedExcess && add_new(frame, beyond, points)) grown = true;
      open = max_or_nan(open, over);
      if (over > kCertifiedExcess) continue;
      certified.push_back(facet);
      excess = max_or_nan(excess, over);
    }
    excess = max_or_nan(excess, grown ? 0.0 : open);
    if (!grown) return {std::move(hull), excess};
  }
  return {{{}, "the hull of feasible forces did not close", {}}, excess};
}

/// Keeps the points where facets of d independent directions meet: true corners, not points that a
/// tie left inside an edge or a facet.
std::vector<Point> corners(const ConvexHull& hull, const Frame& frame,
                           const std::vector<Point>& points) {
  std::vector<Point> kept;
  for (const Point& point : points) {
    const VectorXd local = frame.local(point.phi);
    // Collect the normals of the facets that meet at the point.
    MatrixXd normals(local.size(), 0);
    for (const HullFacet& facet : hull.facets)
      if (facet.normal.dot(local) > facet.offset - kCertifiedExcess) append(facet.normal, normals);
    if (normals.cols() < local.size()) continue;
    // Keep a corner with as many independent normals as dimensions.
    const VectorXd sigma = Eigen::JacobiSVD<MatrixXd>(normals).singularValues();
    if (sigma(local.size() - 1) > kStraightEdge) kept.push_back(point);
  }
  return kept;
}

/// Sorts the corners of a polygon by their angle about the centre.
void sort_ring(const Frame& frame, std::vector<Point>& points) {
  // Compute the centre, and angles about it.
  VectorXd centre = VectorXd::Zero(2);
  for (const Point& point : points)
    centre += frame.local(point.phi) / static_cast<double>(points.size());
  const auto angle = [&](const Point& point) {
    const VectorXd arm = frame.local(point.phi) - centre;
    return std::atan2(arm(1), arm(0));
  };
  std::sort(points.begin(), points.end(),
            [&](const Point& a, const Point& b) { return angle(a) < angle(b); });
}

/// Adds a fan of triangles over a polygon.
void add_fan(const std::vector<int>& ring, FeasibleForceSet& set) {
  for (std::size_t i = 2; i < ring.size(); ++i) {
    set.triangles.conservativeResize(set.triangles.rows() + 1, 3);
    set.triangles.bottomRows<1>() << ring[0], ring[i - 1], ring[i];
  }
}

/// Computes the volume, area or length of the set.
double set_volume(const FeasibleForceSet& set) {
  const auto vertex = [&](Index i) -> Eigen::Vector3d { return set.vertices.row(i); };
  // Return 1 for a point, the length of an edge.
  if (set.dimension == 0) return 1;
  if (set.dimension == 1) return (vertex(1) - vertex(0)).norm();
  // Sum over triangles the area, or the volume of the cone over the first vertex.
  double total = 0;
  for (Index i = 0; i < set.triangles.rows(); ++i) {
    const Eigen::Vector3d a = vertex(set.triangles(i, 1)) - vertex(set.triangles(i, 0));
    const Eigen::Vector3d b = vertex(set.triangles(i, 2)) - vertex(set.triangles(i, 0));
    total += set.dimension == 2 ? a.cross(b).norm() / 2
                                : (vertex(set.triangles(i, 0)) - vertex(0)).dot(a.cross(b)) / 6;
  }
  return total;
}

/// Writes the vertices with their tensions and activations.
void write_points(const TipStatics& statics, const internal::TipBalance& balance,
                  const std::vector<Point>& points, FeasibleForceSet& set) {
  // Allocate all vertices.
  const auto k = static_cast<Index>(points.size());
  set.vertices.resize(k, 3);
  set.tension.resize(k, balance.upper.size());
  set.activation.resize(k, balance.upper.size());
  // Write force, tensions and activations of each vertex.
  for (Index i = 0; i < k; ++i) {
    const Point& point = points[i];
    set.vertices.row(i) = balance.force_unit * (balance.U.leftCols(balance.rank) * point.phi);
    set.tension.row(i) = internal::tension(balance, point.a);
    set.activation.row(i) = internal::activation(statics, set.tension.row(i));
    set.imbalance = max_or_nan(
        set.imbalance, internal::imbalance(statics, set.vertices.row(i), set.tension.row(i)));
  }
}

/// Writes the facets of a solid.
void write_facets(const internal::TipBalance& balance, const Frame& frame, const ConvexHull& hull,
                  FeasibleForceSet& set) {
  // Write outward normals in world axes, and a fan of triangles for each facet.
  const auto sides = static_cast<Index>(hull.facets.size());
  set.normals.resize(sides, 3);
  for (Index i = 0; i < sides; ++i) {
    const HullFacet& facet = hull.facets[i];
    set.normals.row(i) =
        balance.U.leftCols(balance.rank) * frame.outward(facet.normal).normalized();
    std::vector<int> ring = facet.ring;
    // Reverse the rings if the frame is left-handed in the world.
    if ((balance.U.leftCols(balance.rank) * frame.axes).determinant() < 0)
      std::reverse(ring.begin(), ring.end());
    add_fan(ring, set);
  }
  set.offsets = (set.normals * set.vertices.transpose()).rowwise().maxCoeff();
}

/// Returns whether every edge occurs once in each sense, so that the triangles close a surface.
bool closed(const Eigen::MatrixX3i& triangles) {
  std::set<std::pair<int, int>> open;
  for (Index i = 0; i < triangles.rows(); ++i)
    for (int k = 0; k < 3; ++k) {
      const std::pair<int, int> edge(triangles(i, k), triangles(i, (k + 1) % 3));
      if (open.erase({edge.second, edge.first}) == 0 && !open.insert(edge).second) return false;
    }
  return open.empty();
}

/// Writes a set that has width in two or three directions.
void write_hull(const TipStatics& statics, const internal::TipBalance& balance,
                SupportOracle& oracle, const Frame& frame, const std::vector<Point>& support,
                FeasibleForceSet& set) {
  const auto stall = [&](const std::string& why) {
    set.status = Status::kStalled;
    set.message = why;
  };
  // Compute the hull of support points, then of its corners alone.
  std::vector<Point> points = distinct(frame, support);
  auto [hull, excess] = grow(oracle, frame, points);
  set.excess = excess;
  if (hull.message.empty()) {
    points = corners(hull, frame, points);
    hull = convex_hull(local_points(frame, points));
  }
  if (!hull.message.empty()) return stall(hull.message);
  if (oracle.worst() != Status::kSolved) return stall("a linear program stalled");
  // Check that facets are certified.
  if (!(set.excess <= kAcceptedExcess)) return stall("a facet of the hull could not be certified");
  // Write a polygon's corners in order, or a solid's facets as triangles.
  if (set.dimension == 2) sort_ring(frame, points);
  write_points(statics, balance, points, set);
  if (set.dimension == 3) {
    write_facets(balance, frame, hull, set);
    const HullCheck& check = hull.check;
    if (!(closed(set.triangles) && check.closed &&
          check.volume_error <= kVolumeDifference * check.volume))
      stall("nearly flat facets leave a gap in the hull");
    return;
  }
  std::vector<int> ring(points.size());
  std::iota(ring.begin(), ring.end(), 0);
  add_fan(ring, set);
}

}  // namespace

FeasibleForceSet feasible_force_set(const TipStatics& statics) {
  const internal::TipBalance balance = internal::tip_balance(statics);
  FeasibleForceSet set;
  set.tension = set.activation = MatrixXd(0, statics.R.rows());
  set.carried = balance.U.rightCols(3 - balance.rank);

  // Find the affine hull; an empty or unbounded set is detected here.
  SupportOracle oracle(balance);
  std::vector<Point> points{oracle.farthest(VectorXd::Zero(balance.rank))};
  Frame frame;
  if (oracle.worst() == Status::kSolved) frame = span(oracle, points);
  set.status = oracle.worst();
  if (set.status != Status::kSolved) return set;

  set.dimension = static_cast<int>(frame.half.size());
  if (set.dimension == 0) write_points(statics, balance, {points.front()}, set);
  if (set.dimension == 1) {
    const VectorXd along = frame.axes.col(0);
    const Point low = oracle.farthest(-along), high = oracle.farthest(along);
    write_points(statics, balance, {low, high}, set);
    set.excess = std::max(low.gap, high.gap) / (2 * frame.half(0));
  }
  if (set.dimension >= 2) write_hull(statics, balance, oracle, frame, points, set);
  // Combine the status of all linear programs, also of those that found zero width.
  if (set.status == Status::kSolved) set.status = oracle.worst();
  if (set.status == Status::kSolved) set.volume = set_volume(set);
  return set;
}

}  // namespace thenar
