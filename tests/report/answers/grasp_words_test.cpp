// Tests for report/answers/grasp_words.cpp.

#include "report/answers/grasp_words.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "data/io/robot/robot.h"
#include "grasp/robot/robot_hand.h"

namespace thenar {
namespace {

constexpr const char* kJaws = THENAR_DATA_DIR "/robots/parallel_jaw.toml";

TEST(GraspWords, SaysMillimetresOfJointsThatSlide) {
  const RobotHand jaws(read_robot(kJaws));
  const Eigen::VectorXd q = open_posture(jaws.layout());
  EXPECT_TRUE(slides(jaws, q, 0));
  EXPECT_EQ(value_words(0.0125, true), "12.50 mm");
  EXPECT_EQ(value_words(0.5235987755982988, false), "30.0 deg");
}

// A ball of 10 mm between jaws that close: both touch it, and the coordinate says so.
TEST(GraspWords, NamesWhatStoppedACoordinate) {
  const RobotHand jaws(read_robot(kJaws));
  const CollisionHand touching = collision_hand(jaws);
  ShapeSpec ball;
  ball.size.x() = 0.01;
  const PalmApproach& approach = jaws.layout().approach;
  Eigen::VectorXd q = open_posture(jaws.layout());
  const std::vector<Pose<double>> links = jaws.pose(q);
  Eigen::Vector3d between = Eigen::Vector3d::Zero();
  int tips = 0;
  for (const HandTip& tip : jaws.layout().tip_points) {
    between += links[static_cast<std::size_t>(tip.link)] * tip.p;
    ++tips;
  }
  ASSERT_EQ(tips, 2);
  BodySpec body;
  body.name = "ball";
  body.material = "wood";
  body.shapes = {ball};
  GraspSetup setup;
  Pose<double> place;
  place.p = between / 2 - 0.01 * approach.direction;
  setup.object = build_body({body, "", place, true});
  const ClosedHand closed = close_hand(touching, {}, q, setup);
  ASSERT_TRUE(closed.finished);
  const PosedCollisionHand posed{touching, {}, jaws.pose(closed.q)};
  const std::vector<std::string> words =
      stop_words(touching, closed, find_touching(posed, setup, 2e-4));
  ASSERT_EQ(words.size(), 1U);
  EXPECT_NE(words[0].find("contact: "), std::string::npos) << words[0];
  EXPECT_NE(words[0].find(" on ball"), std::string::npos) << words[0];
}

TEST(GraspWords, CallRoundingZero) {
  EXPECT_EQ(fmt::format("{}", epsilon_or_zero(-1.9e-14)), "0");
  EXPECT_EQ(fmt::format("{}", epsilon_or_zero(-0.0)), "0");
  EXPECT_EQ(epsilon_or_zero(-2e-9), -2e-9);
  EXPECT_EQ(epsilon_or_zero(0.25), 0.25);
}

}  // namespace
}  // namespace thenar
