// Tests for geometry/manifold/broad_phase.cpp.

#include "geometry/manifold/broad_phase.h"

#include <random>

#include <gtest/gtest.h>

#include "base/error.h"
#include "tests/geometry/collision/drawn.h"

namespace thenar {
namespace {

// Boxes that drift: every pair that meets is found, no other, in order.
TEST(BroadPhase, IsBruteForceWhileBoxesMove) {
  std::mt19937 rng(1);
  constexpr int kBodies = 40;
  std::vector<Eigen::AlignedBox3d> boxes;
  std::vector<Eigen::Vector3d> drift;
  for (int i = 0; i < kBodies; ++i) {
    const Eigen::Vector3d c = drawn_point(rng, 0.3);
    const Eigen::Vector3d h = drawn_point(rng, 0.05).cwiseAbs();
    boxes.emplace_back(c - h, c + h);
    drift.push_back(drawn_point(rng, 0.02));
  }
  BroadPhase broad(kBodies);
  broad.exclude(7, 3);
  std::size_t met = 0;
  for (int step = 0; step < 200; ++step) {
    std::vector<BodyPair> brute;
    for (int i = 0; i < kBodies; ++i)
      for (int j = i + 1; j < kBodies; ++j)
        if (boxes[i].intersects(boxes[j]) && !(i == 3 && j == 7)) brute.push_back({i, j});
    ASSERT_EQ(broad.update(boxes), brute);
    met += brute.size();
    for (int i = 0; i < kBodies; ++i) {
      boxes[i].translate(drift[i]);
      if (boxes[i].center().norm() > 0.5) drift[i] = -drift[i];
    }
  }
  EXPECT_GT(met, 300U);
}

TEST(BroadPhase, RefusesWhatIsNoBox) {
  BroadPhase broad(1);
  EXPECT_THROW(broad.update({}), InputError);
  EXPECT_THROW(broad.update({Eigen::AlignedBox3d()}), InputError);
  EXPECT_THROW(broad.exclude(0, 1), InputError);
  EXPECT_TRUE(BroadPhase(0).update({}).empty());
}

}  // namespace
}  // namespace thenar
