#pragma once

/// Page about the information that published measurements add to prior knowledge of a thumb's axes.

#include <string>

#include "report/blocks.h"
#include "studies/questions/study.h"

namespace thenar {

/// Returns the section about published measurements: their values, the predictions of models, and
/// the sds of tilts that remain once they are added, to the prior and to the posterior of simulated
/// data.
[[nodiscard]] Json measured_lessons_section(const ThumbRecoveryResult& result);

/// Ratio of the sd of each tilt after an update to that before: rms, smallest and largest over
/// tilts.
struct KeptShares {
  double rms, least, most;         // [1]
  std::string least_name;          // "CMC1_AA tilt 2"
  double largest_shift;            // largest shift of a mean, in plain sds [1]
  std::string largest_shift_name;  // name of the quantity with the largest shift
  int narrower = 0;                // tilts with a ratio below 1 by two errors [1]
  int undecided = 0;               // tilts with a ratio above kUndecidedShare [1]
};
/// Computes the shares. @param update  update with reliable weights
[[nodiscard]] KeptShares kept_shares(const ReweightedDraws& draws, const DataUpdate& update);

/// Returns "" if weights are reliable; else " (NOT reliable ..)", or " (NOT known ..)" without
/// numbers.
[[nodiscard]] std::string doubt_of(const DataUpdate& update);

/// Returns the update by both measurements with their stated sds.
[[nodiscard]] const DataUpdate& update_by_both(const ReweightedDraws& draws);

}  // namespace thenar
