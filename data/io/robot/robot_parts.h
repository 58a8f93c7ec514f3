#pragma once

/// The parts of a robot file: each is read, checked and written by itself.

#include <cstring>
#include <string>
#include <vector>

#include "data/io/robot/robot.h"
#include "data/io/toml_table.h"

namespace thenar::internal {

/// How far a unit vector's length, or R R' - I of a rotation, may be off.
inline constexpr double kUnitTolerance = 1e-9;

/// How many sizes a kind of shape is given by; the rest stays 0.
[[nodiscard]] int size_count(ShapeKind kind);

/// Equal to the bit, signs of zero included.
template <typename Matrix>
[[nodiscard]] bool same_bits(const Matrix& a, const Matrix& b) {
  return std::memcmp(a.data(), b.data(), sizeof(double) * static_cast<std::size_t>(a.size())) == 0;
}

/// What one part must obey, whatever the rest is. @throws InputError
void check_pose(const Pose<double>& X, const std::string& whose);
void check_shape(const ShapeSpec& shape, const std::string& whose);
void check_link(const RobotLink& link);
void check_joint(const RobotJoint& joint);
void check_dof(const RobotDof& dof);

/// `position` with `rotation` (three rows), `quaternion_wxyz` or `rpy`, in a table of its own.
[[nodiscard]] Pose<double> read_pose(TomlTable& table);

/// A [[shape]]; a mesh file is found beside the file `path`.
[[nodiscard]] ShapeSpec read_shape(TomlTable& table, const std::string& path);

[[nodiscard]] RobotLink read_robot_link(TomlTable& table, const std::string& path);
[[nodiscard]] RobotJoint read_robot_joint(TomlTable& table);
[[nodiscard]] RobotDof read_robot_dof(TomlTable& table);

/// The joints of a [[dh_chain]]: rows of Denavit-Hartenberg parameters, standard convention.
[[nodiscard]] std::vector<RobotJoint> read_robot_dh_chain(TomlTable& table);

/// As TOML that reads back to the bit: -0.0, 0.1, 1e-07.
[[nodiscard]] std::string toml_number(double value);
[[nodiscard]] std::string toml_text(const std::string& text);
[[nodiscard]] std::string toml_list(const std::vector<double>& values);
[[nodiscard]] std::string toml_list(const std::vector<std::string>& values);
[[nodiscard]] std::string toml_list(const Eigen::Vector3d& v);

/// `position_m = [..], rotation = [[..]]`, parts that are those of no motion left out.
[[nodiscard]] std::vector<std::string> pose_lines(const Pose<double>& X);
[[nodiscard]] std::vector<std::string> shape_lines(const ShapeSpec& shape);

}  // namespace thenar::internal
