// A ball pressed on a half space and pushed sideways: partial slip by Cattaneo and Mindlin.

#include <cmath>

#include <gtest/gtest.h>

#include "geometry/primitives.h"
#include "tests/pads/tissue_samples.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

/// Nearly incompressible, so that forces across and along the surface do not tell of each other.
/// The block ends at 100 patch radii; cells are a fifth of the radius under the patch.
struct PartialSlip {
  static constexpr double kBall = 0.01, kDepth = 1e-4, kRadius = 1e-3;  // [m]; a^2 = R d
  static constexpr double kModulus = 12e3, kFriction = 0.5, kNu = 0.499;

  static HexMesh mesh() {
    HexMesh out =
        graded_box(even_axis(-0.1, 0.1, 4), even_axis(-0.1, 0.1, 4), even_axis(-0.1, 0, 2));
    refine_where(out, 8, [](const Vector3d& low, const Vector3d& high) {
      const double away = Vector3d::Zero().cwiseMax(low).cwiseMin(high).norm();
      return away < std::max(1.3 * kRadius, 2.5 * (high - low)[0]);
    });
    return out;
  }
  /// Share of a Hertzian force, of a patch of radius 1, within a radius.
  static double within(double radius) { return 1 - std::pow(1 - radius * radius, 1.5); }
};

TEST(PartialSlip, IsThatOfCattaneoAndMindlin) {
  using P = PartialSlip;
  TissueBlock block(P::mesh(), {neo_hookean(P::kModulus, P::kNu)});
  RigidObject ball{build_sphere(P::kBall), 0};
  PressGoal goal;
  goal.X_PO.p = {0, 0, P::kBall};
  PressState state = block.at_rest(goal.X_PO);
  goal.X_PO.p[2] -= P::kDepth;
  PressOutcome out = block.press(ball, goal, state);
  ASSERT_EQ(out.status, Status::kSolved) << out.message;
  const double normal = -out.push.force[2];
  // Sideways until the stick zone should have 0.8 of the patch's radius: Q = mu P (1 - 0.8^3),
  // d = 3 mu P (2 - nu) / (16 G a) (1 - 0.8^2) [Johnson1985] eqs 7.40 and 7.42.
  ball.friction = P::kFriction;
  constexpr double kStick = 0.8;
  goal.X_PO.p[0] += 3 * P::kFriction * normal * (2 - P::kNu) / (16 * P::kModulus * P::kRadius) *
                    (1 - kStick * kStick);
  out = block.press(ball, goal, state);
  ASSERT_EQ(out.status, Status::kSolved) << out.message;
  // Forces of friction end with a jump of their slope, which cells of a / 5 round off: an error of
  // their first order, 3 %, and half as much where they are half as large.
  const double bound = P::kFriction * normal, expected = bound * (1 - std::pow(kStick, 3));
  EXPECT_NEAR(out.push.force[0] / expected, 1, 0.04);
  EXPECT_NEAR(-out.push.force[2] / normal, 1, 0.001);
  // Friction is mu p less mu (c / a) p of a patch of radius c: what it is within 0.4 a, over its
  // bound there, at the c of the force that came out.
  const double c = std::cbrt(1 - out.push.force[0] / bound);
  constexpr double kMiddle = 0.4;
  double friction = 0, most = 0;
  for (std::size_t k = 0; k < block.surface.nodes.size(); ++k) {
    const auto column = static_cast<Eigen::Index>(k);
    if (block.surface.rest_positions.col(column).head<2>().norm() > kMiddle * P::kRadius) continue;
    friction += state.friction_force(0, column);
    most += P::kFriction * state.normal_force[column];
  }
  const double in_stick = c * c * c * P::within(kMiddle / c) / P::within(kMiddle);
  EXPECT_NEAR(friction / most, 1 - in_stick, 0.01);
}

}  // namespace
}  // namespace thenar
