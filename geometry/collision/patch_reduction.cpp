#include "geometry/collision/patch_reduction.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/error.h"
#include "base/lists.h"

namespace thenar {
namespace {

using Points = Eigen::Matrix2Xd;

/// Returns twice the signed area of the triangle o, a, b; positive if it is counterclockwise.
double signed_area2(const Points& points, int o, int a, int b) {
  const Eigen::Vector2d u = points.col(a) - points.col(o), v = points.col(b) - points.col(o);
  return u.x() * v.y() - u.y() * v.x();
}

double distance_from_segment(const Eigen::Vector2d& p, const Eigen::Vector2d& a,
                             const Eigen::Vector2d& b) {
  const double square = (b - a).squaredNorm();
  const double t = square > 0 ? std::clamp((p - a).dot(b - a) / square, 0.0, 1.0) : 0;
  return (a + t * (b - a) - p).norm();
}

/// Returns the corners of the convex hull, counterclockwise, by Andrew's monotone chain.
std::vector<int> convex_hull(const Points& points) {
  // Sort by x, then by y.
  std::vector<int> order(static_cast<std::size_t>(points.cols()));
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int i, int j) {
    return std::pair(points(0, i), points(1, i)) < std::pair(points(0, j), points(1, j));
  });
  // Lower and upper chain: remove corners at right turns.
  std::vector<int> hull;
  const auto sweep = [&](auto first, auto last) {
    const std::size_t base = hull.size();
    for (auto i = first; i != last; ++i) {
      while (hull.size() >= base + 2 &&
             signed_area2(points, hull[hull.size() - 2], hull.back(), *i) <= 0)
        hull.pop_back();
      hull.push_back(*i);
    }
    hull.pop_back();
  };
  sweep(order.begin(), order.end());
  sweep(order.rbegin(), order.rend());
  if (hull.empty()) hull.push_back(order.front());
  return hull;
}

struct FarthestPair {
  int a = 0, b = 0;
  double distance = 0;
};

/// Finds the two corners of the hull that are farthest apart.
FarthestPair farthest_pair(const Points& points, const std::vector<int>& hull) {
  FarthestPair pair{hull.front(), hull.front(), 0};
  double max_square = 0;
  for (std::size_t i = 0; i < hull.size(); ++i)
    for (std::size_t j = i + 1; j < hull.size(); ++j) {
      const double square = (points.col(hull[i]) - points.col(hull[j])).squaredNorm();
      if (square > max_square) max_square = square, pair = {hull[i], hull[j], 0};
    }
  pair.distance = std::sqrt(max_square);
  return pair;
}

/// Returns the maximum distance of a corner of the hull from the segment.
double max_width(const Points& points, const std::vector<int>& hull, const FarthestPair& pair) {
  double width = 0;
  for (const int i : hull)
    width = std::max(width,
                     distance_from_segment(points.col(i), points.col(pair.a), points.col(pair.b)));
  return width;
}

/// Polygon of the corners that are kept. A dropped corner lies beyond the side that bypasses it and
/// within all others, so that this side is the nearest.
class Polygon {
 public:
  Polygon(const Points& points, const std::vector<int>& hull)
      : points_(points), hull_(hull), kept_(hull.size()), loss_(hull.size(), 0) {
    std::iota(kept_.begin(), kept_.end(), std::size_t{0});
    for (std::size_t k = 0; k < kept_.size(); ++k) cost_.push_back(cost(k));
  }

  [[nodiscard]] std::size_t size() const { return kept_.size(); }

  [[nodiscard]] std::size_t cheapest() const {
    return static_cast<std::size_t>(std::min_element(cost_.begin(), cost_.end()) - cost_.begin());
  }

  /// Returns the maximum distance of a hull corner from the polygon without its k-th corner.
  [[nodiscard]] double loss_without(std::size_t k) const {
    // Take the largest distance beyond the new side and beyond all others.
    double loss = beyond(before(k), after(k));
    for (std::size_t i = 0; i < size(); ++i)
      if (i != k && i != before(k)) loss = std::max(loss, loss_[i]);
    return loss;
  }

  /// Removes the k-th corner, and updates the losses and costs of its neighbours.
  void drop(std::size_t k) {
    loss_[before(k)] = beyond(before(k), after(k));
    const auto at = static_cast<std::ptrdiff_t>(k);
    kept_.erase(kept_.begin() + at);
    loss_.erase(loss_.begin() + at);
    cost_.erase(cost_.begin() + at);
    k %= size();
    for (const std::size_t neighbour : {before(k), k}) cost_[neighbour] = cost(neighbour);
  }

  [[nodiscard]] std::vector<int> corners() const {
    return transformed(kept_, [&](std::size_t k) { return hull_[k]; });
  }

 private:
  [[nodiscard]] std::size_t before(std::size_t k) const { return (k + size() - 1) % size(); }
  [[nodiscard]] std::size_t after(std::size_t k) const { return (k + 1) % size(); }
  [[nodiscard]] Eigen::Vector2d corner(std::size_t k) const { return points_.col(hull_[k]); }

  /// Returns the distance of a kept corner from the segment between its kept neighbours.
  [[nodiscard]] double cost(std::size_t k) const {
    return distance_from_segment(corner(kept_[k]), corner(kept_[before(k)]),
                                 corner(kept_[after(k)]));
  }

  /// Returns the maximum distance of hull corners between two kept ones from the side between
  /// these.
  [[nodiscard]] double beyond(std::size_t from, std::size_t to) const {
    double max_distance = 0;
    for (std::size_t i = (kept_[from] + 1) % hull_.size(); i != kept_[to];
         i = (i + 1) % hull_.size())
      max_distance = std::max(
          max_distance, distance_from_segment(corner(i), corner(kept_[from]), corner(kept_[to])));
    return max_distance;
  }

  const Points& points_;
  const std::vector<int>& hull_;
  std::vector<std::size_t> kept_;  // indices of the kept corners in the hull
  std::vector<double> loss_;       // distance beyond the side after each kept corner [m]
  std::vector<double> cost_;       // cost of dropping each kept corner [m]
};

/// Drops the cheapest corners while the loss is allowed, or there are too many.
ReducedPoints simplified(const Points& points, const std::vector<int>& hull, double allowed,
                         int max_points) {
  Polygon polygon(points, hull);
  double loss = 0;
  while (polygon.size() > 3) {
    const std::size_t cheapest = polygon.cheapest();
    const double next = polygon.loss_without(cheapest);
    if (next > allowed && static_cast<int>(polygon.size()) <= max_points) break;
    polygon.drop(cheapest);
    loss = next;
  }
  return {polygon.corners(), loss};
}

}  // namespace

ReducedPoints reduce_points(const Points& points, double merge, int max_points) {
  require(points.cols() > 0 && points.allFinite(),
          "{} points cannot be reduced: one or more, finite", points.cols());
  require(merge >= 0 && max_points >= 3, "merge must be >= 0 and most >= 3, got {} m and {}", merge,
          max_points);
  const std::vector<int> hull = convex_hull(points);
  // If all points coincide, keep the first one.
  const FarthestPair pair = farthest_pair(points, hull);
  if (pair.distance <= merge) {
    double loss = 0;
    for (const int i : hull) loss = std::max(loss, (points.col(i) - points.col(0)).norm());
    return {{0}, loss};
  }
  // If they lie nearly on a line, keep the two that are farthest apart.
  const double width = max_width(points, hull, pair);
  if (width <= merge / 2 || hull.size() < 3) return {{pair.a, pair.b}, width};
  // Otherwise keep a polygon.
  return simplified(points, hull, merge / 10, max_points);
}

}  // namespace thenar
