// Tests for live/live_motion.cpp, motion_history.cpp, scene_picture.cpp and motion_source.cpp.

#include "live/live_motion.h"

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "tests/data_folder.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

using testing::HasSubstr;

MotionSource scene_called(const std::string& name) {
  SceneRequest request;
  request.scene = name;
  request.data = kData;
  return scene_motion(request);
}

MotionSource world_called(const std::string& name, WorldDrives drives = WorldDrives::kHold) {
  return world_motion(read_world(kData + "/worlds/" + name + ".toml"), kData, drives);
}

/// Effort that a coordinate is given, everything else as it is.
MotionInputs effort(const std::string& coordinate, double value) {
  MotionInputs inputs;
  inputs.efforts[coordinate] = value;
  return inputs;
}

TEST(LiveMotion, InstantsFitTheirShape) {
  for (const char* name : {"wine_glass", "mug_lift", "thumb_mug", "pinch", "stack"}) {
    SCOPED_TRACE(name);
    LiveMotion motion(scene_called(name));
    EXPECT_NO_THROW(check_instant(motion.shape(), motion.instant()));
    const unsigned long changes = motion.changes();
    const MotionQuality quality = motion.step(40, {});
    EXPECT_EQ(quality.steps, 40);
    EXPECT_GT(motion.changes(), changes);
    const LiveInstant instant = motion.instant();
    EXPECT_NO_THROW(check_instant(motion.shape(), instant));
    EXPECT_NEAR(instant.time, 40 * motion.live_time().step, 1e-12);
    int meshes = 0;
    for (const LiveBody& body : motion.shape().bodies) meshes += body.mesh ? 1 : 0;
    EXPECT_GT(meshes, 1);
  }
}

TEST(LiveMotion, ShapeSaysWhatThingsAre) {
  const LiveMotion motion(scene_called("wine_glass"));
  std::map<std::string, LiveBody> bodies;
  for (const LiveBody& body : motion.shape().bodies) bodies[body.name] = body;
  EXPECT_EQ(bodies.at("glass").role, LiveRole::kObject);
  EXPECT_EQ(bodies.at("table").role, LiveRole::kObstacle);
  int links = 0, digits = 0;
  for (const auto& [name, body] : bodies) {
    if (body.owner != "barrett") continue;
    EXPECT_EQ(body.role, LiveRole::kLink);
    ++links;
    digits += body.digit.empty() ? 0 : 1;
  }
  EXPECT_GE(links, 7);
  EXPECT_GE(digits, 6);
  // A finger's motor leads its joints.
  int leaders = 0, led = 0;
  for (const LiveJoint& joint : motion.shape().joints) {
    if (joint.name == "barrett/finger 1") ++leaders;
    if (joint.led_by == "barrett/finger 1") ++led;
  }
  EXPECT_EQ(leaders, 1);
  EXPECT_EQ(led, 1);
}

// As seen from what carries it, a body turns about the axis that is drawn, by what the joint says.
TEST(LiveMotion, JointsTurnAboutTheirDrawnAxes) {
  LiveMotion motion(scene_called("wine_glass"));
  const Mechanism& mechanism = motion.scene().mechanism;
  std::map<std::string, std::size_t> shown;
  for (std::size_t i = 0; i < motion.shape().bodies.size(); ++i)
    shown[motion.shape().bodies[i].name] = i;
  const LiveInstant before = motion.instant();
  motion.step(200, {});
  const LiveInstant after = motion.instant();
  int turned = 0;
  for (std::size_t k = 0; k < motion.shape().joints.size(); ++k) {
    const LiveJoint& joint = motion.shape().joints[k];
    const auto body = static_cast<std::size_t>(joint.body);
    const int parent = mechanism
                           .joints[static_cast<std::size_t>(
                               body_named(mechanism, motion.shape().bodies[body].name))]
                           .parent;
    ASSERT_GE(parent, 0);
    const std::size_t on = shown.at(mechanism.bodies[static_cast<std::size_t>(parent)].name);
    const Pose<double> then = before.bodies[on].inverse() * before.bodies[body];
    const Pose<double> now = after.bodies[on].inverse() * after.bodies[body];
    EXPECT_LT((now * joint.point - then * joint.point).norm(), 1e-12);
    EXPECT_LT((now.R * joint.axis - then.R * joint.axis).norm(), 1e-12);
    const Eigen::AngleAxisd turn(then.R.transpose() * now.R);
    const double angle = turn.angle() * (turn.axis().dot(joint.axis) > 0 ? 1 : -1);
    if (!joint.led_by.empty() || joint.name.find("finger") == std::string::npos) {
      EXPECT_NEAR(angle, after.joints[k] - before.joints[k], 1e-9);
    }
    turned += std::abs(angle) > 0.01 ? 1 : 0;
  }
  EXPECT_GE(turned, 6);
}

TEST(LiveMotion, ShowsThePastAndGoesOnFromThere) {
  LiveMotion motion(scene_called("pinch"));
  motion.step(100, {});
  const Eigen::VectorXd end = motion.shown_instant().state.q;
  EXPECT_NEAR(motion.seek(0.0403), 0.040, 1e-12);
  EXPECT_FALSE(motion.is_newest());
  EXPECT_NEAR(motion.instant().time, 0.040, 1e-12);
  // Looking forgets nothing.
  EXPECT_NEAR(motion.seek(5), 0.1, 1e-12);
  EXPECT_EQ(motion.shown_instant().state.q, end);
  // Stepping does.
  (void)motion.seek(0.04);
  motion.step(10, {});
  EXPECT_NEAR(motion.live_time().t, 0.05, 1e-12);
  EXPECT_NEAR(motion.seek(5), 0.05, 1e-12);
  EXPECT_EQ(motion.history().size(), 51u);
  motion.reset();
  EXPECT_EQ(motion.history().size(), 1u);
  EXPECT_EQ(motion.live_time().t, 0);
}

// What is asked in between changes no bit of what follows.
TEST(LiveMotion, LookingChangesNothing) {
  LiveMotion asked(scene_called("swinging_pinch")), left(scene_called("swinging_pinch"));
  for (int i = 0; i < 50; ++i) {
    asked.step(2, {});
    (void)asked.instant();
    (void)asked.state({true, true, true, true, true});
    left.step(2, {});
  }
  EXPECT_EQ(asked.shown_instant().state.q, left.shown_instant().state.q);
  EXPECT_EQ(asked.shown_instant().state.v, left.shown_instant().state.v);
}

TEST(LiveMotion, MemoryOfThePastIsBounded) {
  LiveMotion motion(scene_called("pinch"), {1000, std::size_t{64} << 20});
  motion.step(2000, {});
  const std::size_t bytes = motion.history().bytes();
  motion.step(98000, {});
  EXPECT_EQ(motion.history().size(), 1000u);
  EXPECT_LE(motion.history().bytes(), bytes + bytes / 10);
  // The oldest instant that is kept is the nearest to the start.
  EXPECT_NEAR(motion.seek(0), 100 - 0.999, 1e-9);
}

TEST(LiveMotion, RoomOfThePastIsBoundedInBytes) {
  LiveMotion motion(scene_called("pinch"), {20000, 100000});
  motion.step(3000, {});
  EXPECT_LE(motion.history().bytes(), 110000u);
  EXPECT_GT(motion.history().size(), 20u);
}

TEST(LiveMotion, TellsWhatBecameOfEnergy) {
  LiveMotion motion(scene_called("pinch"));
  motion.set(effort("left", 6));
  motion.step(300, {});
  const TimelineState state = motion.state({false, false, false, true, false});
  ASSERT_TRUE(state.energy && state.energy->balance);
  EXPECT_GT(state.energy->balance->work, 0);
  EXPECT_NEAR(state.energy->balance->error, 0, 1e-6 * state.energy->balance->work);
}

TEST(LiveMotion, InfiniteEffortsStopAtTheLastGoodInstant) {
  MotionSource source = scene_called("pinch");
  BuiltScene blown = *source.built;
  SceneDrive drive;
  drive.coordinate = 0;
  drive.bias = -1e307;
  drive.when.from = 0.02;
  blown.scene.drives.push_back(drive);
  source.built = std::make_shared<const BuiltScene>(blown);
  LiveMotion motion(source);
  motion.play(1);
  EXPECT_THAT(message_of([&] { (void)motion.step(5000, {}); }), HasSubstr("finite"));
  EXPECT_FALSE(motion.live_time().playing);
  EXPECT_TRUE(motion.shown_instant().state.q.allFinite());
  EXPECT_NO_THROW(check_instant(motion.shape(), motion.instant()));
  motion.reset();
  EXPECT_EQ(motion.step(10, {}).steps, 10);
}

TEST(LiveMotion, PlayPausesOnceWhereTheSceneEnds) {
  LiveMotion motion(scene_called("pinch"));
  const double end = motion.live_time().duration.value();
  EXPECT_EQ(end, 10);  // duration_s of the file
  motion.play(1);
  EXPECT_EQ(motion.step(9900, {}).steps, 9900);
  EXPECT_TRUE(motion.live_time().playing);
  EXPECT_EQ(motion.step(400, {}).steps, 100);
  EXPECT_FALSE(motion.live_time().playing);
  EXPECT_NEAR(motion.live_time().t, end, 1e-9);
  // Told to, it goes on; steps that are asked for do not pause either.
  motion.play(1);
  EXPECT_EQ(motion.step(400, {}).steps, 400);
  EXPECT_TRUE(motion.live_time().playing);
  motion.reset();
  EXPECT_EQ(motion.step(700, {}).steps, 700);
  // Worlds have no end.
  EXPECT_FALSE(LiveMotion(world_called("jaw_box")).live_time().duration);
}

TEST(LiveMotion, RefusesInputsThatAreMistakes) {
  LiveMotion motion(scene_called("pinch"));
  for (const double value : {1e308, -10001.0, std::nan(""), -HUGE_VAL})
    EXPECT_THAT(message_of([&] { motion.set(effort("left", value)); }),
                HasSubstr("effort of 'left': wanted a number within 10000 N m or N, got"));
  EXPECT_NO_THROW(motion.set(effort("left", 1e4)));
  // A target beyond the limits of a joint presses against its stop.
  LiveMotion held(world_called("jaw_box"));
  EXPECT_NO_THROW(held.set({{}, {{"parallel_jaw/opening", 1}}, {}, {}, {}}));
  EXPECT_THAT(message_of([&] {
                held.set({{}, {{"parallel_jaw/opening", -1001}}, {}, {}, {}});
              }),
              HasSubstr("wanted a number within 1000 rad or m, got -1001"));
  // Steps under twenty thousand newtons do not end, nor hear that they are to stop.
  LiveMotion pulled(scene_called("human_cylinder"));
  const std::string muscle = "human:skewed/thumb/EPL";
  for (const double value : {-1.0, 5001.0, 1e308, std::nan("")})
    EXPECT_THAT(message_of([&] {
                  pulled.set({{}, {}, {{muscle, value}}, {}, {}});
                }),
                HasSubstr("must be 0 to 5000 N, got"));
  EXPECT_NO_THROW(pulled.set({{}, {}, {{muscle, 5000}}, {}, {}}));
}

// What was driven then, whatever is set now.
TEST(LiveMotion, EffortsOfThePastStay) {
  LiveMotion motion(scene_called("pinch"));
  const auto told = [&] { return motion.state({true, false, false, false, false}).joints; };
  motion.set(effort("left", 6));
  motion.step(10, {});
  motion.set(effort("left", 2));
  EXPECT_EQ(told()[0].name, "left");
  EXPECT_EQ(told()[0].effort, 2);  // of the step to come
  motion.step(10, {});
  (void)motion.seek(0.005);
  EXPECT_EQ(told()[0].effort, 6);
  motion.set(effort("left", 3));
  EXPECT_EQ(told()[0].effort, 6);
  (void)motion.seek(0.015);
  EXPECT_EQ(told()[0].effort, 2);
  motion.step(1, {});
  EXPECT_EQ(told()[0].effort, 3);
}

TEST(LiveMotion, NamesWhatCanBeSet) {
  LiveMotion motion(scene_called("wine_glass"));
  int efforts = 0, targets = 0;
  for (const MotionInput& input : motion.inputs()) {
    efforts += input.kind == MotionInputKind::kEffort ? 1 : 0;
    targets += input.kind == MotionInputKind::kTarget ? 1 : 0;
    EXPECT_LE(input.lower, input.upper);
  }
  EXPECT_EQ(efforts, 3);
  EXPECT_EQ(targets, 3);
  EXPECT_THAT(message_of([&] { motion.set(effort("barrett/finger 4", 1)); }),
              HasSubstr("no coordinate 'barrett/finger 4', did you mean 'barrett/finger"));
}

// Worlds.

TEST(LiveMotion, HandsOfAWorldHoldWhereTheyStand) {
  for (const char* name : {"barrett_bobbin", "jaw_box", "arm_cube"}) {
    SCOPED_TRACE(name);
    LiveMotion motion(world_called(name));
    const TimelineState before = motion.state({true, false, false, false, false});
    const MotionQuality quality = motion.step(500, {});
    EXPECT_EQ(quality.unsolved, 0);
    const TimelineState after = motion.state({true, false, false, false, false});
    ASSERT_EQ(before.joints.size(), after.joints.size());
    for (std::size_t i = 0; i < after.joints.size(); ++i)
      EXPECT_NEAR(after.joints[i].value, before.joints[i].value, 1e-3) << after.joints[i].name;
  }
}

// What stands on nothing falls, what is an obstacle stays.
TEST(LiveMotion, ObjectsOfAWorldFall) {
  WorldSpec world;
  world.name = "ball";
  PlacedBody ball;
  ball.body.name = "ball";
  ShapeSpec shape;
  shape.kind = ShapeKind::kSphere;
  shape.size = {0.02, 0, 0};
  ball.body.shapes = {shape};
  ball.body.material = "wood";
  PlacedBody post = ball;
  post.body.name = "post";
  post.dynamic = false;
  post.X_WB.p = {0.5, 0, 0};
  PlacedBody strange = ball;
  strange.body.name = "strange";
  strange.body.material.clear();
  strange.X_WB.p = {1, 0, 0};
  world.bodies = {ball, post, strange};
  const MotionSource source = world_motion(world, kData, WorldDrives::kHold);
  EXPECT_THAT(source.warnings, testing::Contains(HasSubstr("density of water")));
  LiveMotion motion(source);
  motion.step(100, {});
  const LiveInstant instant = motion.instant();
  EXPECT_NEAR(instant.bodies[0].p.z(), -0.5 * 9.81 * 0.01, 1e-9);
  EXPECT_EQ(instant.bodies[1].p.z(), 0);
  EXPECT_NEAR(instant.bodies[2].p.z(), -0.5 * 9.81 * 0.01, 1e-9);
}

TEST(LiveMotion, TendonsOfAWorldPull) {
  LiveMotion motion(world_called("human_mug", WorldDrives::kTendons));
  MotionInputs inputs;
  for (const MotionInput& input : motion.inputs())
    if (input.kind == MotionInputKind::kTension && input.name.find("FDP3") != std::string::npos)
      inputs.tensions[input.name] = 4;
  ASSERT_FALSE(inputs.tensions.empty());
  LiveMotion slack(world_called("human_mug", WorldDrives::kTendons));
  motion.set(inputs);
  motion.step(30, {});
  slack.step(30, {});
  const auto angle = [](const LiveMotion& of) {
    for (const CoordinateState& joint : of.state({true, false, false, false, false}).joints)
      if (joint.name.find("PIP3") != std::string::npos) return joint.value;
    return std::nan("");
  };
  EXPECT_GT(angle(motion), angle(slack) + 1e-4);
  bool told = false;
  for (const ElementValue& value : motion.state({false, false, false, false, true}).muscles)
    told = told || (value.name == inputs.tensions.begin()->first && value.value >= 4);
  EXPECT_TRUE(told);
}

// What is seen live is what `simulate --method time-stepping` computes, to the last bit.
TEST(LiveMotion, StepsAreThoseOfSimulatedScenes) {
  for (const char* name : {"wine_glass", "mug_lift"}) {
    SCOPED_TRACE(name);
    LiveMotion motion(scene_called(name));
    SceneRequest request;
    request.scene = name;
    request.data = kData;
    request.method = SteppingMethod::kTimeStepping;
    request.step = motion.live_time().step;
    request.seconds = 0.2;
    const SceneResult wanted = simulate_scene(request);
    const MotionQuality quality = motion.step(std::lround(0.2 / motion.live_time().step), {});
    EXPECT_EQ(motion.shown_instant().state.q, wanted.run.samples.back().q);
    EXPECT_EQ(motion.shown_instant().state.v, wanted.run.samples.back().v);
    EXPECT_EQ(quality.leaps, 0);
    EXPECT_EQ(quality.worst_residual, wanted.run.cost.worst_residual);
    ASSERT_TRUE(quality.balance.has_value());
    EXPECT_EQ(quality.balance->error, wanted.measures.balance->error);
    EXPECT_EQ(quality.balance->turned_over, wanted.measures.balance->turned_over);
    EXPECT_EQ(motion.quality().balance->error, quality.balance->error);
  }
}

// A ball that would bounce lies: its energy balances, as a landing is a loss, and what is left out
// is told.
TEST(LiveMotion, TellsRestitutionThatStepsLeaveOut) {
  LiveMotion motion(scene_called("falling_ball"));
  const MotionQuality quality = motion.step(300, {});
  EXPECT_DOUBLE_EQ(quality.restitution, 0.8);
  EXPECT_TRUE(quality.balance->holds());
  EXPECT_GT(quality.balance->impacts, 0.09);
  EXPECT_TRUE(quality.limits.empty());
  EXPECT_EQ(LiveMotion(scene_called("pinch")).quality().restitution, 0);
}

TEST(LiveMotion, WarnsOfPadsOfElements) {
  SceneRequest request;
  request.scene = "soft_jaws";
  request.data = kData;
  for (const std::string pads : {"elements", "hard-point"}) {
    request.pads = pads;
    const std::vector<std::string> warnings = LiveMotion(scene_motion(request)).warnings();
    EXPECT_EQ(std::count_if(warnings.begin(), warnings.end(),
                            [](const std::string& text) {
                              return text.find("finite elements") != std::string::npos;
                            }),
              pads == "elements" ? 1 : 0);
  }
}

}  // namespace
}  // namespace thenar
