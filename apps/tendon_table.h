#pragma once

#include <string>
#include <vector>

#include "apps/tendon_question.h"

namespace thenar {

/// One row a posture under a header with units: angles, status, slips, bands, arms, torques, force.
[[nodiscard]] std::string csv_of(const TendonCase& at, const std::vector<DigitPoint>& points);

/// The same as one list a column.
[[nodiscard]] nlohmann::ordered_json json_of(const TendonCase& at,
                                             const std::vector<DigitPoint>& points);

}  // namespace thenar
