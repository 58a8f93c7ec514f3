#include "api/scenes/scene_builder.h"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "api/scenes/simulate_scene.h"
#include "api/scenes/write_scene_run.h"
#include "base/error.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

using ::testing::HasSubstr;

TEST(SceneBuilder, LetsABallFallFreely) {
  SceneBuilder scene("fall");
  scene.add_ball("ball", 0.02, 0.1, {0.3, -0.2, 2}).velocity.linear = {1, 0, 0.5};
  scene.spec().stepping.duration = 0.5;
  const SceneResult fall = simulate_scene(scene.spec());
  ASSERT_EQ(fall.run.status, SceneStatus::kDone);
  // Ballistics: x = x0 + v t, z = z0 + v t - g t^2 / 2.
  for (std::size_t i = 0; i < fall.run.samples.size(); ++i) {
    const double t = fall.run.samples[i].t;
    const Eigen::Vector3d p = fall.measures.X_WB[i][0].p;
    EXPECT_NEAR(p.x(), 0.3 + t, 1e-12);
    EXPECT_NEAR(p.y(), -0.2, 1e-15);
    EXPECT_NEAR(p.z(), 2 + 0.5 * t - 9.81 * t * t / 2, 1e-12);
  }
}

TEST(SceneBuilder, GivesTheBitsOfAFile) {
  // data/scenes/falling_ball.toml, built in a program.
  SceneBuilder scene("falling_ball");
  scene.add_body(make_body("floor", box_shape({0.4, 0.4, 0.02}), 0, "stone"), {0, 0, -0.01})
      .joint.kind = JointKind::kWeld;
  scene.add_body(make_body("ball", ball_shape(0.02), 0.1, "rubber"), {0, 0, 0.12});
  scene.spec().frictions.push_back({{"floor", "ball"}, {}, {}, 0.8});
  scene.spec().stepping.duration = 0.6;
  const SceneResult built = simulate_scene(scene.spec());
  SceneRequest request;
  request.scene = "falling_ball";
  const SceneResult read = simulate_scene(request);
  ASSERT_EQ(built.run.samples.size(), read.run.samples.size());
  for (std::size_t i = 0; i < read.run.samples.size(); ++i) {
    EXPECT_EQ(built.run.samples[i].q, read.run.samples[i].q) << i;
    EXPECT_EQ(built.run.samples[i].v, read.run.samples[i].v) << i;
  }
}

TEST(SceneBuilder, PutsABoxToRestOnTheFloor) {
  SceneBuilder scene("rest");
  scene.add_floor(0.1);
  scene.add_box("box", {0.06, 0.04, 0.02}, 0.2, {0, 0, 0.15});
  scene.set_contact(0.7);
  scene.set_contact(0.5);
  EXPECT_EQ(scene.spec().frictions.size(), 1u);
  scene.spec().stepping.duration = 1;
  const SceneResult rest = simulate_scene(scene.spec());
  // Its centre is half of its height above the floor, and it does not move.
  EXPECT_NEAR(rest.measures.X_WB.back()[1].p.z(), 0.11, 1e-6);
  EXPECT_LT(rest.measures.velocity[1].linear.norm(), 1e-6);
}

TEST(SceneBuilder, RefusesWhatMakesNoScene) {
  EXPECT_THAT(message_of([] { SceneBuilder(""); }), HasSubstr("wanted the name of a scene"));
  SceneBuilder scene("errors");
  scene.add_floor();
  EXPECT_THAT(message_of([&] { scene.add_floor(1); }), HasSubstr("'floor' is there already"));
  EXPECT_THAT(message_of([&] { scene.add_hand("floor"); }), HasSubstr("'floor' is there already"));
  EXPECT_THAT(message_of([&] {
                scene.add_ball("ball", -1, 0.1, {0, 0, 0});
              }),
              HasSubstr("wanted a size of 'ball' above 0"));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(message_of([&] {
                scene.add_ball("ball", 0.1, 0.1, {0, nan, 0});
              }),
              HasSubstr("wanted a place of 'ball'"));
  scene.add_hand("no_such_hand");
  EXPECT_THAT(message_of<DataError>([&] { (void)simulate_scene(scene.spec()); }),
              HasSubstr("errors:1: there is no hand 'no_such_hand'"));
}

TEST(SceneBuilder, RefusesPartsThatDoNotFitTogether) {
  const auto message_of_run = [](const SceneBuilder& scene) {
    return message_of<DataError>([&] { (void)simulate_scene(scene.spec()); });
  };
  EXPECT_THAT(message_of_run(SceneBuilder("empty")), HasSubstr("something that moves"));
  // Two bodies that hang on each other, one on nothing, and two of one name.
  SceneBuilder ring("ring");
  ring.add_ball("a", 0.1, 1, {0, 0, 0}).joint.parent = "b";
  ring.add_ball("b", 0.1, 1, {1, 0, 0}).joint.parent = "a";
  EXPECT_THAT(message_of_run(ring), HasSubstr("lead back to themselves"));
  SceneBuilder lost("lost");
  lost.add_ball("a", 0.1, 1, {0, 0, 0}).joint.parent = "c";
  EXPECT_THAT(message_of_run(lost), HasSubstr("there is no body or hand 'c'"));
  SceneBuilder twins("twins");
  twins.add_ball("a", 0.1, 1, {0, 0, 0});
  twins.add_ball("b", 0.1, 1, {1, 0, 0}).placed.body.name = "a";
  EXPECT_THAT(message_of_run(twins), HasSubstr("two things are called 'a'"));
}

TEST(SceneBuilder, KeepsNoFileOfARunWithoutAScene) {
  SceneBuilder scene("fall");
  scene.add_ball("ball", 0.02, 0.1, {0, 0, 1});
  scene.spec().stepping.duration = 0.01;
  const SceneResult run = simulate_scene(scene.spec());
  EXPECT_THAT(message_of([&] { write_scene_run(run, "fall.h5"); }),
              HasSubstr("scene 'fall' has no file"));
}

}  // namespace
}  // namespace thenar
