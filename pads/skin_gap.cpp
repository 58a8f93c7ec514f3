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

constexpr int kGridPoints = 12;    // grid points along a radius of the disc in the first search
constexpr double kMinRing = 1e-7;  // radius of the last ring of a search on the disc [1]
// Distance on the disc within which points belong to the deepest one [1]
constexpr double kPeakRadius = 0.25;
constexpr double kNearRing = 0.02;      // first ring of a search from a nearby point [1]
constexpr int kGradientPoints = 8;      // points on a ring at which gradients are taken
constexpr double kGradientStep = 0.01;  // step of gradient differences over the ring's radius [1]
// Least increase of the overlap over the increase that gradients predict [1]
constexpr double kMinIncreaseRatio = 0.01;
// Length of the shortest mean gradient over a gradient below which the overlap is level [1]
constexpr double kLevelRatio = 1e-4;
constexpr double kTinySquare = 1e-300;     // lower bound of a squared length, against division by 0
constexpr double kDifferenceStep = 1e-3;   // step of differences on the disc [1]
constexpr double kMaxNewtonStep = 0.1;     // longest reliable Newton step on the disc [1]
constexpr int kMaxNewtonSteps = 5;         // Newton steps from a nearby point
constexpr double kNewtonTolerance = 1e-6;  // length of a Newton step at convergence [1]
constexpr double kCurvatureStep = 1e-3;    // step of second differences [m]

PrincipalCurvatures curvatures_near(const Shape& shape, const Vector3d& p) {
  const NearestSurface near = shape.nearest(p);
  return curvatures(shape, p - near.distance * near.normal, kCurvatureStep);
}

/// Returns the point of the convex hull of some points that is nearest to 0.
template <std::size_t n>
Vector2d shortest_in_hull(const std::array<Vector2d, n>& points) {
  // Find the nearest point to 0 of all segments between two of them.
  Vector2d out = points.front();
  for (const Vector2d& a : points)
    for (const Vector2d& b : points) {
      const double share = -a.dot(b - a) / std::max((b - a).squaredNorm(), kTinySquare);
      const Vector2d x = a + std::clamp(share, 0.0, 1.0) * (b - a);
      if (x.squaredNorm() < out.squaredNorm()) out = x;
    }
  // The hull contains 0 unless all points lie beyond that point.
  const bool is_beyond = std::all_of(points.begin(), points.end(), [&](const Vector2d& p) {
    return out.dot(p) > (1 - 1e-9) * out.squaredNorm();
  });
  return is_beyond ? out : Vector2d(0, 0);
}

/// Search for the largest overlap of an object over the disc.
class OverlapSearch {
 public:
  OverlapSearch(const PadChart& chart, const Shape& object, const Pose<double>& X_PO)
      : chart_(chart), object_(object), X_OP_(X_PO.inverse()) {}

  /// Returns the overlap at a point [m]; points off the disc are projected on its rim.
  [[nodiscard]] double overlap(Vector2d c) const {
    if (c.norm() > 1) c.normalize();
    return -object_.distance(X_OP_ * chart_.place({c[0], c[1], 1}));
  }

  /// Finds the maximum by Newton's method from a nearby point. @return false if it fails
  bool find_by_newton(Vector2d c) {
    for (int i = 0; i < kMaxNewtonSteps; ++i) {
      if (c.norm() > 1 - 2 * kDifferenceStep) return false;
      // Compute gradient and curvature by central differences.
      const Vector2d x(kDifferenceStep, 0), y(0, kDifferenceStep);
      const double here = overlap(c), left = overlap(c - x), right = overlap(c + x),
                   below = overlap(c - y), above = overlap(c + y);
      Vector2d slope(right - left, above - below);
      Matrix2d curve;
      curve(0, 0) = 4 * (right - 2 * here + left);
      curve(1, 1) = 4 * (above - 2 * here + below);
      curve(0, 1) = curve(1, 0) =
          overlap(c + x + y) - overlap(c + x - y) - overlap(c - x + y) + overlap(c - x - y);
      // Take a Newton step if it is short and the point is near a maximum.
      if (!(curve.trace() < 0 && curve.determinant() > 0)) return false;
      const Vector2d step = -2 * kDifferenceStep * curve.inverse() * slope;
      if (!(step.norm() < kMaxNewtonStep)) return false;
      c += step;
      if (step.norm() < kNewtonTolerance) {
        best = c;
        max_overlap = overlap(c);
        return c.norm() <= 1;
      }
    }
    return false;
  }

  /// Finds the deepest point of a grid.
  /// @return its overlap less the largest one farther away than kPeakRadius [m]
  double search_grid() {
    constexpr int kGridSide = 2 * kGridPoints + 1;
    std::vector<double> found(std::size_t{kGridSide} * kGridSide, -kInfinity);
    const auto place = [](std::size_t k) -> Vector2d {
      return Vector2d(static_cast<int>(k) / kGridSide - kGridPoints,
                      static_cast<int>(k) % kGridSide - kGridPoints) /
             kGridPoints;
    };
    // Find the deepest point of the grid.
    max_overlap = -kInfinity;
    for (std::size_t k = 0; k < found.size(); ++k) {
      if (place(k).norm() > 1) continue;
      found[k] = overlap(place(k));
      if (found[k] <= max_overlap) continue;
      max_overlap = found[k];
      best = place(k);
    }
    // Compute its lead over all points that are not near it.
    double other = -kInfinity;
    for (std::size_t k = 0; k < found.size(); ++k)
      if ((place(k) - best).norm() > kPeakRadius) other = std::max(other, found[k]);
    return max_overlap - other;
  }

  /// Climbs from `best` to a maximum, which may lie on a ridge, as under the edge of a box. The
  /// direction is the shortest convex combination of the gradients around, which ascends on both
  /// sides of a ridge. Gradients are sampled evenly on a ring instead of at random.
  /// Source: [Burke2005] for gradient sampling.
  void climb(double ring) {
    max_overlap = overlap(best);
    while (ring > kMinRing) {
      // Sample gradients on a ring around the best point.
      std::array<Vector2d, kGradientPoints> gradients;
      for (int k = 0; k < kGradientPoints; ++k) {
        const double turn = 2 * kPi * k / kGradientPoints;
        const Vector2d at = best + ring * Vector2d(std::cos(turn), std::sin(turn));
        const double here = overlap(at), d = kGradientStep * ring;
        gradients[k] =
            Vector2d(overlap(at + Vector2d(d, 0)) - here, overlap(at + Vector2d(0, d)) - here) / d;
      }
      // Step on while the overlap increases as the gradients predict; otherwise shrink the ring.
      const Vector2d ascent = shortest_in_hull(gradients), way = ascent.stableNormalized(),
                     from = best;
      double t = ring;
      if (ascent.norm() > kLevelRatio * gradients[0].norm())
        while (accept_if_deeper(from + t * way, kMinIncreaseRatio * t * ascent.norm())) t *= 2;
      if (t == ring) ring /= 2;
    }
  }

  Vector2d best{0, 0};
  double max_overlap = 0;  // overlap there [m]

 private:
  /// Accepts a point as the best one if its overlap is large enough. @return whether it is
  /// @param more  least increase of the overlap [m]
  bool accept_if_deeper(const Vector2d& c, double more) {
    const double found = overlap(c);
    if (!(found > max_overlap + more)) return false;
    max_overlap = found;
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
  // Search the whole disc, or follow the maximum from a nearby point.
  if (!near) {
    out.lead = search.search_grid();
    search.climb(1.0 / kGridPoints);
  } else if (!search.find_by_newton(*near)) {
    search.best = *near;
    search.climb(kNearRing);
  }
  out.disc = search.best;
  out.overlap = search.max_overlap;
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
