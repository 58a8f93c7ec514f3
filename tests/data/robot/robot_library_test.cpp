// Every robot in data/robots reads, and is what its file is called.

#include <algorithm>
#include <filesystem>

#include <gtest/gtest.h>

#include "data/io/robot/robot.h"

namespace thenar {
namespace {

const std::string kRobots = std::string(THENAR_DATA_DIR) + "/robots";

struct Counts {
  const char* robot;
  int motors;
  int joints;  // that move
};

// As their publications count them.
constexpr Counts kCounts[] = {
    {"allegro", 16, 16},
    {"barrett", 4, 8},
    {"barrett_bh8_280", 4, 8},
    {"dlr", 12, 16},
    {"franka_hand", 1, 2},
    {"graspit_human_20dof", 20, 20},
    {"graspit_human_altaxes", 21, 21},
    {"leap", 16, 16},
    {"parallel_jaw", 1, 2},
    {"puma560", 6, 6},
    {"robonaut", 14, 19},
    {"robotiq_2f85", 1, 6},
    {"robotiq_3f", 11, 11},
    {"rutgers", 19, 19},
    {"shadow", 20, 24},
    {"xr4000", 3, 3},
};

TEST(RobotLibrary, HasTheMotorsAndJointsOfThePublications) {
  for (const Counts& count : kCounts) {
    const RobotSpec robot = read_robot(kRobots + "/" + count.robot + ".toml");
    EXPECT_EQ(robot.dofs.size(), static_cast<std::size_t>(count.motors)) << count.robot;
    const auto moving =
        std::count_if(robot.joints.begin(), robot.joints.end(),
                      [](const RobotJoint& joint) { return joint.kind != RobotJointKind::kFixed; });
    EXPECT_EQ(moving, count.joints) << count.robot;
  }
}

TEST(RobotLibrary, IsNamedAsItsFilesAndWritesTheSame) {
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kRobots)) {
    const RobotSpec robot = read_robot(entry.path().string());
    EXPECT_EQ(robot.name, entry.path().stem().string());
    const std::string text = robot_toml(robot);
    EXPECT_EQ(robot_toml(parse_robot(text, "again.toml")), text) << robot.name;
    ++files;
  }
  EXPECT_EQ(files, std::size(kCounts));
}

}  // namespace
}  // namespace thenar
