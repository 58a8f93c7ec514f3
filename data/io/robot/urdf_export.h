#pragma once

/// Robots as URDF.

#include <map>
#include <string>
#include <vector>

#include "data/io/robot/robot.h"

namespace thenar {

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
