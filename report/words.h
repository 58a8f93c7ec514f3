#pragma once

/// Phrases that several answers share.

#include <string>
#include <vector>

#include <Eigen/Core>

namespace thenar {

/// Returns "FDP 0.12, LU 0.03": words on each of some items. @param words  of one of them
template <typename Items, typename Words>
[[nodiscard]] std::string each_in_words(const Items& items, const Words& words,
                                        const std::string& between = ", ") {
  std::string text;
  bool first = true;
  for (const auto& item : items) {
    text += (first ? "" : between) + words(item);
    first = false;
  }
  return text;
}

/// Returns "MCP3_FE=10 PIP3=45 deg": angles of some joints.
/// @param names   of all coordinates (coordinates)
/// @param joints  which of them, in the order of the text
/// @param q       [rad] (coordinates)
[[nodiscard]] std::string angles_in_words(const std::vector<std::string>& names,
                                          const std::vector<int>& joints, const Eigen::VectorXd& q);

/// Returns angles of all joints, in the order of the coordinates.
[[nodiscard]] std::string angles_in_words(const std::vector<std::string>& names,
                                          const Eigen::VectorXd& q);

/// Directions of a digit and their opposites.
inline constexpr const char* kDirectionWords[3][2] = {
    {"proximal", "distal"}, {"dorsal", "palmar"}, {"radial", "ulnar"}};

/// Returns "palmar" of a component (0, -1, 0) along proximal, dorsal and radial; "" of none.
[[nodiscard]] std::string direction_word(const Eigen::RowVector3i& signs);

/// Returns "flexion", "abduction" or "pronation": what a positive angle of a joint does, and a
/// positive moment arm, by the joint's name (docs/conventions.md).
[[nodiscard]] std::string positive_motion(const std::string& joint);

}  // namespace thenar
