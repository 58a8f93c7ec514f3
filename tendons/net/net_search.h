#pragma once

/// Search for an equilibrium of a net by alternative ways, where the usual way finds none.

#include "tendons/net/net_continuation.h"

namespace thenar {

/// Returns whether an equilibrium is acceptable: balanced with loads that tissue tolerates. A net
/// that fails to hold a muscle counts too, since no other way would change that.
[[nodiscard]] inline bool is_sound(const NetEquilibrium& rest) {
  return rest.status == NetStatus::kBalanced || rest.status == NetStatus::kNodeCollapsed;
}

/// Searches for a sound equilibrium of a net at (q, t) by other ways than straight from the
/// straight finger: joints bent one after the other, from either end; all muscles pulling evenly on
/// the way; nodes where the bones carry them. The first one found shows only that one exists.
/// @param found  result of the straight way; returned, with all solves counted, where no way leads
/// to a sound one
[[nodiscard]] NetContinuation search_rest(const NetTendons& tendons, const Eigen::VectorXd& q,
                                          const Eigen::VectorXd& t, NetContinuation found,
                                          const NetContinuationOptions& options);

}  // namespace thenar
