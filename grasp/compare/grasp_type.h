#pragma once

/// Type of a grasp, inferred from its contacts.

#include <string>
#include <vector>

#include "grasp/contact/contact.h"
#include "hand/hand.h"

namespace thenar {

/// Returns the column of the GRASP taxonomy: power, opposition, and the digits in contact, such as
/// "power, palm, thumb and 4 digits", "precision, pad, thumb and 2 digits", "intermediate, side, 2
/// digits". A digit called "thumb" is named, all others are counted; in a hand without a thumb,
/// such as jaws, both sides count: "precision, pad, 2 digits".
///   palm       the palm and a digit are in contact
///   pad        a digit opposes others, without the palm: power if a link before the last of a
///              digit is in contact, otherwise precision
///   side       digits without the opposing digit and the palm
/// The opposing digit is "thumb", in a hand without one any that presses against all others. The
/// type leaves out what contacts do not show: an adducted or abducted thumb, pads or sides of a
/// finger (a lateral pinch counts as pad), and the shape of the object, by which the other rows of
/// the table differ. Without opposition it is "palm alone" or "one digit". Source: [Feix2016].
[[nodiscard]] std::string grasp_type(const Hand& hand, const std::vector<HandContact>& contacts);

/// Returns whether a type is a pinch: "precision, pad".
[[nodiscard]] bool is_pinch(const std::string& type);

/// Returns the digit that opposes the others: "thumb" if the hand has one; otherwise empty.
[[nodiscard]] std::string opposing_digit(const Hand& hand);

}  // namespace thenar
