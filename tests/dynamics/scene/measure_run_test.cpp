// Tests for dynamics/scene/measure_run.cpp: runs whose slip and work are known by hand.

#include "dynamics/scene/measure_run.h"

#include <gtest/gtest.h>

#include "base/units.h"
#include "tests/dynamics/stepping/sample_scenes.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

using sample::primitive;

/// A ball of 10 mm and a floor below z = 0.
MovingScene ball_on_floor() {
  MovingScene scene;
  Pose<double> X;
  X.p.z() = -0.05;
  sample::add_body(scene, "floor", primitive(ShapeKind::kBox, {4, 4, 0.1}), 0, X);
  X.p.z() = 0.01;
  sample::add_body(scene, "ball", primitive(ShapeKind::kSphere, {0.01, 0, 0}), 0.1, X);
  return scene;
}

/// An instant of that ball: its contact has the force (0, 0, 1) N on the floor's side turned round.
SceneSample instant(const MovingScene& scene, double t, const Eigen::Vector3d& centre,
                    double turned_about_y) {
  SceneSample out;
  out.t = t;
  out.q = scene.q;
  out.v = Eigen::VectorXd::Zero(scene.v.size());
  Pose<double> X;
  X.p = centre;
  X.R = rotation_about<double>({0, 1, 0}, turned_about_y);
  set_free_pose(scene.mechanism, 1, X, out.q);
  ContactSample contact;
  contact.a = 0;
  contact.b = 1;
  contact.id = 7;
  contact.point = centre - Eigen::Vector3d(0, 0, 0.01);
  contact.normal = Eigen::Vector3d(0, 0, -1);
  contact.force = Eigen::Vector3d(0, 0, -1);
  contact.mode = ContactMode::kSlide;
  out.contacts = {contact};
  return out;
}

TEST(MeasureRun, AFrictionlessPairThatMovesSlides) {
  // Rows of such contacts are along the normal alone, so that steps do not see it slide.
  MovingScene scene = ball_on_floor();
  scene.friction.coefficient = 0;
  scene.friction_pairs.clear();
  for (const double speed : {0.0, 2.0}) {
    SceneRun run;
    run.samples = {instant(scene, 0, {0, 0, 0.01}, 0), instant(scene, 0.1, {0, 0, 0.01}, 0)};
    for (SceneSample& sample : run.samples) {
      sample.contacts[0].mode = ContactMode::kStick;
      sample.v.tail<3>().x() = speed;
    }
    EXPECT_EQ(measure_run(scene, run).pairs.at(0).mode,
              speed > 0 ? ContactMode::kSlide : ContactMode::kStick);
  }
}

TEST(MeasureRun, SlipIsTheWayOfSliding) {
  const MovingScene scene = ball_on_floor();
  SceneRun run;
  run.samples = {instant(scene, 0, {0, 0, 0.01}, 0), instant(scene, 0.1, {0.03, 0, 0.01}, 0),
                 instant(scene, 0.2, {0.03, 0.04, 0.01}, 0)};
  const RunMeasures found = measure_run(scene, run);
  ASSERT_EQ(found.pairs.size(), 1U);
  EXPECT_NEAR(found.pairs[0].slip, 0.03 + 0.04, 1e-15);
  EXPECT_EQ(found.pairs[0].first, 0);
  EXPECT_EQ(found.pairs[0].last, 0.2);
  EXPECT_DOUBLE_EQ(found.pairs[0].largest_force, 1);
  EXPECT_EQ(found.pairs[0].mode, ContactMode::kSlide);
  EXPECT_EQ(found.pairs[0].points, 1);
}

// A contact that was lost and found anew, at the ball's lowest point, has slid.
TEST(MeasureRun, IdentitiesMayChange) {
  const MovingScene scene = ball_on_floor();
  SceneRun run;
  run.samples = {instant(scene, 0, {0, 0, 0.01}, 0), instant(scene, 0.1, {0.03, 0, 0.01}, 0)};
  run.samples[1].contacts[0].id = 8;
  EXPECT_NEAR(measure_run(scene, run).pairs.at(0).slip, 0.03, 1e-15);
  // Somewhere else it is another contact.
  run.samples[1].contacts[0].point.y() = 0.002;
  EXPECT_EQ(measure_run(scene, run).pairs.at(0).slip, 0);
}

/// A ball that is turned by these angles while its centre goes on by these ways, with the speeds of
/// an even motion.
SceneRun even_motion(const MovingScene& scene, double turn, double way, int instants) {
  SceneRun run;
  const double step = 0.01;  // [s]
  for (int k = 0; k <= instants; ++k) {
    run.samples.push_back(instant(scene, step * k, {way * k, 0, 0.01}, turn * k));
    run.samples.back().v << 0, turn / step, 0, way / step, 0, 0;
  }
  return run;
}

TEST(MeasureRun, RollingIsNoSlip) {
  const MovingScene scene = ball_on_floor();
  for (const double turn : {0.01, 0.3, 1.0, 1.9, -1.9, 2.1, 50.0})
    EXPECT_NEAR(measure_run(scene, even_motion(scene, turn, 0.01 * turn, 100)).pairs.at(0).slip, 0,
                1e-12)
        << turn;
}

// A ball that skids slides by what it goes on less what it rolls, or more if it turns backwards.
TEST(MeasureRun, SlipIsTheWayLessRolling) {
  const MovingScene scene = ball_on_floor();
  for (const double turn : {0.0, 0.3, 1.0, -1.0, 1.9, 2.1, -8.0})
    EXPECT_NEAR(measure_run(scene, even_motion(scene, turn, 0.004, 100)).pairs.at(0).slip,
                100 * std::abs(0.004 - 0.01 * turn), 1e-12)
        << turn;
}

TEST(MeasureRun, WhatIsApartAtOneEndDoesNotSlip) {
  const MovingScene scene = ball_on_floor();
  SceneRun run;
  run.samples = {instant(scene, 0, {0, 0, 0.01}, 0), instant(scene, 0.1, {0.03, 0, 0.02}, 0),
                 instant(scene, 0.2, {0.06, 0, 0.01}, 0)};
  run.samples[1].contacts.clear();
  EXPECT_EQ(measure_run(scene, run).pairs.at(0).slip, 0);
}

// Force along the way, moment along the turn.
TEST(MeasureRun, WorkIsForceTimesWay) {
  MovingScene scene = ball_on_floor();
  scene.forces.push_back({1, {0, 0, 0}, {2, 0, 0}, {0, 0.5, 0}, {0, 0.15}});
  SceneRun run;
  run.samples = {instant(scene, 0, {0, 0, 0.01}, 0), instant(scene, 0.1, {0.03, 0, 0.01}, 0.2),
                 instant(scene, 0.3, {0.09, 0, 0.01}, 0.3)};
  // The force ends before the middle of the second interval.
  EXPECT_NEAR(measure_run(scene, run).work, 2 * 0.03 + 0.5 * 0.2, 1e-15);
}

// The spring of a drive: its work is what the spring loses, 1/2 k (x0^2 - x1^2).
TEST(MeasureRun, WorkOfADriveIsThatOfItsSpring) {
  MovingScene scene;
  sample::add_on_joint(scene, "slider", primitive(ShapeKind::kSphere, {0.01, 0, 0}), 0.1,
                       JointKind::kSlide, {1, 0, 0}, {0, 0, 0});
  scene.gravity.setZero();
  scene.q[0] = 0.1;
  SceneDrive drive;
  drive.stiffness = 50;
  scene.drives.push_back(drive);
  SceneOptions options;
  options.duration = 0.05;
  options.sample_interval = 0.001;
  const SceneRun run = simulate_scene(scene, options);
  const RunMeasures found = measure_run(scene, run);
  const double x = run.samples.back().q[0];
  EXPECT_NEAR(found.work, 0.5 * 50 * (0.1 * 0.1 - x * x), 1e-12);
  EXPECT_NEAR(found.dissipated, 0, 1e-9);
  // x = 0.1 cos(sqrt(k / m) t): the simulator itself.
  EXPECT_NEAR(x, 0.1 * std::cos(std::sqrt(50 / 0.1) * 0.05), 1e-8);
}

}  // namespace
}  // namespace thenar
