#include "pads/skin_gap.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

#include "base/spatial.h"
#include "geometry/primitives.h"

namespace thenar {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int kGrid = 12;            // places along a radius of the disc, of a first look
constexpr double kFinest = 1e-7;     // of a search on the disc [1]
constexpr double kSlope = 1e-3;      // step of differences on the disc [1]
constexpr double kNewton = 0.1;      // longest step that a parabola is believed for [1]
constexpr double kCurvature = 1e-3;  // step of second differences [m]

PrincipalCurvatures curvatures_near(const Shape& shape, const Vector3d& p) {
  const NearestSurface near = shape.nearest(p);
  return curvatures(shape, p - near.distance * near.normal, kCurvature);
}

/// Overlap of an object over the disc.
class OverlapSearch {
 public:
  OverlapSearch(const PadChart& chart, const Shape& object, const Pose<double>& X_PO)
      : chart_(chart), object_(object), X_OP_(X_PO.inverse()) {}

  [[nodiscard]] double overlap(const Vector2d& c) const {
    return -object_.distance(X_OP_ * chart_.place({c[0], c[1], 1}));
  }

  /// Follows parabolas from a place nearby. @return false if they lead nowhere
  bool follow(Vector2d c) {
    for (int i = 0; i < 5; ++i) {
      if (c.norm() > 1 - 2 * kSlope) return false;
      const Vector2d x(kSlope, 0), y(0, kSlope);
      const double here = overlap(c), left = overlap(c - x), right = overlap(c + x),
                   below = overlap(c - y), above = overlap(c + y);
      Vector2d slope(right - left, above - below);
      Matrix2d curve;
      curve(0, 0) = 4 * (right - 2 * here + left);
      curve(1, 1) = 4 * (above - 2 * here + below);
      curve(0, 1) = curve(1, 0) =
          overlap(c + x + y) - overlap(c + x - y) - overlap(c - x + y) + overlap(c - x - y);
      // A maximum, and not far.
      if (!(curve.trace() < 0 && curve.determinant() > 0)) return false;
      const Vector2d step = -2 * kSlope * curve.inverse() * slope;
      if (!(step.norm() < kNewton)) return false;
      c += step;
      if (step.norm() < 1e-6) {
        best = c;
        most = overlap(c);
        return c.norm() <= 1;
      }
    }
    return false;
  }

  /// The best of a grid, then of its neighbours, nearer and nearer.
  void search() {
    best.setZero();
    most = overlap(best);
    double step = 1.0 / kGrid;
    for (int i = -kGrid; i <= kGrid; ++i)
      for (int j = -kGrid; j <= kGrid; ++j) look_at({i * step, j * step});
    while (step > kFinest) {
      const Vector2d from = best;
      bool better = false;
      for (const Vector2d& way :
           {Vector2d(1, 0), Vector2d(-1, 0), Vector2d(0, 1), Vector2d(0, -1), Vector2d(1, 1),
            Vector2d(-1, -1), Vector2d(1, -1), Vector2d(-1, 1)})
        better = look_at(from + step * way) || better;
      if (!better) step /= 2;
    }
  }

  Vector2d best{0, 0};
  double most = 0;  // overlap there [m]

 private:
  bool look_at(const Vector2d& c) {
    if (c.norm() > 1) return false;
    const double found = overlap(c);
    if (found <= most) return false;
    most = found;
    best = c;
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

DeepestSkin deepest_skin(const PadChart& chart, const Shape& object, const Pose<double>& X_PO,
                         const std::optional<Vector2d>& near) {
  OverlapSearch search(chart, object, X_PO);
  if (!near || !search.follow(*near)) search.search();
  const Vector2d& c = search.best;
  return {search.most, chart.thickness(c[0], c[1]), chart.place({c[0], c[1], 1}), c};
}

RelativeCurvatures skin_gap(const Shape& skin, const Shape& object, const Pose<double>& X_PO,
                            const Vector3d& p) {
  const PrincipalCurvatures pad = curvatures_near(skin, p);
  const PrincipalCurvatures other = curvatures_near(object, X_PO.inverse() * p);
  const double angle = std::acos(std::min(1.0, std::abs(pad.d1.dot(X_PO.R * other.d1))));
  return relative_curvatures(pad, other, angle);
}

}  // namespace thenar
