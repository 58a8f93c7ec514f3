// Tests for grasp/closing/describe_grasp.cpp.

#include "grasp/closing/describe_grasp.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace thenar {
namespace {

TEST(DescribeGrasp, NamesTheLargePartsOfADirection) {
  EXPECT_EQ(direction_words({}), "none");
  // 0.2 is below a third of the largest.
  EXPECT_EQ(direction_words({{0, 0, -1}, {0.2, 0.5, 0}}), "force along -z, torque about +y");
}

// Two hard points of friction 0.5 across a ball hold it but for turning about their line; the same
// at 40 deg to the line, beyond atan(0.5) = 27 deg, do not.
TEST(DescribeGrasp, SaysThatTwoHardPointsLetTheObjectTurn) {
  Grasp grasp{};
  grasp.outcome = GraspOutcome::kGrasped;
  const auto pressed = [&](double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    grasp.contacts = {{{{-0.02, 0, 0}, {c, s, 0}, 0.5}, 0, 0},
                      {{{0.02, 0, 0}, {-c, s, 0}, 0.5}, 1, 0}};
    return describe_outcome(grasp);
  };
  EXPECT_THAT(pressed(0), testing::HasSubstr("free to turn about the line through them"));
  EXPECT_EQ(pressed(0.7), "touched, not grasped: 2 contacts, no force closure");
}

TEST(DescribeGrasp, SaysHowDeepOverlapsAre) {
  EXPECT_EQ(describe_overlaps({{"DP2", "table", 0.0032}, {"palm", "can", 0.001}}),
            "DP2 is 3.20 mm in table, palm is 1.00 mm in can");
  Grasp grasp{};
  grasp.outcome = GraspOutcome::kOverlaps;
  grasp.closed.overlaps = {{"DP2", "table", 0.0032}};
  EXPECT_EQ(describe_outcome(grasp), "the hand begins in something: DP2 is 3.20 mm in table");
}

}  // namespace
}  // namespace thenar
