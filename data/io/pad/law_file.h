#pragma once

/// Calibrated laws of pads as TOML.

#include <string>

#include "data/io/pad/pad.h"
#include "pad_laws/calibrated_laws.h"

namespace thenar {

/// Reads the laws of a pad; the format is in docs/data_format.md.
/// @throws DataError  `path:line: what was wanted, what came`.
[[nodiscard]] CalibratedLaws read_laws(const std::string& path);
[[nodiscard]] CalibratedLaws parse_laws(const std::string& text, const std::string& path);

/// Writes laws as text, from which every bit comes back.
/// @param source  how they were found, for the file's [sources]
/// @throws InputError as check_laws(), or if the name or the source is empty.
[[nodiscard]] std::string laws_text(const CalibratedLaws& laws, const std::string& source);

/// Returns a warning where laws carry the digest of other numbers than the pad's; "" if they fit,
/// or if their file states no digest.
[[nodiscard]] std::string version_doubt(const CalibratedLaws& laws, const PadSpec& pad);

}  // namespace thenar
