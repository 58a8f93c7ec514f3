#pragma once

/// Readers and checks of the parts of a robot file.

#include <cstring>
#include <string>
#include <vector>

#include "data/io/robot/robot.h"
#include "data/io/toml_table.h"

namespace thenar::internal {

/// Tolerance of the length of unit vectors, and of R R' - I of rotations [1].
inline constexpr double kUnitTolerance = 1e-9;

/// Returns whether two matrices are equal to the bit, including the sign of zero.
template <typename Matrix>
[[nodiscard]] bool same_bits(const Matrix& a, const Matrix& b) {
  return std::memcmp(a.data(), b.data(), sizeof(double) * static_cast<std::size_t>(a.size())) == 0;
}

/// Checks of a single part. @throws InputError
void check_pose(const Pose<double>& X, const std::string& whose);
void check_shape(const ShapeSpec& shape, const std::string& whose);
void check_link(const RobotLink& link);
void check_joint(const RobotJoint& joint);
void check_dof(const RobotDof& dof);

/// Dimensions of the numbers of a joint or motor.
struct Measures {
  Dimension value, effort, stiffness, damping;
};

/// Returns the dimensions of what slides, or of what turns.
[[nodiscard]] const Measures& measures_of(bool slides);

/// Reads a direction as written; normalises it unless it is a unit vector up to rounding.
[[nodiscard]] Eigen::Vector3d read_unit(TomlTable& table, const std::string& key);

/// Readers of one link, joint, or degree of freedom. @throws DataError
[[nodiscard]] RobotLink read_robot_link(TomlTable& table, const std::string& path);
[[nodiscard]] RobotJoint read_robot_joint(TomlTable& table);
[[nodiscard]] RobotDof read_robot_dof(TomlTable& table);

/// Reads the joints of a [[dh_chain]]: rows of Denavit-Hartenberg parameters, standard convention.
[[nodiscard]] std::vector<RobotJoint> read_robot_dh_chain(TomlTable& table);

}  // namespace thenar::internal
