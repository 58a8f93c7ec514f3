#include "geometry/collision/segment_search.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/collision/segment_bounds.h"

namespace thenar::internal {
namespace {

constexpr int kMaxPlanes = 40;          // maximum number of planes along one segment
constexpr std::size_t kMaxPairs = 200;  // maximum number of pairs of balls along one segment
constexpr double kMinStepRatio = 1e-2;  // minimum step over half the segment's length [1]

Eigen::Vector3d longest_side(const Eigen::Matrix3d& corners) {
  Eigen::Vector3d longest = corners.col(1) - corners.col(0);
  for (const int k : {0, 1}) {
    const Eigen::Vector3d side = corners.col(2) - corners.col(k);
    if (side.squaredNorm() > longest.squaredNorm()) longest = side;
  }
  return longest;
}

}  // namespace

double bound_by_planes(const TrianglePiece& piece, DistanceRecord& record) {
  // Compute distance and slope at points of the segment.
  const Eigen::Matrix3d& c = piece.corners;
  const Eigen::Vector3d u = longest_side(c).stableNormalized();
  const auto tangent = [&](double t, const NearestSurface& seen) {
    return Tangent{t, seen.distance - piece.radius, seen.normal.dot(u)};
  };
  NearestSurface seen = piece.seen;
  ConvexBracket bracket(-piece.ball.r, piece.ball.r, tangent(0, seen));
  // Add planes on both sides, until the bound is high enough.
  for (int i = 0; i < kMaxPlanes && bracket.lower() < record.sufficient_bound() &&
                  bracket.lower() <= record.options().cutoff && !record.is_exhausted();
       ++i) {
    const double step = std::abs(seen.distance * seen.normal.dot(u));
    const double t = bracket.next_position(std::max(step, kMinStepRatio * piece.ball.r));
    const Eigen::Vector3d p = piece.ball.c + t * u;
    seen = record.nearest_surface(p);
    if (!seen.supports) return kNoBound;
    record.update_best(p, seen, piece);
    bracket.add(tangent(t, seen));
  }
  return bracket.lower();
}

bool has_ball_bounds(const DistanceRecord& record) {
  return record.options().within.r >= kEverywhere && record.shape().accuracy() == 0;
}

double bound_by_balls(const TrianglePiece& piece, DistanceRecord& record) {
  const double r = piece.ball.r;
  if (!has_ball_bounds(record) || !(r > 0)) return kNoBound;
  const Eigen::Vector3d u = longest_side(piece.corners).stableNormalized();
  const auto distance_at = [&](double t) {
    const Eigen::Vector3d p = piece.ball.c + t * u;
    const NearestSurface seen = record.nearest_surface(p);
    record.update_best(p, seen, piece);
    return seen.distance;
  };
  // Start with balls at both ends, then bisect the pair with the lowest bound.
  std::vector<BallPair> pairs{{-r, r, distance_at(-r), distance_at(r)}};
  while (pairs.back().d_from > 0 && pairs.back().d_to > 0) {
    const auto lowest = std::min_element(
        pairs.begin(), pairs.end(),
        [](const BallPair& x, const BallPair& y) { return x.min_bound() < y.min_bound(); });
    const BallPair pair = *lowest;
    const double bound = pair.min_bound() - piece.radius, t = pair.narrowest_position();
    if (bound >= record.sufficient_bound() || bound > record.options().cutoff ||
        pairs.size() >= kMaxPairs || record.is_exhausted() || !(t > pair.from && t < pair.to))
      return bound;
    const double d = distance_at(t);
    *lowest = {pair.from, t, pair.d_from, d};
    pairs.push_back({t, pair.to, d, pair.d_to});
  }
  return kNoBound;
}

}  // namespace thenar::internal
