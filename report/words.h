#pragma once

/// Phrases that several answers share.

#include <string>
#include <vector>

#include <Eigen/Core>

namespace thenar {

/// "MCP3_FE=10 PIP3=45 deg": angles of some joints.
/// @param names   of all coordinates (coordinates)
/// @param joints  which of them, in the order of the text
/// @param q       [rad] (coordinates)
[[nodiscard]] std::string angles_in_words(const std::vector<std::string>& names,
                                          const std::vector<int>& joints, const Eigen::VectorXd& q);

/// Angles of all joints, in the order of the coordinates.
[[nodiscard]] std::string angles_in_words(const std::vector<std::string>& names,
                                          const Eigen::VectorXd& q);

/// "flexion", "abduction" or "pronation": what a positive angle of a joint does, and a positive
/// moment arm, by the joint's name (docs/conventions.md).
[[nodiscard]] std::string positive_motion(const std::string& joint);

}  // namespace thenar
