#pragma once

/// Distance of two convex bodies by their support points (GJK).

#include <array>
#include <cmath>

#include <Eigen/Core>
#include <Eigen/LU>

namespace thenar::internal {

/// Points of two bodies A and B that are farthest against and along a direction.
struct SupportPoints {
  Eigen::Vector3d on_a{0, 0, 0};  // [m] (3)
  Eigen::Vector3d on_b{0, 0, 0};  // [m] (3)

  [[nodiscard]] Eigen::Vector3d difference() const { return on_a - on_b; }
};

/// Nearest points of two convex bodies.
struct ConvexDistance {
  double distance = 0;  // 0: they overlap, or are nearer than rounding errors [m]
  double lower = 0;     // lower bound of the distance [m]
  SupportPoints points{};
  Eigen::Vector3d n{0, 0, 0};  // unit, from B to A; 0 if they overlap (3)
};

/// Simplex of up to four points of the difference of two bodies, reduced to the corners that span
/// its point nearest to the origin.
class Simplex {
 public:
  /// Adds a point to at most three others, and keeps the corners that span the point nearest to the
  /// origin.
  /// @return that point; 0: the origin is inside
  Eigen::Vector3d add(const SupportPoints& point) {
    points_[count_++] = point;
    // Find the nearest point of every face that has the new corner.
    double least = std::numeric_limits<double>::infinity();
    unsigned best_set = 0;
    Eigen::Vector4d best_weights = Eigen::Vector4d::Zero();
    Eigen::Vector3d best = Eigen::Vector3d::Zero();
    const unsigned newest = 1U << static_cast<unsigned>(count_ - 1);
    for (unsigned set = newest; set < 2 * newest; ++set) {
      Eigen::Vector4d weights = Eigen::Vector4d::Zero();
      Eigen::Vector3d v;
      if (!nearest_of(set, weights, v)) continue;
      if (v.squaredNorm() < least)
        least = v.squaredNorm(), best_set = set, best_weights = weights, best = v;
    }
    // Keep the corners of the nearest face.
    int kept = 0;
    for (int i = 0; i < count_; ++i)
      if (best_set & (1U << static_cast<unsigned>(i))) {
        weights_(kept) = best_weights(i);
        points_[kept++] = points_[i];
      }
    count_ = kept;
    return best;
  }

  [[nodiscard]] int count() const { return count_; }
  [[nodiscard]] bool contains(const Eigen::Vector3d& difference) const {
    for (int i = 0; i < count_; ++i)
      if (points_[i].difference() == difference) return true;
    return false;
  }
  [[nodiscard]] SupportPoints nearest_points() const {
    SupportPoints points;
    for (int i = 0; i < count_; ++i) {
      points.on_a += weights_(i) * points_[i].on_a;
      points.on_b += weights_(i) * points_[i].on_b;
    }
    return points;
  }

 private:
  /// Computes the point nearest to the origin of the plane, line or point through some corners.
  /// @return whether it is between them
  bool nearest_of(unsigned set, Eigen::Vector4d& weights, Eigen::Vector3d& v) const {
    // Collect the corners of the set.
    std::array<int, 4> index{};
    int n = 0;
    for (int i = 0; i < count_; ++i)
      if (set & (1U << static_cast<unsigned>(i))) index[n++] = i;
    const auto corner = [&](int k) -> Eigen::Vector3d { return points_[index[k]].difference(); };
    const Eigen::Vector3d first = corner(0);
    // Compute weights on a corner, an edge, a face, or the whole tetrahedron.
    if (n == 1) {
      weights(index[0]) = 1;
      v = first;
      return true;
    }
    if (n == 2) {
      const Eigen::Vector3d edge = corner(1) - first;
      const double squared = edge.squaredNorm();
      if (!(squared > 0)) return false;
      const double t = -first.dot(edge) / squared;
      if (!(t > 0 && t < 1)) return false;
      weights(index[0]) = 1 - t;
      weights(index[1]) = t;
      v = first + t * edge;
      return true;
    }
    const Eigen::Vector3d d1 = corner(1) - first, d2 = corner(2) - first;
    const Eigen::Vector3d normal = d1.cross(d2);
    if (n == 3) {
      const double area = normal.squaredNorm();
      if (!(area > kFlatTriangle * d1.squaredNorm() * d2.squaredNorm())) return false;
      const double s = -normal.dot(first.cross(d2)) / area, t = -normal.dot(d1.cross(first)) / area;
      if (!(s > 0 && t > 0 && s + t < 1)) return false;
      weights(index[0]) = 1 - s - t;
      weights(index[1]) = s;
      weights(index[2]) = t;
      v = normal.dot(first) / area * normal;
      return true;
    }
    const Eigen::Vector3d d3 = corner(3) - first;
    const double volume = normal.dot(d3);
    if (!(std::abs(volume) > kFlatTetrahedron * normal.norm() * d3.norm())) return false;
    const double x = -first.dot(d2.cross(d3)) / volume, y = -first.dot(d3.cross(d1)) / volume,
                 z = -first.dot(normal) / volume;
    if (!(x > 0 && y > 0 && z > 0 && x + y + z < 1)) return false;
    weights << 1 - x - y - z, x, y, z;
    v.setZero();
    return true;
  }

  static constexpr double kFlatTriangle = 1e-30;  // squared area over squared edges: rounding [1]
  static constexpr double kFlatTetrahedron = 1e-15;  // volume over area times edge: rounding [1]

  std::array<SupportPoints, 4> points_{};
  Eigen::Vector4d weights_ = Eigen::Vector4d::Zero();
  int count_ = 0;
};

/// Computes the distance of two convex bodies: simplices of support points approach their
/// difference A - B, until the plane perpendicular to the nearest point v is within `tolerance` of
/// it:
///   h = min over A - B of x . v / |v|  <=  distance  <=  |v|.
/// @param support  function of a direction n: A's point farthest against n, and B's farthest along
///                 n
/// @param guess    direction from B to A, not 0 (3);  @param tolerance  of the distance [m]
/// @param enough   bound above which the search ends early [m]
/// Source: [Gilbert1988].
template <typename Support>
[[nodiscard]] ConvexDistance convex_distance(const Support& support, const Eigen::Vector3d& guess,
                                             double tolerance, double enough) {
  constexpr int kMaxSteps = 60;       // maximum number of steps
  constexpr double kOverlap = 1e-12;  // distance that counts as overlap [m]
  Simplex simplex;
  Eigen::Vector3d n = guess.normalized(), v = Eigen::Vector3d::Zero();
  ConvexDistance found;
  found.lower = -std::numeric_limits<double>::infinity();
  for (int i = 0; i < kMaxSteps; ++i) {
    // Bound the distance from below by the support point.
    const SupportPoints point = support(n);
    const Eigen::Vector3d w = point.difference();
    found.lower = std::max(found.lower, w.dot(n));
    if (i > 0 && (found.distance - found.lower <= tolerance || simplex.contains(w))) break;
    if (found.lower > enough) {
      if (i == 0) found.distance = w.norm(), found.points = point, found.n = n;
      break;
    }
    // Bound it from above by the simplex, unless it contains the origin.
    v = simplex.add(point);
    const double distance = v.norm();
    if (simplex.count() == 4 || distance < kOverlap)
      return {0, 0, simplex.nearest_points(), {0, 0, 0}};
    if (i > 0 && !(distance < found.distance)) break;
    found.distance = distance;
    found.points = simplex.nearest_points();
    found.n = n = v / distance;
  }
  return found;
}

}  // namespace thenar::internal
