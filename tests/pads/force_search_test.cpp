// Tests for pads/force_search.cpp: a made-up pad whose force is  k depth^(3/2).

#include "pads/force_search.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>

#include <gtest/gtest.h>

namespace thenar {
namespace {

constexpr double kPadStiffness = 3e4;  // [N/m^1.5]

/// A press in one number, x(0) the depth. A depth is solved within `reach` of the state's, a force
/// within `near` of the state's force.
struct PowerPad {
  double reach = 1;    // [m]
  double near = 0.05;  // [N]
  double deepest = 1;  // [m]
  bool stops = false;  // as soon as a force is asked
  double anchor = 7;   // of the past, which every trial must have [m]
  mutable int calls = 0;

  static double force_at(double depth) {
    return kPadStiffness * std::pow(std::max(depth, 0.0), 1.5);
  }
  PressOutcome operator()(const PressGoal& goal, PressState& state) const {
    ++calls;
    EXPECT_EQ(state.anchor(0, 0), anchor);
    PressOutcome out;
    out.iterations = 2;
    const double depth = -goal.X_PO.p[2];
    if (goal.force && stops) {
      out.status = Status::kStopped;
      return out;
    }
    const double wanted = goal.force ? std::pow(*goal.force / kPadStiffness, 2.0 / 3) : depth;
    const bool solved = goal.force ? std::abs(*goal.force - force_at(state.x[0])) <= near
                                   : std::abs(depth - state.x[0]) <= reach && depth <= deepest;
    if (!solved) {
      out.message = "too far";
      return out;
    }
    out.status = Status::kSolved;
    state.x[0] = wanted;
    state.anchor.setConstant(9);
    out.push.force = Eigen::Vector3d(0, 0, -force_at(wanted));
    return out;
  }
};

PressState at_touch(const PowerPad& pad) {
  PressState state;
  state.x = Eigen::VectorXd::Zero(1);
  state.anchor = Eigen::Matrix3Xd::Constant(3, 1, pad.anchor);
  return state;
}

PressGoal push_of(double force) {
  PressGoal goal;
  goal.force = force;
  return goal;
}

TEST(ForceSearch, ReachesAForceFarFromTouch) {
  const PowerPad pad;
  PressState state = at_touch(pad);
  const PressOutcome out = seek_force(std::cref(pad), push_of(2), 1e-4, state);
  ASSERT_EQ(out.status, Status::kSolved) << out.message;
  EXPECT_NEAR(state.x[0], std::pow(2 / kPadStiffness, 2.0 / 3), 1e-15);
  EXPECT_NEAR(out.push.force[2], -2, 1e-12);
  EXPECT_EQ(out.iterations, 2 * pad.calls);  // those of all trials
}

// Steps that are too long fail, and are halved.
TEST(ForceSearch, ShortensStepsThatFail) {
  PowerPad pad;
  pad.reach = 3e-5;
  PressState state = at_touch(pad);
  const PressOutcome out = seek_force(pad, push_of(0.1), 1e-4, state);
  ASSERT_EQ(out.status, Status::kSolved) << out.message;
  EXPECT_NEAR(PowerPad::force_at(state.x[0]), 0.1, 1e-12);
}

// From a depth whose force is larger, and at which nothing is solved, it goes back.
TEST(ForceSearch, GoesBackFromTooDeep) {
  PowerPad pad;
  pad.deepest = 4e-4;
  PressState state = at_touch(pad);
  PressGoal goal = push_of(0.03);
  goal.X_PO.p[2] = -6e-4;
  const PressOutcome out = seek_force(pad, goal, 1e-4, state);
  ASSERT_EQ(out.status, Status::kSolved) << out.message;
  EXPECT_NEAR(PowerPad::force_at(state.x[0]), 0.03, 1e-12);
}

// A pad that cannot be pressed beyond a depth: the force there is named, and the state kept.
TEST(ForceSearch, SaysBeyondWhichForceNothingIsSolved) {
  PowerPad pad;
  pad.deepest = 1e-3;
  PressState state = at_touch(pad);
  const PressOutcome out = seek_force(pad, push_of(2), 1e-4, state);
  EXPECT_EQ(out.status, Status::kStalled);
  // Depths come within the shortest way, a thousandth of the first, of 1 mm.
  double named = 0;
  ASSERT_EQ(std::sscanf(out.message.c_str(), "no solution beyond %lf N: too far", &named), 1)
      << out.message;
  EXPECT_NEAR(named, PowerPad::force_at(1e-3), 2e-3);
  EXPECT_EQ(state.x[0], 0);
  EXPECT_EQ(state.anchor(0, 0), pad.anchor);
}

TEST(ForceSearch, EndsAtOnceWhereItIsStopped) {
  PowerPad pad;
  pad.stops = true;
  PressState state = at_touch(pad);
  const PressOutcome out = seek_force(pad, push_of(0.5), 1e-4, state);
  EXPECT_EQ(out.status, Status::kStopped);
  EXPECT_EQ(state.x[0], 0);
}

}  // namespace
}  // namespace thenar
