#pragma once

/// What kind of grasp it is, as far as contacts tell.

#include <string>
#include <vector>

#include "grasp/contact/contact.h"
#include "hand/hand.h"

namespace thenar {

/// A column of the table of grasps by power, opposition and number of opposing digits, like
/// "power, palm, 4 digits", "precision, pad, 2 digits", "intermediate, side, 2 digits":
///   palm       the palm and a digit touch; what follows counts digits besides the opposing one
///   pad        the opposing digit and others touch, not the palm: power if a link before the last
///              of a digit touches, else precision
///   side       digits without the opposing one and the palm
/// The opposing digit is "thumb", else the one that presses most against all others. What contacts
/// cannot tell is left out: adducted or abducted thumb, pads from sides of a finger (a lateral
/// pinch counts as pad), and the object's shape, which parts the other rows of the table.
/// "palm alone" or "one digit" where nothing opposes.
/// Source: [Feix2016].
[[nodiscard]] std::string grasp_type(const Hand& hand, const std::vector<HandContact>& contacts);

/// The digit that opposes the others: "thumb" if the hand has one; empty if it has not.
[[nodiscard]] std::string thumb_of(const Hand& hand);

}  // namespace thenar
