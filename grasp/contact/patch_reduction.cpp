#include "grasp/contact/patch_reduction.h"

#include <algorithm>
#include <cmath>
#include <limits>
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
  std::vector<int> order(static_cast<std::size_t>(points.cols()));
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int i, int j) {
    return std::pair(points(0, i), points(1, i)) < std::pair(points(0, j), points(1, j));
  });
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
  for (const int i : hull)
    for (const int j : hull) {
      const double distance = (points.col(i) - points.col(j)).norm();
      if (distance > pair.distance) pair = {i, j, distance};
    }
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

/// Outermost distance of any hull corner from the polygon of the kept ones.
double loss_of(const Points& points, const std::vector<int>& hull, const std::vector<int>& kept) {
  double loss = 0;
  for (const int i : hull) {
    if (std::find(kept.begin(), kept.end(), i) != kept.end()) continue;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < kept.size(); ++k)
      nearest = std::min(nearest, distance_from_segment(points.col(i), points.col(kept[k]),
                                                        points.col(kept[(k + 1) % kept.size()])));
    loss = std::max(loss, nearest);
  }
  return loss;
}

/// Drops corners that cost least.
ReducedPoints simplified(const Points& points, const std::vector<int>& hull, double allowed,
                         int most) {
  ReducedPoints result{hull, 0};
  while (result.kept.size() > 3) {
    ReducedPoints next{{}, std::numeric_limits<double>::infinity()};
    const std::size_t n = result.kept.size();
    std::size_t cheapest = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < n; ++k) {
      const double cost = distance_from_segment(points.col(result.kept[k]),
                                                points.col(result.kept[(k + n - 1) % n]),
                                                points.col(result.kept[(k + 1) % n]));
      if (cost < least) least = cost, cheapest = k;
    }
    next.kept = result.kept;
    next.kept.erase(next.kept.begin() + static_cast<std::ptrdiff_t>(cheapest));
    next.loss = loss_of(points, hull, next.kept);
    if (next.loss > allowed && static_cast<int>(n) <= most) break;
    result = std::move(next);
  }
  return result;
}

}  // namespace

ReducedPoints reduce_points(const Points& points, double merge, int most) {
  require(points.cols() > 0 && points.allFinite(),
          "{} points cannot be reduced: one or more, finite", points.cols());
  require(merge >= 0 && most >= 3, "merge must be >= 0 and most >= 3, got {} m and {}", merge,
          most);
  const std::vector<int> hull = convex_hull(points);
  const FarthestPair pair = farthest_pair(points, hull);
  if (pair.distance <= merge) {
    double loss = 0;
    for (const int i : hull) loss = std::max(loss, (points.col(i) - points.col(0)).norm());
    return {{0}, loss};
  }
  const double wide = width(points, hull, pair);
  if (wide <= merge / 2 || hull.size() < 3) return {{pair.a, pair.b}, wide};
  return simplified(points, hull, merge / 10, most);
}

}  // namespace thenar
