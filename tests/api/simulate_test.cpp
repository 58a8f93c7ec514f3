// Tests for api/simulate.cpp.

#include "api/simulate.h"

#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include "data/io/result_file.h"
#include "tests/data_folder.h"
#include "tests/message_of.h"
#include "tests/temporary_folder.h"

namespace thenar {
namespace {

class SimulateDigit : public TemporaryFolder {};

DigitMotionRequest index_finger() {
  DigitMotionRequest request;
  request.digit.subject = kData + "/subjects/an_chao_index.toml";
  request.excitation = {{"FDP", 0.2}};
  request.muscle = Muscle::kBounds;
  request.seconds = 0.02;
  return request;
}

// (0.5 + 1.5 a) a' / (0.2 - a) = 1 / 15 ms, integrated; FDP pulls with a times 4.79 cm^2 x
// 30 N/cm^2.
TEST_F(SimulateDigit, FollowsTheIntegralOfActivation) {
  const DigitMotionResult motion = simulate_digit(index_finger());
  const Trajectory& t = motion.trajectory;
  ASSERT_EQ(t.status, MotionStatus::kCompleted);
  const Eigen::Index last = t.time.size() - 1, fdp = 2;
  ASSERT_EQ(t.muscles[fdp], "FDP");
  const double a = t.activation(last, fdp);
  EXPECT_NEAR(-1.5 * a - 0.8 * std::log(1 - a / 0.2), 0.02 / 0.015, 1e-4);
  EXPECT_NEAR(t.tension(last, fdp), a * 4.79 * 30, 1e-6);
}

// Only lines of a net can drift from their lengths.
TEST_F(SimulateDigit, MeasuresDriftOfNetsOnly) {
  DigitMotionRequest request = index_finger();
  EXPECT_FALSE(simulate_digit(request).trajectory.drift.has_value());
  request.digit.net = "chao_an";
  request.excitation = {{"EDC", 0.1}, {"FDP", 0.1}};
  const DigitMotionResult motion = simulate_digit(request);
  ASSERT_TRUE(motion.trajectory.drift.has_value());
  EXPECT_LT(*motion.trajectory.drift, 1e-4);  // [m]
  EXPECT_EQ(motion.sources.size(), 2U);       // subject and net
}

// No thumb muscle of human_hand states a fibre length; all of an_chao_index do.
TEST_F(SimulateDigit, PullsByBoundsWhereNoFibresAreStated) {
  DigitMotionRequest request;
  request.digit.subject = kData + "/subjects/human_hand.toml";
  request.digit.digit = "thumb";
  request.excitation = {{"EPL", 0.1}};
  request.seconds = 0.01;
  const DigitMotionResult motion = simulate_digit(request);
  EXPECT_EQ(motion.trajectory.fidelity.muscle, Muscle::kBounds);
  EXPECT_NE(fmt::format("{}", fmt::join(motion.outcome.warnings, "; "))
                .find("states no 'fibre_length_mm'"),
            std::string::npos);
  request.digit = index_finger().digit;
  request.excitation = index_finger().excitation;
  EXPECT_EQ(simulate_digit(request).trajectory.fidelity.muscle, Muscle::kRigidTendon);
}

// Without passive moments nothing but weight moves it, the other way if gravity is turned round.
TEST_F(SimulateDigit, FallsWithoutExcitation) {
  DigitMotionRequest request = index_finger();
  request.excitation.clear();
  request.digit.passive = PassiveMoments::kOff;
  request.seconds = 0.005;
  const auto speeds = [&](const Eigen::Vector3d& gravity) -> Eigen::VectorXd {
    request.gravity = gravity;
    const Trajectory t = simulate_digit(request).trajectory;
    EXPECT_EQ(t.activation.cwiseAbs().maxCoeff(), 0);
    return t.speed.row(t.speed.rows() - 1);
  };
  const Eigen::Vector3d down(0, -9.81, 0);  // palmar
  const Eigen::VectorXd fall = speeds(down), rise = speeds(-down);
  EXPECT_GT(fall.cwiseAbs().maxCoeff(), 0.1);  // [rad/s]
  for (Eigen::Index j = 0; j < fall.size(); ++j) EXPECT_LE(fall[j] * rise[j], 0) << j;
}

TEST_F(SimulateDigit, WantsOneKindOfExcitation) {
  DigitMotionRequest request = index_finger();
  request.excitation_file = "e.csv";
  EXPECT_NE(message_of([&] { (void)simulate_digit(request); }).find("got both"), std::string::npos);
  request.excitation.clear();
  request.excitation_file.clear();
  EXPECT_THROW((void)simulate_digit(request), InputError);
}

TEST_F(SimulateDigit, RefusesATendonWithoutLength) {
  DigitMotionRequest request = index_finger();
  request.tendon_slack = {{"FDP", 0}};
  EXPECT_EQ(message_of([&] { (void)simulate_digit(request); }),
            "wanted a slack length > 0 of 'FDP', got 0 mm");
}

TEST_F(SimulateDigit, StopsOnRequest) {
  Progress progress;
  progress.stop_requested = [] { return true; };
  EXPECT_EQ(simulate_digit(index_finger(), progress).trajectory.status, MotionStatus::kStopped);
}

TEST_F(SimulateDigit, IsWrittenWithItsRun) {
  const DigitMotionResult motion = simulate_digit(index_finger());
  RunRecord run{{"simulate", "my hand.toml"}, "/tmp", "0123", "2026-01-31T12:00:00Z"};
  write_motion(motion, path("motion.h5"), run);
  const ResultFile file = read_result(path("motion.h5"));
  EXPECT_EQ(file.text("format"), "thenar motion 1");
  EXPECT_EQ(file.text("status"), "done");
  EXPECT_EQ(file.text("provenance/command"), "thenar simulate 'my hand.toml'");
  EXPECT_EQ(file.text("provenance/commit"), "0123");
  EXPECT_EQ(file.text("inputs/1/text"), motion.sources[0].text);
  EXPECT_EQ(file.matrix("angle"), motion.trajectory.angle);
  EXPECT_TRUE(std::isnan(file.number("stray")));
}

}  // namespace
}  // namespace thenar
