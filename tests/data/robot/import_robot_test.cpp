// Tests for data/io/robot/import_robot.cpp.

#include "data/io/robot/import_robot.h"

#include <gmock/gmock.h>

namespace thenar::internal {
namespace {

TEST(ImportWarnings, StandByWeightEachOnce) {
  EXPECT_THAT(
      by_severity({"<Kp> in <dof> is not read (line 3)", "limits of 'j' are swapped",
                   "x.xml:2: <a> is not understood and was left out", "MISSING BODY 'b.xml'",
                   "x.xml:2: <a> is not understood and was left out", "hand.xml: MISSING MESH"}),
      testing::ElementsAre("MISSING BODY 'b.xml'", "hand.xml: MISSING MESH",
                           "limits of 'j' are swapped", "<Kp> in <dof> is not read (line 3)",
                           "x.xml:2: <a> is not understood and was left out (2 times)"));
}

}  // namespace
}  // namespace thenar::internal
