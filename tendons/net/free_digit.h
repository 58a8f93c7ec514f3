#pragma once

/// Digit with all its joints free, and the transfer of a net built on it to the digit with frozen
/// joints.

#include "tendons/net/build_net.h"

namespace thenar {

/// Builds the digit with every joint free, on which a net is built: separate tendons, straight
/// between their points, of muscles that cross joints of the digit itself. Joints that digits share
/// stay welded at the reference posture if they are welded there in `digit`.
[[nodiscard]] TendonDigit free_digit(const Subject& subject, const TendonDigit& digit);

/// Transfers a net from a digit with all joints free to the same digit with frozen joints, where
/// bones are displaced. Muscles that the digit lacks have no pull.
/// @param whole  free_digit(), on which the net was built
[[nodiscard]] BuiltNet transferred(BuiltNet built, const TendonDigit& whole,
                                   const TendonDigit& digit);

}  // namespace thenar
