#include "geometry/manifold/collision_pair.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/error.h"

namespace thenar {

CollisionPair::CollisionPair(std::shared_ptr<const CollisionBody> a,
                             std::shared_ptr<const CollisionBody> b)
    : a_(std::move(a)), b_(std::move(b)) {
  require(a_ != nullptr && b_ != nullptr, "a pair wants two {}", "bodies");
  for (int i = 0; i < static_cast<int>(a_->parts.size()); ++i)
    for (int j = 0; j < static_cast<int>(b_->parts.size()); ++j) parts_.push_back({i, j});
  candidates_.reserve(64);
}

void CollisionPair::clear_memory() {
  for (PartPair& pair : parts_) pair.memory = {};
  memory_.clear();
  manifold_.count = 0;
  is_updated_ = false;
}

const ContactManifold& CollisionPair::update(const Pose<double>& X_WA, const Pose<double>& X_WB,
                                             double margin) {
  require(X_WA.R.allFinite() && X_WA.p.allFinite() && X_WB.R.allFinite() && X_WB.p.allFinite(),
          "poses must be finite, got origins at {} and {} m", X_WA.p.norm(), X_WB.p.norm());
  require(margin >= 0 && margin < 1e6, "a margin must be finite and not negative, got {} m",
          margin);
  const Pose<double> X_BA = X_WB.inverse() * X_WA;
  candidates_.clear();
  bound_ = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    // Skip the pair while its bound exceeds the motion since the last query.
    PartPair& pair = parts_[i];
    PartMemory& memory = pair.memory;
    const CollisionPart& a = a_->parts[pair.a];
    const CollisionPart& b = b_->parts[pair.b];
    const Pose<double> X = b.X_BP.inverse() * X_BA * a.X_BP;
    if (memory.is_known) {
      const double remaining = memory.bound - motion_bound(a.ball, b.ball, memory.X_BA, X);
      if (remaining > margin) {
        bound_ = std::min(bound_, remaining);
        continue;
      }
    }
    // Compare bounding balls first, then the parts.
    const std::size_t first = candidates_.size();
    memory.bound = (X * a.ball.c - b.ball.c).norm() - a.ball.r - b.ball.r;
    if (memory.bound <= margin)
      memory.bound = find_points(a, b, X, margin, memory, candidates_);
    else
      memory.overlapped = false;
    memory.X_BA = X;
    memory.is_known = true;
    bound_ = std::min(bound_, memory.bound);
    // Transform to world, and add the pair of parts to the key.
    const Pose<double> X_WP = X_WB * b.X_BP;
    for (std::size_t k = first; k < candidates_.size(); ++k) {
      ManifoldPoint& point = candidates_[k];
      point.on_a = X_WP * point.on_a;
      point.on_b = X_WP * point.on_b;
      point.normal = X_WP.R * point.normal;
      point.feature |= static_cast<std::uint64_t>(i % 4096) << 52U;
    }
  }
  // Bound the motion since the last update, to identify points.
  const double motion = is_updated_ ? motion_bound(a_->ball, b_->ball, X_BA_, X_BA) : 0;
  X_BA_ = X_BA;
  is_updated_ = true;
  memory_.update(candidates_, X_WA, X_WB, motion, margin, manifold_);
  return manifold_;
}

}  // namespace thenar
