#include "geometry/manifold/manifold_memory.h"

#include <algorithm>
#include <limits>

namespace thenar {
namespace {

using Eigen::Vector3d;

constexpr int kMaxRegionPoints = 6;  // points after which only other directions count
// Cosine between normals above which they are one direction, 30 degrees [1]
constexpr double kSameDirection = 0.87;
constexpr double kSamePoint = 1e-6;        // distance within which points are one [m]
constexpr double kMaxPointMotion = 1e-4;   // distance of a point from the one that it continues [m]
constexpr double kMinNormalCosine = 0.94;  // cosine between their normals, 20 degrees [1]
constexpr double kKeptWeight = 1.3;        // weight of the distance of kept points [1]
constexpr double kMinGapWeight = 0.2;      // weight of points at the margin; 1 for the nearest [1]
// Gap by which another point must be nearer than the last first point [m]
constexpr double kFirstPointGain = 1e-6;

/// Returns whether the direction of a point differs from that of all kept ones.
bool is_other_region(const ManifoldPoint& point, const ContactManifold& kept) {
  for (const ManifoldPoint& other : kept)
    if (point.normal.dot(other.normal) > kSameDirection) return false;
  return true;
}

}  // namespace

bool ManifoldMemory::was_kept(std::uint64_t feature) const {
  for (int i = 0; i < count_; ++i)
    if (last_[i].feature == feature) return true;
  return false;
}

void ManifoldMemory::reduce(std::vector<ManifoldPoint>& points, double margin,
                            ContactManifold& manifold) {
  // Find the nearest point, and the extent of all.
  std::size_t first = 0;
  double least = std::numeric_limits<double>::infinity();
  Vector3d low = points[0].on_b, high = low, low_a = points[0].on_a, high_a = low_a;
  squared_distances_.resize(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    ManifoldPoint& point = points[i];
    point.age = was_kept(point.feature) ? 1 : 0;
    const double gap = point.gap - (point.age > 0 ? kFirstPointGain : 0);
    if (gap < least) least = gap, first = i;
    low = low.cwiseMin(point.on_b);
    high = high.cwiseMax(point.on_b);
    low_a = low_a.cwiseMin(point.on_a);
    high_a = high_a.cwiseMax(point.on_a);
    squared_distances_[i] = std::numeric_limits<double>::infinity();
  }
  const double extent2 = std::max((high - low).squaredNorm(), (high_a - low_a).squaredNorm());
  const double range = std::max(margin - least, 1e-12);
  // Repeatedly keep the point farthest from those kept.
  std::size_t next = first;
  for (;;) {
    const ManifoldPoint& kept = manifold.points[manifold.count++] = points[next];
    if (manifold.count == ContactManifold::kMaxPoints) return;
    double farthest = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const ManifoldPoint& point = points[i];
      const double cosine = point.normal.dot(kept.normal);
      const double distance2 =
          std::min((point.on_a - kept.on_a).squaredNorm(), (point.on_b - kept.on_b).squaredNorm());
      // Count only other directions after six points, or at the same position.
      double apart2 = distance2 + extent2 * (1 - cosine);
      if (cosine > kSameDirection && distance2 < kSamePoint * kSamePoint) apart2 = 0;
      squared_distances_[i] = std::min(squared_distances_[i], apart2);
      if (manifold.count >= kMaxRegionPoints && !is_other_region(point, manifold)) continue;
      const double share =
          kMinGapWeight + (1 - kMinGapWeight) * std::min(1.0, (margin - point.gap) / range);
      const double weight = share * (point.age > 0 ? kKeptWeight : 1);
      const double weighted = squared_distances_[i] * weight * weight;
      if (weighted > farthest) farthest = weighted, next = i;
    }
    if (!(farthest > 0)) return;
  }
}

void ManifoldMemory::assign_ids(const Pose<double>& X_WA, const Pose<double>& X_WB, double motion,
                                ContactManifold& manifold) {
  // Keep the ids of points of the same feature.
  std::array<bool, ContactManifold::kMaxPoints> taken{};
  const auto inherit = [&](ManifoldPoint& point, int from) {
    taken[from] = true;
    point.id = last_[from].id;
    point.age = last_[from].age + 1;
  };
  for (int i = 0; i < manifold.count; ++i) {
    ManifoldPoint& point = manifold.points[i];
    point.id = -1;
    point.age = 0;
    for (int k = 0; k < count_ && point.id < 0; ++k)
      if (!taken[k] && last_[k].feature == point.feature) inherit(point, k);
  }
  // Give others the id of the nearest unassigned point, if it is near enough.
  const Pose<double> X_AW = X_WA.inverse(), X_BW = X_WB.inverse();
  for (int i = 0; i < manifold.count; ++i) {
    ManifoldPoint& point = manifold.points[i];
    if (point.id >= 0) continue;
    const Vector3d on_a = X_AW * point.on_a, on_b = X_BW * point.on_b;
    double nearest = kMaxPointMotion + 2 * motion;
    int from = -1;
    for (int k = 0; k < count_; ++k) {
      if (taken[k] || last_[k].n.dot(X_BW.R * point.normal) < kMinNormalCosine) continue;
      const double distance =
          std::min((last_[k].on_a - on_a).norm(), (last_[k].on_b - on_b).norm());
      if (distance < nearest) nearest = distance, from = k;
    }
    if (from < 0)
      point.id = next_id_++;
    else
      inherit(point, from);
  }
}

void ManifoldMemory::update(std::vector<ManifoldPoint>& points, const Pose<double>& X_WA,
                            const Pose<double>& X_WB, double motion, double margin,
                            ContactManifold& manifold) {
  manifold.count = 0;
  if (!points.empty()) {
    reduce(points, margin, manifold);
    assign_ids(X_WA, X_WB, motion, manifold);
    std::sort(manifold.points.begin(), manifold.points.begin() + manifold.count,
              [](const ManifoldPoint& a, const ManifoldPoint& b) { return a.id < b.id; });
  }
  // Store the points in the frames of the bodies.
  const Pose<double> X_AW = X_WA.inverse(), X_BW = X_WB.inverse();
  count_ = manifold.count;
  for (int i = 0; i < count_; ++i) {
    const ManifoldPoint& point = manifold.points[i];
    last_[i] = {X_AW * point.on_a, X_BW * point.on_b, X_BW.R * point.normal,
                point.feature,     point.id,          point.age};
  }
}

}  // namespace thenar
