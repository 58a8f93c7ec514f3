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

/// A direction as written, made a unit vector unless it is one to rounding already.
[[nodiscard]] Eigen::Vector3d read_unit(TomlTable& table, const std::string& key);

[[nodiscard]] RobotLink read_robot_link(TomlTable& table, const std::string& path);
[[nodiscard]] RobotJoint read_robot_joint(TomlTable& table);
[[nodiscard]] RobotDof read_robot_dof(TomlTable& table);

/// The joints of a [[dh_chain]]: rows of Denavit-Hartenberg parameters, standard convention.
[[nodiscard]] std::vector<RobotJoint> read_robot_dh_chain(TomlTable& table);

}  // namespace thenar::internal
