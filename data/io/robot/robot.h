#pragma once

/// A robot described once, as plain data: links, joints, and degrees of freedom apart from joints.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "base/spatial.h"
#include "geometry/shape_spec.h"

namespace thenar {

/// A rigid link, in a frame of its own.
struct RobotLink {
  std::string name;
  std::string digit;                                  // finger it belongs to; empty: palm or arm
  double mass = 0;                                    // [kg]; 0 if unknown
  Eigen::Vector3d com{0, 0, 0};                       // [m] (3)
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  // about com [kg m^2] (3, 3)
  std::vector<ShapeSpec> shapes;                      // its surface, for contacts
  std::string material;                               // of data/materials; empty: unknown
};

enum class RobotJointKind { kFixed, kRevolute, kPrismatic };

/// "fixed", "revolute", "prismatic".
[[nodiscard]] std::string name_of(RobotJointKind kind);

/// Joint value = offset + ratio * u + curve[0] * u^2 + curve[1] * u^3 + .., with u its degree of
/// freedom.
/// Pose of the child in the parent = X_PJ * motion(axis, value) * X_JC.
/// Limits are finite: a joint that turns without end goes from -pi to pi.
struct RobotJoint {
  std::string name;
  RobotJointKind kind = RobotJointKind::kRevolute;
  std::string parent;             // link
  std::string child;              // link
  Pose<double> X_PJ;              // joint frame in the parent link
  Eigen::Vector3d axis{0, 0, 1};  // unit, in the joint frame (3)
  Pose<double> X_JC;              // child link in the moved joint frame
  double lower = 0;               // of the joint value [rad] or [m]
  double upper = 0;               // of the joint value [rad] or [m]
  std::string dof;                // degree of freedom that drives it; empty: fixed or free
  double ratio = 1;               // [1], [m/rad] or [rad/m]
  double offset = 0;              // [rad] or [m]
  std::vector<double> curve;      // of a linkage; empty: linear [rad/rad^2], [rad/rad^3] ..
  double damping = 0;             // [N m s/rad] or [N s/m]
  double friction = 0;            // Coulomb's [N m] or [N]
  double stiffness = 0;           // of a spring to `rest` [N m/rad] or [N/m]
  double rest = 0;                // [rad] or [m]
};

/// How one motor drives several joints.
enum class RobotDofKind {
  kRigid,      // gears: if one joint is blocked, all are
  kBreakaway,  // a clutch: blocked beyond `breakaway` a joint stops, those further out go on
  kCompliant   // springs or an adaptive linkage: a blocked joint stops, all others go on
};

/// A motor.
struct RobotDof {
  std::string name;
  RobotDofKind kind = RobotDofKind::kRigid;
  double lower = 0;             // [rad] or [m]
  double upper = 0;             // [rad] or [m]
  double speed = 0;             // in closing, relative to the others; negative closes downwards [1]
  double max_effort = 0;        // [N m] or [N]; 0 if unknown
  double breakaway = 0;         // torque at which the clutch opens [N m]
  double stiffness = 0;         // of a compliant coupling [N m/rad]
  bool backdrivable = true;     // false: a worm or brake, which holds whatever pushes it back
  bool nominal_effort = false;  // max_effort is a placeholder of a model, not a published figure
  std::optional<double> open;   // where it stands before the hand closes [rad] or [m]; none: at the
                                // limit it comes from, or, if speed is 0, at 0 or the limit next to
};

/// Which way a hand goes at an object.
struct RobotApproach {
  Eigen::Vector3d point{0, 0, 0};      // in the base link [m] (3)
  Eigen::Vector3d direction{0, 0, 1};  // unit, in the base link (3)
};

/// A robot of more links is refused: checks of trees and couplings take the square of them.
constexpr std::size_t kMaxLinks = 1000;

/// Joints stand parents before children; the first link is the base.
struct RobotSpec {
  std::string name;
  std::string description;
  std::string source;   // citation keys
  std::string licence;  // of the file it came from; empty: ours
  std::vector<RobotLink> links;
  std::vector<RobotJoint> joints;
  std::vector<RobotDof> dofs;
  RobotApproach approach;
  bool closing_stated = true;   // false: speeds say how fast drives run, not which way closes
  bool approach_stated = true;  // false: `approach` says nothing
  std::vector<std::string> open_loops;  // what closes it to more than a tree and is not solved: it
                                        // must not grasp
  std::vector<std::pair<std::string, std::string>> joined;  // links that a solved loop holds
                                                            // together; no file keeps them
  std::vector<std::string> warnings;  // what an importer met and did not understand
};

/// Whether a joint slides, or turns.
[[nodiscard]] bool slides(const RobotJoint& joint);
/// How the joints of a degree of freedom move: sliding if the first of them does.
[[nodiscard]] bool slides(const RobotSpec& robot, const RobotDof& dof);

/// Reads a robot from TOML; the format is in docs/data_format.md. Mesh files are found beside it.
/// @throws DataError  `path:line: what was wanted, what came`.
[[nodiscard]] RobotSpec read_robot(const std::string& path);
[[nodiscard]] RobotSpec parse_robot(const std::string& text, const std::string& path);

/// The robot as TOML that read_robot() reads without loss: every double survives to the bit. A mesh
/// that came from a file is named, not written out.
/// @param stated  what was known of it before digits, materials, closing and approach were guessed:
/// lines of these that differ end in a comment, "# guessed"; null: nothing was
/// @throws InputError as check_robot().
[[nodiscard]] std::string robot_toml(const RobotSpec& robot, const RobotSpec* stated = nullptr);

/// Whether some rigid body has this inertia about its centre of mass: symmetric, no principal
/// moment negative, none larger than the sum of the others; to 1e-6 of the largest.
/// @param inertia  [kg m^2] (3, 3)
[[nodiscard]] bool is_body_inertia(const Eigen::Matrix3d& inertia);

/// Refuses a robot that is none, naming what is wrong: no link, a name given twice, a link that is
/// unknown, that two joints carry, or that hangs on a loop, joints out of order, an unknown degree
/// of freedom, an axis or direction that is no unit vector, a rotation that is none, limits that
/// cross, a mass or a limit below zero, an inertia that is not a body's, anything not finite.
/// @throws InputError
void check_robot(const RobotSpec& robot);

/// `tool` mounted on a link of `carrier`: one tree, which approaches as the tool does, and closes
/// as it does where nothing states how the carrier closes, which then stands still; names of the
/// tool get "NAME/" before them where the carrier has them already. A fixed joint "NAME mount"
/// holds them together.
/// @param X_LT  base link of the tool in that link
/// @throws InputError if the carrier has no such link, or as check_robot().
[[nodiscard]] RobotSpec attach(const RobotSpec& carrier, const std::string& link,
                               const RobotSpec& tool, const Pose<double>& X_LT);

}  // namespace thenar
