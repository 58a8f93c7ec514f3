// Tests for dynamics/compliant/: what is refused, and how runs end that cannot go on.

#include <cmath>

#include <gtest/gtest.h>

#include "geometry/tessellate.h"
#include "tests/dynamics/compliant/compliant_scenes.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

using sample::centre;
using sample::primitive;

TEST(CompliantLimits, RefuseWhatTheLawsDoNotKnow) {
  sample::BallOnFloor world = sample::ball_on_floor();
  SceneOptions options;
  options.compliance.ramp = FrictionRamp::kLinear;
  EXPECT_THROW((void)simulate_simbody_scene(world.scene, options), InputError);
  options.compliance = {};
  options.compliance.modulus = 0;
  EXPECT_THROW((void)simulate_simbody_scene(world.scene, options), InputError);
  options.compliance = {};
  world.scene.friction = {0.5, 1e-3, 0};
  EXPECT_THROW((void)simulate_simbody_scene(world.scene, options), InputError);
  world.scene.friction = {0.5, 0, 0.5};
  EXPECT_THROW((void)simulate_simbody_scene(world.scene, options), InputError);
  EXPECT_THROW((void)simulate_penalty_scene(world.scene, options), InputError);
}

/// A force element that does nothing.
class Idle final : public ForceElement {
 public:
  [[nodiscard]] std::unique_ptr<ForceElement> clone() const override {
    return std::make_unique<Idle>();
  }
  [[nodiscard]] std::string name() const override { return "idle"; }
  bool add_action(const ElementInput& /*at*/, ElementAction& /*out*/) override { return true; }
};

TEST(CompliantLimits, RefuseForceElements) {
  sample::BallOnFloor world = sample::ball_on_floor();
  world.scene.elements.push_back(std::make_shared<Idle>());
  EXPECT_THROW((void)simulate_simbody_scene(world.scene, {}), InputError);
  EXPECT_THROW((void)simulate_penalty_scene(world.scene, {}), InputError);
}

// A cube of triangles, one of which is left out.
TEST(CompliantLimits, SimbodyNamesTheBodyWhoseMeshIsOpen) {
  MovingScene scene = sample::ball_on_floor(1).scene;
  ShapeSpec cube = primitive(ShapeKind::kMesh, {0, 0, 0});
  cube.mesh = box_mesh({0.05, 0.05, 0.05});
  Pose<double> X;
  X.p = {0.3, 0, 0.025};
  const int body = sample::add_body(scene, "cube", cube, 0.1, X);
  SceneOptions options;
  options.duration = 0.01;
  EXPECT_EQ(simulate_simbody_scene(scene, options).status, SceneStatus::kDone);
  Solid open = *scene.mechanism.bodies[static_cast<std::size_t>(body)].solid;
  Eigen::Matrix3Xi& triangles = open.collision.front().core.triangles;
  triangles.conservativeResize(3, triangles.cols() - 1);
  scene.mechanism.bodies[static_cast<std::size_t>(body)].solid =
      std::make_shared<const Solid>(std::move(open));
  const std::string told =
      message_of<InputError>([&] { (void)simulate_simbody_scene(scene, options); });
  EXPECT_NE(told.find("Simbody refuses the surface of 'cube'"), std::string::npos) << told;
}

TEST(CompliantLimits, OtherStepperRefusesTheirNames) {
  const sample::BallOnFloor world = sample::ball_on_floor();
  SceneOptions options;
  options.method = SteppingMethod::kCompliantSundials;
  EXPECT_THROW((void)simulate_scene(world.scene, options), InputError);
}

TEST(CompliantLimits, TellsWhenTheToleranceIsBelowRounding) {
  const sample::BallOnFloor world = sample::ball_on_floor(0.01);
  SceneOptions options;
  options.tolerance = 1e-30;
  for (const sample::CompliantProgram& program : {sample::kOfSimbody, sample::kOfSundials}) {
    const SceneRun run = program.run(world.scene, options, {});
    EXPECT_EQ(run.status, SceneStatus::kFailed) << program.name;
    EXPECT_NE(run.message, "");
    EXPECT_EQ(run.samples.size(), 1);
  }
}

TEST(CompliantLimits, StopWhenAsked) {
  const sample::BallOnFloor world = sample::ball_on_floor(0.01);
  Progress progress;
  int asked = 0;
  progress.stop_requested = [&] { return ++asked > 20; };
  for (const sample::CompliantProgram& program : {sample::kOfSimbody, sample::kOfSundials}) {
    asked = 0;
    const SceneRun run = program.run(world.scene, {}, progress);
    EXPECT_EQ(run.status, SceneStatus::kStopped) << program.name;
    EXPECT_LT(run.samples.back().t, 1);
  }
}

// A half space goes on where its box ends: the run must not.
TEST(CompliantLimits, SimbodyTellsWhenABallRollsOffABox) {
  MovingScene scene;
  Pose<double> X;
  X.p.z() = -0.05;
  sample::add_body(scene, "table", primitive(ShapeKind::kBox, {0.2, 0.2, 0.1}), 0, X);
  X.p = {0.08, 0, 0.02};
  sample::add_body(scene, "ball", primitive(ShapeKind::kSphere, {0.02, 0, 0}), 0.1, X);
  scene.v << 0, 0, 0, 0.5, 0, 0;
  const SceneRun run = simulate_simbody_scene(scene, {});
  EXPECT_EQ(run.status, SceneStatus::kFailed);
  EXPECT_NE(run.message.find("'table' and 'ball' touch beyond the face"), std::string::npos)
      << run.message;
  EXPECT_NEAR(run.samples.back().t, 0.04, 0.011);  // 20 mm at 0.5 m/s
  // Ours knows the box: it falls.
  const SceneRun ours = simulate_penalty_scene(scene, {});
  EXPECT_EQ(ours.status, SceneStatus::kDone) << ours.message;
  EXPECT_LT(centre(scene, 1, ours.samples.back()).z(), -1);
}

// Steps of error control alone would jump over a plate that nothing announces.
TEST(CompliantLimits, NothingFastGoesThroughSomethingThin) {
  MovingScene scene;
  Pose<double> X;
  sample::add_body(scene, "plate", primitive(ShapeKind::kBox, {1, 1, 0.5e-3}), 0, X);
  X.p.z() = 0.5;
  sample::add_body(scene, "pellet", primitive(ShapeKind::kSphere, {2e-3, 0, 0}), 1e-3, X);
  scene.v[5] = -30;
  scene.gravity.setZero();
  SceneOptions options;
  options.duration = 0.05;
  options.compliance.modulus = 1e11;
  options.compliance.dissipation = 0;
  const SceneRun run = simulate_penalty_scene(scene, options);
  ASSERT_EQ(run.status, SceneStatus::kDone) << run.message;
  EXPECT_NEAR(run.samples.back().v[5], 30, 1e-3);
  EXPECT_GT(run.cost.rejected, 0);  // steps that went too far
}

// Nothing announces a floor: the step that finds it errs, and is made again.
TEST(CompliantLimits, TellStepsThatWereMadeInVain) {
  const sample::BallOnFloor world = sample::ball_on_floor(0.01);
  SceneOptions options;
  options.duration = 0.2;
  for (const sample::CompliantProgram& program : {sample::kOfSimbody, sample::kOfSundials}) {
    const SceneRun run = program.run(world.scene, options, {});
    EXPECT_GT(run.cost.rejected, 0) << program.name;
    EXPECT_GT(run.cost.substeps, run.cost.steps) << program.name;
  }
}

TEST(CompliantLimits, InfiniteMotionIsTold) {
  MovingScene scene;
  scene.v.resize(0);
  sample::add_body(scene, "ball", primitive(ShapeKind::kSphere, {0.02, 0, 0}), 0.1);
  scene.forces.push_back({0, {0, 0, 0}, {1e305, 0, 0}, {0, 0, 0}, {0.1, 1}});
  for (const sample::CompliantProgram& program : {sample::kOfSimbody, sample::kOfSundials}) {
    const SceneRun run = program.run(scene, {}, {});
    EXPECT_NE(run.status, SceneStatus::kDone) << program.name;
    for (const SceneSample& at : run.samples) EXPECT_TRUE(at.q.allFinite() && at.v.allFinite());
  }
}

// Nothing that moves, and a scene without bodies.
TEST(CompliantLimits, RestsWhereNothingCanMove) {
  MovingScene scene;
  sample::add_body(scene, "table", primitive(ShapeKind::kBox, {0.2, 0.2, 0.1}), 0);
  for (const sample::CompliantProgram& program : {sample::kOfSimbody, sample::kOfSundials}) {
    const SceneRun run = program.run(scene, {}, {});
    EXPECT_EQ(run.status, SceneStatus::kDone) << program.name << run.message;
    EXPECT_EQ(run.samples.size(), 101) << program.name;
  }
}

TEST(CompliantLimits, TheSameSceneGivesTheSameBits) {
  sample::BallOnFloor world = sample::ball_on_floor(0.01);
  world.scene.v << 3, 20, -2, 0.5, 0.2, 0;
  world.scene.friction.coefficient = 0.3;
  SceneOptions options;
  options.duration = 0.2;
  for (const sample::CompliantProgram& program : {sample::kOfSimbody, sample::kOfSundials}) {
    const SceneRun once = program.run(world.scene, options, {});
    const SceneRun again = program.run(world.scene, options, {});
    EXPECT_EQ(once.samples.back().q, again.samples.back().q) << program.name;
    EXPECT_EQ(once.samples.back().v, again.samples.back().v) << program.name;
  }
}

}  // namespace
}  // namespace thenar
