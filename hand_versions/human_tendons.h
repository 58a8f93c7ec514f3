#pragma once

/// Tendons of a human hand, digit by digit.

#include <string>
#include <vector>

#include "base/fidelity.h"
#include "hand_versions/human_hand.h"
#include "hand_versions/tendon_hand.h"

namespace thenar {

/// Tendons of a subject's hand, with the assumptions made for them.
struct HumanTendons {
  HandTendons hand;                   // tendons of each of the subject's digits
  std::vector<std::string> warnings;  // assumptions, omissions and simplified models
};

/// Builds the tendons of build_human_hand(), with any model of extensors: a floating net where a
/// finger can carry it, with a warning where not; else the hood's fractions where the subject has
/// them, and separate tendons elsewhere.
/// @throws InputError as build_tendon_digit() and muscle_forces().
[[nodiscard]] HumanTendons human_tendons(const Subject& subject, Hood extensors,
                                         const HumanHandOptions& options = {});

}  // namespace thenar
