// Tests for tendons/topology/rank_tests.cpp.

#include "tendons/topology/rank_tests.h"

#include <gtest/gtest.h>

#include "tests/tendons/topology/tug.h"

namespace thenar {
namespace {

FittedNet net_of_share(double s0, double s1, double misfit) {
  FittedNet net{{true, true}, {}};
  net.fit.holds = true;
  net.fit.s = Eigen::Vector2d(s0, s1);
  net.fit.misfit = misfit;
  return net;
}

const std::vector<TendonTest> kPool = {tug::test(1), tug::test(4)};
const Eigen::Vector2d kTypical(tug::kEA, tug::kEA);

// Shares 1/2 and 1/3 of the pull; sd is the floor alone, so the difference grows with the pull:
// (arm t / 6 / floor)^2.
TEST(RankTests, PrefersTheTestOnWhichModelsDisagree) {
  const double floor = tug::kArm;  // of a pull of 1 N
  NetForwardModel pool(tug::candidate(2), kPool);
  const auto ranked =
      rank_tests(pool, kPool, {net_of_share(1, 1, 0), net_of_share(1, 2, 0)}, kTypical, {0, floor});
  EXPECT_EQ(ranked[0].test, 1);
  EXPECT_NEAR(ranked[0].disagreement, 16.0 / 36, 1e-6);
  EXPECT_NEAR(ranked[1].disagreement, 1.0 / 36, 1e-6);
}

TEST(RankTests, CountsACertainDifferenceAsFiveSd) {
  NetForwardModel pool(tug::candidate(2), kPool);
  const auto ranked =
      rank_tests(pool, kPool, {net_of_share(1, 1, 0), net_of_share(1, 2, 0)}, kTypical, {0, 1e-6});
  EXPECT_EQ(ranked[0].disagreement, 25);
}

TEST(RankTests, PromisesNothingOfOneModel) {
  NetForwardModel pool(tug::candidate(2), kPool);
  EXPECT_EQ(rank_tests(pool, kPool, {net_of_share(1, 1, 0)}, kTypical, {})[0].disagreement, 0);
}

TEST(ReadingSd, AddsFloorAndShareInSquares) {
  EXPECT_NEAR(reading_sd({0.04, 0.3}, Eigen::Vector2d(6, 8))(1), 0.5, 1e-12);
}

}  // namespace
}  // namespace thenar
