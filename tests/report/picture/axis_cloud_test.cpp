// Tests for report/picture/axis_cloud.cpp.

#include "report/picture/axis_cloud.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "report/picture/digit_layers.h"
#include "tests/kinematics_fit/fit_samples.h"

namespace thenar {
namespace {

/// The index of a parameter by name.
int index_of(const FitParameters& parameters, const std::string& name) {
  for (std::size_t i = 0; i < parameters.all.size(); ++i)
    if (parameters.all[i].name == name) return static_cast<int>(i);
  throw InputError("no parameter " + name);
}

class AxisClouds : public testing::Test {
 protected:
  sample::FitSetup setup = sample::middle_finger("");
  Eigen::VectorXd q = Eigen::VectorXd::Zero(setup.digit.model.coordinates);
};

// At zero shift an axis of the cloud is the axis of the subject, as long, about the same point.
TEST_F(AxisClouds, LieOnTheAxesIfNothingIsShifted) {
  const std::vector<int> moving{index_of(setup.parameters, "axis/PIP3/direction/1")};
  const AxisCloud cloud =
      axis_cloud("population", setup.digit, setup.parameters, moving, Eigen::MatrixXd::Zero(1, 3));
  const Json scene = axis_cloud_picture(setup.digit, q, {cloud}, std::nullopt, "");
  const Json& axes = scene["layers"][1]["items"];
  const Json& lines = scene["layers"][2]["items"];
  ASSERT_EQ(lines.size(), axes.size());
  for (std::size_t hinge = 0; hinge < axes.size(); ++hinge) {
    const Json& ends = lines[hinge]["positions"];
    ASSERT_EQ(ends.size(), 6U);  // two ends of three draws
    for (std::size_t k = 0; k < 3; ++k) {
      const double a = ends[0][k], b = ends[1][k];
      const double point = axes[hinge]["point"][k], direction = axes[hinge]["direction"][k],
                   length = axes[hinge]["length"];
      EXPECT_NEAR((a + b) / 2, point, 0.1);  // ends are rounded to 0.1 mm
      EXPECT_NEAR(b - a, length * direction, 0.1);
    }
  }
}

// A tilt of 0.2 rad turns an axis by that angle, whatever the tangent, and no other.
TEST_F(AxisClouds, TurnTheAxisThatIsTilted) {
  const std::vector<int> moving{index_of(setup.parameters, "axis/PIP3/direction/1")};
  const AxisCloud cloud = axis_cloud("H01", setup.digit, setup.parameters, moving,
                                     Eigen::MatrixXd::Constant(1, 1, 0.2));
  const TreeState<double> before = pose_tree(setup.digit.model.tree, q),
                          after = pose_tree(cloud.drawn.front().tree, q);
  for (std::size_t hinge = 0; hinge < before.size(); ++hinge) {
    const double angle = std::acos(std::min(1.0, before[hinge].axis.dot(after[hinge].axis)));
    const bool tilted = setup.digit.names.hinges[hinge] == "PIP3";
    // Tangents are added and the direction made a unit again: atan 0.2.
    EXPECT_NEAR(angle, tilted ? 0.2 : 0, tilted ? 0.2 - std::atan(0.2) + 1e-9 : 1e-7);
  }
}

TEST_F(AxisClouds, TakeNoMoreDrawsThanAreWanted) {
  const std::vector<int> moving{0};
  const AxisCloud cloud =
      axis_cloud("H01", setup.digit, setup.parameters, moving, Eigen::MatrixXd::Zero(1, 1000), 20);
  EXPECT_EQ(cloud.drawn.size(), 20U);
}

TEST_F(AxisClouds, RefuseValuesOfOtherParameters) {
  EXPECT_THROW(
      (void)axis_cloud("H01", setup.digit, setup.parameters, {0, 1}, Eigen::MatrixXd::Zero(1, 3)),
      InputError);
}

}  // namespace
}  // namespace thenar
