// Tests for report/pages/scene_run.cpp.

#include "report/pages/scene_run.h"

#include <vector>

#include <gtest/gtest.h>

#include "tests/data_folder.h"

namespace thenar {
namespace {

/// A pinch of 0.1 s with eleven instants.
SceneResult pinched(std::optional<SteppingMethod> method = {}) {
  SceneRequest request;
  request.scene = kData + "/scenes/pinch.toml";
  request.seconds = 0.1;
  request.sample = 0.01;
  request.method = method;
  return simulate_scene(request);
}

// Half time and half way: a jump at the sixth of eleven instants is half of all. The shares there
// are 0, 0.05 .. 0.2, 0.75 .. 1, and those of stills 0, 1/7 .. 1.
TEST(ScenePage, HasOneStillOfAJump) {
  SceneResult scene = pinched();
  auto& X = scene.measures.X_WB;
  ASSERT_EQ(X.size(), 11U);
  for (std::size_t i = 1; i < X.size(); ++i) {
    X[i] = X[0];
    if (i < 5) continue;
    for (const std::size_t body : scene.measures.moving) X[i][body].p.x() += 1;
  }
  const Json page = page_of(scene);
  const auto strip = page["sections"][0]["blocks"][1]["strip"].get<std::vector<double>>();
  const std::vector<double> wanted{0, 0.03, 0.05, 0.08, 0.1};
  ASSERT_EQ(strip.size(), wanted.size());
  for (std::size_t k = 0; k < wanted.size(); ++k) EXPECT_NEAR(strip[k], wanted[k], 1e-9);
}

// Steady motion: as many as there may be, about evenly spaced.
TEST(ScenePage, HasEightStillsOfASteadyMotion) {
  SceneResult scene = pinched();
  auto& X = scene.measures.X_WB;
  for (std::size_t i = 1; i < X.size(); ++i) {
    X[i] = X[0];
    for (const std::size_t body : scene.measures.moving) X[i][body].p.x() += static_cast<double>(i);
  }
  const Json page = page_of(scene);
  const auto strip = page["sections"][0]["blocks"][1]["strip"].get<std::vector<double>>();
  const std::vector<double> wanted{0, 0.02, 0.03, 0.05, 0.06, 0.08, 0.09, 0.1};
  ASSERT_EQ(strip.size(), wanted.size());
  for (std::size_t k = 0; k < wanted.size(); ++k) EXPECT_NEAR(strip[k], wanted[k], 1e-9);
}

TEST(ScenePage, SaysHowFarTheMotionIsToBeBelieved) {
  for (const char* words : {"energy error", "total energy exchanged", "dissipated by",
                            "deepest overlap", "joint limits passed"})
    EXPECT_NE(page_of(pinched(SteppingMethod::kTimeStepping)).dump().find(words), std::string::npos)
        << words;
  SceneResult scene = pinched(SteppingMethod::kTimeStepping);
  scene.measures.worst->error = scene.measures.worst->turned_over = 1;
  EXPECT_NE(page_of(scene)["sections"][0]["blocks"][0].dump().find("energy does not balance"),
            std::string::npos);
}

TEST(ScenePage, ToldResidualsAreOfContactProblems) {
  const auto title = [](const SceneResult& scene) {
    return page_of(scene)["sections"][0]["blocks"][0]["title"].get<std::string>();
  };
  EXPECT_EQ(title(pinched(SteppingMethod::kEvents)).rfind("All contact problems were solved", 0),
            0U);
  EXPECT_EQ(title(pinched(SteppingMethod::kCompliantSundials)).rfind("Contacts are springs", 0),
            0U);
}

}  // namespace
}  // namespace thenar
