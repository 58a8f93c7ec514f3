#pragma once

/// Ways of a digit's tendons, thinned so that they can be drawn in every frame.

#include <string>
#include <vector>

#include "tendons/tendon_model.h"

namespace thenar {

/// Most points of a tendon that is drawn in a hand, so that a frame stays small.
inline constexpr int kLinePoints = 8;

/// The path of one strand of a digit, from its end on the bone towards the muscle.
struct StrandPath {
  int strand = 0;  // of the digit
  std::string name;
  TendonPath<double> nodes;  // 2 to kLinePoints of its via points, links of the digit's own tree
};

/// "index": the name of a digit; empty if its skeleton has no tip.
[[nodiscard]] std::string digit_name(const TendonDigit& digit);

/// Paths of all strands of a digit. The muscle's way up the forearm ends at the first point that no
/// joint of the digit moves. Strands without a path are left out; on the rungs `fitted` and
/// `wrapped` lines run straight through via points, too.
[[nodiscard]] std::vector<StrandPath> strand_paths(const TendonDigit& digit);

}  // namespace thenar
