// Random random_net_count: none lost, none silently wrong. THENAR_NETS sets how many; the default
// is quick.

#include <cstdio>
#include <cstdlib>
#include <random>

#include <gtest/gtest.h>

#include "tendons/net/solve_net.h"
#include "tests/tendons/net/judge_net.h"

namespace thenar {
namespace {

int random_net_count() {
  const char* wanted = std::getenv("THENAR_NETS");
  return wanted ? std::atoi(wanted) : 1000;
}

class RandomNets : public testing::TestWithParam<bool> {};

TEST_P(RandomNets, AreBalancedOrSayThatTheyAreNot) {
  constexpr double kPromised = 1e-9;  // residual of a net at rest [N]
  int count[5] = {0, 0, 0, 0, 0};
  for (int seed = 0; seed < random_net_count(); ++seed) {
    std::mt19937 rng(static_cast<unsigned>(seed));
    RandomNetOptions options;
    options.bones = GetParam();
    options.all_slack = seed % 20 == 0;
    const SampleNet sample = random_net(rng, options);
    const NetEquilibrium rest = NetSolver(sample.net).solve(sample.state(), sample.drive);
    ++count[static_cast<int>(rest.status)];
    ASSERT_TRUE(rest.x.allFinite() && rest.tension.allFinite()) << "seed " << seed;
    ASSERT_GE(rest.tension.minCoeff(), 0) << "seed " << seed;
    if (rest.status == NetStatus::kStalled || rest.status == NetStatus::kFarSideWrap) {
      EXPECT_GT(rest.residual, kPromised) << "seed " << seed;
      EXPECT_EQ(rest.status == NetStatus::kFarSideWrap, !rest.far_side_bands.empty())
          << "seed " << seed;
      continue;
    }
    const NetJudgement judged = judge(sample, rest);
    EXPECT_LE(rest.residual, kPromised) << "seed " << seed;
    EXPECT_LE(judged.residual, kPromised) << "seed " << seed;
    EXPECT_LE(judged.rounding, kPromised) << "seed " << seed;
    EXPECT_LE(judged.overdrawn, 0) << "seed " << seed;
    EXPECT_LE(judged.glued, 0) << "seed " << seed;
  }
  std::printf("balanced %d, unstable %d, drawn in %d, stalled %d, wound round %d\n", count[0],
              count[1], count[2], count[3], count[4]);
  EXPECT_LE(count[static_cast<int>(NetStatus::kStalled)], random_net_count() / 1000);
  EXPECT_LE(count[static_cast<int>(NetStatus::kFarSideWrap)],
            GetParam() ? random_net_count() / 50 : 0);
}

INSTANTIATE_TEST_SUITE_P(BonesOrNone, RandomNets, testing::Bool());

}  // namespace
}  // namespace thenar
