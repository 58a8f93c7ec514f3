#pragma once

/// Robots in URDF: reading and writing.

#include <map>
#include <string>
#include <vector>

#include "data/io/robot/import_xml.h"
#include "data/io/robot/robot.h"

namespace thenar {

/// Reads a URDF: links, inertials, collision shapes (visual ones if a link has no others), joints,
/// limits, dynamics and mimic joints, also mimics of mimics. Every moving joint that mimics none is
/// a degree of freedom; its speed is the joint's velocity limit, taken as relative, and downwards
/// if its range lies below zero. A continuous joint gets one turn. Floating and planar joints are
/// fixed. `warnings` lists what is not read (transmissions, colours, sensors..) or missing (mesh
/// files).
/// @throws DataError `path:line: ..` for malformed URDF, and for xacro, which must be expanded
///         first.
[[nodiscard]] RobotSpec read_urdf(const std::string& path);

}  // namespace thenar

namespace thenar::internal {

/// Prefix of the name that a capsule's mesh gets, because urdfdom does not know capsules:
/// "capsule:RADIUS LENGTH" [m].
inline constexpr const char* kCapsule = "capsule:";

/// Prepares a URDF for urdfdom, which refuses much that real files have and drops much silently.
/// Checks every number and name with its line, removes and notes what is not read, and fills in
/// defaults that urdfdom insists on (effort, velocity, products of inertia).
/// @returns the text for urdfdom
/// @throws DataError `path:line: ..`
[[nodiscard]] std::string prepare_urdf(const XmlFile& file, UnreadElements& unread);

}  // namespace thenar::internal

namespace thenar {

/// A URDF and the files that belong to it.
struct UrdfText {
  std::string text;
  std::map<std::string, TriangleMesh> meshes;  // meshes without a file, by the name of a new one
  std::vector<std::string> warnings;           // features that URDF cannot express
};

/// Returns the roll, pitch and yaw of URDF,  R = Rz(yaw) Ry(pitch) Rx(roll), accurate at any pitch.
/// @returns [rad] (3)
[[nodiscard]] Eigen::Vector3d roll_pitch_yaw(const Eigen::Matrix3d& R);

/// Writes a robot as URDF. There the frame of a link is that of its joint, so that each link is
/// expressed in the frame that its joint moves (X_JC is worked into its content). Every degree of
/// freedom is led by its first joint with ratio 1 and no offset, or otherwise by its first joint;
/// the others mimic it. Capsules become a cylinder and two spheres; shapes unknown to URDF become
/// meshes.
/// @param mesh_prefix  of the names of meshes that must be written, "hand_"
/// @throws InputError as check_robot().
[[nodiscard]] UrdfText robot_urdf(const RobotSpec& robot, const std::string& mesh_prefix);

/// Writes the URDF and its meshes beside it, all or none. @returns the warnings
[[nodiscard]] std::vector<std::string> write_urdf(const std::string& path, const RobotSpec& robot);

}  // namespace thenar
