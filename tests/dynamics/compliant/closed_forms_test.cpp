// Tests for dynamics/compliant/: both programs against closed forms of their laws.

#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "dynamics/compliant/penalty_law.h"
#include "geometry/tessellate.h"
#include "tests/dynamics/compliant/compliant_scenes.h"
#include "tests/dynamics/compliant/creep_speed.h"

namespace thenar {
namespace {

using sample::centre;
using sample::CompliantProgram;
using sample::kBallRadius;
using sample::kG;

class CompliantPrograms : public testing::TestWithParam<CompliantProgram> {
 protected:
  static SceneRun run(const MovingScene& scene, const SceneOptions& options) {
    return GetParam().run(scene, options, {});
  }
};

INSTANTIATE_TEST_SUITE_P(Both, CompliantPrograms,
                         testing::Values(sample::kOfSimbody, sample::kOfSundials),
                         [](const auto& of) { return of.param.name; });

// m g = (4/3) E sqrt(R) d^1.5.
TEST_P(CompliantPrograms, BallRestsAtTheDepthOfHertz) {
  const sample::BallOnFloor world = sample::ball_on_floor();
  SceneOptions options;
  options.compliance.modulus = 1e6;
  options.compliance.dissipation = 20;
  const SceneRun run = this->run(world.scene, options);
  ASSERT_EQ(run.status, SceneStatus::kDone) << run.message;
  const double weight = 0.1 * kG;
  const double depth = std::pow(0.75 * weight / (1e6 * std::sqrt(kBallRadius)), 2.0 / 3);
  const SceneSample& end = run.samples.back();
  EXPECT_NEAR(kBallRadius - centre(world.scene, world.ball, end).z(), depth, 1e-9);
  ASSERT_EQ(end.contacts.size(), 1);
  const ContactSample& contact = end.contacts.front();
  EXPECT_NEAR(contact.gap, -depth, 1e-9);
  EXPECT_EQ(std::pair(contact.a, contact.b), std::pair(0, 1));
  EXPECT_NEAR(contact.normal.z(), -1, 1e-9);  // outward of the ball, which is b
  EXPECT_NEAR(contact.force.z(), -weight, 1e-5 * weight);
  EXPECT_NEAR(contact.point.z(), -0.5 * depth, 1e-9);
  EXPECT_NEAR(end.energy.springs, 0.4 * weight * depth, 1e-5 * weight * depth);
  EXPECT_GT(run.cost.max_penetration, depth);
}

// Of m d'' = -F(d) (1 + a d'), a = 1.5 c, the speeds before and after obey  G(v) = G(-e v)  with
// G(v) = a v - log(1 + a v), whatever F.
TEST_P(CompliantPrograms, BouncesKeepTheSpeedOfHuntAndCrossley) {
  sample::BallOnFloor world = sample::ball_on_floor(1e-3);
  world.scene.gravity.setZero();
  const double c = 0.3, a = 1.5 * c, v = 1;
  world.scene.v << 0, 0, 0, 0, 0, -v;
  SceneOptions options;
  options.duration = 0.1;
  options.compliance.dissipation = c;
  options.tolerance = 1e-10;
  const SceneRun run = this->run(world.scene, options);
  ASSERT_EQ(run.status, SceneStatus::kDone) << run.message;
  const auto G = [&](double u) { return a * u - std::log1p(a * u); };
  double low = 0, high = 1;
  for (int i = 0; i < 60; ++i) {
    const double e = 0.5 * (low + high);
    (G(-e * v) < G(v) ? low : high) = e;
  }
  EXPECT_NEAR(run.samples.back().v[5], high * v, 2e-5);
}

// A cube that starts at rest and at its depth on an incline:  v' = g sin - mu g cos share(v / v_t).
TEST_P(CompliantPrograms, CubeSlidesAsItsRampSays) {
  const double slope = 0.5, mu = 0.3;
  const sample::Incline world = sample::incline(slope, mu);
  SceneOptions options;
  options.duration = 0.4;
  options.compliance.stiffness = 1e7;
  options.compliance.dissipation = 100;
  options.compliance.transition = 0.02;
  const SceneRun run = this->run(world.scene, options);
  ASSERT_EQ(run.status, SceneStatus::kDone) << run.message;
  // Midpoint steps of the law.
  double way = 0, speed = 0;
  const double h = 1e-5;
  const auto slope_at = [&](double v) {
    const double share = friction_ratio(FrictionRamp::kQuintic, v / options.compliance.transition);
    return kG * (std::sin(slope) - mu * std::cos(slope) * share);
  };
  for (int i = 0; i < 40000; ++i) {
    const double middle = speed + 0.5 * h * slope_at(speed);
    way += h * middle;
    speed += h * slope_at(middle);
  }
  const Eigen::Vector3d moved = centre(world.scene, world.cube, run.samples.back()) -
                                centre(world.scene, world.cube, run.samples.front());
  // It tilts by less than its depth of 0.03 um over its size, and sinks by it.
  EXPECT_NEAR(moved.norm(), way, 1e-6);
}

// What is held by friction sinks at the speed at which the ramp carries its share of the weight.
TEST_P(CompliantPrograms, HeldCubeCreepsAtTheSpeedOfItsShare) {
  const sample::Pinch world = sample::pinch({});
  SceneOptions options;
  options.duration = 0.5;
  options.compliance.dissipation = 100;
  const double share = 0.1 * kG / (2 * 0.8 * 2);
  const SceneRun run = this->run(world.scene, options);
  ASSERT_EQ(run.status, SceneStatus::kDone) << run.message;
  const double creep =
      options.compliance.transition * closed_form::creep_speed(FrictionRamp::kQuintic, share);
  EXPECT_NEAR(run.samples.back().v[7], -creep, 1e-4 * creep);
  EXPECT_NEAR(centre(world.scene, world.cube, run.samples.back()).z(), -creep * 0.5, 0.05 * creep);
  ASSERT_EQ(run.samples.back().contacts.size(), 2);
  EXPECT_EQ(run.samples.back().contacts.front().mode, ContactMode::kStick);
}

// A layer of 5 mm under a face of 25 cm2:  m g = E A d / layer.
TEST(SimbodyScene, MeshRestsOnItsElasticFoundation) {
  MovingScene scene = sample::ball_on_floor(1).scene;
  ShapeSpec cube = sample::primitive(ShapeKind::kMesh, {0, 0, 0});
  cube.mesh = box_mesh({0.05, 0.05, 0.05});
  Pose<double> X;
  X.p = {0.3, 0, 0.025};
  const int body = sample::add_body(scene, "cube", cube, 0.1, X);
  SceneOptions options;
  options.duration = 0.3;
  options.sample_interval = 0.3;
  options.tolerance = 1e-8;
  options.compliance.modulus = 1e6;
  options.compliance.dissipation = 100;
  const SceneRun run = simulate_simbody_scene(scene, options);
  ASSERT_EQ(run.status, SceneStatus::kDone) << run.message;
  const double depth = 0.1 * kG * 5e-3 / (1e6 * 0.05 * 0.05);
  EXPECT_NEAR(0.025 - centre(scene, body, run.samples.back()).z(), depth, 1e-2 * depth);
}

// A tolerance of 0.1 mm/s in speeds must not drown a creep of 4 um/s.
TEST(PenaltyScene, ResolvesCreepBelowItsTolerance) {
  const sample::Pinch world = sample::pinch({});
  SceneOptions options;
  options.duration = 2;
  options.tolerance = 1e-6;
  options.compliance.modulus = 1e10;
  options.compliance.dissipation = 10;
  options.compliance.transition = 1e-5;
  const SceneRun run = simulate_penalty_scene(world.scene, options);
  ASSERT_EQ(run.status, SceneStatus::kDone) << run.message;
  const double creep =
      1e-5 * closed_form::creep_speed(FrictionRamp::kQuintic, 0.1 * kG / (2 * 0.8 * 2));
  // Speeds are kept to 0.1 um/s, which is 3 % of it.
  EXPECT_NEAR(centre(world.scene, world.cube, run.samples.back()).z() / (-2 * creep), 1, 0.03);
}

// Friction alone takes  m s^2 / 7  of a ball until it rolls, s its slip at the start: the slip has
// the mass 1 / (1 / m + R^2 / I) = 2 m / 7. The arm of friction is shorter than R by half of the
// depth, 0.7 of 20 mm at most, which changes that mass by 5 %.
TEST_P(CompliantPrograms, EnergyIsKeptWithoutDissipationAndNeverRisesWithIt) {
  const double slipped =
      0.1 * Eigen::Vector2d(0.4 - kBallRadius * 1, kBallRadius * 3).squaredNorm() / 7;
  struct Loss {
    double dissipation, friction;  // [s/m], [1]
  };
  for (const auto& [dissipation, friction] : {Loss{0, 0}, {0.5, 0}, {0, 0.5}, {0.5, 0.5}}) {
    SCOPED_TRACE(fmt::format("dissipation {}, friction {}", dissipation, friction));
    sample::BallOnFloor world = sample::ball_on_floor(0.05);
    world.scene.friction.coefficient = friction;
    world.scene.v << 3, 1, 2, 0.4, 0, 0;
    SceneOptions options;
    options.compliance.dissipation = dissipation;
    options.compliance.modulus = 1e7;
    options.tolerance = 1e-10;
    const SceneRun run = this->run(world.scene, options);
    ASSERT_EQ(run.status, SceneStatus::kDone) << run.message;
    const double start = run.samples.front().energy.total();
    double last = start;
    for (const SceneSample& at : run.samples) {
      if (dissipation == 0 && friction == 0) {
        EXPECT_NEAR(at.energy.total(), start, 1e-5 * start) << at.t;
      }
      EXPECT_LT(at.energy.total(), last + 1e-6 * start) << at.t;
      last = at.energy.total();
    }
    if (dissipation > 0) {
      EXPECT_LT(last, 0.9 * start);
    }
    if (dissipation == 0 && friction > 0) {
      EXPECT_NEAR(start - last, slipped, 0.05 * slipped);
    }
  }
}

// A pendulum of 0.1 kg leans on its stop: stop * (angle beyond) = its moment.
TEST_P(CompliantPrograms, JointsLeanOnStopsByTheirStiffness) {
  MovingScene scene;
  ShapeSpec bob = sample::primitive(ShapeKind::kSphere, {0.01, 0, 0});
  bob.X_BS.p = {0.1, 0, 0};
  sample::add_on_joint(scene, "bob", bob, 0.1, JointKind::kHinge, {0, -1, 0}, {0, 0, 0});
  MechanismJoint& joint = scene.mechanism.joints.front();
  joint.lower = -0.2;
  joint.damping = 0.01;
  SceneOptions options;
  options.compliance.stop = 100;
  options.duration = 3;
  const SceneRun run = this->run(scene, options);
  ASSERT_EQ(run.status, SceneStatus::kDone) << run.message;
  const double q = run.samples.back().q[0];
  EXPECT_NEAR(100 * (-0.2 - q), 0.1 * kG * 0.1 * std::cos(q), 1e-5);
}

}  // namespace
}  // namespace thenar
