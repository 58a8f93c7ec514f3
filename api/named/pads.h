#pragma once

/// Finger pads by name or file.

#include <optional>
#include <string>

#include "pads/build_pad.h"

namespace thenar {

/// Options of a pad: its file or name, and values that replace those of the file.
struct PadRequest {
  std::string pad = "index_pad";   // a file, or the name of one of pads/
  std::string data;                // folder with pads/; empty: the usual ones
  std::string law;                 // material law of all its tissues; empty: as the file says
  std::optional<double> exponent;  // exponent of that law [1]; absent: as the file says
  std::string element;             // "Q1", "Q1P0", "F-bar", "Q2P1"; empty: as the file says
};

/// Pad found by name or file.
struct NamedPad {
  std::string path;  // path of its file
  PadSpec spec;      // numbers of the file with the requested changes
  PadModel model;    // model built from `spec`
};

/// Finds, reads and builds a pad.
/// @throws InputError if there is none of that name, or a law lacks its exponent; DataError for a
///         wrong file.
[[nodiscard]] NamedPad open_pad(const PadRequest& request);

/// Returns a sentence that lists the assumed, not measured, properties of a pad; "" if all are
/// measured.
[[nodiscard]] std::string assumption_of(const PadSpec& spec);

}  // namespace thenar
