// Tests for api/pose.cpp and api/robot_pose.cpp.

#include "api/pose.h"

#include <gtest/gtest.h>

#include "base/units.h"
#include "tests/data_folder.h"
#include "tests/matrix_near.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

PoseRequest request_of(const std::string& model) {
  PoseRequest request;
  request.model = model;
  request.data = kData;
  request.posture.unit = PostureUnit::kTyped;
  return request;
}

// The tip's speed is its Jacobian's column: by central differences along the grid.
TEST(ComputePoses, MovesTheTipAsItsJacobianSays) {
  PoseRequest request = request_of("synek2019_middle");
  request.vary = {{"PIP3", 29.99, 30.01, 0.01}};
  const auto poses = std::get<SubjectPoses>(compute_poses(request));
  ASSERT_EQ(poses.points.size(), 3u);
  const Eigen::Vector3d speed =
      (poses.points[2].tips[0].p - poses.points[0].tips[0].p) / (0.02 * kDegree);
  EXPECT_TRUE(matrix_near(Eigen::Vector3d(poses.points[1].tips[0].J.col(2)), speed, 1e-8));
}

// Two joints of one motor move together; 3 x 2 postures, the last name varies fastest.
TEST(ComputePoses, VariesARobotsDrives) {
  PoseRequest request = request_of("barrett");
  const auto alone = std::get<RobotPoses>(compute_poses(request));
  const std::string first = alone.points.front().joints[0].dof;
  std::string second;
  for (const RobotJointPose& joint : alone.points.front().joints)
    if (joint.dof != first) second = joint.dof;
  request.vary = {{first, 0, 20, 10}, {second, 0, 10, 10}};
  const auto poses = std::get<RobotPoses>(compute_poses(request));
  ASSERT_EQ(poses.points.size(), 6u);
  EXPECT_EQ(poses.row, 2u);
  EXPECT_NEAR(poses.points[3].varied[0], 10 * kDegree, 1e-15);
  EXPECT_NEAR(poses.points[3].varied[1], 10 * kDegree, 1e-15);
  EXPECT_TRUE(matrix_near(poses.points[0].links.back().X_BL.p,
                          alone.points.front().links.back().X_BL.p, 1e-15));
}

TEST(ComputePoses, GuessesANameOfARobot) {
  PoseRequest request = request_of("barrett");
  request.posture.named = {{"fingr 1", 10}};
  EXPECT_NE(message_of([&] { (void)compute_poses(request); }).find("did you mean"),
            std::string::npos);
}

TEST(ComputePoses, NamesTheFieldOfAnUnknownDrive) {
  const auto field_of = [](const PoseRequest& request) {
    try {
      (void)compute_poses(request);
    } catch (const InputError& error) {
      return error.field();
    }
    return std::string("nothing was thrown");
  };
  PoseRequest posed = request_of("barrett"), varied = posed, missing = request_of("barett");
  posed.posture.named = {{"fingr 1", 10}};
  varied.vary = {{"fingr 1", 0, 10, 10}};
  EXPECT_EQ(field_of(posed), "posture");
  EXPECT_EQ(field_of(varied), "vary");
  EXPECT_EQ(field_of(missing), "model");
}

TEST(ComputePoses, RefusesAnglesThatNoJointHas) {
  PoseRequest request = request_of("synek2019_middle");
  request.posture.named = {{"PIP3", 4000}};
  EXPECT_EQ(message_of([&] { (void)compute_poses(request); }),
            "wanted an angle of 'PIP3' between -360 and 360 deg, got 4000 deg");
}

}  // namespace
}  // namespace thenar
