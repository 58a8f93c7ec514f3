// Tests for api/named/posture.cpp.

#include "api/named/posture.h"

#include <gtest/gtest.h>

#include "base/units.h"
#include "tests/data_folder.h"
#include "tests/matrix_near.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

const Subject& subject() {
  static const Subject read = read_subject(kData + "/subjects/synek2019_middle.toml");
  return read;
}

/// MCP3_FE, MCP3_AA, PIP3, DIP3.
const Skeleton& skeleton() {
  static const Skeleton built = build_skeleton(subject(), {{"middle"}, {}});
  return built;
}

const std::string& joint(int i) { return skeleton().coordinate_names[static_cast<std::size_t>(i)]; }

PostureRequest typed(const std::map<std::string, double>& named) {
  return {named, {}, PostureUnit::kTyped};
}

TEST(Posture, IsByNameOrInOrder) {
  const PostureRequest named = typed({{joint(1), 30}});
  Eigen::VectorXd wanted = Eigen::VectorXd::Zero(skeleton().coordinates());
  wanted[1] = kPi / 6;
  EXPECT_TRUE(matrix_near(posture_of(skeleton(), named), wanted, 1e-15));
  PostureRequest all;
  for (int i = 0; i < skeleton().coordinates(); ++i) all.in_order.push_back(wanted[i]);
  EXPECT_TRUE(matrix_near(posture_of(skeleton(), all), wanted, 0));
}

TEST(Posture, RefusesAWrongCountAndAnUnknownJoint) {
  EXPECT_NE(message_of([] {
              (void)posture_of(skeleton(), {{}, {1.0}, PostureUnit::kSI});
            }).find("angles [rad], of "),
            std::string::npos);
  EXPECT_NE(message_of([] {
              (void)posture_of(skeleton(), typed({{"PIP8", 1}}));
            }).find("no free joint 'PIP8', did you mean"),
            std::string::npos);
}

// 3 x 2 postures: the last joint that varies does so fastest.
TEST(PostureGrid, VariesTheLastJointFastest) {
  const PostureGrid grid =
      posture_grid(skeleton(), typed({}), {{joint(1), 0, 20, 10}, {joint(2), 5, 10, 5}});
  ASSERT_EQ(grid.postures.size(), 6u);
  EXPECT_EQ(grid.row, 2u);
  EXPECT_EQ(grid.varied, (std::vector<int>{1, 2}));
  EXPECT_NEAR(grid.postures[3][1], 10 * kDegree, 1e-15);
  EXPECT_NEAR(grid.postures[3][2], 10 * kDegree, 1e-15);
  EXPECT_TRUE(grid.warnings.empty());
}

TEST(PostureGrid, MeetsAnEndThatRoundingWouldMiss) {
  EXPECT_EQ(posture_grid(skeleton(), typed({}), {{joint(2), 0, 0.3, 0.1}}).postures.size(), 4u);
}

TEST(PostureGrid, RefusesStepsAwayFromTheEnd) {
  EXPECT_EQ(message_of([] {
              (void)posture_grid(skeleton(), typed({}), {{joint(2), 0, 9, -1}});
            }),
            "steps of -1 deg do not lead from 0 to 9 deg");
}

TEST(PostureGrid, WarnsOnceOfAJointOutsideItsLimits) {
  const double far = skeleton().limits[2].upper + 0.1;
  PostureRequest request;
  request.named[joint(2)] = far;
  EXPECT_EQ(posture_grid(skeleton(), request, {{joint(1), 0, 0.1, 0.1}}).warnings.size(), 1u);
}

TEST(FrozenJoints, AreWithinTheirLimits) {
  const JointAxis& first = subject().joints.front();
  const double middle = (first.lower + first.upper) / 2;
  EXPECT_DOUBLE_EQ(frozen_joints(subject(), {{{first.name, middle}}, {}}).at(first.name), middle);
  EXPECT_THROW((void)frozen_joints(subject(), {{{first.name, first.upper + 1}}, {}}), InputError);
}

}  // namespace
}  // namespace thenar
