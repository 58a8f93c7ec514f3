#pragma once

/// Search for an equilibrium of a net by other paths, where the usual path finds none.

#include "tendons/net/net_continuation.h"

namespace thenar {

/// Returns whether a net is in balance as tissue can be; also where it does not hold a muscle,
/// which no other way would change.
[[nodiscard]] inline bool is_sound(const NetEquilibrium& rest) {
  return rest.status == NetStatus::kBalanced || rest.status == NetStatus::kNodeCollapsed;
}

/// Looks for a sound equilibrium of a net at (q, t) on other ways than straight from the straight
/// finger: its joints bent one after the other, from either end; all muscles pulling evenly on the
/// way; the nodes where the bones carry them. Which one it finds first says only that there is one.
/// @param found  what the straight way led to; returned, with all solves counted, where no way
/// leads
///               to a sound one
[[nodiscard]] NetContinuation search_rest(const NetTendons& tendons, const Eigen::VectorXd& q,
                                          const Eigen::VectorXd& t, NetContinuation found,
                                          const NetContinuationOptions& options);

}  // namespace thenar
