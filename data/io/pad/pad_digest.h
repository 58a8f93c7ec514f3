#pragma once

/// Digest of the numbers of a pad on which presses depend; it identifies the pad's version.

#include <string>

#include "data/io/pad/pad.h"

namespace thenar {

/// Returns the SHA-256, in hexadecimal digits, of the pad's shape, its own skin and its tissues
/// with their relaxation, numbers to 12 digits, so that other units of a file make no other pad.
/// Names, cells, sources and what is assumed have no part in it.
[[nodiscard]] std::string pad_digest(const PadSpec& pad);

}  // namespace thenar
