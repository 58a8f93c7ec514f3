#pragma once

/// Which version of a pad laws were fitted to: a digest of the numbers that presses depend on.

#include <string>

#include "data/io/pad/pad.h"
#include "pads/laws/calibrated_laws.h"

namespace thenar {

/// SHA-256, in hexadecimal digits, of the pad's shape, its own skin and its tissues with their
/// relaxation, numbers to 12 digits, so that other units of a file make no other pad. Names, cells,
/// sources and what is assumed have no part in it.
[[nodiscard]] std::string pad_digest(const PadSpec& pad);

/// A warning where laws carry the digest of other numbers than the pad's; "" if they fit, or if
/// their file tells no digest.
[[nodiscard]] std::string version_doubt(const CalibratedLaws& laws, const PadSpec& pad);

}  // namespace thenar
