// Tests for report/answers/simulate_scene.cpp.

#include "report/answers/simulate_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/data_folder.h"

namespace thenar {
namespace {

using testing::HasSubstr;

SimulatedScene pinched() {
  SceneRequest request;
  request.scene = kData + "/scenes/pinch.toml";
  request.seconds = 0.1;
  return run_scene(request);
}

TEST(SceneAnswer, MayBeUsedWhereAllContactsWereSolved) {
  const SimulatedScene scene = pinched();
  EXPECT_EQ(refusal_of(scene), "");
  EXPECT_THAT(text_of(scene), HasSubstr("pinch: done after 0.1 s"));
  EXPECT_EQ(json_of(scene)["status"], "done");
}

TEST(SceneAnswer, IsRefusedWhereContactsWereNotSolved) {
  SimulatedScene scene = pinched();
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
  SimulatedScene scene = pinched();
  scene.run.status = SceneStatus::kFailed;
  scene.run.reason = "at 0.1 s no step is short enough";
  EXPECT_EQ(refusal_of(scene), "at 0.1 s no step is short enough: do not use this motion");
  EXPECT_EQ(json_of(scene)["status"], "failed");
}

TEST(SceneAnswer, ByAllMethodsHoldsThePinch) {
  SceneRequest request;
  request.scene = kData + "/scenes/pinch.toml";
  request.seconds = 0.1;
  for (const std::string& method : stepping_names()) {
    SCOPED_TRACE(method);
    request.method = method;
    const SimulatedScene scene = run_scene(request);
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
  SceneSweep sweep = *vary_scene(request);
  EXPECT_EQ(refusal_of(sweep), "");
  sweep.runs[1].run.cost.unsolved = 1;
  EXPECT_THAT(refusal_of(sweep), HasSubstr("at friction 0.6: 1 of "));
  EXPECT_EQ(table_of(sweep).rows.size(), 3U);
}

}  // namespace
}  // namespace thenar
