#pragma once

/// Postures over which a command sweeps: `PIP3=0:90:5`.

#include <string>
#include <vector>

#include "apps/tendon_question.h"

namespace thenar {

struct VariedJoints {
  std::vector<int> joints;                // coordinates, the last one varies fastest
  std::size_t row;                        // postures that differ in the last one only
  std::vector<Eigen::VectorXd> postures;  // all, row after row [rad] (coordinates)
};

/// @param q      angles of the joints that are not varied [rad] (coordinates)
/// @param texts  JOINT=from:to:step [deg]; `to` is met or not passed
/// @throws InputError for an unknown joint, one named twice, or steps that do not lead there.
[[nodiscard]] VariedJoints parse_varied(const Skeleton& skeleton, const Eigen::VectorXd& q,
                                        const std::vector<std::string>& texts);

/// "MCP3_FE=10 PIP3=45 deg" of the varied joints.
[[nodiscard]] std::string angles_in_words(const TendonCase& at, const VariedJoints& varied,
                                          const Eigen::VectorXd& q);

}  // namespace thenar
