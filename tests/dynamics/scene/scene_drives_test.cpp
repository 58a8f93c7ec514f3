// Tests for dynamics/scene/scene_drives.cpp.

#include "dynamics/scene/scene_drives.h"

#include <string>

#include <gtest/gtest.h>

#include "tests/matrix_near.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

/// A ball on a slide along x, with what else a file has.
SceneSpec sliding(const std::string& more, const std::string& stepping = "") {
  return parse_scene(
      "name = \"x\"\nsource = \"Mine\"\n[sources]\nMine = \"Own\"\n[[body]]\nname = \"ball\"\n"
      "mass_g = 100\nmaterial = \"wood\"\n[body.joint]\nkind = \"slide\"\naxis = [1, 0, 0]\n"
      "[[body.shape]]\nkind = \"sphere\"\nsize_mm = [10]\nposition_mm = [0, 0, 5]\n" +
          more + "[stepping]\nduration_s = 2\n" + stepping,
      "s.toml");
}

TEST(SceneDrives, PushABodyAtItsCentreOfMassByDefault) {
  const BuiltScene built =
      build_scene(sliding("[[force]]\nbody = \"ball\"\nforce_N = [1, 2, 3]\n"), {});
  ASSERT_EQ(built.scene.forces.size(), 1U);
  EXPECT_TRUE(matrix_near(built.scene.forces[0].point, Eigen::Vector3d(0, 0, 0.005), 1e-15));
  EXPECT_EQ(built.scene.forces[0].force, Eigen::Vector3d(1, 2, 3));
}

TEST(SceneDrives, HaveNoLargestEffortWhereNoMotorIsKnown) {
  const BuiltScene built =
      build_scene(sliding("[[drive]]\ncoordinate = \"ball\"\neffort_N = 4\n"), {});
  ASSERT_EQ(built.scene.drives.size(), 1U);
  EXPECT_EQ(built.scene.drives[0].bias, 4);
  EXPECT_EQ(built.scene.drives[0].max_effort, std::numeric_limits<double>::infinity());
}

TEST(SceneDrives, LeaveStepsThatTheFileDoesNotStateAsTheyAre) {
  const BuiltScene plain = build_scene(sliding(""), {});
  const BuiltScene stated = build_scene(sliding("", "step_ms = 0.25\n"), {});
  EXPECT_EQ(plain.options.step_length, SceneOptions{}.step_length);
  EXPECT_EQ(stated.options.step_length, 0.25e-3);
  EXPECT_EQ(stated.options.duration, 2);
}

}  // namespace
}  // namespace thenar
