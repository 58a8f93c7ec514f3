#pragma once

/// Phrases that several results share.

#include <functional>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace thenar {

/// Returns the words on each item, joined: "FDP 0.12, LU 0.03". @param words  returns the words on
/// one item, or is a member of it
template <typename Items, typename Words>
[[nodiscard]] std::string each_in_words(const Items& items, const Words& words,
                                        const std::string& between = ", ") {
  std::string text;
  bool first = true;
  for (const auto& item : items) {
    text += (first ? "" : between) + std::invoke(words, item);
    first = false;
  }
  return text;
}

/// Returns the angles of some joints: "MCP3_FE=10 PIP3=45 deg".
/// @param names   names of all coordinates (coordinates)
/// @param joints  indices of the joints, in the order of the text
/// @param q       [rad] (coordinates)
[[nodiscard]] std::string angles_in_words(const std::vector<std::string>& names,
                                          const std::vector<int>& joints, const Eigen::VectorXd& q);

/// Returns the angles of all joints, in the order of the coordinates.
[[nodiscard]] std::string angles_in_words(const std::vector<std::string>& names,
                                          const Eigen::VectorXd& q);

/// Directions of a digit and their opposites.
inline constexpr const char* kDirectionWords[3][2] = {
    {"proximal", "distal"}, {"dorsal", "palmar"}, {"radial", "ulnar"}};

/// Returns the word for a direction along proximal, dorsal and radial: "palmar" for (0, -1, 0); ""
/// for zero.
[[nodiscard]] std::string direction_word(const Eigen::RowVector3i& signs);

/// Returns the motion of a positive angle and a positive moment arm of a joint, by its name
/// (docs/conventions.md): "flexion", "abduction" or "pronation".
[[nodiscard]] std::string positive_motion(const std::string& joint);

}  // namespace thenar
