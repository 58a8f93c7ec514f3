#pragma once

/// Meaning of the names of parameters, in plain words.

#include <string>

#include "tendons/tendon_model.h"

namespace thenar {

/// Returns the common name of a joint: "DIP" of DIP3, "MCP flexion" of MCP3_FE, "CMC abduction" of
/// CMC1_AA; other names are returned unchanged.
[[nodiscard]] std::string joint_words(const std::string& joint);

/// Returns the meaning of a parameter, a coordinate of a fit or a quantity of a posterior in plain
/// words:
///   "path/FDP/1/dorsal"         "FDP, path point 1: shift dorsally"
///   "angle/PIP3/Hook"           "goniometer error at PIP in posture Hook"
///   "H01: noise/synek2019_H01"  "H01: noise of synek2019_H01 over the stated noise"
/// The names are in docs/conventions.md. Returns "" for an unknown name.
[[nodiscard]] std::string meaning_of(const std::string& name);

/// Returns the meaning of a name for a given digit, so that axes have anatomical directions:
///   "axis/DIP3/direction/1"     "DIP axis: tilt about the digit's length"
///   "axis/DIP3/point/2"         "DIP axis: shift dorsally"
/// A tilt along the tangent e of an axis d turns it about  d x e;  the stated direction is the
/// nearest one of the straight digit. 1 and 2 of a name are the tangents of base/spatial.h.
/// @param digit  digit before the fit
[[nodiscard]] std::string meaning_of(const std::string& name, const TendonDigit& digit);

}  // namespace thenar
