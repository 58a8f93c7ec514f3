// Tests for grasp/closing/setup.cpp: centres of bodies, and friction.

#include "grasp/closing/setup.h"

#include <gtest/gtest.h>

#include "tests/grasp/closing_samples.h"

namespace thenar {
namespace {

TEST(GraspSetup, CentresOneShapeExactly) {
  const Eigen::Vector3d at(0.01, -0.02, 0.03);
  const GraspBody body = build_body(
      sample::placed("box", sample::shape(ShapeKind::kBox, {0.02, 0.04, 0.06}, at), {0, 0, 0}));
  EXPECT_LT((body.com - at).norm(), 1e-15);
  EXPECT_NEAR(body.torque_scale, 0.5 * Eigen::Vector3d(0.02, 0.04, 0.06).norm(), 1e-15);
}

// Boxes over x = 0 .. 30 mm and 20 .. 40 mm: together 0 .. 40 mm. To count the overlap twice would
// give 21 mm.
TEST(GraspSetup, CountsOverlapsOnce) {
  PlacedBody placed = sample::placed(
      "bar", sample::shape(ShapeKind::kBox, {0.03, 0.02, 0.02}, {0.015, 0, 0}), {0, 0, 0});
  placed.body.shapes.push_back(sample::shape(ShapeKind::kBox, {0.02, 0.02, 0.02}, {0.03, 0, 0}));
  const GraspBody body = build_body(placed);
  EXPECT_LT((body.com - Eigen::Vector3d(0.02, 0, 0)).norm(), 1e-4);  // cells of 0.4 mm
}

TEST(GraspSetup, KeepsTheCentreThatIsStated) {
  PlacedBody placed =
      sample::placed("ball", sample::shape(ShapeKind::kSphere, {0.02, 0, 0}), {0, 0, 0});
  placed.body.mass = BodyMass{0.1, {0, 0, 0.005}, Eigen::Matrix3d::Identity()};
  EXPECT_EQ(build_body(placed).com, Eigen::Vector3d(0, 0, 0.005));
}

TEST(GraspSetup, KeepsTheFrictionOfItsWorld) {
  WorldSpec world;
  world.bodies = {
      sample::placed("ball", sample::shape(ShapeKind::kSphere, {0.02, 0, 0}), {0, 0, 0})};
  world.materials.friction[{"rubber", "wood"}] = {0.3, 0.2};
  EXPECT_EQ(build_setup(world).materials.between("wood", "rubber").static_coefficient, 0.3);
}

}  // namespace
}  // namespace thenar
