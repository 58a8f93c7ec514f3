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

void CollisionPair::forget() {
  for (PartPair& pair : parts_) pair.memory = {};
  memory_.forget();
  manifold_.count = 0;
  seen_ = false;
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
    // Skipped while the bound exceeds the motion since then.
    PartPair& pair = parts_[i];
    PartMemory& memory = pair.memory;
    const CollisionPart& a = a_->parts[pair.a];
    const CollisionPart& b = b_->parts[pair.b];
    const Pose<double> X = b.X_BP.inverse() * X_BA * a.X_BP;
    if (memory.seen) {
      const double left = memory.bound - motion_bound(a.ball, b.ball, memory.X_BA, X);
      if (left > margin) {
        bound_ = std::min(bound_, left);
        continue;
      }
    }
    // Balls first, then the parts themselves.
    const std::size_t first = candidates_.size();
    memory.bound = (X * a.ball.c - b.ball.c).norm() - a.ball.r - b.ball.r;
    if (memory.bound <= margin)
      memory.bound = find_points(a, b, X, margin, memory, candidates_);
    else
      memory.overlapped = false;
    memory.X_BA = X;
    memory.seen = true;
    bound_ = std::min(bound_, memory.bound);
    // To world, named by the pair of parts.
    const Pose<double> X_WP = X_WB * b.X_BP;
    for (std::size_t k = first; k < candidates_.size(); ++k) {
      ManifoldPoint& point = candidates_[k];
      point.on_a = X_WP * point.on_a;
      point.on_b = X_WP * point.on_b;
      point.normal = X_WP.R * point.normal;
      point.feature |= static_cast<std::uint64_t>(i % 4096) << 52U;
    }
  }
  // The way since the last update, for ids.
  const double motion = seen_ ? motion_bound(a_->ball, b_->ball, X_BA_, X_BA) : 0;
  X_BA_ = X_BA;
  seen_ = true;
  memory_.keep(candidates_, X_WA, X_WB, motion, margin, manifold_);
  return manifold_;
}

}  // namespace thenar
