#pragma once

/// Robots from URDF.

#include <map>
#include <string>
#include <vector>

#include "data/io/robot/import_xml.h"
#include "data/io/robot/robot.h"

namespace thenar {

/// Reads a URDF: links, inertials, collision shapes (visual ones where a link has no other),
/// joints, limits, dynamics and mimic joints, also mimics of mimics. Every moving joint that mimics
/// none is a degree of freedom; its speed is the joint's velocity limit, taken as relative,
/// downwards where its range lies below zero. A continuous joint gets one turn. Floating and planar
/// joints stay where they are. What is not read (transmissions, colours, sensors..) and what is
/// missing (mesh files) is in `warnings`.
/// @throws DataError `path:line: ..` for what is no URDF, and for xacro, which must be expanded
/// first.
[[nodiscard]] RobotSpec read_urdf(const std::string& path);

}  // namespace thenar

namespace thenar::internal {

// A URDF made fit for urdfdom, which refuses much that real files hold and drops much silently.

/// Beginning of the name that a capsule's mesh gets, which urdfdom knows nothing of:
/// "capsule:RADIUS LENGTH".
inline constexpr const char* kCapsule = "capsule:";

/// Checks every number and name with its line; takes out what is not read, noting it; fills in what
/// urdfdom insists on and has a plain default (effort, velocity, products of inertia).
/// @return the text for urdfdom
/// @throws DataError `path:line: ..`
[[nodiscard]] std::string prepare_urdf(const XmlFile& file, UnreadElements& unread);

}  // namespace thenar::internal

namespace thenar {

// Robots as URDF.

/// A URDF and the files that belong to it.
struct UrdfText {
  std::string text;
  std::map<std::string, TriangleMesh> meshes;  // surfaces that no file has, by their file's name
  std::vector<std::string> warnings;           // what URDF cannot say, also a comment in the text
};

/// Roll, pitch and yaw of URDF,  R = Rz(yaw) Ry(pitch) Rx(roll), to rounding at any pitch.
/// @return [rad] (3)
[[nodiscard]] Eigen::Vector3d roll_pitch_yaw(const Eigen::Matrix3d& R);

/// Writes a robot as URDF. A link's frame there is its joint's, so each link is told in the frame
/// that its joint moves (X_JC is worked into what the link holds). Every degree of freedom is led
/// by its first joint of ratio 1 and no offset, or else its first; the others mimic that one.
/// Capsules become a cylinder and two spheres; shapes that URDF lacks become meshes.
/// @param mesh_prefix  begins the names of the meshes that must be written, "hand_"
/// @throws InputError as check_robot().
[[nodiscard]] UrdfText robot_urdf(const RobotSpec& robot, const std::string& mesh_prefix);

/// Writes the URDF and its meshes beside it: all of them, or none. @return the warnings
[[nodiscard]] std::vector<std::string> write_urdf(const std::string& path, const RobotSpec& robot);

}  // namespace thenar
