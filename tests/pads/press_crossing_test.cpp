// Tests for pads/press_crossing.cpp: answers of presses that went through skin.

#include "pads/press_crossing.h"

#include <gtest/gtest.h>

#include "geometry/primitives.h"
#include "tests/pads/tissue_samples.h"

namespace thenar {
namespace {

/// What is said of an object that a step put somewhere in a block from -1 to 0, which did not move.
std::string crossing_of(const std::shared_ptr<const Shape>& shape, const Eigen::Vector3d& place) {
  const TissueBlock block(graded_box(even_axis(-1, 1, 2), even_axis(-1, 1, 2), even_axis(-1, 0, 2)),
                          {neo_hookean(1, 0.4)});
  Pose<double> above;
  above.p = {0, 0, 10};
  const PressState state = block.at_rest(above);
  const RigidObject object{shape, 0};
  PressGoal goal;
  goal.X_PO.p = place;
  const PressOptions options;
  PressFactors factors(*block.body);
  const PressIterate at({*block.body, block.surface, object, goal, options, state}, factors);
  return describe_crossing(at, block.body->node_displacements(state.x, {}));
}

TEST(PressCrossing, IsNoneOfWhatIsOutside) {
  EXPECT_EQ(crossing_of(build_sphere(0.1), {0.3, 0.2, 0.15}), "");
  EXPECT_EQ(crossing_of(build_box({4, 4, 1}), {0, 0, 0.5}), "");
}

TEST(PressCrossing, IsToldOfNodesInside) {
  EXPECT_EQ(crossing_of(build_sphere(0.3), {0, 0, -0.5}),
            "the object is inside the tissue at (0, 0, -500) mm");
}

TEST(PressCrossing, IsToldOfWhatIsAllUnderTheSkin) {
  EXPECT_EQ(crossing_of(build_sphere(0.1), {0.3, 0.2, -0.3}), "the object is inside the tissue");
}

}  // namespace
}  // namespace thenar
