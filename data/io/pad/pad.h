#pragma once

/// Finger pads as plain data: shape, tissues, elements, and where each number comes from.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/provenance.h"
#include "geometry/shape_spec.h"

namespace thenar {

/// One tissue of a pad: its pulp, or a layer of its skin.
struct PadTissueSpec {
  double thickness = 0;  // thickness of a layer [m]; 0 for the pulp, which fills the rest
  std::string law = "neo-hookean";  // "ogden", "veronda-westmann"
  double shear_modulus = 0;         // instantaneous shear modulus at zero strain [Pa]
  double exponent = 0;              // exponent of Ogden's law and of Veronda and Westmann's [1]
  double poisson_ratio = 0;         // Poisson's ratio at zero strain [1]
  std::vector<double> relaxation_share;  // share of the instantaneous stress (terms) [1]
  std::vector<double> relaxation_time;   // [s] (terms)
  std::string source;                    // citation keys
  std::vector<std::string> assumed;      // keys of the file whose values are not measured
};

/// A pad as a file states it. Frame: origin in the middle of the nail's plane, x distal, y radial,
/// z palmar.
struct PadSpec {
  std::string name, description;
  double length = 0, width = 0, height = 0;  // lengths of the skin, half an ellipsoid [m]
  double bone_length = 0, bone_width = 0,
         bone_height = 0;                  // lengths of the phalanx, half an ellipsoid [m]
  std::string shape_source;                // citation keys
  std::vector<std::string> shape_assumed;  // see PadTissueSpec::assumed
  std::optional<ShapeSpec> skin;           // closed, in the pad's frame; absent: the ellipsoid
  PadTissueSpec pulp;                      // tissue between the bone and the skin
  std::vector<PadTissueSpec> layers;       // layers of the skin, from the outside in
  std::string element = "Q1P0";            // "Q1", "F-bar", "Q2P1"
  int across = 4;     // cells of the coarsest mesh along the middle of the disc
  int around = 2;     // cells from there to the rim
  int through = 3;    // through the pulp
  FileDigests files;  // digests of the files that were read for it
  std::map<std::string, std::string> own_sources;  // citation keys that the file defines
};

/// Names as files have them.
[[nodiscard]] const std::vector<std::string>& tissue_law_names();
[[nodiscard]] const std::vector<std::string>& pad_element_names();

/// Returns whether a law has an exponent.
[[nodiscard]] bool has_exponent(const std::string& law);

/// Reads a pad (data/pads); docs/data_format.md describes the format. A mesh of the skin is beside
/// the file.
/// @throws DataError  `path:line: what was wanted, what came`.
[[nodiscard]] PadSpec read_pad(const std::string& path);
[[nodiscard]] PadSpec parse_pad(const std::string& text, const std::string& path);

/// Returns the text that parse_pad() reads back, numbers to 15 digits.
/// Of citation keys that are neither in data/sources.bib nor the pad's own, it says that they are
/// unstated.
/// @param comment  lines above it, without their '#'; empty: none
[[nodiscard]] std::string pad_toml(const PadSpec& pad, const std::string& comment = "");

/// Returns all keys that the file marks as not measured: "length_mm" of [shape], "law" of [pulp] ..
[[nodiscard]] std::vector<std::string> assumed_words(const PadSpec& pad);

}  // namespace thenar
