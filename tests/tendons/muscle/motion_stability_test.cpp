// Where simulate() might break: every case on every rung of muscles. All of them must end, with
// finite numbers, and keep energy to a part in 10,000 of what was turned over: a hundred steps of
// the tolerance.

#include <cmath>

#include <gtest/gtest.h>

#include "tests/tendons/muscle/moving_samples.h"

namespace thenar {
namespace {

using Eigen::VectorXd;
using sample::Mover;

/// What is hard about a motion.
struct Hard {
  Subject subject = sample::index_finger();
  Excitation excitation = constant_excitation(VectorXd::Constant(7, 0.2));
  double angle = 0.2;  // of every joint at the start [rad]
  double speed = 0;    // [rad/s]
};

class MotionStability : public testing::TestWithParam<Muscle> {
 protected:
  static void expect_sound(const Hard& hard) {
    const Mover mover(hard.subject, GetParam());
    SimulateOptions options;
    options.seconds = 0.2;
    const VectorXd each = VectorXd::Ones(mover.joints());
    const Trajectory path = simulate(mover.model(), hard.excitation,
                                     {hard.angle * each, hard.speed * each, {}}, options);
    EXPECT_EQ(path.status, MotionStatus::kCompleted) << path.warning;
    EXPECT_TRUE(path.angle.allFinite() && path.speed.allFinite() && path.tension.allFinite());
    EXPECT_GE(path.tension.minCoeff(), 0);
    const double turned_over = path.work.cwiseAbs().maxCoeff() + path.dissipated.maxCoeff() +
                               path.energy.cwiseAbs().maxCoeff();
    EXPECT_LE(energy_error(path), 1e-4 * turned_over);
  }
};

TEST_P(MotionStability, AllMusclesAtFullExcitation) {
  Hard hard;
  hard.excitation = constant_excitation(VectorXd::Ones(7));
  expect_sound(hard);
}

TEST_P(MotionStability, AllMusclesAtRest) {
  Hard hard;
  hard.excitation = constant_excitation(VectorXd::Zero(7));
  expect_sound(hard);
}

// Every muscle is switched on or off every 5 ms, its neighbours the other way.
TEST_P(MotionStability, ExcitationThatJumpsAllTheTime) {
  Hard hard;
  hard.excitation = {VectorXd(80), Eigen::MatrixXd(80, 7)};
  for (int k = 0; k < 80; ++k) {
    const int pair = k / 2;
    hard.excitation.time[k] = 0.005 * pair;
    for (int m = 0; m < 7; ++m) hard.excitation.value(k, m) = ((k + 1) / 2 + m) % 2;
  }
  expect_sound(hard);
}

TEST_P(MotionStability, StartOneRadianBeyondTheStops) {
  Hard hard;
  hard.angle = 2.5;
  expect_sound(hard);
}

TEST_P(MotionStability, StartAtAHundredRadiansASecond) {
  Hard hard;
  hard.speed = 100;
  expect_sound(hard);
}

TEST_P(MotionStability, FibresOfThreeMillimetres) {
  Hard hard;
  for (MuscleUnit& muscle : hard.subject.muscles) muscle.fibre_length = 3e-3;
  expect_sound(hard);
}

TEST_P(MotionStability, FibresAlmostSquareToTheTendon) {
  Hard hard;
  for (MuscleUnit& muscle : hard.subject.muscles) muscle.pennation = 1.5;
  expect_sound(hard);
}

TEST_P(MotionStability, TendonsFromAMillimetreToTwoMetres) {
  for (const double slack : {1e-3, 2.0}) {
    Hard hard;
    for (MuscleUnit& muscle : hard.subject.muscles) muscle.tendon_slack = slack;
    expect_sound(hard);
  }
}

TEST_P(MotionStability, MusclesFromNothingToTheMillionfold) {
  Hard hard;
  hard.subject.muscles[0].max_force = 0;
  hard.subject.muscles[1].max_force = 1e6;
  hard.subject.muscles[2].max_force = 1;
  expect_sound(hard);
}

INSTANTIATE_TEST_SUITE_P(Muscles, MotionStability,
                         testing::Values(Muscle::kBounds, Muscle::kRigidTendon,
                                         Muscle::kElasticTendon));

}  // namespace
}  // namespace thenar
