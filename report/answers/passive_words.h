#pragma once

/// Phrases about passive moments of joints in a result.

#include <string>

#include <Eigen/Core>

#include "api/named/digit_result.h"
#include "hand/skeleton.h"
#include "report/fields.h"

namespace thenar {

/// Returns the passive moments as a line of text: "passive joint moments, included [N mm]:
/// MCP2_FE -12.1, PIP2 3.2"; empty if no joint has any.
/// @param q  [rad] (coordinates)
[[nodiscard]] std::string passive_line(const Skeleton& skeleton, const Eigen::VectorXd& q);
/// Returns the passive moments of a sweep's only posture; if there are several, a line without
/// numbers.
[[nodiscard]] std::string passive_line(const DigitResult& about);

/// Adds "passive_moment", by coordinate, where a joint has any.
void add_passive(const Skeleton& skeleton, const Eigen::VectorXd& q, Fields& fields);
/// Adds "passive_moment" at a posture of a sweep. @param point  index of the posture
void add_passive(const DigitResult& about, std::size_t point, Fields& fields);

}  // namespace thenar
