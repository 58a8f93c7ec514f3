#pragma once

/// Changes of contact modes within a step: whether there is one, and when.

#include <vector>

#include "dynamics/stepping/contact_step.h"

namespace thenar {

/// Returns true if the same contacts have forces in the same modes, and none slides the other way.
/// Contacts that open have no force and are ignored.
[[nodiscard]] bool same_modes(const std::vector<ActiveContact>& a,
                              const std::vector<ActiveContact>& b);

/// Largest slip, before, of the contacts that then slide the other way [m/s], [rad/s].
[[nodiscard]] double slip_that_turned(const std::vector<ActiveContact>& before,
                                      const std::vector<ActiveContact>& after);

/// Share of a substep after which the first mode changes, if margins go on as in the substep
/// before: the normal force of what opens, the friction that is left where a contact sticks, the
/// slip where it slides, each a straight line over the two. 1 if no margin falls; 1/2 if nothing
/// is known of the substep before.
/// @param earlier, now, next  contacts two substeps before its end, one before, and there
[[nodiscard]] double share_before_change(const std::vector<ActiveContact>& earlier,
                                         const std::vector<ActiveContact>& now,
                                         const std::vector<ActiveContact>& next);

}  // namespace thenar
