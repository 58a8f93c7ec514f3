#pragma once

/// Explanation of a digit: the parts of a subject that were built, and why others were dropped.

#include <string>
#include <vector>

#include "tendons/tendon_model.h"

namespace thenar {

/// Part of the subject that the digit was built without.
struct DroppedPart {
  std::string what;  // kind of part: "segment", "joint", "strand", "muscle", "hood"
  std::string name;
  std::string reason;  // reason, in words
};

/// Parts of a subject that a digit was built with, and those that were dropped.
struct DigitExplanation {
  std::vector<std::string> segments;  // kept segments, from the wrist outwards
  std::vector<std::string> joints;    // kept hinges, coupled ones included
  std::vector<std::string> strands;
  std::vector<std::string> muscles;
  std::string hood;  // distribution of tensions over the extensor mechanism, in words
  std::vector<DroppedPart> dropped;
};

/// Explains the result of build_tendon_digit(subject, name, options).
/// @param built  that result
[[nodiscard]] DigitExplanation explain_digit(const Subject& subject, const std::string& name,
                                             const TendonOptions& options,
                                             const TendonDigit& built);

}  // namespace thenar
