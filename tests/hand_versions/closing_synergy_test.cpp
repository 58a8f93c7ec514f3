// Tests for hand_versions/closing_synergy.cpp: drives of a human hand.

#include "hand_versions/closing_synergy.h"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "base/error.h"
#include "tests/hand/skin/human_subjects.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

struct SynergyHand {
  Subject subject = sample::subject("mirakhorlo2016");
  Skeleton skeleton = build_skeleton(subject, {{"thumb", "index", "middle", "ring", "little"},
                                               {{"WRIST_FE", 0}, {"WRIST_AA", 0}}});
  ClosingSynergy use = motor_synergy(find_anatomy(subject), subject, skeleton);
};

// Every coordinate has one drive; those that close are of the digits, and all others stand.
TEST(ClosingSynergyOfHands, DrivesEveryJointOnce) {
  const SynergyHand hand;
  std::set<int> driven;
  int closing = 0;
  for (const Drive& drive : hand.use.drives) {
    closing += drive.speed > 0 ? 1 : 0;
    for (const DrivenCoordinate& each : drive.moves)
      EXPECT_TRUE(driven.insert(each.coordinate).second) << drive.name;
  }
  EXPECT_EQ(static_cast<int>(driven.size()), hand.skeleton.coordinates());
  EXPECT_EQ(closing, 5);
  EXPECT_NEAR(hand.use.approach.direction.norm(), 1, 1e-12);
}

// The open posture is within the limits; closing joints are at zero, or at the limit nearest to it.
TEST(ClosingSynergyOfHands, OpensWithinTheLimits) {
  const SynergyHand hand;
  ASSERT_EQ(hand.use.open.size(), hand.skeleton.coordinates());
  for (int i = 0; i < hand.skeleton.coordinates(); ++i) {
    const CoordinateLimits& limits = hand.skeleton.limits[static_cast<std::size_t>(i)];
    EXPECT_GE(hand.use.open[i], limits.lower) << i;
    EXPECT_LE(hand.use.open[i], limits.upper) << i;
  }
  for (const Drive& drive : hand.use.drives)
    for (const DrivenCoordinate& each : drive.moves) {
      if (!(drive.speed > 0)) continue;
      const CoordinateLimits& limits =
          hand.skeleton.limits[static_cast<std::size_t>(each.coordinate)];
      EXPECT_EQ(hand.use.open[each.coordinate], std::clamp(0.0, limits.lower, limits.upper));
    }
}

// Long flexors alone pull, each with its largest tension.
TEST(ClosingSynergyOfHands, OnlyLongFlexorsPull) {
  Actuation actuation;
  actuation.upper = (Eigen::VectorXd(5) << 10, 20, 30, 40, 50).finished();
  const Eigen::VectorXd t = max_flexor_tensions({"FDP2", "EDC2", "FDS2", "FPL", "DI1"}, actuation);
  EXPECT_EQ(t, (Eigen::VectorXd(5) << 10, 0, 30, 40, 0).finished());
  EXPECT_EQ(message_of([&] { (void)max_flexor_tensions({"FDP2"}, actuation); }),
            "1 names for 5 actuators");
}

}  // namespace
}  // namespace thenar
