// Tests for the limit ellipsoid of soft contacts, against the exact limit surface.

#include "tests/pad_laws/limit_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/units.h"

namespace thenar {
namespace {

constexpr PatchPressure kPressures[] = {PatchPressure::kUniform, PatchPressure::kHertz,
                                        PatchPressure::kParaboloid};
constexpr double kMu = 0.6, kSums = 1e-4;  // error of the midpoint sums

// Around a point of its rim, in polar coordinates from there: f = 8 / (3 pi), torque about that
// point 32 a / (9 pi), of a uniform disc.
TEST(LimitSurface, OfADiscThatTurnsAboutItsRim) {
  constexpr double kA = 0.005, kF = 8 / (3 * kPi);
  const PatchFriction slip = slip_friction(kA, kA, PatchPressure::kUniform, 1, {kA, 0});
  EXPECT_NEAR(slip.f.y(), -kF, kSums);
  EXPECT_NEAR(slip.f.x(), 0, 1e-12);
  EXPECT_NEAR(slip.torque / kA, 32 / (9 * kPi) - kF, kSums);
}

TEST(LimitSurface, EndsAtPureSlidingAndPureTwist) {
  constexpr double kA = 0.006, kB = 0.002;
  for (const PatchPressure pressure : kPressures) {
    const PatchFriction slide = slip_friction(kA, kB, pressure, kMu, {1e4 * kA, 0});
    EXPECT_NEAR(slide.f.norm(), kMu, kSums);
    EXPECT_NEAR(slide.torque / kA, 0, kSums);
    const PatchFriction twist = slip_friction(kA, kB, pressure, kMu, {0, 0});
    EXPECT_NEAR(twist.torque, patch_torsion(kA, kB, pressure, kMu), kSums * kA);
    EXPECT_NEAR(twist.f.norm(), 0, 1e-12);
  }
}

/// Power of a friction while the patch turns at 1 rad/s about a centre, per normal force [m/s].
double power(const PatchFriction& load, const Eigen::Vector2d& centre) {
  const Eigen::Vector2d v(centre.y(), -centre.x());  // of the patch's centre
  return load.f.dot(v) + load.torque;
}

// Friction takes the most power it can: no other point of the limit surface takes more.
TEST(LimitSurface, DissipatesMost) {
  std::vector<Eigen::Vector2d> centres;
  for (const double x : {0.0, 0.001, 0.004, 0.02})
    for (const double y : {-0.003, 0.0, 0.002}) centres.emplace_back(x, y);
  for (const Eigen::Vector2d& own : centres) {
    const double most =
        power(slip_friction(0.006, 0.003, PatchPressure::kParaboloid, kMu, own), own);
    for (const Eigen::Vector2d& other : centres)
      EXPECT_LE(power(slip_friction(0.006, 0.003, PatchPressure::kParaboloid, kMu, other), own),
                most * (1 + 1e-12));
  }
}

struct FrictionRange {
  double least, most;
};

/// How far the ellipsoid is off the patches that slip, over all ways to turn.
FrictionRange ellipsoid_range(double ratio, PatchPressure pressure) {
  FrictionRange range{2, 0};
  const double torsion = patch_torsion(1, ratio, pressure, kMu);
  for (const double heading : {0.0, kPi / 4, kPi / 2})
    for (int i = 0; i <= 12; ++i) {
      const double way = std::pow(10, -2 + i / 3.0);
      const Eigen::Vector2d centre(way * std::cos(heading), way * std::sin(heading));
      const double value =
          limit_ellipsoid(slip_friction(1, ratio, pressure, kMu, centre), kMu, torsion);
      range = {std::min(range.least, value), std::max(range.most, value)};
    }
  return range;
}

// What docs/theory/grasp_contact.md says of it.
TEST(LimitSurface, EllipsoidPromisesLittleTooMuch) {
  for (const PatchPressure pressure : kPressures) {
    const FrictionRange disc = ellipsoid_range(1, pressure);
    EXPECT_GT(disc.least, 0.93);
    EXPECT_LT(disc.most, 1 + kSums);
    const FrictionRange oblong = ellipsoid_range(0.2, pressure);
    EXPECT_GT(oblong.least, 0.88);
    EXPECT_LT(oblong.most, 1.04);
  }
}

TEST(LimitSurface, EllipsoidAddsSharesAsSquares) {
  EXPECT_NEAR(limit_ellipsoid({{0.3, 0.4}, 0}, 0.5, 0.002), 1, 1e-15);
  EXPECT_NEAR(limit_ellipsoid({{0.3, 0}, 0.0008}, 0.5, 0.001), 1, 1e-15);  // 0.6, 0.8
  EXPECT_EQ(limit_ellipsoid({{0, 0}, 0}, 0, 0), 0);
  EXPECT_EQ(limit_ellipsoid({{0, 0}, 1e-6}, 0.5, 0), std::numeric_limits<double>::infinity());
}

TEST(LimitSurface, RejectsImpossiblePatches) {
  EXPECT_THROW((void)slip_friction(0, 1, PatchPressure::kHertz, 1, {0, 0}), InputError);
  EXPECT_THROW((void)slip_friction(1, 1, PatchPressure::kHertz, -1, {0, 0}), InputError);
  EXPECT_THROW((void)limit_ellipsoid({}, -1, 0), InputError);
}

}  // namespace
}  // namespace thenar
