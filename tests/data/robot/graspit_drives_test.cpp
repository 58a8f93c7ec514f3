// Tests for data/io/robot/graspit_drives.cpp; joints and ranges are tested by graspit_robot_test.

#include "data/io/robot/graspit_drives.h"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/message_of.h"

namespace thenar {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(GraspitDrive, ParsesItsForms) {
  const auto parts = [](const std::string& text) {
    const GraspitDrive drive = parse_graspit_drive(text);
    return std::vector<double>{static_cast<double>(drive.dof), drive.ratio, drive.offset,
                               drive.ignored ? 1. : 0.};
  };
  EXPECT_THAT(parts("d0"), ElementsAre(0, 1, 0, 0));
  EXPECT_THAT(parts(" d12*0.333+40 "), ElementsAre(12, 0.333, 40, 0));
  EXPECT_THAT(parts("d1 * -1.0 + -5e-1"), ElementsAre(1, -1, -0.5, 0));
  EXPECT_THAT(parts("d3+90"), ElementsAre(3, 1, 90, 0));
  EXPECT_THAT(parts("0.5*d2"), ElementsAre(2, 0.5, 0, 0));
  EXPECT_THAT(parts("-17.5"), ElementsAre(-1, 1, -17.5, 0));
  EXPECT_THAT(parts("d1-2.46"), ElementsAre(1, 1, -2.46, 1));
}

TEST(GraspitDrive, RefusesOtherTexts) {
  for (const std::string text : {"", "x1", "d", "d1*", "d1+", "d1 40", "d1*2*3", "nan"})
    EXPECT_THAT(message_of([&] { (void)parse_graspit_drive(text); }), HasSubstr("wanted")) << text;
}

}  // namespace
}  // namespace thenar
