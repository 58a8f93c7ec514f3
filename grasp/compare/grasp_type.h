#pragma once

/// Type of a grasp, as far as its contacts tell.

#include <string>
#include <vector>

#include "grasp/contact/contact.h"
#include "hand/hand.h"

namespace thenar {

/// Column of the GRASP taxonomy: power, opposition, and the digits that touch, like
/// "power, palm, thumb and 4 digits", "precision, pad, thumb and 2 digits", "intermediate, side, 2
/// digits". A digit called "thumb" is named, all others are counted; in a hand without thumb, like
/// jaws, both sides count: "precision, pad, 2 digits".
///   palm       the palm and a digit touch
///   pad        a digit opposes others, without the palm: power if a link before the last of a
///              digit touches, otherwise precision
///   side       digits without the opposing digit and the palm
/// The opposing digit is "thumb", in a hand without one any that presses against all others. What
/// contacts cannot tell is left out: adducted or abducted thumb, pads or sides of a finger (a
/// lateral pinch counts as pad), and the shape of the object, by which the other rows of the table
/// differ. "palm alone" or "one digit" where nothing opposes. Source: [Feix2016].
[[nodiscard]] std::string grasp_type(const Hand& hand, const std::vector<HandContact>& contacts);

/// Returns whether a type is a pinch: "precision, pad".
[[nodiscard]] bool is_pinch(const std::string& type);

/// The digit that opposes the others: "thumb" if the hand has one; empty if it has not.
[[nodiscard]] std::string thumb_of(const Hand& hand);

}  // namespace thenar
