// Tests for report/answers/simulate.cpp.

#include "report/answers/simulate.h"

#include <cmath>

#include <gtest/gtest.h>

namespace thenar {
namespace {

/// One joint that turns by a right angle in 0.5 s, pulled by one muscle.
DigitMotionResult quarter_turn() {
  DigitMotionResult motion;
  motion.subject = "rod";
  motion.digit = "index";
  Trajectory& t = motion.trajectory;
  t.status = MotionStatus::kCompleted;
  t.joints = {"PIP2"};
  t.muscles = {"FDP"};
  t.time = Eigen::Vector2d(0, 0.5);
  t.angle = t.speed = Eigen::Vector2d(0, M_PI / 2);
  t.excitation = t.activation = t.tension = Eigen::Vector2d(0, 1);
  t.excursion = Eigen::Vector2d(0, -0.01);
  t.slips = Eigen::MatrixX4d::Zero(2, 4);
  t.tip = Eigen::MatrixX3d::Constant(2, 3, 0.02);
  t.energy = t.work = t.dissipated = Eigen::Vector2d(0, 1e-3);
  t.balance = {2e-6, 1e-3};
  return motion;
}

TEST(MotionAnswer, HasDegreesAndMillimetres) {
  const OrderedJson json = json_of(quarter_turn());
  EXPECT_NEAR(json["last"]["posture_deg"]["PIP2"].get<double>(), 90, 1e-12);
  EXPECT_NEAR(json["last"]["excursion_mm"]["FDP"].get<double>(), -10, 1e-12);
  EXPECT_NEAR(json["last"]["tip_mm"][0].get<double>(), 20, 1e-12);
  EXPECT_EQ(json["energy_error_J"], 2e-6);
}

TEST(MotionAnswer, DoesNotKnowADriftThatNothingMeasures) {
  DigitMotionResult motion = quarter_turn();
  EXPECT_TRUE(json_of(motion)["drift_mm"].is_null());
  EXPECT_NE(text_of(motion).find("from the tendon length: not applicable\n"), std::string::npos);
  motion.trajectory.drift = 2e-5;
  EXPECT_NEAR(json_of(motion)["drift_mm"].get<double>(), 0.02, 1e-15);
  EXPECT_NE(text_of(motion).find("from the tendon length: 0.02 mm\n"), std::string::npos);
}

TEST(MotionAnswer, CallsTheEnergyErrorByItsName) {
  EXPECT_NE(text_of(quarter_turn()).find("energy error 0.002 mJ of 1 mJ total energy exchanged"),
            std::string::npos)
      << text_of(quarter_turn());
}

TEST(MotionAnswer, HasARowAnInstant) {
  const Table table = table_of(quarter_turn());
  ASSERT_EQ(table.rows.size(), 2U);
  EXPECT_EQ(table.header.front(), "time_s");
  EXPECT_EQ(table.rows[1].front(), "0.5");
}

TEST(MotionAnswer, RefusesMotionsThatDidNotGetToTheirEnd) {
  DigitMotionResult motion = quarter_turn();
  motion.trajectory.warning = "why";
  EXPECT_EQ(refusal_of(motion), "");
  EXPECT_EQ(motion_warnings(motion.trajectory), std::vector<std::string>{"why"});
  motion.trajectory.status = MotionStatus::kIntegratorFailed;
  EXPECT_EQ(refusal_of(motion), "the motion is stuck: why");
  EXPECT_TRUE(motion_warnings(motion.trajectory).empty());  // said once
  motion.trajectory.status = MotionStatus::kUnbalanced;
  EXPECT_EQ(refusal_of(motion),
            "energy does not balance: error 0.002 mJ of 1 mJ total energy exchanged");
}

}  // namespace
}  // namespace thenar
