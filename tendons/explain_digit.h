#pragma once

/// Explanation of a digit: the parts of a subject that building it kept, and why it dropped others.

#include <string>
#include <vector>

#include "tendons/tendon_model.h"

namespace thenar {

/// A part of the subject that the digit was built without.
struct DroppedPart {
  std::string what;  // "segment", "joint", "strand", "muscle", "hood"
  std::string name;
  std::string reason;
};

struct DigitExplanation {
  std::vector<std::string> segments;  // kept, from the wrist outwards
  std::vector<std::string> joints;    // kept hinges, coupled ones too
  std::vector<std::string> strands;
  std::vector<std::string> muscles;
  std::string hood;  // how tensions spread over the extensor mechanism, in words
  std::vector<DroppedPart> dropped;
};

/// Explains build_tendon_digit(subject, name, options).
/// @param built  its result
[[nodiscard]] DigitExplanation explain_digit(const Subject& subject, const std::string& name,
                                             const TendonOptions& options,
                                             const TendonDigit& built);

}  // namespace thenar
