// Tests for grasp/compare/object_motion.cpp.

#include "grasp/compare/object_motion.h"

#include <gtest/gtest.h>

#include "data/io/robot/robot.h"
#include "grasp/closing/closing_drives.h"
#include "grasp/robot/robot_hand.h"

namespace thenar {
namespace {

// One motor moves the only coordinate of the jaws, by the ratio that the layout states.
TEST(DriveRatios, HasAColumnForEachDrive) {
  const RobotHand jaws(read_robot(THENAR_DATA_DIR "/robots/parallel_jaw.toml"));
  const Eigen::MatrixXd ratios = drive_ratios(jaws, open_posture(jaws.layout()));
  ASSERT_EQ(ratios.rows(), 1);
  ASSERT_EQ(ratios.cols(), 1);
  EXPECT_DOUBLE_EQ(ratios(0, 0), jaws.layout().drives[0].moves[0].ratio);
}

}  // namespace
}  // namespace thenar
