// Tests for tendons/net/net_search.cpp, and for what a net on a finger is refused for.

#include "tendons/net/net_search.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "base/units.h"
#include "tendons/net/build_tendons.h"
#include "tendons/net/digit_sweep.h"
#include "tendons/net/posture_sweep.h"
#include "tests/data_folder.h"

namespace thenar {
namespace {

using Eigen::VectorXd;

std::unique_ptr<DigitTendons> ring(const std::string& net) {
  return build_net_tendons(read_subject(kData + "/subjects/human_hand.toml"), "ring", {},
                           read_net(kData + "/nets/" + net + ".toml"));
}

/// A pull of one muscle.
VectorXd pull_of(const DigitTendons& tendons, const std::string& muscle, double tension) {
  const auto& names = tendons.digit().names.muscles;
  return tension * VectorXd::Unit(static_cast<Eigen::Index>(names.size()),
                                  std::find(names.begin(), names.end(), muscle) - names.begin());
}

/// The ring finger with its knuckle straight [rad] (4).
VectorXd bent(double pip, double dip) { return kDegree * Eigen::Vector4d(0, 0, pip, dip); }

// The central slip's insertion goes from before the axis of the middle joint to behind it: its
// bands run over the head all the way, and no tension changes by more than a few per cent a degree.
TEST(NetOnAFinger, CentralSlipRunsOverTheHeadThroughTheRange) {
  const auto tendons = ring("extensor_hood");
  const VectorXd t = pull_of(*tendons, "EDC4", 2.9);
  double before = 0;
  for (double pip = 75; pip <= 105; ++pip) {
    const DigitPoint point = sweep_digit(*tendons, {bent(pip, 57)}, t).front();
    EXPECT_EQ(point.rest.status, NetStatus::kBalanced) << pip;
    EXPECT_FALSE(point.snapped) << pip;
    EXPECT_LT(point.rest.tension.maxCoeff(), 2 * 2.9) << pip;
    if (before > 0) {
      EXPECT_NEAR(point.pull.slips.central, before, 0.05 * before) << pip;
    }
    before = point.pull.slips.central;
  }
}

// Two equal bands hold a knot that a muscle pulls away from them: each has half of the pull, and a
// strain of that over EA.
Net fork(double EA) {
  Net net;
  net.name = "fork";
  net.nodes = {{"knot", true, -1, {0, 0, 0}, {}},
               {"left", false, -1, {-0.01, 0, 0}, {}},
               {"right", false, -1, {-0.01, 0, 0}, {}},
               {"exit", false, -1, {0.05, 0, 0}, {}}};
  NetBand left{"left", 0, 1}, right{"right", 0, 2}, muscle{"muscle", 0, 3};
  for (NetBand* band : {&left, &right}) {
    band->slack = 0.01;
    band->EA = EA;
    band->max_strain = 0.1;
  }
  muscle.muscle = 0;
  net.bands = {left, right, muscle};
  net.muscles = {"muscle"};
  net.max_load = 3;
  return net;
}

NetEquilibrium rest_of(const Net& net, double pull) {
  return NetSolver(net).solve({}, {VectorXd::Constant(1, pull), {}});
}

TEST(Overstrained, IsANetWhoseBandsStrainByMoreThanTheyBear) {
  EXPECT_EQ(rest_of(fork(100), 19).status, NetStatus::kBalanced);  // 9.5 N: 9.5 %
  const NetEquilibrium over = rest_of(fork(100), 21);              // 10.5 %
  EXPECT_EQ(over.status, NetStatus::kOverstrained);
  EXPECT_EQ(over.overstrained, (std::vector<int>{0, 1}));
  EXPECT_LT(over.residual, 1e-9);
}

// A third band, 5 % too short between two bones: it has 50 N whatever the muscle pulls.
TEST(Overstrained, IsANetWhoseBandsBearMoreThanThreeTimesThePull) {
  Net net = fork(1000);
  NetBand wedged{"wedged", 1, 3};
  wedged.slack = 0.06 / 1.05;
  wedged.EA = 1000;
  net.bands.push_back(wedged);
  EXPECT_EQ(rest_of(net, 17).status, NetStatus::kBalanced);  // 2.9 times
  const NetEquilibrium over = rest_of(net, 16);              // 3.1 times
  EXPECT_EQ(over.status, NetStatus::kOverstrained);
  EXPECT_EQ(over.overstrained, std::vector<int>{3});
  // A net that was not laid on a finger has no such bounds.
  net.max_load = std::numeric_limits<double>::infinity();
  EXPECT_EQ(rest_of(net, 16).status, NetStatus::kBalanced);
}

TEST(NetDescription, StatesWhatItsTissueBears) {
  NetDescription plan = read_net(kData + "/nets/extensor_hood.toml");
  EXPECT_EQ(plan.bands.front().max_strain, 0.1);
  plan.bands.front().max_strain = 0.2;
  const Subject subject = read_subject(kData + "/subjects/human_hand.toml");
  const BuiltNet built = build_net(subject, build_tendon_digit(subject, "ring"), plan);
  EXPECT_EQ(built.net.bands.front().max_strain, 0.2);
}

// One posture, asked alone and as the last of a row.
TEST(SweepDigit, TellsWhatSolvingTells) {
  for (const char* net : {"winslow", "extensor_hood"}) {
    const auto tendons = ring(net);
    const VectorXd t = pull_of(*tendons, "EDC4", 2.9);
    const std::vector<VectorXd> row = postures_between(bent(0, 0), bent(100, 60), 10);
    const std::vector<DigitPoint> swept = sweep_digit(*tendons, row, t);
    for (std::size_t i = 0; i < row.size(); ++i) {
      const DigitPoint alone = sweep_digit(*tendons, {row[i]}, t).front();
      EXPECT_EQ(alone.snapped, swept[i].snapped) << net << " " << i;
      EXPECT_EQ(alone.rest.status, swept[i].rest.status) << net << " " << i;
      EXPECT_EQ(alone.rest.x, swept[i].rest.x) << net << " " << i;
    }
  }
}

}  // namespace
}  // namespace thenar
