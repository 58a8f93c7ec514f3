#include "geometry/manifold/broad_phase.h"

#include <algorithm>
#include <numeric>

#include "base/error.h"

namespace thenar {

BroadPhase::BroadPhase(int bodies) : bodies_(0) {
  require(bodies >= 0, "a world has no fewer than {} bodies, got {}", 0, bodies);
  bodies_ = static_cast<std::size_t>(bodies);
  excluded_.assign(bodies_ * bodies_, false);
  order_.resize(bodies_);
  std::iota(order_.begin(), order_.end(), 0);
}

void BroadPhase::exclude(int a, int b) {
  const int bodies = static_cast<int>(bodies_);
  require(a >= 0 && a < bodies && b >= 0 && b < bodies, "no pair ({}, {}) among {} bodies", a, b,
          bodies);
  excluded_[static_cast<std::size_t>(a) * bodies_ + static_cast<std::size_t>(b)] = true;
  excluded_[static_cast<std::size_t>(b) * bodies_ + static_cast<std::size_t>(a)] = true;
}

bool BroadPhase::excluded(int a, int b) const {
  return excluded_[static_cast<std::size_t>(a) * bodies_ + static_cast<std::size_t>(b)];
}

const std::vector<BodyPair>& BroadPhase::update(const std::vector<Eigen::AlignedBox3d>& boxes) {
  require(boxes.size() == bodies_, "{} boxes for {} bodies", boxes.size(), bodies_);
  const auto box = [&](int i) -> const Eigen::AlignedBox3d& { return boxes[i]; };
  // Find the axis along which centres vary most.
  Eigen::Array3d sum = Eigen::Array3d::Zero(), squares = sum;
  for (std::size_t i = 0; i < bodies_; ++i) {
    require(!boxes[i].isEmpty() && boxes[i].min().allFinite() && boxes[i].max().allFinite(),
            "the box of body {} is empty or not finite", i);
    const Eigen::Array3d centre = boxes[i].center();
    sum += centre;
    squares += centre.square();
  }
  Eigen::Index axis = 0;
  if (bodies_ > 0) (squares - sum.square() / static_cast<double>(bodies_)).maxCoeff(&axis);
  // Sort by insertion, as the order has hardly changed; break ties by number.
  const auto before = [&](int i, int j) {
    const double low_i = box(i).min()(axis), low_j = box(j).min()(axis);
    return low_i != low_j ? low_i < low_j : i < j;
  };
  for (std::size_t k = 1; k < bodies_; ++k) {
    const int moving = order_[k];
    std::size_t at = k;
    for (; at > 0 && before(moving, order_[at - 1]); --at) order_[at] = order_[at - 1];
    order_[at] = moving;
  }
  // Compare boxes while their ranges overlap.
  pairs_.clear();
  for (std::size_t k = 0; k < bodies_; ++k)
    for (std::size_t m = k + 1; m < bodies_; ++m) {
      const int i = order_[k], j = order_[m];
      if (box(j).min()(axis) > box(i).max()(axis)) break;
      if (excluded(i, j) || !box(i).intersects(box(j))) continue;
      pairs_.push_back({std::min(i, j), std::max(i, j)});
    }
  std::sort(pairs_.begin(), pairs_.end());
  return pairs_;
}

}  // namespace thenar
