#pragma once

/// Numbers of a subject that no hand has: most often of another unit.

#include <string>
#include <vector>

#include "data/io/subject.h"

namespace thenar {

/// What to look at before a subject is trusted, a sentence each: digits shorter than 15 mm or
/// longer than 0.5 m from their first joint to the tip, ranges of joints below 4 degrees, constant
/// moment arms that are all below 0.1 mm or one above 0.1 m, path points more than 1 m apart,
/// forces above 5 kN. Choices of ours, wide of hands of children and large robots.
[[nodiscard]] std::vector<std::string> subject_doubts(const Subject& subject);

}  // namespace thenar
