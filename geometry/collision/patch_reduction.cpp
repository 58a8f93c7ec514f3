#include "geometry/collision/patch_reduction.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/error.h"

namespace thenar {
namespace {

using Points = Eigen::Matrix2Xd;

/// Twice the area of the triangle o, a, b; positive if it turns left.
double turn(const Points& points, int o, int a, int b) {
  const Eigen::Vector2d u = points.col(a) - points.col(o), v = points.col(b) - points.col(o);
  return u.x() * v.y() - u.y() * v.x();
}

double distance_from_segment(const Eigen::Vector2d& p, const Eigen::Vector2d& a,
                             const Eigen::Vector2d& b) {
  const double square = (b - a).squaredNorm();
  const double t = square > 0 ? std::clamp((p - a).dot(b - a) / square, 0.0, 1.0) : 0;
  return (a + t * (b - a) - p).norm();
}

/// Corners of the convex hull, counterclockwise.
std::vector<int> convex_hull(const Points& points) {
  // By x, then by y.
  std::vector<int> order(static_cast<std::size_t>(points.cols()));
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int i, int j) {
    return std::pair(points(0, i), points(1, i)) < std::pair(points(0, j), points(1, j));
  });
  // Lower and upper chain: right turns go.
  std::vector<int> hull;
  const auto sweep = [&](auto first, auto last) {
    const std::size_t base = hull.size();
    for (auto i = first; i != last; ++i) {
      while (hull.size() >= base + 2 && turn(points, hull[hull.size() - 2], hull.back(), *i) <= 0)
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

FarthestPair farthest_pair(const Points& points, const std::vector<int>& hull) {
  FarthestPair pair{hull.front(), hull.front(), 0};
  double most = 0;
  for (std::size_t i = 0; i < hull.size(); ++i)
    for (std::size_t j = i + 1; j < hull.size(); ++j) {
      const double square = (points.col(hull[i]) - points.col(hull[j])).squaredNorm();
      if (square > most) most = square, pair = {hull[i], hull[j], 0};
    }
  pair.distance = std::sqrt(most);
  return pair;
}

/// Farthest that any corner of the hull lies from the segment.
double width(const Points& points, const std::vector<int>& hull, const FarthestPair& pair) {
  double width = 0;
  for (const int i : hull)
    width = std::max(width,
                     distance_from_segment(points.col(i), points.col(pair.a), points.col(pair.b)));
  return width;
}

/// The polygon of the corners that are kept. A dropped one lies beyond the side that passes it by
/// and within all others, so that this side is the nearest.
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

  /// Outermost distance of any hull corner once the k-th is dropped as well.
  [[nodiscard]] double loss_without(std::size_t k) const {
    // Distance beyond the new side, and beyond all others.
    double loss = beyond(before(k), after(k));
    for (std::size_t i = 0; i < size(); ++i)
      if (i != k && i != before(k)) loss = std::max(loss, loss_[i]);
    return loss;
  }

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
    std::vector<int> corners;
    for (const std::size_t k : kept_) corners.push_back(hull_[k]);
    return corners;
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

  /// Outermost distance of hull corners between two kept ones from the line between these.
  [[nodiscard]] double beyond(std::size_t from, std::size_t to) const {
    double most = 0;
    for (std::size_t i = (kept_[from] + 1) % hull_.size(); i != kept_[to];
         i = (i + 1) % hull_.size())
      most =
          std::max(most, distance_from_segment(corner(i), corner(kept_[from]), corner(kept_[to])));
    return most;
  }

  const Points& points_;
  const std::vector<int>& hull_;
  std::vector<std::size_t> kept_;  // places in the hull
  std::vector<double> loss_;       // beyond the side from each kept corner to the next [m]
  std::vector<double> cost_;       // of each kept corner [m]
};

/// Drops corners that cost least.
ReducedPoints simplified(const Points& points, const std::vector<int>& hull, double allowed,
                         int most) {
  // Cheapest corners go until the loss is too large and few enough are left.
  Polygon polygon(points, hull);
  double loss = 0;
  while (polygon.size() > 3) {
    const std::size_t cheapest = polygon.cheapest();
    const double next = polygon.loss_without(cheapest);
    if (next > allowed && static_cast<int>(polygon.size()) <= most) break;
    polygon.drop(cheapest);
    loss = next;
  }
  return {polygon.corners(), loss};
}

}  // namespace

ReducedPoints reduce_points(const Points& points, double merge, int most) {
  require(points.cols() > 0 && points.allFinite(),
          "{} points cannot be reduced: one or more, finite", points.cols());
  require(merge >= 0 && most >= 3, "merge must be >= 0 and most >= 3, got {} m and {}", merge,
          most);
  const std::vector<int> hull = convex_hull(points);
  // All in one place: the first point stands for them.
  const FarthestPair pair = farthest_pair(points, hull);
  if (pair.distance <= merge) {
    double loss = 0;
    for (const int i : hull) loss = std::max(loss, (points.col(i) - points.col(0)).norm());
    return {{0}, loss};
  }
  // Nearly on a line: the two farthest apart.
  const double wide = width(points, hull, pair);
  if (wide <= merge / 2 || hull.size() < 3) return {{pair.a, pair.b}, wide};
  // Otherwise a polygon.
  return simplified(points, hull, merge / 10, most);
}

}  // namespace thenar
