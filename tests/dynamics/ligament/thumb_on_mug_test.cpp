// The founding paper's figure 8: a thumb that meets a mug on its ulnar side stays there on pins,
// and rolls towards its pad where joints give [Miller2005]. By how much is told with its
// assumptions in docs/theory/compliant_joints.md; here stand the claim, its limit and its
// convergence.

#include "tests/dynamics/ligament/thumb_on_mug.h"

#include <gtest/gtest.h>

#include "base/units.h"

namespace thenar {
namespace {

using sample::ThumbOnMugOptions;
using sample::ThumbOnMugState;

std::vector<ThumbOnMugState> run(const ThumbOnMugOptions& options, double step = 5e-4) {
  sample::ThumbOnMug made = sample::thumb_on_mug(options);
  made.options.step_length = step;
  const SceneRun run = simulate_scene(made.scene, made.options);
  // Facets turn the normal without the gap, which makes some energy of nothing: the status tells.
  EXPECT_EQ(run.cost.unsolved, 0);
  return states_of(made, run);
}

/// Turn of the pad towards the mug, from the first contact to the last state [deg].
double turned(const std::vector<ThumbOnMugState>& states) {
  return (states.at(1).pad_angle - states.back().pad_angle) / kDegree;
}

// Moments of the muscles balance the force on pins: the thumb stays on its side, to a tenth of a
// degree.
TEST(ThumbOnMug, StaysOnItsSideOnPins) {
  ThumbOnMugOptions options;
  options.compliant = false;
  for (const ThumbOnMugState& state : run(options)) {
    EXPECT_LT(std::abs(state.roll), 0.1 * kDegree);
    if (state.force > 1) {
      EXPECT_NEAR(state.pad_angle, 69 * kDegree, 1 * kDegree);
    }
  }
}

// 30 N turn it by more than 10 deg about its bone, and its pad comes as much nearer to the mug; the
// more, the tighter the grip.
TEST(ThumbOnMug, RollsToItsPadWhereJointsGive) {
  const std::vector<ThumbOnMugState> states = run({});
  EXPECT_NEAR(states.back().force, 30, 0.5);
  EXPECT_GT(states.back().roll, 10 * kDegree);
  EXPECT_GT(turned(states), 10);
  const ThumbOnMugState& third = states.at(states.size() / 3);
  EXPECT_GT(third.roll, 4 * kDegree);
  EXPECT_GT(states.back().roll, third.roll + 3 * kDegree);
  // The metacarpal turns inwards with it.
  EXPECT_LT(states.back().moved.at("CMC1_AA/twist"), -4 * kDegree);
}

// A fourth of the compliance gives half of the turn or more; a thousandth of it, none.
TEST(ThumbOnMug, TendsToPins) {
  ThumbOnMugOptions options;
  options.stiffer = 4;
  EXPECT_GT(run(options).back().roll, 4 * kDegree);
  options.stiffer = 1000;
  EXPECT_LT(std::abs(run(options).back().roll), 0.1 * kDegree);
}

// Half the step, or half the pace, changes the turn by less than 5 %.
TEST(ThumbOnMug, DoesNotHangOnTheStepOrThePace) {
  const double roll = run({}).back().roll;
  EXPECT_NEAR(run({}, 2.5e-4).back().roll, roll, 0.05 * roll);
  ThumbOnMugOptions slow;
  slow.seconds = 6;
  EXPECT_NEAR(run(slow).back().roll, roll, 0.05 * roll);
}

}  // namespace
}  // namespace thenar
