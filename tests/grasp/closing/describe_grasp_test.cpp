// Tests for grasp/closing/describe_grasp.cpp.

#include "grasp/closing/describe_grasp.h"

#include <gtest/gtest.h>

namespace thenar {
namespace {

TEST(DescribeGrasp, NamesTheLargePartsOfADirection) {
  ScaledWrench w = ScaledWrench::Zero();
  EXPECT_EQ(direction_words(w), "none");
  w << 0, 0, -1, 0.2, 0.5, 0;  // 0.2 is below a third of the largest
  EXPECT_EQ(direction_words(w), "force along -z, torque about +y");
}

TEST(DescribeGrasp, SaysHowDeepOverlapsAre) {
  EXPECT_EQ(overlap_words({{"DP2", "table", 0.0032}, {"palm", "can", 0.001}}),
            "DP2 is 3.20 mm in table, palm is 1.00 mm in can");
  Grasp grasp{};
  grasp.outcome = GraspOutcome::kOverlaps;
  grasp.closed.overlaps = {{"DP2", "table", 0.0032}};
  EXPECT_EQ(outcome_words(grasp), "the hand begins in something: DP2 is 3.20 mm in table");
}

}  // namespace
}  // namespace thenar
