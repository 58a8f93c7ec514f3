// Presses that are hard: each ends solved, within its laws, or with a status and as it began.

#include <cmath>
#include <cstdlib>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "geometry/primitives.h"
#include "tests/pads/stability_trials.h"
#include "tests/pads/tissue_samples.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

/// What holds of every trial.
void expect_sound(const StabilityTrial& trial, const PressReport& report) {
  SCOPED_TRACE(trial.name + ": " + report.message);
  EXPECT_TRUE(report.finite);
  EXPECT_TRUE(report.told);
  EXPECT_TRUE(report.intact);
  EXPECT_LE(report.unbalanced, 1e-6);
  EXPECT_LE(report.beyond_cone, 1e-9);
  EXPECT_GE(report.pulls, 0);
  // Friction is against the slip of each step, to the tolerances of both.
  EXPECT_LE(report.drives, 1e-6);
  // On one mesh all the way all is given back without friction. Blades, edges and pins may stand on
  // either side of a node, and need not come back on the side where they were.
  const bool wide = trial.name.compare(0, 4, "wall") == 0 ||
                    trial.name.compare(0, 4, "ball") == 0 ||
                    trial.name.compare(0, 5, "pearl") == 0 ||
                    trial.name.compare(0, 3, "rod") == 0 || trial.name.compare(0, 4, "mesh") == 0;
  if (trial.back && report.failed == 0 && trial.max_elements == 1) {
    if (trial.object.friction == 0 && wide) {
      EXPECT_LE(std::abs(report.work), 1e-6 * report.most_work);
    }
    EXPECT_LE(report.left, 1e-8);
  }
}

/// A plain press without friction by an object.
StabilityTrial plain_trial(const std::string& name, double poisson_ratio) {
  const TrialObject object = trial_object(name);
  StabilityTrial trial;
  trial.name = name;
  trial.model = trial_pad(poisson_ratio);
  trial.object = {object.shape, 0};
  trial.R = object.R;
  return trial;
}

// Four by default; THENAR_PRESSES=300 for all that ./run long does.
TEST(PressStability, AnyPressEndsSoundly) {
  const char* all = std::getenv("THENAR_PRESSES");
  const int trials = all != nullptr ? std::stoi(all) : 4;
  ASSERT_GE(trials, 1) << "THENAR_PRESSES=" << all;
  std::mt19937 random(1);
  for (int k = 0; k < trials; ++k) {
    const StabilityTrial trial = random_trial(random);
    expect_sound(trial, run_trial(trial));
  }
}

TEST(PressStability, WallsReachSixtyPercentInOneStep) {
  for (const double nu : {0.45, 0.49, 0.499, 0.49999}) {
    StabilityTrial trial = plain_trial("wall", nu);
    trial.depth = 0.6 * 5.5e-3;
    const PressReport report = run_trial(trial);
    expect_sound(trial, report);
    EXPECT_EQ(report.failed, 0) << nu << ' ' << report.message;
  }
}

TEST(PressStability, AllIsGivenBackWithoutFriction) {
  for (const char* name : {"wall", "ball", "rod"}) {
    StabilityTrial trial = plain_trial(name, 0.49);
    trial.depth = 2e-3;
    trial.steps = 3;
    trial.back = true;
    const PressReport report = run_trial(trial);
    expect_sound(trial, report);
    EXPECT_EQ(report.failed, 0) << name << ' ' << report.message;
    EXPECT_GT(report.most_work, 0);
  }
}

TEST(PressStability, ThePushIsTheSlopeOfTheEnergy) {
  const StabilityTrial trial = plain_trial("wall", 0.49);
  PadPressOptions options;
  options.max_elements = 1;
  PadPress press(trial.model, trial.object, {trial.R, {5e-4, -1.5e-3, 0.1}}, options);
  (void)press.touch(trial.along);
  PressGoal goal;
  goal.X_PO = press.state().X_PO;
  const double touch = goal.X_PO.p[2];
  const auto energy = [&](double depth) {
    goal.X_PO.p[2] = touch - depth;
    EXPECT_EQ(press.step(goal).solved.status, Status::kSolved);
    TissueResponse at;
    press.body().evaluate(press.body().node_displacements(press.state().x, {}), 0, {}, {},
                          ElementRequest::kEnergy, at);
    return at.energy;
  };
  constexpr double kDepth = 1e-3, kStep = 1e-6;
  const double slope = (energy(kDepth + kStep) - energy(kDepth - kStep)) / (2 * kStep);
  (void)energy(kDepth);
  // Differences of second order, 1e-6 of the depth's square.
  EXPECT_NEAR(slope / -press.state().push.force[2], 1, 1e-5);
}

TEST(PressStability, FrictionTakesWork) {
  StabilityTrial trial = plain_trial("ball", 0.49);
  trial.object.friction = 0.3;
  trial.sideways = {3e-3, 0, 0};
  trial.steps_sideways = 10;
  trial.back = true;
  const PressReport report = run_trial(trial);
  expect_sound(trial, report);
  EXPECT_EQ(report.failed, 0) << report.message;
  EXPECT_GT(report.work, 0.1 * report.most_work);
}

TEST(PressStability, SlidesAtAnyFriction) {
  for (const char* name : {"wall", "ball", "rod"})
    for (const double friction : {0.3, 0.6, 1.0, 1.5}) {
      StabilityTrial trial = plain_trial(name, 0.49);
      trial.object.friction = friction;
      trial.depth = 1.5e-3;
      trial.steps = 15;
      trial.sideways = {3e-3, 0, 0};
      trial.steps_sideways = 30;
      const PressReport report = run_trial(trial);
      expect_sound(trial, report);
      // No step was cut: those that are take 30 iterations and more.
      EXPECT_EQ(report.failed, 0) << name << " " << friction << " " << report.message;
      EXPECT_LT(report.iterations, 15 * report.solved) << name << " " << friction;
    }
}

TEST(PressStability, ThroughTheBoneEndsWithAStatus) {
  for (const char* name : {"wall", "ball", "blade"}) {
    StabilityTrial trial = plain_trial(name, 0.49);
    trial.depth = 7e-3;  // more than there is
    const PressReport report = run_trial(trial);
    expect_sound(trial, report);
    EXPECT_EQ(report.failed, 1) << name;
  }
}

// A pearl that one step puts under the skin meets no node and no face, and pulls as it comes out.
TEST(PressStability, APearlDoesNotPassThroughSkin) {
  StabilityTrial trial = plain_trial("pearl", 0.49);
  trial.depth = 3e-3;
  const PressReport report = run_trial(trial);
  expect_sound(trial, report);
  EXPECT_EQ(report.failed, 1);
  EXPECT_NE(report.message.find("inside the tissue"), std::string::npos) << report.message;
}

// As a small ball does that goes the same way in small steps.
TEST(PressStability, APearlGivesBackItsWork) {
  StabilityTrial trial = plain_trial("pearl", 0.49);
  trial.depth = 1e-3;
  trial.steps = 10;
  trial.sideways = {1e-3, 0, 0};
  trial.steps_sideways = 10;
  trial.back = true;
  const PressReport report = run_trial(trial);
  expect_sound(trial, report);
  EXPECT_EQ(report.failed, 0) << report.message;
  EXPECT_LE(std::abs(report.work), 1e-6 * report.most_work);
}

TEST(PressStability, ATissueThatBeginsInsideOutIsTold) {
  TissueBlock block(graded_box(even_axis(-1, 1, 2), even_axis(-1, 1, 2), even_axis(-1, 0, 2)),
                    {neo_hookean(12e3, 0.49)});
  PressGoal goal;
  goal.X_PO.p = {0, 0, 1};
  PressState state = block.at_rest(goal.X_PO);
  // Every node beyond its neighbours.
  for (Eigen::Index i = 0; i < state.x.size() / 3; ++i)
    state.x.segment<3>(3 * i) =
        -3 * block.mesh.place(block.body->free_nodes()[static_cast<std::size_t>(i)]) -
        Vector3d(0, 0, 4);
  const Eigen::VectorXd before = state.x;
  goal.X_PO.p[2] -= 0.1;
  const PressOutcome out = block.press({build_sphere(1), 0.5}, goal, state);
  EXPECT_NE(out.status, Status::kSolved);
  EXPECT_FALSE(out.message.empty());
  EXPECT_EQ((state.x - before).norm(), 0);
}

}  // namespace
}  // namespace thenar
