#include "report/words.h"

#include <numeric>

#include <fmt/format.h>

#include "base/units.h"
#include "tendons/name_conventions.h"

namespace thenar {

std::string angles_in_words(const std::vector<std::string>& names, const std::vector<int>& joints,
                            const Eigen::VectorXd& q) {
  std::string text;
  for (const int joint : joints)
    text += fmt::format("{}={:.4g} ", names[static_cast<std::size_t>(joint)], q[joint] / kDegree);
  return text + "deg";
}

std::string angles_in_words(const std::vector<std::string>& names, const Eigen::VectorXd& q) {
  std::vector<int> all(names.size());
  std::iota(all.begin(), all.end(), 0);
  return angles_in_words(names, all, q);
}

std::string direction_word(const Eigen::RowVector3i& signs) {
  for (int k = 0; k < 3; ++k)
    if (signs[k] != 0) return kDirectionWords[k][signs[k] > 0 ? 0 : 1];
  return "";
}

std::string positive_motion(const std::string& joint) {
  if (is_flexion_joint(joint)) return "flexion";
  return ends_with(joint, "_AA") ? "abduction" : "pronation";
}

}  // namespace thenar
