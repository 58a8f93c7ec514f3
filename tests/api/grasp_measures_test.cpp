// Tests for api/grasp_measures.cpp.

#include "api/grasp_measures.h"

#include <gtest/gtest.h>

#include "api/grasp.h"
#include "tests/data_folder.h"

namespace thenar {
namespace {

// Laws that hold of any grasp: efforts support no more than efforts and structure, a hand needs no
// less grasp force than friction alone asks for, and bounds enclose.
TEST(MeasureGrasp, KeepsTheOrderOfItsMeasures) {
  GraspRequest request;
  request.world.world = "barrett_bobbin";
  request.world.data = kData;
  const GraspMeasures measures = *measure_grasp(request).measures;
  for (const auto* load : {&measures.times_weight, &measures.pull, &measures.turn}) {
    ASSERT_TRUE(load->value);
    ASSERT_TRUE(load->value->active);
    EXPECT_LE(*load->value->active, load->value->with_structure);
    EXPECT_GT(*load->value->active, 0);
  }
  EXPECT_LT(*measures.pull.value->active, measures.pull.value->with_structure / 2);  // the palm
  EXPECT_GE(*measures.hold_actuated.value, *measures.hold.value - 1e-6);
  EXPECT_LE(measures.actuated.value->lower, measures.actuated.value->upper);
  EXPECT_LE(measures.volume.lower, measures.volume.upper);
}

// 70 g under 9.81 m/s^2.
TEST(MeasureGrasp, WeighsTheObject) {
  GraspRequest request;
  request.world.world = "barrett_bobbin";
  request.world.data = kData;
  const GraspMeasures measures = *measure_grasp(request).measures;
  EXPECT_NEAR(*measures.weight.value, 0.07 * 9.81, 1e-9);
  EXPECT_FALSE(measures.stiffness.value);  // plastic on wood has no soft layer
  EXPECT_FALSE(measures.stiffness.message.empty());
}

}  // namespace
}  // namespace thenar
