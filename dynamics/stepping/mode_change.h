#pragma once

/// Detection of contact mode changes within a step, and an estimate of their instant.

#include <vector>

#include "dynamics/stepping/contact_step.h"

namespace thenar {

/// Returns true if the same contacts have forces in the same modes, and none slides the other way.
/// Contacts that open have no force and are ignored.
[[nodiscard]] bool same_modes(const std::vector<ActiveContact>& a,
                              const std::vector<ActiveContact>& b);

/// Returns the largest slip in `before` of contacts that slide the other way in `after` [m/s],
/// [rad/s].
[[nodiscard]] double max_reversed_slip(const std::vector<ActiveContact>& before,
                                       const std::vector<ActiveContact>& after);

/// Estimates the fraction of a substep after which the first contact changes its mode, by linear
/// extrapolation of its margin from the previous substep: the normal force of a contact that opens,
/// the remaining friction of one that sticks, the slip of one that slides [1]. 1 if no margin
/// falls; 1/2 if the previous substep is unknown.
/// @param earlier, now, next  contacts at the start of the previous substep, at the start of this
///                            one and at its end
[[nodiscard]] double fraction_before_change(const std::vector<ActiveContact>& earlier,
                                            const std::vector<ActiveContact>& now,
                                            const std::vector<ActiveContact>& next);

}  // namespace thenar
