// Tests for dynamics/compliant/: both programs agree where they have the same laws, and contacts
// that yield tend to those that do not as they grow stiff.

#include <cmath>

#include <gtest/gtest.h>

#include "dynamics/compliant/penalty_law.h"
#include "tests/dynamics/compliant/compliant_scenes.h"
#include "tests/dynamics/mechanism/sample_mechanisms.h"

namespace thenar {
namespace {

using sample::centre;

/// Largest difference of the positions of two runs at their ends [m], [rad].
double difference(const SceneRun& a, const SceneRun& b) {
  return (a.samples.back().q - b.samples.back().q).cwiseAbs().maxCoeff();
}

/// Both programs on a scene; they must come to its end.
std::pair<SceneRun, SceneRun> both(const MovingScene& scene, const SceneOptions& options) {
  std::pair<SceneRun, SceneRun> out{simulate_simbody_scene(scene, options),
                                    simulate_penalty_scene(scene, options)};
  EXPECT_EQ(out.first.status, SceneStatus::kDone) << out.first.message;
  EXPECT_EQ(out.second.status, SceneStatus::kDone) << out.second.message;
  return out;
}

/// A pinch whose cube swings about the axis of the grip.
sample::Pinch swing() {
  sample::PinchOptions grip;
  grip.force = 8;
  grip.above = 5.4e-3;
  sample::Pinch world = sample::pinch(grip);
  world.scene.v[2] = 6;
  return world;
}

// A ball thrown askew with spin bounces and rolls: Hertz, Hunt and Crossley, the quintic ramp.
TEST(CompliantLadder, ProgramsAgreeOnAThrownBall) {
  sample::BallOnFloor world = sample::ball_on_floor(0.02);
  world.scene.friction.coefficient = 0.4;
  world.scene.v << 3, 20, -2, 0.5, 0.2, 0;
  SceneOptions options;
  options.duration = 0.5;
  options.compliance.modulus = 1e7;
  options.compliance.transition = 1e-2;
  options.tolerance = 1e-11;
  const auto [theirs, ours] = both(world.scene, options);
  EXPECT_LT(difference(theirs, ours), 1e-7);
  ASSERT_EQ(theirs.samples.size(), ours.samples.size());
}

TEST(CompliantLadder, ProgramsAgreeOnAPinchThatSwings) {
  const sample::Pinch world = swing();
  SceneOptions options;
  options.duration = 0.3;
  options.compliance.modulus = 1e7;
  options.compliance.dissipation = 10;
  options.compliance.transition = 1e-2;
  options.tolerance = 1e-10;
  const auto [theirs, ours] = both(world.scene, options);
  EXPECT_LT(difference(theirs, ours), 1e-7);
  double most = 0;  // it swings [m]
  for (const SceneSample& at : ours.samples)
    most = std::max(most, std::abs(centre(world.scene, world.cube, at).y()));
  EXPECT_GT(most, 1e-3);
}

// Springs, dampers, drives, dry friction, stops, forces for a time, shared coordinates.
TEST(CompliantLadder, ProgramsAgreeOnMechanismsWithoutContacts) {
  sample::MechanismDraw draw(5);
  for (int trial = 0; trial < 6; ++trial) {
    SCOPED_TRACE(trial);
    MovingScene scene;
    scene.mechanism = draw.mechanism(6, trial % 2 == 1);
    scene.q = draw.position(scene.mechanism, 0.5);
    scene.v = draw.numbers(layout_of(scene.mechanism).v, 1);
    if (scene.v.size() == 0) continue;
    for (MechanismJoint& joint : scene.mechanism.joints) {
      if (!is_scalar(joint.kind)) continue;
      joint.stiffness = 0.5;
      joint.damping = 0.01;
      joint.friction = 0.01;
      const MechanismLayout layout = layout_of(scene.mechanism);
      const auto at = static_cast<std::size_t>(&joint - scene.mechanism.joints.data());
      joint.upper = joint_value(joint, scene.q[layout.first_q[at]]).value + 0.1;
    }
    scene.forces.push_back({0, {0.01, 0, 0}, {0.1, 0.2, 0}, {0, 0, 0.01}, {0.05, 0.11}});
    if (!scene.mechanism.coordinates.empty())
      scene.drives.push_back({0, 0.02, 1, 0.01, 0.3, 0.5, 0.1, {0.02, 0.15}});
    SceneOptions options;
    options.duration = 0.2;
    options.compliance.transition = 0.1;
    options.compliance.stop = 50;
    options.tolerance = 1e-9;
    const auto [theirs, ours] = both(scene, options);
    EXPECT_LT(difference(theirs, ours), 1e-6);
  }
}

// With stiffness and 1 / transition times s, the distance from rigid contacts falls as 1 / s.
TEST(CompliantLadder, SwingingPinchTendsToRigidContacts) {
  const sample::Pinch world = swing();
  SceneOptions options;
  options.duration = 0.3;
  const SceneRun rigid = simulate_scene(world.scene, options);
  options.compliance.modulus = 0;  // linear springs
  options.compliance.dissipation = 10;
  options.compliance.ramp = FrictionRamp::kLinear;
  std::vector<double> errors;
  for (const double s : {1.0, 4.0, 16.0}) {
    options.compliance.stiffness = 1e5 * s;
    options.compliance.transition = 4e-3 / s;
    const SceneRun run = simulate_penalty_scene(world.scene, options);
    ASSERT_EQ(run.status, SceneStatus::kDone) << run.message;
    errors.push_back((centre(world.scene, world.cube, run.samples.back()) -
                      centre(world.scene, world.cube, rigid.samples.back()))
                         .norm());
  }
  EXPECT_NEAR(errors[0] / errors[1], 4, 0.8);
  EXPECT_NEAR(errors[1] / errors[2], 4, 0.4);
}

// The same on the incline, whose rigid answer is closed: g (sin - mu cos) t^2 / 2.
TEST(CompliantLadder, SlidingCubeTendsToCoulomb) {
  const double slope = 0.5, mu = 0.3;
  const sample::Incline world = sample::incline(slope, mu);
  const double way = 0.5 * sample::kG * (std::sin(slope) - mu * std::cos(slope)) * 0.4 * 0.4;
  SceneOptions options;
  options.duration = 0.4;
  options.compliance.dissipation = 100;
  options.compliance.stiffness = 1e7;
  std::vector<double> errors;
  for (const double s : {1.0, 10.0}) {
    options.compliance.transition = 2e-2 / s;
    const SceneRun run = simulate_penalty_scene(world.scene, options);
    ASSERT_EQ(run.status, SceneStatus::kDone) << run.message;
    const Eigen::Vector3d moved = centre(world.scene, world.cube, run.samples.back()) -
                                  centre(world.scene, world.cube, run.samples.front());
    errors.push_back(moved.norm() - way);
  }
  EXPECT_GT(errors[1], 0);  // the ramp resists less
  EXPECT_NEAR(errors[0] / errors[1], 10, 1);
}

}  // namespace
}  // namespace thenar
