// Tests for live/scene_tendons.cpp and strand_paths.cpp.

#include "live/scene_tendons.h"

#include <cmath>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "api/scenes/write_scene_run.h"
#include "live/live_motion.h"
#include "live/recorded_motion.h"
#include "tests/data_folder.h"
#include "tests/temporary_folder.h"

namespace thenar {
namespace {

SceneRequest closing_hand() {
  SceneRequest request;
  request.scene = "human_cylinder";
  request.data = kData;
  request.step = 2e-3;
  return request;
}

/// Entry of a shape's lines.
struct LineOf {
  std::size_t line = 0, first = 0;  // its first point
};
LineOf line_called(const LiveShape& shape, const std::string& name) {
  LineOf out;
  for (; out.line < shape.lines.size(); ++out.line) {
    if (shape.lines[out.line].name == name) return out;
    out.first += static_cast<std::size_t>(shape.lines[out.line].points);
  }
  ADD_FAILURE() << "no line " << name;
  return {};
}

std::size_t body_called(const LiveShape& shape, const std::string& name) {
  for (std::size_t i = 0; i < shape.bodies.size(); ++i)
    if (shape.bodies[i].name == name) return i;
  ADD_FAILURE() << "no body " << name;
  return 0;
}

// FDP inserts at the distal phalanx, FDS at the middle one: there a line goes where the bone goes,
// by fingers that close and by the hand that is lifted.
TEST(SceneTendons, EndOnTheirBonesWhileTheseMove) {
  LiveMotion motion(scene_motion(closing_hand()));
  const LiveShape& shape = motion.shape();
  const std::map<std::string, std::string> inserted{
      {"FDP2", "DP2"}, {"FDS2", "MP2"}, {"FDP5", "DP5"}, {"FPL", "DP1"}};
  const auto ends = [&] {
    const LiveInstant now = motion.instant();
    std::map<std::string, Eigen::Vector3d> out;
    for (const auto& [tendon, bone] : inserted)
      out[tendon] = now.bodies[body_called(shape, "human:skewed/" + bone)].inverse() *
                    now.line_points[line_called(shape, tendon).first];
    return out;
  };
  const LiveInstant start = motion.instant();
  const auto before = ends();
  (void)motion.step(250, {});
  const auto after = ends();
  for (const auto& [tendon, bone] : inserted) {
    EXPECT_LT((after.at(tendon) - before.at(tendon)).norm(), 1e-12) << tendon;
    // It lies in the flesh of the bone, and has moved.
    EXPECT_LT(before.at(tendon).norm(), 0.3);
    const std::size_t first = line_called(shape, tendon).first;
    EXPECT_GT((motion.instant().line_points[first] - start.line_points[first]).norm(), 5e-3)
        << tendon;
  }
}

// The file of tensions rises straight from 0 to 0.48 N within half a second.
TEST(SceneTendons, PullAsTheirMuscles) {
  LiveMotion motion(scene_motion(closing_hand()));
  const std::size_t line = line_called(motion.shape(), "FDP2").line;
  const std::size_t slack = line_called(motion.shape(), "EDC2").line;
  EXPECT_EQ(motion.instant().tensions[line], 0);
  (void)motion.step(50, {});
  EXPECT_NEAR(motion.instant().tensions[line], 0.48 * 0.1 / 0.5, 1e-12);
  EXPECT_EQ(motion.instant().tensions[slack], 0);
  // What is set holds from the next step on; the past stays as it was.
  MotionInputs inputs;
  inputs.tensions["human:skewed/index/FDP2"] = 3;
  motion.set(inputs);
  (void)motion.step(1, {});
  EXPECT_EQ(motion.instant().tensions[line], 3);
  (void)motion.seek(0.05);
  EXPECT_NEAR(motion.instant().tensions[line], 0.48 * 0.05 / 0.5, 1e-12);
  for (const ElementValue& value : motion.state({false, false, false, false, true}).muscles)
    if (value.name == "human:skewed/index/FDP2") {
      EXPECT_EQ(value.value, motion.instant().tensions[line]);
    }
}

TEST(SceneTendons, LinesHaveTheirPointsAndNamesOnce) {
  const LiveMotion motion(scene_motion(closing_hand()));
  const LiveShape& shape = motion.shape();
  EXPECT_NO_THROW(check_instant(shape, motion.instant()));
  EXPECT_GE(shape.lines.size(), 30u);
  std::set<std::string> names;
  for (const LiveLine& line : shape.lines) {
    EXPECT_LE(line.points, kMaxStrandPoints);
    EXPECT_GE(line.points, 2);
    EXPECT_TRUE(names.insert(line.owner + " " + line.name).second) << line.owner << line.name;
  }
}

TEST(SceneTendons, ScenesWithoutTendonsHaveNone) {
  SceneRequest request = closing_hand();
  for (const char* scene : {"pinch", "thumb_mug", "wine_glass"}) {
    request.scene = scene;
    EXPECT_TRUE(LiveMotion(scene_motion(request)).shape().lines.empty()) << scene;
  }
}

class RecordedTendons : public TemporaryFolder {};

TEST_F(RecordedTendons, PullAsInTheRun) {
  SceneRequest request = closing_hand();
  request.seconds = 0.06;
  const SceneResult run = simulate_scene(request);
  write_scene_run(run, path("run.h5"));
  RecordedMotion motion(read_scene_run(path("run.h5"), kData));
  const std::size_t line = line_called(motion.shape(), "FDP2").line;
  for (const double t : {0.0, 0.03, 0.037, 0.06}) {
    (void)motion.seek(t);
    const LiveInstant instant = motion.instant();
    EXPECT_NO_THROW(check_instant(motion.shape(), instant));
    EXPECT_NEAR(instant.tensions[line], 0.48 * t / 0.5, 1e-9) << t;
  }
}

}  // namespace
}  // namespace thenar
