// Tests for api/compare_rungs.cpp.

#include "api/scenes/compare_rungs.h"

#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.h"
#include "tests/data_folder.h"

namespace thenar {
namespace {

RungComparison compared(const std::string& scene, const std::vector<std::string>& rungs,
                        double seconds = 0.06) {
  SceneRequest request;
  request.scene = kData + "/scenes/" + scene + ".toml";
  request.seconds = seconds;
  return compare_rungs(request, rungs);
}

TEST(CompareRungs, MeasuresAgainstTheFinest) {
  const RungComparison pencil = compared("pencil_pinch", {"hard-point", "soft-finger"});
  ASSERT_EQ(pencil.runs.size(), 2u);
  EXPECT_EQ(pencil.runs[pencil.finest].rung, "soft-finger");
  const RungError &hard = pencil.runs[0].error, &soft = pencil.runs[1].error;
  EXPECT_EQ(soft.force_end, 0);
  EXPECT_EQ(soft.force_all, 0);
  EXPECT_EQ(soft.place_largest, 0);
  // Two pads, one on each fingertip.
  ASSERT_EQ(pencil.pads.size(), 2u);
  const auto a = pad_loads(pencil, pencil.runs[0].scene.run.samples.back());
  const auto b = pad_loads(pencil, pencil.runs[1].scene.run.samples.back());
  EXPECT_NEAR(hard.force_end,
              std::hypot(a[0].force - b[0].force, a[1].force - b[1].force) /
                  std::hypot(b[0].force, b[1].force),
              1e-12);
  EXPECT_EQ(a[0].area, 0);
  EXPECT_GT(b[0].area, 0);
  // Skin that yields lets the grip of 2 N close further: springs of the posture give less.
  EXPECT_GT(a[0].force, b[0].force);
  EXPECT_GT(hard.place_largest, 0);
  EXPECT_GE(hard.place_largest, hard.place_end);
}

TEST(CompareRungs, IsEachRunByItself) {
  const RungComparison pencil = compared("pencil_pinch", {"soft-finger", "foundation"});
  SceneRequest request;
  request.scene = kData + "/scenes/pencil_pinch.toml";
  request.seconds = 0.06;
  request.pads = "foundation";
  const SceneResult alone = simulate_scene(request);
  EXPECT_EQ(alone.run.samples.back().q, pencil.runs[1].scene.run.samples.back().q);
  EXPECT_EQ(pencil.finest, 1u);
}

TEST(CompareRungs, TakesNoRunForTheFinestThatWasNotSolved) {
  // A soft finger has no answer for a coin that is thinner than twice its depth.
  const RungComparison coin = compared("coin_draw", {"soft-finger", "hard-point"});
  EXPECT_EQ(coin.runs[coin.finest].rung, "hard-point");
  EXPECT_GT(coin.runs[0].scene.run.cost.unsolved, 0);
}

TEST(CompareRungs, RefusesWhatItCannotCompare) {
  EXPECT_THROW((void)compared("pencil_pinch", {"elements"}), InputError);
  EXPECT_THROW((void)compared("pencil_pinch", {"elements", "elements"}), InputError);
  EXPECT_THROW((void)compared("pencil_pinch", {"elements", "sponge"}), InputError);
  EXPECT_THROW((void)compared("pinch", {"elements", "foundation"}), InputError);
}

TEST(CompareRungs, KeepsRunsThatAreDoneWhenItIsStopped) {
  SceneRequest request;
  request.scene = kData + "/scenes/pencil_pinch.toml";
  request.seconds = 0.04;
  bool second = false;
  Progress progress;
  progress.report = [&](double fraction, const std::string&) { second = fraction > 0.5; };
  progress.stop_requested = [&] { return second; };
  // Which runs are done by then depends on the processors; none is kept in part.
  const RungComparison pencil =
      compare_rungs(request, {"soft-finger", "foundation", "power-law", "hard-point"}, progress);
  EXPECT_EQ(pencil.outcome.asked, 4u);
  EXPECT_FALSE(pencil.runs.empty());
  EXPECT_LT(pencil.runs.size(), 4u);
  for (const RungRun& run : pencil.runs) EXPECT_EQ(run.scene.run.status, SceneStatus::kDone);
}

}  // namespace
}  // namespace thenar
