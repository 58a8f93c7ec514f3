// Tests for dynamics/stepping: motions with exact answers.

#include "dynamics/stepping/simulate_scene.h"

#include <gtest/gtest.h>

#include "tests/dynamics/stepping/sample_hands.h"
#include "tests/dynamics/stepping/sample_scenes.h"

namespace thenar {
namespace {

using sample::centre;
using sample::kG;
using sample::primitive;

TEST(SimulateScene, BodyInFreeFlight) {
  MovingScene scene;
  const int body =
      sample::add_body(scene, "box", primitive(ShapeKind::kBox, {0.05, 0.1, 0.02}), 0.2);
  scene.v << 1, 20, 2, 0.5, 0.1, 3;
  const SceneRun run = simulate_scene(scene, {});
  ASSERT_EQ(run.status, SceneStatus::kDone);
  const Eigen::Vector3d wanted = Eigen::Vector3d(0.5, 0.1, 3 - 0.5 * kG);
  EXPECT_LT((centre(scene, body, run.samples.back()) - wanted).norm(), 1e-8);
  // Energy and angular momentum about the centre stay.
  const auto momentum = [&](const SceneSample& at) -> Eigen::Vector3d {
    const Eigen::Quaterniond turn(at.q[0], at.q[1], at.q[2], at.q[3]);
    const Eigen::Matrix3d& inertia =
        scene.mechanism.bodies[static_cast<std::size_t>(body)].mass.inertia;
    return turn * (inertia * (turn.conjugate() * at.v.head<3>()));
  };
  EXPECT_LT((momentum(run.samples.back()) - momentum(run.samples.front())).norm(),
            1e-8 * momentum(run.samples.front()).norm());
  EXPECT_NEAR(run.samples.back().energy.total(), run.samples.front().energy.total(), 1e-9);
}

TEST(SimulateScene, CubeOnAnInclineSticksBelowTheThreshold) {
  const sample::Incline world = sample::incline(30 * kDegree, std::tan(30.1 * kDegree));
  SceneOptions options;
  options.duration = 10;
  const SceneRun run = simulate_scene(world.scene, options);
  ASSERT_EQ(run.status, SceneStatus::kDone);
  const Eigen::Vector3d moved = centre(world.scene, world.cube, run.samples.back()) -
                                centre(world.scene, world.cube, run.samples.front());
  EXPECT_LT(moved.norm(), 1e-12);
}

TEST(SimulateScene, CubeOnAnInclineSlidesAboveTheThreshold) {
  const double slope = 30 * kDegree, friction = std::tan(29.9 * kDegree);
  const sample::Incline world = sample::incline(slope, friction);
  SceneOptions options;
  options.duration = 2;
  const SceneRun run = simulate_scene(world.scene, options);
  ASSERT_EQ(run.status, SceneStatus::kDone);
  const double way = 0.5 * kG * (std::sin(slope) - friction * std::cos(slope)) * 4;
  const Eigen::Vector3d moved = centre(world.scene, world.cube, run.samples.back()) -
                                centre(world.scene, world.cube, run.samples.front());
  EXPECT_NEAR(moved.norm(), way, 1e-6 * way);
}

// A body that slides at 0.5 m/s stops after v^2 / (2 mu g), between two instants that are kept; the
// step up to there is found by its slip, not by halving.
TEST(SimulateScene, SlidingBodyStopsWithinAFewTrials) {
  MovingScene scene;
  Pose<double> X;
  X.p.z() = -0.05;
  sample::add_body(scene, "floor", primitive(ShapeKind::kBox, {2, 1, 0.1}), 0, X);
  X.p.z() = 0.025;
  const int cube =
      sample::add_body(scene, "cube", primitive(ShapeKind::kBox, {0.05, 0.05, 0.05}), 0.1, X);
  scene.friction.coefficient = 0.3;
  scene.v[3] = 0.5;
  SceneOptions options;
  options.duration = 0.5;
  const SceneRun run = simulate_scene(scene, options);
  ASSERT_EQ(run.status, SceneStatus::kDone);
  EXPECT_NEAR(centre(scene, cube, run.samples.back()).x(), 0.25 / (2 * 0.3 * kG), 1e-9);
  EXPECT_LE(run.cost.rejected, 5);
  EXPECT_EQ(run.cost.inaccurate_steps, 0);
}

// Until such a body stops, a step ends at each instant that is kept; the stop itself costs no more
// than eight steps and three trials, wherever it lies between two instants.
TEST(SimulateScene, StopsCostFewSteps) {
  for (const double speed : {0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9}) {
    SCOPED_TRACE(speed);
    sample::Incline world = sample::incline(0, 0.3);
    world.scene.v[3] = speed;
    SceneOptions options;
    options.duration = 0.5;
    const SceneRun run = simulate_scene(world.scene, options);
    const double stops = speed / (0.3 * kG), way = 0.5 * speed * stops;
    EXPECT_NEAR(centre(world.scene, world.cube, run.samples.back()).x(), way, 1e-9);
    EXPECT_LE(run.cost.steps, std::lround(std::ceil(stops / options.sample_interval)) + 8);
    EXPECT_LE(run.cost.rejected, 3);
  }
}

TEST(SimulateScene, BallBounces) {
  MovingScene scene;
  Pose<double> X;
  X.p.z() = -0.05;
  sample::add_body(scene, "floor", primitive(ShapeKind::kBox, {1, 1, 0.1}), 0, X);
  X.p.z() = 0.02 + 0.1;
  const int ball =
      sample::add_body(scene, "ball", primitive(ShapeKind::kSphere, {0.02, 0, 0}), 0.1, X);
  scene.friction.restitution = 0.8;
  SceneOptions options;
  options.duration = 0.6;
  const SceneRun run = simulate_scene(scene, options);
  // Falls, then rises with 0.8 of the speed again and again.
  double left = 0.6 - std::sqrt(2 * 0.1 / kG), up = 0.8 * std::sqrt(2 * 0.1 * kG);
  while (left > 2 * up / kG) {
    left -= 2 * up / kG;
    up *= 0.8;
  }
  const double height = up * left - 0.5 * kG * left * left;
  EXPECT_NEAR(centre(scene, ball, run.samples.back()).z(), 0.02 + height, 1e-6);
}

TEST(SimulateScene, PinchHoldsWithoutSlip) {
  const sample::Pinch world = sample::pinch({});
  SceneOptions options;
  options.duration = 10;
  for (const bool sleep : {true, false}) {
    options.sleep = sleep;
    const SceneRun run = simulate_scene(world.scene, options);
    ASSERT_EQ(run.status, SceneStatus::kDone);
    EXPECT_LT(centre(world.scene, world.cube, run.samples.back()).norm(), 1e-12);
    EXPECT_EQ(run.cost.rest_time > 9, sleep);
  }
}

TEST(SimulateScene, PinchHoldsAtEveryStep) {
  const sample::Pinch world = sample::pinch({});
  SceneOptions options;
  options.duration = 10;
  options.method = SteppingMethod::kTimeStepping;
  for (const double step : {1e-4, 1e-3, 5e-3, 1e-2, 2e-2}) {
    options.step_length = step;
    const SceneRun run = simulate_scene(world.scene, options);
    ASSERT_EQ(run.status, SceneStatus::kDone);
    EXPECT_LT(centre(world.scene, world.cube, run.samples.back()).norm(), 1e-12) << step;
  }
}

// A force of 1 N on 1 kg for 0.4 s, in free flight, by both methods: steps end where it begins and
// ends.
TEST(SimulateScene, ForcesActForTheirTime) {
  MovingScene scene;
  const int box = sample::add_body(scene, "box", primitive(ShapeKind::kBox, {0.05, 0.05, 0.05}), 1);
  scene.gravity.setZero();
  scene.forces.push_back({box, {0, 0, 0}, {1, 0, 0}, {0, 0, 0}, {0.1, 0.5003}});
  SceneOptions options;
  for (const SteppingMethod method : {SteppingMethod::kEvents, SteppingMethod::kTimeStepping}) {
    options.method = method;
    const SceneRun run = simulate_scene(scene, options);
    EXPECT_NEAR(run.samples.back().v[3], 0.4003, 1e-12);
    const double wanted = 0.5 * 0.4003 * 0.4003 + 0.4003 * (1 - 0.5003);
    EXPECT_NEAR(run.samples.back().q[4], wanted, 1e-12);
  }
}

// What hangs on a joint of the world meets what is fixed there: a pendulum strikes a wall.
TEST(SimulateScene, PendulumMeetsAWall) {
  MovingScene scene;
  ShapeSpec bob = primitive(ShapeKind::kSphere, {0.01, 0, 0});
  bob.X_BS.p = {0.2, 0, 0};
  sample::add_on_joint(scene, "bob", bob, 0.1, JointKind::kHinge, {0, 1, 0}, {0, 0, 0});
  Pose<double> X;
  X.p = {-0.06, 0, -0.2};  // its face at x = -0.01 touches the bob as it hangs
  X.p.x() = -0.01 - 0.05;
  sample::add_body(scene, "wall", primitive(ShapeKind::kBox, {0.1, 1, 1}), 0, X);
  SceneOptions options;
  options.duration = 3;
  const SceneRun run = simulate_scene(scene, options);
  ASSERT_EQ(run.status, SceneStatus::kDone);
  EXPECT_NEAR(run.samples.back().q[0], kPi / 2, 1e-7);
  EXPECT_EQ(run.cost.impacts, 1);
}

// Forces of a squeezed cube are not those of an event elsewhere: the squeeze stays 2 N while a ball
// strikes the floor.
TEST(SimulateScene, SqueezeDoesNotHearOfImpactsElsewhere) {
  sample::Pinch world = sample::pinch({});
  Pose<double> X;
  X.p = {1, 0, -0.05};
  sample::add_body(world.scene, "floor", primitive(ShapeKind::kBox, {0.5, 0.5, 0.1}), 0, X);
  X.p = {1, 0, 0.1};
  sample::add_body(world.scene, "ball", primitive(ShapeKind::kSphere, {0.02, 0, 0}), 0.1, X);
  world.scene.friction.restitution = 0.5;
  const SceneRun run = simulate_scene(world.scene, {});
  ASSERT_EQ(run.status, SceneStatus::kDone);
  EXPECT_GT(run.cost.impacts, 3);
  for (const SceneSample& at : run.samples) {
    int fingers = 0;
    for (const ContactSample& contact : at.contacts) {
      if (contact.b != world.cube && contact.a != world.cube) continue;
      ++fingers;
      EXPECT_NEAR(std::abs(contact.force.x()), 2, 1e-6) << at.t;
      EXPECT_NEAR(std::abs(contact.force.z()), 0.5 * 0.1 * kG, 1e-6) << at.t;
    }
    EXPECT_EQ(fingers, 2) << at.t;
  }
}

/// A cube on the axis of the grip 5.4 mm beside its centre, swung at 6 rad/s.
sample::Pinch swinging_pinch() {
  sample::PinchOptions options;
  options.force = 8;
  options.above = 0.0054;
  sample::Pinch world = sample::pinch(options);
  set_free_velocity(world.scene.mechanism, world.cube, world.scene.q,
                    Eigen::Vector3d(0, 6 * 0.0054, 0), Eigen::Vector3d(6, 0, 0), world.scene.v);
  return world;
}

/// Angle of the swinging cube about the grip's axis.
double swing(const sample::Pinch& world, const SceneSample& at) {
  const Eigen::Vector3d arm = centre(world.scene, world.cube, at) - Eigen::Vector3d(0, 0, 0.0054);
  return std::atan2(arm.y(), -arm.z());
}

// A compound pendulum: its arm and its energy stay.
TEST(SimulateScene, SwingingPinchKeepsItsArmAndEnergy) {
  const sample::Pinch world = swinging_pinch();
  SceneOptions options;
  options.duration = 10;
  const SceneRun run = simulate_scene(world.scene, options);
  ASSERT_EQ(run.status, SceneStatus::kDone);
  const Eigen::Vector3d arm =
      centre(world.scene, world.cube, run.samples.back()) - Eigen::Vector3d(0, 0, 0.0054);
  EXPECT_NEAR(std::hypot(arm.y(), arm.z()), 0.0054, 1e-10);
  EXPECT_NEAR(arm.x(), 0, 1e-12);
  EXPECT_NEAR(run.samples.back().energy.total(), run.samples.front().energy.total(), 1e-10);
  EXPECT_LT(run.cost.worst_residual, 1e-11);
}

// Between impacts the midpoint rule is of second order: halving the step quarters the error.
TEST(SimulateScene, TimeSteppingIsOfSecondOrder) {
  const sample::Pinch world = swinging_pinch();
  SceneOptions options;
  options.duration = 0.5;
  options.tolerance = 1e-12;
  const double exact = swing(world, simulate_scene(world.scene, options).samples.back());
  options.method = SteppingMethod::kTimeStepping;
  std::vector<double> errors;
  for (const double step : {4e-3, 2e-3, 1e-3}) {
    options.step_length = step;
    errors.push_back(
        std::abs(swing(world, simulate_scene(world.scene, options).samples.back()) - exact));
  }
  EXPECT_NEAR(errors[0] / errors[1], 4, 0.3);
  EXPECT_NEAR(errors[1] / errors[2], 4, 0.3);
}

/// A body of 100 g above a floor, as it falls by fixed steps of 1 ms.
struct Fall {
  MovingScene scene;
  int body = 0;
  SceneRun run;
};

Fall fall(const ShapeSpec& shape, const Pose<double>& X_WB, double seconds) {
  Fall out;
  Pose<double> X;
  X.p.z() = -0.05;
  sample::add_body(out.scene, "floor", primitive(ShapeKind::kBox, {1, 1, 0.1}), 0, X);
  out.body = sample::add_body(out.scene, "body", shape, 0.1, X_WB);
  out.scene.friction.coefficient = 0.5;
  SceneOptions options;
  options.method = SteppingMethod::kTimeStepping;
  options.duration = seconds;
  options.step_length = options.sample_interval = 1e-3;
  out.run = simulate_scene(out.scene, options);
  return out;
}

/// What the floor bears at an instant [N].
double borne(const SceneSample& at) {
  double force = 0;
  for (const ContactSample& contact : at.contacts) force += std::abs(contact.force.z());
  return force;
}

// A ball that lands stays where it landed, borne with its weight from the third step on.
TEST(SimulateScene, FixedStepsDoNotBounce) {
  for (const double height : {1e-4, 1e-3, 0.02, 0.1, 0.5}) {
    SCOPED_TRACE(height);
    Pose<double> X;
    X.p.z() = 0.02 + height;
    const Fall ball = fall(primitive(ShapeKind::kSphere, {0.02, 0.02, 0.02}), X, 0.6);
    const std::vector<SceneSample>& samples = ball.run.samples;
    const auto lands = std::find_if(samples.begin(), samples.end(),
                                    [](const SceneSample& at) { return borne(at) > 0; });
    ASSERT_NE(lands, samples.end());
    EXPECT_NEAR(lands->t, std::sqrt(2 * height / kG), 2.1e-3);
    for (auto at = lands + 3; at < samples.end(); ++at) {
      EXPECT_NEAR(centre(ball.scene, ball.body, *at).z(), 0.02, 1e-12);
      EXPECT_NEAR(borne(*at), 0.1 * kG, 1e-8);
      EXPECT_LT(at->v.norm(), 1e-9);
    }
  }
}

// A box that falls on a corner rocks until it lies; then nothing alternates from step to step.
TEST(SimulateScene, FixedStepsComeToRest) {
  Pose<double> X;
  X.p.z() = 0.06;
  X.R = (Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitX()) *
         Eigen::AngleAxisd(0.2, Eigen::Vector3d::UnitY()))
            .toRotationMatrix();
  const Fall box = fall(primitive(ShapeKind::kBox, {0.06, 0.05, 0.04}), X, 2);
  const std::vector<SceneSample>& samples = box.run.samples;
  EXPECT_NEAR(centre(box.scene, box.body, samples.back()).z(), 0.02, 1e-9);
  for (auto at = samples.end() - 100; at < samples.end(); ++at) {
    EXPECT_NEAR(borne(*at), 0.1 * kG, 1e-6);
    EXPECT_LT(at->v.norm(), 1e-6);
  }
}

// Eleven contacts have more rows than ball, palm and fingers have freedoms. What a step of 10 ms
// leaves of its problem is within the solver's own tolerance, as gaps are known to a rounding of
// 2e-16 m and ask for 4e-14 m/s, 4e-13 of the 0.1 m/s that gravity gives in a step.
TEST(SimulateScene, FixedStepsLeaveNothingToTheNextOne) {
  SceneOptions options;
  options.duration = 0.3;
  options.method = SteppingMethod::kTimeStepping;
  options.step_length = 1e-2;
  const SceneRun run = simulate_scene(sample::ball_in_hand().scene, options);
  EXPECT_EQ(run.status, SceneStatus::kDone);
  EXPECT_LE(run.cost.worst_residual, options.contacts.tolerance);
}

// Friction that turns round within a step: a cube on a dry slide, pushed back while it flies forth.
TEST(SimulateScene, FrictionOfAJointThatTurnsRound) {
  MovingScene scene;
  scene.gravity.setZero();
  const double mass = 0.2, friction = 0.3, force = 3, speed = 1, seconds = 0.6;
  sample::add_on_joint(scene, "cube", sample::primitive(ShapeKind::kBox, {0.1, 0.1, 0.1}), mass,
                       JointKind::kSlide, {1, 0, 0}, {0, 0, 0});
  scene.mechanism.joints[0].friction = friction;
  scene.forces.push_back({0, {0, 0, 0}, {force, 0, 0}, {0, 0, 0}, {}});
  scene.v[0] = -speed;
  // Slower by (force + friction) / mass until it stands, then faster by their difference.
  const double back = (force + friction) / mass, forth = (force - friction) / mass;
  const double rest = seconds - speed / back;
  const double x = -0.5 * speed * speed / back + 0.5 * forth * rest * rest;
  for (const double sample_time : {0.01, 0.6}) {
    SceneOptions options;
    options.duration = seconds;
    options.sample_interval = sample_time;
    options.tolerance = 1e-9;
    const SceneRun run = simulate_scene(scene, options);
    EXPECT_EQ(run.status, SceneStatus::kDone);
    EXPECT_NEAR(run.samples.back().q[0], x, 1e-8) << sample_time;
    EXPECT_NEAR(run.samples.back().v[0], forth * rest, 1e-7) << sample_time;
  }
}

// The same of a contact: a cube thrown up a slope, which it slides down again.
TEST(SimulateScene, FrictionOfAContactThatTurnsRound) {
  const double slope = 30 * kDegree, friction = 0.3, speed = 1, seconds = 0.6;
  const double up = kG * (std::sin(slope) + friction * std::cos(slope));
  const double down = kG * (std::sin(slope) - friction * std::cos(slope));
  const double rest = seconds - speed / up;
  const double way = -0.5 * speed * speed / up + 0.5 * down * rest * rest;
  for (const double sample_time : {0.01, 0.6}) {
    sample::Incline world = sample::incline(slope, friction);
    const Eigen::Vector3d downhill(std::cos(slope), 0, -std::sin(slope));
    world.scene.v.tail<3>() = -speed * downhill;
    const Eigen::Vector3d start = world.scene.q.tail<3>();
    SceneOptions options;
    options.duration = seconds;
    options.sample_interval = sample_time;
    options.tolerance = 1e-9;
    const SceneRun run = simulate_scene(world.scene, options);
    EXPECT_EQ(run.status, SceneStatus::kDone);
    const Eigen::Vector3d end = run.samples.back().q.tail<3>();
    // A step that begins without impulses of the last one, as after an event, cannot tell that it
    // turned: 1.1e-6 m are left of what was 1.1 mm.
    EXPECT_NEAR((end - start).dot(downhill), way, sample_time < 0.1 ? 1e-8 : 2e-6) << sample_time;
  }
}

// The error of steps between events follows the tolerance.
TEST(SimulateScene, ErrorFollowsTheTolerance) {
  const sample::Pinch world = swinging_pinch();
  SceneOptions options;
  options.duration = 1;
  options.tolerance = 1e-13;
  const double exact = swing(world, simulate_scene(world.scene, options).samples.back());
  for (const double tolerance : {1e-7, 1e-9, 1e-11}) {
    options.tolerance = tolerance;
    const double error =
        std::abs(swing(world, simulate_scene(world.scene, options).samples.back()) - exact);
    EXPECT_LT(error, 1000 * tolerance);
  }
}

}  // namespace
}  // namespace thenar
