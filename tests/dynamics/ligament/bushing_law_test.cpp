// Tests for dynamics/ligament/bushing_law.cpp: efforts as slopes of the energy, poses and back.

#include "dynamics/ligament/bushing_law.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "base/error.h"
#include "tests/matrix_near.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kSlopeStep = 1e-6;  // of differences [m], [rad]

/// Laws of all coordinates with toe regions; twist and `along` have a ratio to flexion.
BushingLaw curved_law() {
  BushingLaw law;
  for (std::size_t i = 0; i < law.laws.size(); ++i) {
    law.laws[i].stiffness = 2 + static_cast<double>(i);
    law.laws[i].toe = 0.3;
    law.laws[i].damping = 0.1 * static_cast<double>(i);
  }
  law.flexion_ratios[static_cast<std::size_t>(BushingCoordinate::kTwist)] = 0.4;
  law.flexion_ratios[static_cast<std::size_t>(BushingCoordinate::kAlong)] = -0.2;
  return law;
}

BushingVector sample_place() {
  BushingVector x;
  x << 0.1, -0.2, 0.05, 0.5, -0.3, 0.15;
  return x;
}

TEST(BushingLaw, EffortsAreSlopesOfTheEnergy) {
  const BushingLaw law = curved_law();
  const BushingVector x = sample_place(), still = BushingVector::Zero();
  const BushingAction at = bushing_action(law, x, still);
  for (int i = 0; i < kBushingCoordinates; ++i) {
    const BushingVector way = kSlopeStep * BushingVector::Unit(i);
    const BushingAction more = bushing_action(law, x + way, still),
                        less = bushing_action(law, x - way, still);
    EXPECT_NEAR(at.effort[i], -(more.energy - less.energy) / (2 * kSlopeStep), 1e-8) << i;
    EXPECT_TRUE(
        matrix_near(at.stiffness.col(i), (less.effort - more.effort) / (2 * kSlopeStep), 1e-7))
        << i;
  }
}

// Damping never gives power, and adds to the effort in proportion to the rate.
TEST(BushingLaw, DampingTakesPower) {
  const BushingLaw law = curved_law();
  std::mt19937 rng(1);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 50; ++trial) {
    const BushingVector rate = BushingVector::NullaryExpr([&] { return normal(rng); });
    const BushingAction at = bushing_action(law, sample_place(), rate),
                        still = bushing_action(law, sample_place(), BushingVector::Zero());
    EXPECT_TRUE(matrix_near(at.effort - still.effort, -at.damping * rate, 1e-12));
    EXPECT_LE(rate.dot(at.effort - still.effort), 0);
    EXPECT_EQ(at.energy, still.energy);
  }
}

// A twist that goes along with flexion as the law says meets no resistance.
TEST(BushingLaw, FollowsFlexionFreely) {
  BushingLaw law;
  law.law_for(BushingCoordinate::kTwist).stiffness = 5;
  law.flexion_ratios[static_cast<std::size_t>(BushingCoordinate::kTwist)] = 0.4;
  BushingVector x = BushingVector::Zero();
  x[static_cast<int>(BushingCoordinate::kFlexion)] = 0.5;
  x[static_cast<int>(BushingCoordinate::kTwist)] = 0.2;
  EXPECT_LT(bushing_action(law, x, BushingVector::Zero()).effort.norm(), 1e-15);
  x[static_cast<int>(BushingCoordinate::kTwist)] = 0;  // held back: flexion feels 0.4 of the torque
  const BushingAction held = bushing_action(law, x, BushingVector::Zero());
  EXPECT_NEAR(held.effort[static_cast<int>(BushingCoordinate::kTwist)], 5 * 0.2, 1e-14);
  EXPECT_NEAR(held.effort[static_cast<int>(BushingCoordinate::kFlexion)], -0.4 * 5 * 0.2, 1e-14);
}

Matrix3d turned(double flexion, double abduction, double twist) {
  return (AngleAxisd(flexion, Vector3d::UnitZ()) * AngleAxisd(abduction, Vector3d::UnitX()) *
          AngleAxisd(twist, Vector3d::UnitY()))
      .toRotationMatrix();
}

// R = Rz(flexion) Rx(abduction) Ry(twist) and back, and rates by a small turn of the distal body.
TEST(BushingLaw, FindsTheAnglesOfAPose) {
  std::mt19937 rng(2);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int trial = 0; trial < 100; ++trial) {
    const Vector3d angles(3 * unit(rng), kMaxAbduction * unit(rng), 3 * unit(rng));
    const Pose<double> X{turned(angles[0], angles[1], angles[2]), Vector3d(1, 2, 3)};
    const BushingPose at = bushing_pose(X);
    EXPECT_TRUE(matrix_near(at.x.head<3>(), X.p, 0));
    EXPECT_TRUE(matrix_near(at.x.tail<3>(), angles, 1e-12));
    const Vector3d omega(unit(rng), unit(rng), unit(rng));
    const auto after = [&](double time) {
      const Matrix3d turn = AngleAxisd(time * omega.norm(), omega.normalized()).toRotationMatrix();
      return Vector3d(bushing_pose({turn * X.R, X.p}).x.tail<3>());
    };
    if (std::abs(angles[0]) > 2.9 || std::abs(angles[2]) > 2.9) continue;  // near the jump by 2 pi
    const Vector3d rates = (after(kSlopeStep) - after(-kSlopeStep)) / (2 * kSlopeStep);
    EXPECT_TRUE(matrix_near(at.rate_map * omega, rates, 1e-6 * (1 + rates.norm())));
  }
}

TEST(BushingLaw, RefusesAFlexionThatFollowsItself) {
  BushingLaw law = curved_law();
  EXPECT_NO_THROW(check_law(law));
  law.flexion_ratios[static_cast<std::size_t>(BushingCoordinate::kFlexion)] = 0.1;
  EXPECT_EQ(message_of([&] { check_law(law); }), "bushing: flexion cannot follow itself");
  law = curved_law();
  law.flexion_ratios[0] = std::nan("");
  EXPECT_EQ(message_of([&] { check_law(law); }), "bushing: wanted finite numbers, got nan");
}

}  // namespace
}  // namespace thenar
