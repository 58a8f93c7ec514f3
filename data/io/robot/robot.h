#pragma once

/// Robots as plain data: links, joints, and degrees of freedom apart from joints.

#include <array>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "base/enum_names.h"
#include "base/provenance.h"
#include "base/spatial.h"
#include "data/io/robot/drive_coupling.h"
#include "geometry/shape_spec.h"

namespace thenar {

/// A rigid link, in a frame of its own.
struct RobotLink {
  std::string name;
  std::string digit;             // digit to which it belongs; empty: palm or arm
  double mass = 0;               // [kg]; 0: unknown
  Eigen::Vector3d com{0, 0, 0};  // [m] (3)
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  // inertia about com [kg m^2] (3, 3)
  std::vector<ShapeSpec> shapes;                      // shapes for contacts
  std::string material;  // material name of data/materials; empty: unknown
};

/// Kinds of joints.
enum class RobotJointKind { kFixed, kRevolute, kPrismatic };
inline constexpr std::array kRobotJointKindNames{EnumName{RobotJointKind::kFixed, "fixed"},
                                                 EnumName{RobotJointKind::kRevolute, "revolute"},
                                                 EnumName{RobotJointKind::kPrismatic, "prismatic"}};
[[nodiscard]] inline std::string name_of(RobotJointKind kind) {
  return name_in(kRobotJointKindNames, kind);
}

/// A joint. Its value is offset + ratio * u + curve[0] * u^2 + curve[1] * u^3 + .., u its degree of
/// freedom, and the pose of the child in the parent X_PJ * motion(axis, value) * X_JC. Limits are
/// finite: a joint that turns without end has -pi to pi.
struct RobotJoint {
  std::string name;
  RobotJointKind kind = RobotJointKind::kRevolute;
  std::string parent;             // link
  std::string child;              // link
  Pose<double> X_PJ;              // joint frame in the parent link
  Eigen::Vector3d axis{0, 0, 1};  // unit, in the joint frame (3)
  Pose<double> X_JC;              // child link in the moved joint frame
  double lower = 0;               // lower limit of the joint value [rad] or [m]
  double upper = 0;               // upper limit of the joint value [rad] or [m]
  std::string dof;                // degree of freedom that drives it; empty: fixed or free
  double ratio = 1;               // [1], [m/rad] or [rad/m]
  double offset = 0;              // [rad] or [m]
  std::vector<double> curve;      // higher coefficients; empty: linear [rad/rad^2], [rad/rad^3] ..
  double damping = 0;             // [N m s/rad] or [N s/m]
  double friction = 0;            // Coulomb's [N m] or [N]
  double stiffness = 0;           // stiffness of a spring to `rest` [N m/rad] or [N/m]
  double rest = 0;                // [rad] or [m]
};

/// A degree of freedom: a motor.
struct RobotDof {
  std::string name;
  DriveCoupling kind = DriveCoupling::kRigid;
  double lower = 0;       // [rad] or [m]
  double upper = 0;       // [rad] or [m]
  double speed = 0;       // closing speed relative to other drives; negative: closes downwards [1]
  double max_effort = 0;  // [N m] or [N]; 0: unknown
  double breakaway = 0;   // torque at which the clutch opens [N m]
  double stiffness = 0;   // stiffness of a compliant coupling [N m/rad]
  bool backdrivable = true;     // false: a worm gear or brake, which no load drives back
  bool nominal_effort = false;  // max_effort is a model's placeholder, not a published number
  std::optional<double> open;   // value when closing begins [rad] or [m]; nothing: the limit from
                                // which it closes, or for speed 0 zero or the nearest limit
  double effort_up = 0;    // efforts in both directions, where those of a file differ; otherwise 0;
  double effort_down = 0;  //   not written to files [N m] or [N]
};

/// Approach of a hand towards an object: a point of the palm and its direction.
struct RobotApproach {
  Eigen::Vector3d point{0, 0, 0};      // position in the base link [m] (3)
  Eigen::Vector3d direction{0, 0, 1};  // unit, in the base link (3)
};

/// Largest number of links: checks of trees and couplings take its square.
constexpr std::size_t kMaxLinks = 1000;

/// A whole robot. Joints come parents before children; the first link is the base.
struct RobotSpec {
  std::string name;
  std::string description;
  std::string source;   // citation keys
  std::string licence;  // licence of the original file; empty: ours
  std::vector<RobotLink> links;
  std::vector<RobotJoint> joints;
  std::vector<RobotDof> dofs;
  RobotApproach approach;
  bool closing_stated = true;   // false: speeds give the pace of drives, not the sense of closing
  bool approach_stated = true;  // false: `approach` means nothing
  std::vector<std::string> open_loops;  // unsolved loops: the robot must not grasp
  std::vector<std::pair<std::string, std::string>> joined;  // links held together by solved loops;
                                                            // not written to files
  std::vector<std::string> warnings;                        // warnings of an importer
  FileDigests files = {};  // digests of its input files, its own first
};

/// Names of the digits that links belong to.
[[nodiscard]] std::set<std::string> digits_in(const RobotSpec& robot);
/// Returns whether a degree of freedom says how it closes.
[[nodiscard]] bool any_speed(const RobotSpec& robot);

/// Returns whether a joint slides rather than turns.
[[nodiscard]] bool slides(const RobotJoint& joint);
/// Returns whether the joints of a degree of freedom slide: as its first joint does.
[[nodiscard]] bool slides(const RobotSpec& robot, const RobotDof& dof);

/// Sets the effort of a degree of freedom to that in the direction of its speed, where efforts
/// differ by direction; 0, unknown, if there is none that way.
/// @returns whether they differed
bool take_effort_of_speed(RobotDof& dof);

/// Reads a robot from TOML; docs/data_format.md describes the format. Mesh files are beside it.
/// @throws DataError  `path:line: what was wanted, what came`.
[[nodiscard]] RobotSpec read_robot(const std::string& path);
[[nodiscard]] RobotSpec parse_robot(const std::string& text, const std::string& path);

/// Returns the robot as TOML that read_robot() reads without loss, every double to the bit. A mesh
/// from a file is named, not written out.
/// @param stated  the robot before digits, materials, closing and approach were inferred: lines
/// that differ end in a comment, "# guessed"; null: nothing was inferred
/// @throws InputError as check_robot().
[[nodiscard]] std::string robot_toml(const RobotSpec& robot, const RobotSpec* stated = nullptr);

/// Returns whether a rigid body can have this inertia about its centre of mass: symmetric, no
/// principal moment negative or larger than the sum of the others, to 1e-6 of the largest.
/// @param inertia  [kg m^2] (3, 3)
[[nodiscard]] bool is_body_inertia(const Eigen::Matrix3d& inertia);

/// Checks a robot, and says what is wrong: no link; a name given twice; a link that is unknown,
/// carried by two joints, or on a loop; joints out of order; an unknown degree of freedom; an axis
/// or direction that is no unit vector; an invalid rotation; limits that cross; a negative mass; an
/// inertia that no body has; a number that is not finite.
/// @throws InputError
void check_robot(const RobotSpec& robot);

/// Mounts `tool` on a link of `carrier` by a fixed joint "NAME mount". The result
/// approaches and closes as the tool does; a carrier that states no closing does not move. Names of
/// the tool get "NAME/" in front if the carrier has them already.
/// @param X_LT  base link of the tool in that link
/// @throws InputError if the carrier has no such link, or as check_robot().
[[nodiscard]] RobotSpec attach(const RobotSpec& carrier, const std::string& link,
                               const RobotSpec& tool, const Pose<double>& X_LT);

}  // namespace thenar
