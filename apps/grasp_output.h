#pragma once

/// What `thenar grasp` and `thenar close` found, as text, JSON and a report.

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "apps/grasp_answer.h"

namespace thenar {

/// @param pictures  projections and slices of the wrench set as meshes, too
[[nodiscard]] nlohmann::ordered_json grasp_json(const GraspQuestion& question,
                                                const CollisionHand& touching,
                                                const GraspAnswer& answer, bool pictures = false);
[[nodiscard]] std::string grasp_text(const GraspQuestion& question, const CollisionHand& touching,
                                     const GraspAnswer& answer);

/// One line for all warnings of a kind, those that begin alike up to the first comma or colon: the
/// first of them, with how many more there are.
[[nodiscard]] std::vector<std::string> folded(const std::vector<std::string>& warnings);

/// A page of the grasp; human hands are smoothest where the question asked for pictures. @throws
/// InputError
void write_grasp_report(const GraspQuestion& question, const CollisionHand& touching,
                        const GraspAnswer& answer, const std::string& path);

}  // namespace thenar
