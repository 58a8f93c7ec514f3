#pragma once

/// Paths of a digit's tendons, with few enough points to be drawn in every frame.

#include <string>
#include <vector>

#include "tendons/tendon_model.h"

namespace thenar {

/// Largest number of points of a tendon that is drawn in a hand; keeps frames small.
inline constexpr int kMaxStrandPoints = 8;

/// Path of one strand of a digit, from its insertion towards the muscle.
struct StrandPath {
  int strand = 0;  // index of the strand in the digit
  std::string name;
  TendonPath<double> nodes;  // 2 to kMaxStrandPoints via points on links of the digit's tree
};

/// Returns the name of a digit, "index"; empty if its skeleton has no tip.
[[nodiscard]] std::string digit_name(const TendonDigit& digit);

/// Returns the paths of all strands of a digit. A path ends at the first point that no joint of the
/// digit moves. Strands without a path are left out. Lines are straight between via points, also
/// for fitted and wrapped tendon paths.
[[nodiscard]] std::vector<StrandPath> strand_paths(const TendonDigit& digit);

}  // namespace thenar
