// Tests for live/recorded_motion.cpp and api/scenes/read_scene_run.cpp.

#include "live/recorded_motion.h"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "api/scenes/write_scene_run.h"
#include "base/file_io.h"
#include "data/io/result_file.h"
#include "tests/data_folder.h"
#include "tests/live/changed_result.h"
#include "tests/message_of.h"
#include "tests/temporary_folder.h"

namespace thenar {
namespace {

using testing::HasSubstr;

class RecordedRunFile : public TemporaryFolder {
 protected:
  /// Simulates a scene for a while and writes the run.
  SceneResult record(const std::string& scene, double seconds, const std::string& file) const {
    SceneRequest request;
    request.scene = scene;
    request.data = kData;
    request.seconds = seconds;
    SceneResult run = simulate_scene(request);
    write_scene_run(run, path(file));
    return run;
  }
  [[nodiscard]] RecordedScene read(const std::string& file) const {
    return read_scene_run(path(file), kData);
  }
  /// What reading says once something in the file is another one.
  template <typename Change>
  std::string trouble_with(const Change& change) const {
    return trouble_with_change(path("run.h5"), path("changed.h5"), change,
                               [](const std::string& file) { (void)read_scene_run(file, kData); });
  }
};

TEST_F(RecordedRunFile, HoldsTheInstantsOfTheRun) {
  for (const char* scene : {"pinch", "wine_glass", "loose_joint"}) {
    SCOPED_TRACE(scene);
    const SceneResult run = record(scene, 0.05, "run.h5");
    const RecordedScene got = read("run.h5");
    EXPECT_EQ(got.name, scene);
    ASSERT_EQ(got.samples.size(), run.run.samples.size());
    for (std::size_t i = 0; i < got.samples.size(); ++i) {
      const SceneSample &a = got.samples[i], &b = run.run.samples[i];
      EXPECT_EQ(a.t, b.t);
      EXPECT_EQ(a.q, b.q);
      EXPECT_EQ(a.v, b.v);
      ASSERT_EQ(a.contacts.size(), b.contacts.size());
      for (std::size_t k = 0; k < a.contacts.size(); ++k) {
        EXPECT_EQ(a.contacts[k].force, b.contacts[k].force);
        EXPECT_EQ(a.contacts[k].mode, b.contacts[k].mode);
      }
    }
    EXPECT_EQ(got.steps, run.run.cost.steps);
    EXPECT_EQ(got.worst_residual, run.run.cost.worst_residual);
    ASSERT_TRUE(got.balance.has_value());
    EXPECT_EQ(got.balance->error, run.measures.worst->error);
    EXPECT_EQ(got.balance->turned_over, run.measures.worst->turned_over);
    EXPECT_TRUE(got.limits.empty());
    RecordedMotion motion(got);
    EXPECT_EQ(motion.quality().balance->error, got.balance->error);
    EXPECT_NO_THROW(check_instant(motion.shape(), motion.instant()));
    EXPECT_EQ(motion.seek(10), run.run.samples.back().t);
    EXPECT_NO_THROW(check_instant(motion.shape(), motion.instant()));
  }
}

TEST_F(RecordedRunFile, HoldsTheLimitsThatJointsWentBeyond) {
  SceneRequest request;
  request.scene = "pinch";
  request.data = kData;
  request.seconds = 0.01;
  SceneResult run = simulate_scene(request);
  run.run.cost.limit_excess[0] = 0.25;
  write_scene_run(run, path("limits.h5"));
  const RecordedScene got = read("limits.h5");
  ASSERT_EQ(got.limits.size(),
            passed_limits(run.built->scene.mechanism, run.run.cost.limit_excess).size());
  ASSERT_EQ(got.limits.size(), 1U);
  EXPECT_EQ(got.limits[0].joint, run.built->scene.mechanism.joints[0].name);
  EXPECT_EQ(got.limits[0].excess, 0.25);
}

// Files of before 0.2 name no rung of tendon paths: they were straight.
TEST_F(RecordedRunFile, IsBuiltAgainOnThePathsOfItsRun) {
  const auto path_without = [&](const char* key) {
    ResultFile file = read_result(path("run.h5"));
    file.texts.erase(key);
    write_result(file, path("old.h5"));
    return read("old.h5").path;
  };
  (void)record("pendulum", 0.05, "run.h5");
  EXPECT_EQ(read("run.h5").path, std::nullopt);
  EXPECT_EQ(path_without("rungs/path"), Path::kViaPoint);
  SceneRequest request;
  request.scene = "pendulum";
  request.data = kData;
  request.seconds = 0.05;
  request.path = Path::kWrapped;
  write_scene_run(simulate_scene(request), path("run.h5"));
  EXPECT_EQ(read("run.h5").path, Path::kWrapped);
}

TEST_F(RecordedRunFile, HandsTakeThePathsThatAreAskedForUnlessTheyNameOthers) {
  const auto path_of = [&](const std::string& name, const std::optional<Path>& asked) {
    const std::string file = path("hand.toml");
    write_file(file,
               "name = \"hand\"\nsource = \"Scene\"\n[sources]\nScene = \"Arranged\"\n"
               "[[hand]]\nname = \"" +
                   name + "\"\n[stepping]\nduration_s = 1\n");
    SceneSpec spec = read_scene(file);
    const std::vector<SceneHand> hands = hands_of_scene(spec, kData, spec.files, asked);
    return std::get<HumanModel>(hands.front()).options.path;
  };
  EXPECT_EQ(path_of("human:skewed", {}), std::nullopt);
  EXPECT_EQ(path_of("human:skewed", Path::kViaPoint), Path::kViaPoint);
  EXPECT_EQ(path_of("human:tendons:wrapped", Path::kViaPoint), Path::kWrapped);
}

// Half way between two instants of a fall a body is half way between their places.
TEST_F(RecordedRunFile, ShowsWhatIsBetweenInstants) {
  const SceneResult run = record("falling_ball", 0.1, "run.h5");
  RecordedMotion motion(read("run.h5"));
  const double a = run.run.samples[3].t, b = run.run.samples[4].t;
  std::vector<double> heights;
  for (const double t : {a, 0.5 * (a + b), b}) {
    EXPECT_DOUBLE_EQ(motion.seek(t), t);
    const LiveInstant instant = motion.instant();
    EXPECT_DOUBLE_EQ(instant.time, t);
    for (std::size_t i = 0; i < motion.shape().bodies.size(); ++i)
      if (motion.shape().bodies[i].role == LiveRole::kObject)
        heights.push_back(instant.bodies[i].p.z());
  }
  ASSERT_EQ(heights.size(), 3u);
  EXPECT_GT(heights[0], heights[2]);
  EXPECT_NEAR(heights[1], 0.5 * (heights[0] + heights[2]), 1e-12);
}

// A free fall between instants: speed -g t, and as much kinetic energy as weight has lost.
TEST_F(RecordedRunFile, SpeedsAndEnergiesGoOnBetweenInstants) {
  const SceneResult run = record("falling_ball", 0.1, "run.h5");
  RecordedMotion motion(read("run.h5"));
  const double a = run.run.samples[3].t, b = run.run.samples[4].t;
  const TimelineState start = motion.state({false, false, false, true, false});
  for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    const double t = motion.seek(a + share * (b - a));
    const TimelineState state = motion.state({false, true, false, true, false});
    const auto ball = std::find_if(state.bodies.begin(), state.bodies.end(),
                                   [](const BodyState& body) { return body.name == "ball"; });
    ASSERT_NE(ball, state.bodies.end());
    EXPECT_NEAR(ball->velocity.linear.z(), -9.81 * t, 1e-9) << share;
    EXPECT_NEAR(state.energy->total, start.energy->total, 1e-9) << share;
    EXPECT_EQ(state.energy->total,
              state.energy->kinetic + state.energy->weight + state.energy->springs);
  }
}

TEST_F(RecordedRunFile, PlaysToItsEnd) {
  (void)record("pendulum", 0.1, "run.h5");
  RecordedMotion motion(read("run.h5"));
  motion.play(1);
  EXPECT_TRUE(motion.live_time().recorded);
  EXPECT_EQ(motion.live_time().duration, 0.1);
  (void)motion.step(12, {});
  EXPECT_NEAR(motion.live_time().t, 0.05, 1e-12);
  EXPECT_TRUE(motion.live_time().playing);
  (void)motion.step(12, {});
  EXPECT_EQ(motion.live_time().t, 0.1);
  EXPECT_FALSE(motion.live_time().playing);
  motion.reset();
  EXPECT_EQ(motion.live_time().t, 0);
}

TEST_F(RecordedRunFile, RefusesWhatDoesNotFitTogether) {
  (void)record("pinch", 0.05, "run.h5");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(trouble_with([](ResultFile&) {}), "nothing was thrown");
  EXPECT_THAT(trouble_with(set_number("time", 2, nan)), HasSubstr("'time'"));
  EXPECT_THAT(trouble_with(set_number("time", 2, 0)), HasSubstr("does not rise"));
  EXPECT_THAT(trouble_with(set_number("position", 5, nan)),
              HasSubstr("'position': it has numbers"));
  EXPECT_THAT(trouble_with(set_number("position", 0, 9)), HasSubstr("not length 1"));
  EXPECT_THAT(trouble_with(set_number("contact_body_a", 0, 99)), HasSubstr("'contact_body_a'"));
  EXPECT_THAT(trouble_with(set_number("contact_body_b", 0, -1)), HasSubstr("'contact_body_b'"));
  EXPECT_THAT(trouble_with(set_number("contact_mode", 0, 0.5)), HasSubstr("'contact_mode'"));
  EXPECT_THAT(trouble_with(set_number("contact_instant", 0, 1e300)),
              HasSubstr("'contact_instant'"));
  EXPECT_THAT(trouble_with(set_number("body_position", 0, 1)), HasSubstr("is elsewhere now"));
  for (const char* key : {"time", "position", "speed", "energy", "body_position", "contact_force"})
    EXPECT_NE(trouble_with([&](ResultFile& file) { file.arrays.erase(key); }), "nothing was thrown")
        << key;
  EXPECT_THAT(trouble_with(set_text("format", "thenar motion 1")), HasSubstr("it is missing"));
  EXPECT_THAT(trouble_with(set_text("varied", "friction")), HasSubstr("'value': it is missing"));
  EXPECT_THAT(trouble_with([](ResultFile& file) { file.texts.at("name/body")[0] = "lid"; }),
              HasSubstr("its bodies are not those"));
  EXPECT_THAT(trouble_with(set_text("inputs/1/text", "name = 3")),
              HasSubstr("cannot be built again"));
  EXPECT_THAT(trouble_with([](ResultFile& file) { file.texts.erase("inputs/1/text"); }),
              HasSubstr("does not keep the text"));
}

}  // namespace
}  // namespace thenar
