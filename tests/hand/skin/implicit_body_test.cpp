// Tests for hand/skin/implicit_body.cpp.

#include "hand/skin/implicit_body.h"

#include <gtest/gtest.h>

#include "tests/hand/sample_subjects.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

constexpr double kRounding = 1e-14;  // [m]

Lump capsule(const Vector3d& a, const Vector3d& b, double ra, double rb) {
  Lump lump;
  lump.core = {a, b, b};
  lump.radius = {ra, rb};
  return lump;
}

TEST(ImplicitBody, IsExactForCapsules) {
  const ImplicitBody body{capsule({0, 0, 0}, {0.04, 0, 0}, 0.01, 0.01)};
  EXPECT_NEAR(implicit_height(body, {0.02, 0.03, 0}), 0.02, kRounding);
  EXPECT_NEAR(implicit_height(body, {0.02, 0, 0}), -0.01, kRounding);
  EXPECT_NEAR(implicit_height(body, {-0.03, 0.04, 0}), 0.04, kRounding);
}

// Hull of two balls: its flank leans by asin((ra - rb) / length) = asin(0.6).
TEST(ImplicitBody, IsExactForTaperedCapsules) {
  const ImplicitBody body{capsule({0, 0, 0}, {0.01, 0, 0}, 0.008, 0.002)};
  const Vector3d normal(0.6, 0.8, 0), foot = 0.008 * normal + 0.004 * Vector3d(0.8, -0.6, 0);
  EXPECT_NEAR(implicit_height(body, foot), 0, kRounding);
  EXPECT_NEAR(implicit_height(body, foot + 0.005 * normal), 0.005, kRounding);
  EXPECT_NEAR(implicit_height(body, foot - 0.001 * normal), -0.001, kRounding);
}

TEST(ImplicitBody, PressesSectionsToEllipsesOfTheSameArea) {
  Lump lump = capsule({0, 0, 0}, {0.1, 0, 0}, 0.01, 0.01);
  lump.flat = Vector3d::UnitZ();
  lump.aspect = 1.44;
  EXPECT_NEAR(implicit_height({lump}, {0.05, 0.012, 0}), 0, kRounding);
  EXPECT_NEAR(implicit_height({lump}, {0.05, 0, 0.01 / 1.2}), 0, kRounding);
}

TEST(ImplicitBody, ThickensTriangles) {
  Lump lump;
  lump.core = {Vector3d(0, 0, 0), Vector3d(0.03, 0, 0), Vector3d(0, 0.03, 0)};
  lump.radius = {0.004, 0};
  lump.sheet = true;
  EXPECT_NEAR(implicit_height({lump}, {0.005, 0.005, 0.01}), 0.006, kRounding);
  EXPECT_NEAR(implicit_height({lump}, {0.01, -0.005, 0}), 0.001, kRounding);
  EXPECT_NEAR(implicit_height({lump}, {0.03 + 0.003, -0.004, 0}), 0.001, kRounding);
}

// Where two are equally near, the blend adds a quarter of itself.
TEST(ImplicitBody, BlendsByAQuarterWhereTwoMeet) {
  Lump second = capsule({0, 0.02, 0}, {0.04, 0.02, 0}, 0.01, 0.01);
  second.blend = 0.004;
  const ImplicitBody body{capsule({0, 0, 0}, {0.04, 0, 0}, 0.01, 0.01), second};
  EXPECT_NEAR(implicit_height(body, {0.02, 0.01, 0}), -0.001, kRounding);
  EXPECT_NEAR(implicit_height(body, {0.02, -0.02, 0}), 0.01, kRounding);
}

// On this every search for contacts leans: never more than the way gone.
TEST(ImplicitBody, ChangesByNoMoreThanTheWayGone) {
  sample::Draw draw(3);
  for (int trial = 0; trial < 200; ++trial) {
    ImplicitBody body;
    for (int i = 0; i < 4; ++i) {
      Lump lump = capsule(draw.vector(0.03), draw.vector(0.03), draw.number(0.003, 0.01),
                          draw.number(0.003, 0.01));
      lump.core[2] = draw.vector(0.03);
      lump.sheet = i == 2;
      lump.flat = draw.direction();
      lump.aspect = draw.number(1, 1.5);
      lump.blend = draw.number(0, 0.01);
      body.push_back(lump);
    }
    for (int i = 0; i < 50; ++i) {
      const Vector3d p = draw.vector(0.06), q = p + draw.vector(0.01);
      EXPECT_LE(std::abs(implicit_height(body, p) - implicit_height(body, q)),
                (p - q).norm() + kRounding);
    }
  }
}

TEST(ImplicitBody, LiesWithinItsBounds) {
  Lump lump = capsule({0, 0, 0}, {0.02, 0.01, 0}, 0.01, 0.006);
  lump.flat = Vector3d(0.6, 0, 0.8);
  lump.aspect = 1.4;
  const Eigen::AlignedBox3d box = implicit_bounds({lump});
  sample::Draw draw(4);
  for (int i = 0; i < 20000; ++i) {
    const Vector3d p = draw.vector(0.04);
    if (implicit_height({lump}, p) < 0) {
      EXPECT_TRUE(box.contains(p));
    }
  }
}

}  // namespace
}  // namespace thenar
