// A robot of any format moves the same after it was written as TOML, as URDF, and read again.

#include <algorithm>
#include <filesystem>

#include <gtest/gtest.h>

#include "base/file_io.h"
#include "data/io/robot/import_robot.h"
#include "data/io/robot/link_poses.h"
#include "data/io/robot/urdf.h"
#include "tests/data/robot/sample_files.h"
#include "tests/data/robot/sample_robots.h"
#include "tests/matrix_near.h"
#include "tests/temporary_folder.h"

namespace thenar {
namespace {

constexpr double kPoseTolerance = 1e-9;    // a chain of joints, angles written in decimals
constexpr double kRangeTolerance = 1e-12;  // [rad] or [m]

template <typename Part>
const Part* find(const std::vector<Part>& parts, const std::string& name) {
  const auto found =
      std::find_if(parts.begin(), parts.end(), [&](const Part& part) { return part.name == name; });
  return found == parts.end() ? nullptr : &*found;
}

/// Degrees of freedom somewhere in their ranges.
DofValues random_posture(const RobotSpec& robot, std::mt19937& rng) {
  DofValues values;
  for (const RobotDof& dof : robot.dofs)
    values[dof.name] = dof.lower + (sample::odd_number(rng, 1) + 0.5) * (dof.upper - dof.lower);
  return values;
}

/// The frame of a link in that of its URDF link, which is that of the moved joint.
Pose<double> urdf_frame_of(const RobotSpec& robot, const std::string& link) {
  for (const RobotJoint& joint : robot.joints)
    if (joint.child == link) return joint.X_JC;
  return {};
}

class RoundTrip : public TemporaryFolder {
 protected:
  void expect_the_same(const std::string& file) {
    SCOPED_TRACE(file);
    const RobotSpec robot = import_robot(file);
    write_file(path("robot.toml"), robot_toml(robot));
    const RobotSpec kept = read_robot(path("robot.toml"));
    EXPECT_EQ(robot_toml(kept), robot_toml(robot));
    (void)write_urdf(path("robot.urdf"), kept);
    const RobotSpec back = import_robot(path("robot.urdf"));
    expect_same_ranges(robot, back);
    std::mt19937 rng(1);
    for (int trial = 0; trial < 20; ++trial) expect_same_poses(robot, back, rng);
  }

 private:
  /// A motor of the URDF is the joint that leads: q there is that joint's value here.
  static void expect_same_ranges(const RobotSpec& robot, const RobotSpec& back) {
    for (const RobotDof& dof : back.dofs) {
      const RobotJoint* leader = find(robot.joints, dof.name);
      ASSERT_NE(leader, nullptr) << dof.name;
      if (leader->dof.empty()) continue;
      const RobotDof* own = find(robot.dofs, leader->dof);
      ASSERT_NE(own, nullptr) << leader->dof;
      const double a = leader->ratio * own->lower + leader->offset,
                   b = leader->ratio * own->upper + leader->offset;
      EXPECT_NEAR(dof.lower, std::min(a, b), kRangeTolerance) << dof.name;
      EXPECT_NEAR(dof.upper, std::max(a, b), kRangeTolerance) << dof.name;
    }
  }

  static void expect_same_poses(const RobotSpec& robot, const RobotSpec& back, std::mt19937& rng) {
    const DofValues values = random_posture(robot, rng);
    DofValues led;
    for (const RobotDof& dof : back.dofs)
      led[dof.name] = joint_value(*find(robot.joints, dof.name), values);
    const std::vector<Pose<double>> X = link_poses(robot, values), Y = link_poses(back, led);
    ASSERT_EQ(X.size(), Y.size());
    for (std::size_t i = 0; i < X.size(); ++i) {
      const std::string& name = robot.links[i].name;
      const RobotLink* link = find(back.links, name);
      ASSERT_NE(link, nullptr) << name;
      const Pose<double> again =
          Y[static_cast<std::size_t>(link - back.links.data())] * urdf_frame_of(robot, name);
      EXPECT_TRUE(matrix_near(again.p, X[i].p, kPoseTolerance)) << name;
      EXPECT_TRUE(matrix_near(again.R, X[i].R, kPoseTolerance)) << name;
    }
  }
};

TEST_F(RoundTrip, KeepsEveryRobotOfTheLibrary) {
  for (const auto& entry : std::filesystem::directory_iterator(THENAR_DATA_DIR "/robots"))
    if (entry.path().extension() == ".toml") expect_the_same(entry.path().string());
}

TEST_F(RoundTrip, KeepsUrdf) {
  write_file(path("seg.off"), sample::wedge_off());
  write_file(path("claw.urdf"), sample::urdf_file());
  expect_the_same(path("claw.urdf"));
}

TEST_F(RoundTrip, KeepsMjcf) {
  write_file(path("seg.off"), sample::wedge_off());
  write_file(path("claw.xml"), sample::mjcf_file());
  expect_the_same(path("claw.xml"));
}

TEST_F(RoundTrip, KeepsGraspit) {
  write_file(path("seg.off"), sample::wedge_off());
  write_file(path("seg.xml"), sample::graspit_body_file());
  write_file(path("claw.xml"), sample::graspit_file());
  expect_the_same(path("claw.xml"));
}

}  // namespace
}  // namespace thenar
