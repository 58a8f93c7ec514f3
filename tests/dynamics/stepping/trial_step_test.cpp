// Tests for dynamics/stepping/trial_step.cpp and step_control.cpp: a ball that falls on a floor,
// and a cube that stands on it.

#include "dynamics/stepping/trial_step.h"

#include <cmath>

#include <gtest/gtest.h>

#include "dynamics/stepping/step_control.h"
#include "tests/dynamics/stepping/sample_scenes.h"

namespace thenar {
namespace {

constexpr double kDrop = 2e-3;  // of a ball above the floor [m]

MovingScene falling_ball() {
  MovingScene scene;
  Pose<double> X;
  X.p.z() = -0.05;
  (void)sample::add_body(scene, "floor", sample::primitive(ShapeKind::kBox, {1, 1, 0.1}), 0, X);
  X.p.z() = 0.01 + kDrop;
  (void)sample::add_body(scene, "ball", sample::primitive(ShapeKind::kSphere, {0.01, 0, 0}), 0.1,
                         X);
  return scene;
}

/// Trials from the start of a scene.
struct FromStart {
  explicit FromStart(const MovingScene& scene)
      : step(scene),
        state(step.initial_state()),
        counts(cost),
        trials(step, options, counts, state) {}
  StepTrial& attempt(double length) {
    trials.try_step({state, closed, 0}, length);
    return trials.result();
  }
  SceneOptions options;
  SceneCost cost;
  ContactStep step;
  SceneState state;
  ProblemCounts counts;
  StepTrials trials;
  std::vector<ActiveContact> closed;
};

// A parabola until it touches, after sqrt(2 drop / g).
TEST(StepTrials, OfAFreeFallAreExactUpToTheFloor) {
  FromStart from(falling_ball());
  const double lands = std::sqrt(2 * kDrop / sample::kG);
  const double before = 0.9 * lands;
  const StepTrial& free = from.attempt(before);
  EXPECT_TRUE(free.is_smooth);
  EXPECT_LT(free.closing_time, 0);
  EXPECT_LE(free.error, 1);
  EXPECT_EQ(free.order, 8);
  EXPECT_NEAR(free.state.v.tail<1>()[0], -sample::kG * before, 1e-12);
  // Beyond it the trial tells about when, by the speed at its end.
  const StepTrial& through = from.attempt(1.05 * lands);
  EXPECT_NEAR(through.closing_time, lands, 0.03 * lands);
}

TEST(StepTrials, CountTheirProblemsForTheRunOnceTheyAreAccepted) {
  FromStart from(falling_ball());
  from.counts.count_free_step(false);
  EXPECT_EQ(from.counts.unsolved(), 1);
  EXPECT_EQ(from.cost.unsolved, 0);
  from.counts.accept();
  EXPECT_EQ(from.cost.unsolved, 1);
  EXPECT_EQ(from.counts.unsolved(), 0);
  (void)from.attempt(1e-3);
  EXPECT_EQ(from.cost.substeps, static_cast<long>(FreeStep::kStages));
}

TEST(StepControl, EndsAStepWhereAGapCloses) {
  FromStart from(falling_ball());
  StepControl control(from.options);
  const double lands = std::sqrt(2 * kDrop / sample::kG);
  double length = control.first_trial_length(0, 1.05 * lands);
  EXPECT_EQ(length, 1.05 * lands);
  const double closes = from.attempt(length).closing_time;
  length = control.shorten_after_rejection(from.trials, 0, length);
  EXPECT_EQ(length, closes);
  // After a rejection the next step is no longer.
  (void)from.attempt(0.5 * length);
  EXPECT_LE(control.next_step_length(from.trials, 0.5 * length), 0.5 * length);
}

TEST(StepControl, LengthensFreeStepsByTheirErrors) {
  FromStart from(falling_ball());
  StepControl control(from.options);
  double length = control.first_trial_length(0, 1e-3);
  (void)from.attempt(length);
  // A parabola has no error at all.
  EXPECT_GT(control.next_step_length(from.trials, length), 2 * length);
  EXPECT_EQ(control.max_length(), from.options.max_step);
  control.set_max_length(true);
  EXPECT_EQ(control.max_length(), 5 * from.options.max_step);
}

TEST(StepControl, ShortensByTheRootOfADoubt) {
  const SceneOptions options;
  StepControl control(options);
  EXPECT_NEAR(control.shorten_for_elements(4, 1e-3), 0.45e-3, 1e-18);
  EXPECT_NEAR(control.shorten_for_elements(1e6, 1e-3), 0.2e-3, 1e-18);
  EXPECT_EQ(control.shorten_for_elements(1e6, options.min_step), options.min_step);
}

}  // namespace
}  // namespace thenar
