#include "pads/skin_gap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <Eigen/Dense>

#include "base/numbers.h"
#include "base/spatial.h"
#include "base/units.h"
#include "geometry/primitives.h"

namespace thenar {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int kGridPlaces = 12;       // Places along a radius of the disc in the first search
constexpr double kFinestStep = 1e-7;  // Shortest step of a search on the disc [1]
// Places within this distance on the disc belong to the deepest [1]
constexpr double kBesideShare = 0.25;
constexpr double kNearStart = 0.02;  // First ring of a search that begins at a place nearby [1]
constexpr int kSlopePlaces = 8;      // Places around a point at which slopes are taken
// Step of the slopes' differences, over the radius of their ring [1]
constexpr double kSlopeStep = 0.01;
// Least rise of the overlap, over the rise that slopes predict [1]
constexpr double kRiseShare = 0.01;
constexpr double kLevelMixture = 1e-4;    // Shorter mixtures of slopes, over a slope, are level [1]
constexpr double kTinySquare = 1e-300;    // Squares below this count as 0
constexpr double kDifferenceStep = 1e-3;  // step of differences on the disc [1]
constexpr double kMostNewtonStep = 0.1;   // Longest step for which a parabola is trusted [1]
constexpr double kCurvatureStep = 1e-3;   // step of second differences [m]

PrincipalCurvatures curvatures_near(const Shape& shape, const Vector3d& p) {
  const NearestSurface near = shape.nearest(p);
  return curvatures(shape, p - near.distance * near.normal, kCurvatureStep);
}

/// The point of the convex hull of some points that is nearest to 0.
template <std::size_t n>
Vector2d shortest_mixture(const std::array<Vector2d, n>& points) {
  // Nearest point to 0 of all segments between two of them.
  Vector2d out = points.front();
  for (const Vector2d& a : points)
    for (const Vector2d& b : points) {
      const double share = -a.dot(b - a) / std::max((b - a).squaredNorm(), kTinySquare);
      const Vector2d x = a + std::clamp(share, 0.0, 1.0) * (b - a);
      if (x.squaredNorm() < out.squaredNorm()) out = x;
    }
  // The hull holds 0 unless all points lie beyond that point.
  const bool is_beyond = std::all_of(points.begin(), points.end(), [&](const Vector2d& p) {
    return out.dot(p) > (1 - 1e-9) * out.squaredNorm();
  });
  return is_beyond ? out : Vector2d(0, 0);
}

/// Overlap of an object over the disc.
class OverlapSearch {
 public:
  OverlapSearch(const PadChart& chart, const Shape& object, const Pose<double>& X_PO)
      : chart_(chart), object_(object), X_OP_(X_PO.inverse()) {}

  /// Places off the disc count as the nearest on its rim.
  [[nodiscard]] double overlap(Vector2d c) const {
    if (c.norm() > 1) c.normalize();
    return -object_.distance(X_OP_ * chart_.place({c[0], c[1], 1}));
  }

  /// Follows parabolas from a place nearby. @return false if they lead nowhere
  bool follow(Vector2d c) {
    for (int i = 0; i < 5; ++i) {
      if (c.norm() > 1 - 2 * kDifferenceStep) return false;
      // Slope and curvature by central differences.
      const Vector2d x(kDifferenceStep, 0), y(0, kDifferenceStep);
      const double here = overlap(c), left = overlap(c - x), right = overlap(c + x),
                   below = overlap(c - y), above = overlap(c + y);
      Vector2d slope(right - left, above - below);
      Matrix2d curve;
      curve(0, 0) = 4 * (right - 2 * here + left);
      curve(1, 1) = 4 * (above - 2 * here + below);
      curve(0, 1) = curve(1, 0) =
          overlap(c + x + y) - overlap(c + x - y) - overlap(c - x + y) + overlap(c - x - y);
      // Newton step, only near a maximum and if it is short.
      if (!(curve.trace() < 0 && curve.determinant() > 0)) return false;
      const Vector2d step = -2 * kDifferenceStep * curve.inverse() * slope;
      if (!(step.norm() < kMostNewtonStep)) return false;
      c += step;
      if (step.norm() < 1e-6) {
        best = c;
        most = overlap(c);
        return c.norm() <= 1;
      }
    }
    return false;
  }

  /// The best of a grid. @return by how much it is deeper than all that is farther than
  /// kBesideShare
  double look_over() {
    constexpr int kGridSide = 2 * kGridPlaces + 1;
    std::vector<double> found(std::size_t{kGridSide} * kGridSide, -kInfinity);
    const auto place = [](std::size_t k) -> Vector2d {
      return Vector2d(static_cast<int>(k) / kGridSide - kGridPlaces,
                      static_cast<int>(k) % kGridSide - kGridPlaces) /
             kGridPlaces;
    };
    // Deepest place of the grid.
    most = -kInfinity;
    for (std::size_t k = 0; k < found.size(); ++k) {
      if (place(k).norm() > 1) continue;
      found[k] = overlap(place(k));
      if (found[k] <= most) continue;
      most = found[k];
      best = place(k);
    }
    // Lead over all places that are not beside it.
    double other = -kInfinity;
    for (std::size_t k = 0; k < found.size(); ++k)
      if ((place(k) - best).norm() > kBesideShare) other = std::max(other, found[k]);
    return most - other;
  }

  /// Climbs from `best` to a maximum, which may lie on a ridge, as edges of boxes make them: along
  /// the shortest of all mixtures of slopes around, which rises on both sides of it. Slopes are
  /// taken on a ring, evenly instead of by chance. Source: [Burke2005].
  void climb(double ring) {
    most = overlap(best);
    while (ring > kFinestStep) {
      // Slopes on a ring around the best place.
      std::array<Vector2d, kSlopePlaces> slopes;
      for (int k = 0; k < kSlopePlaces; ++k) {
        const double turn = 2 * kPi * k / kSlopePlaces;
        const Vector2d at = best + ring * Vector2d(std::cos(turn), std::sin(turn));
        const double here = overlap(at), d = kSlopeStep * ring;
        slopes[static_cast<std::size_t>(k)] =
            Vector2d(overlap(at + Vector2d(d, 0)) - here, overlap(at + Vector2d(0, d)) - here) / d;
      }
      // Go on while the overlap rises by a part of what slopes promise; otherwise shrink the ring.
      const Vector2d mixed = shortest_mixture(slopes), way = mixed.stableNormalized(), from = best;
      double t = ring;
      if (mixed.norm() > kLevelMixture * slopes[0].norm())
        while (look_at(from + t * way, kRiseShare * t * mixed.norm())) t *= 2;
      if (t == ring) ring /= 2;
    }
  }

  Vector2d best{0, 0};
  double most = 0;  // overlap there [m]

 private:
  /// @param more  than it has it must rise, to be the best [m]
  bool look_at(const Vector2d& c, double more) {
    const double found = overlap(c);
    if (!(found > most + more)) return false;
    most = found;
    best = c / std::max(1.0, c.norm());
    return true;
  }

  const PadChart& chart_;
  const Shape& object_;
  Pose<double> X_OP_;
};

}  // namespace

std::shared_ptr<const Shape> skin_solid(const PadShape& shape) {
  if (shape.skin) return shape.skin;
  return build_ellipsoid({shape.length / 2, shape.width / 2, shape.height});
}

double reach_of(const PadShape& shape) {
  if (!shape.skin) return 0.5 * std::max({shape.length, shape.width, 2 * shape.height});
  const Eigen::AlignedBox3d box = shape.skin->bounds();
  return box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs()).norm();
}

DeepestSkin deepest_skin(const PadChart& chart, const Shape& object, const Pose<double>& X_PO,
                         const std::optional<Vector2d>& near) {
  OverlapSearch search(chart, object, X_PO);
  DeepestSkin out;
  // Search all of the disc, or follow the maximum from a place nearby.
  if (!near) {
    out.lead = search.look_over();
    search.climb(1.0 / kGridPlaces);
  } else if (!search.follow(*near)) {
    search.best = *near;
    search.climb(kNearStart);
  }
  out.disc = search.best;
  out.overlap = search.most;
  out.thickness = chart.thickness(out.disc[0], out.disc[1]);
  out.place = chart.place({out.disc[0], out.disc[1], 1});
  return out;
}

RelativeCurvatures skin_gap(const Shape& skin, const Shape& object, const Pose<double>& X_PO,
                            const Vector3d& p) {
  const PrincipalCurvatures pad = curvatures_near(skin, p);
  const PrincipalCurvatures other = curvatures_near(object, X_PO.inverse() * p);
  const double angle = std::acos(std::min(1.0, std::abs(pad.d1.dot(X_PO.R * other.d1))));
  return relative_curvatures(pad, other, angle);
}

}  // namespace thenar
