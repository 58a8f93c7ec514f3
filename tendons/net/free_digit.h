#pragma once

/// A digit with all its joints free, and what was built on it carried to the digit with some
/// frozen.

#include "tendons/net/build_net.h"

namespace thenar {

/// The digit with every joint free, which a net is laid on: separate tendons, straight between
/// their points, of muscles that cross joints of its own. Joints that digits share stay welded at
/// the reference posture if they are in `digit`.
[[nodiscard]] TendonDigit free_digit(const Subject& subject, const TendonDigit& digit);

/// Moves the parts of a net from a digit with all joints free to the same digit with some of them
/// frozen, on which bones are displaced. Muscles that it has not pull with nothing.
/// @param whole  free_digit(), on which the net was built
[[nodiscard]] BuiltNet carried(BuiltNet built, const TendonDigit& whole, const TendonDigit& digit);

}  // namespace thenar
