// Tests for tendons/forces/pinch_statics.cpp.

#include "tendons/forces/pinch_statics.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "tendons/forces/max_tip_load.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr int kWrist = 0;

/// Wrist and digit: two hinges about z, 60 mm apart along x, the tip 40 mm on. A flexor of 100 N
/// runs over both at 10 mm, an extensor of the wrist alone at 15 mm.
TipStatics wrist_and_digit(double extensor_N) {
  TipStatics statics;
  statics.J.resize(3, 2);
  statics.J << 0, 0, 0.1, 0.04, 0, 0;
  statics.W.resize(3, 2);
  statics.W << 0, 0, 0, 0, 1, 1;
  statics.R.resize(2, 2);
  statics.R << 0.01, 0.01, -0.015, 0;
  statics.tau_0 = VectorXd::Zero(2);
  statics.max_tension = Eigen::Vector2d(100, extensor_N);
  return statics;
}

double pinch_of(const TipStatics& statics, const std::vector<JointStop>& stops = {}) {
  TipLoadOptions options;
  options.stops = stops;
  return max_tip_load(without_load_on(statics, {kWrist}), {0, 1, 0}, options).largest.component;
}

// By hand: the flexor pulls with as much as the wrist's extensor holds, 15 mm x 40 N / 10 mm = 60
// N, and 60 N x 10 mm / 40 mm are 15 N at the tip; at most its 100 N, 25 N.
TEST(PinchStatics, WristHoldsWhatIsPulledAcrossIt) {
  EXPECT_NEAR(pinch_of(wrist_and_digit(40)), 15, 1e-9);
  EXPECT_NEAR(pinch_of(wrist_and_digit(1000)), 25, 1e-9);
  EXPECT_NEAR(pinch_of(wrist_and_digit(0)), 0, 1e-9);
}

// A wrist that hangs at the end of its flexion: ligaments of 0.2 N m hold 20 N of the flexor, 5 N
// at the tip. They do not flex it.
TEST(PinchStatics, LigamentsHoldADroppedWrist) {
  EXPECT_NEAR(pinch_of(wrist_and_digit(0), {{kWrist, -0.2}}), 5, 1e-9);
  EXPECT_NEAR(pinch_of(wrist_and_digit(0), {{kWrist, 0.2}}), 0, 1e-9);
}

// The load alone goes: tendons, and the digit's own joints, stay.
TEST(PinchStatics, TakesOffTheLoadAlone) {
  const TipStatics whole = wrist_and_digit(40), pinch = without_load_on(whole, {kWrist});
  EXPECT_TRUE(pinch.J.col(0).isZero(0) && pinch.W.col(0).isZero(0));
  EXPECT_EQ(pinch.J.col(1), whole.J.col(1));
  EXPECT_EQ(pinch.W.col(1), whole.W.col(1));
  EXPECT_EQ(pinch.R, whole.R);
  EXPECT_THROW((void)without_load_on(whole, {2}), InputError);
}

}  // namespace
}  // namespace thenar
