// No broken robot file does harm, whatever its kind.

#include <gtest/gtest.h>

#include "data/io/robot/import_robot.h"
#include "data/io/robot/urdf.h"
#include "tests/data/broken_files.h"
#include "tests/data/robot/sample_files.h"
#include "tests/data/robot/sample_robots.h"
#include "tests/temporary_folder.h"

namespace thenar {
namespace {

class BrokenRobot : public TemporaryFolder {
 protected:
  BrokenRobot() {
    write_file(path("seg.off"), sample::wedge_off());
    write_file(path("seg.xml"), sample::graspit_body_file());
  }
  /// What is imported can also be written.
  void expect_harmless(const std::string& name, const std::string& text) {
    expect_no_harm(text, path(name), [](const std::string& file) {
      const RobotSpec robot = import_robot(file);
      (void)robot_toml(robot);
      (void)robot_urdf(robot, "");
    });
  }
};

TEST_F(BrokenRobot, OfUrdfDoesNoHarm) { expect_harmless("claw.urdf", sample::urdf_file()); }
TEST_F(BrokenRobot, OfMjcfDoesNoHarm) { expect_harmless("claw.xml", sample::mjcf_file()); }
TEST_F(BrokenRobot, OfGraspitDoesNoHarm) { expect_harmless("claw.xml", sample::graspit_file()); }
TEST_F(BrokenRobot, OfTomlDoesNoHarm) {
  expect_harmless("claw.toml", robot_toml(sample::small_robot()));
}

}  // namespace
}  // namespace thenar
