// Presses as hard as those of a grip, and by plates that are thin beside the way into the pad.

#include <cmath>
#include <optional>
#include <tuple>

#include <gtest/gtest.h>

#include "geometry/primitives.h"
#include "pads/pad_press.h"
#include "tests/pads/tissue_samples.h"

namespace thenar {
namespace {

/// The pulp of `index_pad`, or that of `index_fitted`, whose stiffness grows a thousandfold.
Tissue pulp(TissueLaw law) {
  Tissue tissue = neo_hookean(12e3, 0.49);
  if (law == TissueLaw::kVerondaWestmann) tissue = neo_hookean(1650, 0.499);
  tissue.law = law;
  tissue.exponent = 3.12;
  return tissue;
}

/// A pad under a plate that touches it.
class PlatePress {
 public:
  PlatePress(TissueLaw law, double thickness, double friction, double error, int max_elements) {
    PadModel model;
    model.tissues = {pulp(law)};
    PadPressOptions options;
    options.force_error = error;
    options.max_elements = max_elements;
    Pose<double> X;
    X.p = {0, 0, model.shape.height + 1e-3 + thickness / 2};
    press_.emplace(model, RigidObject{build_box({0.2, 0.2, thickness}), friction}, X, options);
    (void)press_->touch({0, 0, -1});
    touch_ = press_->state().X_PO;
  }

  PadPressResult to_depth(double depth) {
    PressGoal goal;
    goal.X_PO = touch_;
    goal.X_PO.p[2] -= depth;
    return press_->step(goal);
  }
  PadPressResult to_force(double force) {
    PressGoal goal;
    goal.X_PO = press_->state().X_PO;
    goal.force = force;
    return press_->step(goal);
  }
  [[nodiscard]] double force() const { return -press_->state().push.force[2]; }

 private:
  std::optional<PadPress> press_;
  Pose<double> touch_;
};

using DeepCase = std::tuple<TissueLaw, double>;
class DeepPress : public testing::TestWithParam<DeepCase> {};

TEST_P(DeepPress, ReachesTheForceOfAGrip) {
  const auto [law, friction] = GetParam();
  PlatePress press(law, 0.2, friction, 0.1, 20000);
  for (const double force : {0.05, 0.2, 0.5, 1.0, 2.0, 3.5, 5.0, 7.5, 10.0}) {
    const PadPressResult result = press.to_force(force);
    ASSERT_EQ(result.solved.status, Status::kSolved) << force << ' ' << result.solved.message;
    EXPECT_NEAR(press.force(), force, 1e-6);
    EXPECT_LE(result.force_error, 0.1);
  }
}

INSTANTIATE_TEST_SUITE_P(All, DeepPress,
                         testing::Combine(testing::Values(TissueLaw::kNeoHookean,
                                                          TissueLaw::kVerondaWestmann),
                                          testing::Values(0.0, 0.6)));

TEST(ThinPlate, PressesAsAThickOne) {
  // All skin that touches is on the face that faces it: what lies behind makes no difference, but
  // for friction on a way that was cut, where a step first came out on the far side.
  for (const double friction : {0.0, 0.6}) {
    PlatePress thick(TissueLaw::kNeoHookean, 0.2, friction, 0.1, 20000);
    PlatePress thin(TissueLaw::kNeoHookean, 1e-3, friction, 0.1, 20000);
    for (const double depth : {0.5e-3, 1e-3, 1.5e-3, 2e-3}) {
      ASSERT_EQ(thick.to_depth(depth).solved.status, Status::kSolved);
      ASSERT_EQ(thin.to_depth(depth).solved.status, Status::kSolved);
      EXPECT_NEAR(thin.force() / thick.force(), 1, friction > 0 ? 0.01 : 1e-6)
          << depth << ' ' << friction;
    }
  }
}

TEST(ThinPlate, GivesBackItsWorkWithoutFriction) {
  PlatePress press(TissueLaw::kNeoHookean, 2e-3, 0, 1, 1);
  constexpr int kSteps = 10;
  constexpr double kDepth = 1.5e-3;
  double work = 0, most = 0, before = 0;
  for (int k = 1; k <= 2 * kSteps; ++k) {
    const double depth = kDepth * (k <= kSteps ? k : 2 * kSteps - k) / kSteps;
    const PadPressResult result = press.to_depth(depth);
    ASSERT_EQ(result.solved.status, Status::kSolved) << depth << ' ' << result.solved.message;
    work += 0.5 * (before + press.force()) * kDepth / kSteps * (k <= kSteps ? 1 : -1);
    before = press.force();
    most = std::max(most, work);
  }
  EXPECT_LT(std::abs(work), 0.01 * most);
}

TEST(ErrorEstimate, IsOfTheTangentOfPulpThatStiffens) {
  // Against a mesh of half the error; by the modulus at rest it was 50 times too large.
  PlatePress rough(TissueLaw::kVerondaWestmann, 0.2, 0, 0.2, 20000);
  PlatePress fine(TissueLaw::kVerondaWestmann, 0.2, 0, 0.03, 20000);
  double estimate = 0;
  for (const double depth : {0.8e-3, 1.6e-3, 2.4e-3}) {
    const PadPressResult result = rough.to_depth(depth);
    ASSERT_EQ(result.solved.status, Status::kSolved);
    ASSERT_EQ(fine.to_depth(depth).solved.status, Status::kSolved);
    estimate = result.force_error;
  }
  const double error = std::abs(rough.force() / fine.force() - 1);
  EXPECT_LT(error, 2 * estimate);
  EXPECT_GT(error, estimate / 10);
}

}  // namespace
}  // namespace thenar
