// Tests for report/words.cpp.

#include "report/words.h"

#include <gtest/gtest.h>

#include "base/units.h"

namespace thenar {
namespace {

TEST(Words, GiveAnglesInDegrees) {
  const Eigen::Vector3d q = kDegree * Eigen::Vector3d(10, 0, 45.5);
  EXPECT_EQ(angles_in_words({"a", "b", "c"}, {2, 0}, q), "c=45.5 a=10 deg");
  EXPECT_EQ(angles_in_words({"a", "b", "c"}, q), "a=10 b=0 c=45.5 deg");
}

TEST(Words, CallAnArmByWhatItsJointDoes) {
  EXPECT_EQ(positive_motion("PIP3"), "flexion");
  EXPECT_EQ(positive_motion("MCP2_FE"), "flexion");
  EXPECT_EQ(positive_motion("MCP2_AA"), "abduction");
}

}  // namespace
}  // namespace thenar
