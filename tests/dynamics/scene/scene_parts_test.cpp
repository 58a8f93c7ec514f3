// Tests for dynamics/scene/scene_parts.cpp.

#include "dynamics/scene/scene_parts.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/units.h"
#include "tests/data_folder.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

const std::string kBall =
    "[[body]]\nname = \"ball\"\nmass_g = 100\nmaterial = \"wood\"\nposition_mm = [0, 0, 50]\n"
    "[body.joint]\nkind = \"hinge\"\naxis = [0, 0, 1]\npoint_mm = [0, 0, 0]\nstart_deg = 30\n"
    "[[body.shape]]\nkind = \"sphere\"\nsize_mm = [10]\n";

SceneParts parts_of(const std::string& text) {
  const std::string head = "name = \"x\"\nsource = \"Mine\"\n[sources]\nMine = \"Own\"\n";
  const SceneSpec spec = parse_scene(head + text + "[stepping]\nduration_s = 1\n", "s.toml");
  std::vector<SceneHand> hands;
  if (!spec.hands.empty()) hands.emplace_back(read_robot(kData + "/robots/barrett.toml"));
  return build_scene_parts(spec, hands);
}

TEST(SceneParts, HaveABodyWhereTheFilePutsIt) {
  const SceneParts made = parts_of(kBall);
  ASSERT_EQ(made.parts.size(), 1U);
  const ScenePart& ball = made.parts[0];
  EXPECT_TRUE(matrix_near(ball.X_WB.at(0).p, Eigen::Vector3d(0, 0, 0.05), 1e-15));
  EXPECT_EQ(ball.prefix, "");
  ASSERT_EQ(ball.u.size(), 1U);
  EXPECT_DOUBLE_EQ(ball.u[0], kPi / 6);
}

// All of the Barrett hand's motors are behind worms, and nothing drives them.
TEST(SceneParts, WeldMotorsThatHoldByThemselves) {
  const SceneParts made = parts_of(kBall + "[[hand]]\nname = \"barrett\"\n");
  ASSERT_EQ(made.parts.size(), 2U);
  EXPECT_EQ(made.parts[0].prefix, "barrett/");  // hands come first
  EXPECT_TRUE(made.parts[0].mechanism.coordinates.empty());
  EXPECT_EQ(made.parts[1].name, "ball");
  EXPECT_TRUE(made.humans.empty());
}

}  // namespace
}  // namespace thenar
