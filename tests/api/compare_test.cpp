// Tests for api/compare.cpp; tests/apps/compare_command_test.py stops it and goes on.

#include "api/compare.h"

#include <algorithm>
#include <fstream>

#include <gtest/gtest.h>

#include "base/error.h"
#include "tests/temporary_folder.h"

namespace thenar {
namespace {

CompareRequest jaws_on_ball() {
  CompareRequest request;
  request.hands = {"parallel_jaw"};
  request.objects = {"sphere_70"};
  request.tasks = {GraspTask::kForceClosure};
  request.approaches = 2;
  request.best = 0;
  request.data = THENAR_DATA_DIR;
  return request;
}

TEST(CompareHands, OwnsHandsAndObjectsAndSaysWhatItDependsOn) {
  const CompareResult result = compare_hands(jaws_on_ball());
  EXPECT_FALSE(result.outcome.stopped());
  ASSERT_EQ(result.comparison.cells.size(), 1U);
  EXPECT_EQ(result.comparison.cells[0].approaches, 2);
  EXPECT_EQ(result.hands.at(0).name, "parallel_jaw");
  EXPECT_EQ(result.objects.at(0).name, "sphere_70");
  EXPECT_EQ(result.inputs.at("object sphere_70").rfind("read as ", 0), 0U);
}

TEST(CompareHands, StoppedIsNotComplete) {
  Progress progress;
  progress.stop_requested = [] { return true; };
  EXPECT_TRUE(compare_hands(jaws_on_ball(), progress).outcome.stopped());
}

using CompareHandsFile = TemporaryFolder;

// A plate with a fixed jaw, and a jaw that slides to it.
TEST_F(CompareHandsFile, OneJawBringsTheBallToTheFixedOne) {
  CompareRequest request = jaws_on_ball();
  request.approaches = 10;
  request.hands = {path("vise.urdf")};
  std::ofstream(path("vise.urdf")) << R"(<robot name="vise"><link name="body">
<collision><origin xyz="0 0 -.01"/><geometry><box size=".03 .16 .02"/></geometry></collision>
<collision><origin xyz="0 -.045 .035"/><geometry><box size=".03 .01 .07"/></geometry></collision></link>
<link name="jaw"><collision><origin xyz="0 0 .035"/><geometry><box size=".03 .01 .07"/></geometry></collision></link>
<joint name="s" type="prismatic"><parent link="body"/><child link="jaw"/><origin xyz="0 .045 0"/><axis xyz="0 -1 0"/>
<limit lower="0" upper=".075" effort="60" velocity=".2"/></joint></robot>)";
  EXPECT_GE(compare_hands(request).comparison.cells.at(0).closures, 3);
}

TEST_F(CompareHandsFile, IsGoneOnWithByTheSameRequestOnly) {
  CompareRequest request = jaws_on_ball();
  request.file = path("a.json");
  const CompareResult first = compare_hands(request);
  const CompareResult again = compare_hands(request);
  EXPECT_EQ(again.comparison.cells.at(0).outcomes, first.comparison.cells.at(0).outcomes);
  request.seed = 2;
  EXPECT_THROW((void)compare_hands(request), InputError);
}

}  // namespace
}  // namespace thenar
