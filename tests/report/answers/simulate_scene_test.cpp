// Tests for report/answers/simulate_scene.cpp.

#include "report/answers/simulate_scene.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "api/scenes/write_scene_run.h"
#include "data/io/result_file.h"
#include "tests/data_folder.h"
#include "tests/temporary_folder.h"

namespace thenar {
namespace {

using testing::HasSubstr;

SceneResult pinched() {
  SceneRequest request;
  request.scene = kData + "/scenes/pinch.toml";
  request.seconds = 0.1;
  return simulate_scene(request);
}

TEST(SceneAnswer, MayBeUsedWhereAllContactsWereSolved) {
  const SceneResult scene = pinched();
  EXPECT_EQ(refusal_of(scene), "");
  EXPECT_THAT(text_of(scene), HasSubstr("pinch: done after 0.1 s"));
  EXPECT_EQ(json_of(scene)["status"], "done");
}

TEST(SceneAnswer, IsRefusedWhereContactsWereNotSolved) {
  SceneResult scene = pinched();
  scene.run.status = SceneStatus::kUnsolved;
  scene.run.cost.unsolved = 3;
  scene.run.cost.worst_residual = 0.25;
  EXPECT_THAT(refusal_of(scene), HasSubstr("3 of "));
  EXPECT_THAT(refusal_of(scene), HasSubstr("worst residual 0.25"));
  // A run that was stopped afterwards is no better.
  scene.run.status = SceneStatus::kStopped;
  EXPECT_NE(refusal_of(scene), "");
  EXPECT_EQ(json_of(scene)["unsolved"], 3);
}

TEST(SceneAnswer, IsRefusedWhereTheIntegratorGaveUp) {
  SceneResult scene = pinched();
  scene.run.status = SceneStatus::kFailed;
  scene.run.message = "at 0.1 s no step is short enough";
  EXPECT_EQ(refusal_of(scene), "at 0.1 s no step is short enough: do not use this motion");
  EXPECT_EQ(json_of(scene)["status"], "failed");
  EXPECT_EQ(json_of(scene)["reason"], scene.run.message);
  EXPECT_TRUE(json_of(pinched())["reason"].is_null());
}

using SceneFile = TemporaryFolder;

TEST_F(SceneFile, HasTheReasonOfAFailure) {
  SceneResult scene = pinched();
  write_scene_run(scene, path("run.h5"), {});
  EXPECT_EQ(read_result(path("run.h5")).texts.count("reason"), 0U);
  scene.run.status = SceneStatus::kFailed;
  scene.run.message = "at 0.1 s no step is short enough";
  write_scene_run(scene, path("run.h5"), {});
  const ResultFile file = read_result(path("run.h5"));
  EXPECT_EQ(file.text("status"), "failed");
  EXPECT_EQ(file.text("reason"), scene.run.message);
}

// Contacts as springs pose no contact problems: no residual is told, rather than one of 0.
TEST(SceneAnswer, HasAResidualWhereContactProblemsWerePosed) {
  SceneRequest request;
  request.scene = kData + "/scenes/pinch.toml";
  request.seconds = 0.05;
  request.vary = {{"friction", 0.8, 0.8, 1}};
  for (const auto& [value, method] : kSteppingMethodNames) {
    SCOPED_TRACE(method);
    request.method = value;
    const SceneSweepResult sweep = *sweep_scene(request);
    const SceneResult& scene = sweep.runs.front();
    const bool has = value == SteppingMethod::kEvents || value == SteppingMethod::kTimeStepping;
    EXPECT_EQ(json_of(scene)["worst_residual"].is_number(), has);
    EXPECT_EQ(json_of(scene)["worst_residual"].is_null(), !has);
    EXPECT_EQ(text_of(scene).find("contact problem n/a") == std::string::npos, has);
    const Table table = table_of(sweep);
    const auto column = std::find(table.header.begin(), table.header.end(), "worst_residual") -
                        table.header.begin();
    EXPECT_EQ(table.rows.front()[static_cast<std::size_t>(column)] == "n/a", !has);
  }
}

TEST(SceneAnswer, ByAllMethodsHoldsThePinch) {
  SceneRequest request;
  request.scene = kData + "/scenes/pinch.toml";
  request.seconds = 0.1;
  for (const auto& [value, method] : kSteppingMethodNames) {
    SCOPED_TRACE(method);
    request.method = value;
    const SceneResult scene = simulate_scene(request);
    EXPECT_EQ(refusal_of(scene), "");
    EXPECT_EQ(json_of(scene)["method"], method);
    EXPECT_LT(json_of(scene)["largest_slip_m"], 1.1e-4);  // 0.1 s at the transition speed
  }
}

TEST(SceneAnswer, OfASweepNamesTheRunThatIsRefused) {
  SceneRequest request;
  request.scene = kData + "/scenes/pinch.toml";
  request.seconds = 0.05;
  request.vary = {{"friction", 0.4, 0.8, 3}};
  SceneSweepResult sweep = *sweep_scene(request);
  EXPECT_EQ(refusal_of(sweep), "");
  sweep.runs[1].run.cost.unsolved = 1;
  EXPECT_THAT(refusal_of(sweep), HasSubstr("at friction 0.6: 1 of "));
  EXPECT_EQ(table_of(sweep).rows.size(), 3U);
}

// Rigid surfaces that are deep in each other were stepped over: no word would be a wrong number.
TEST(SceneAnswer, WarnsOfDeepPenetration) {
  SceneRequest request;
  request.scene = kData + "/scenes/pinch.toml";
  request.seconds = 0.05;
  SceneResult scene = simulate_scene(request);
  EXPECT_THAT(scene_warnings(scene), testing::IsEmpty());
  scene.run.cost.max_penetration = 2e-3;
  EXPECT_THAT(scene_warnings(scene),
              testing::ElementsAre(HasSubstr("up to 2 mm inside each other")));
}

}  // namespace
}  // namespace thenar
