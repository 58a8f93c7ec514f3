#pragma once

/// Pads built from the data of their files.

#include "data/io/pad/pad.h"
#include "pads/pad_model.h"

namespace thenar {

/// Returns the tissue law of a name in data files, name_of(TissueLaw).
/// @throws InputError, with the known names, if there is none.
[[nodiscard]] TissueLaw tissue_law_named(const std::string& name);
/// Returns the element of a name in data files, name_of(HexElement).
/// @throws InputError, with the known names, if there is none.
[[nodiscard]] HexElement pad_element_named(const std::string& name);

/// Builds a pad. Layers of PadSpec are ordered from the outside in; tissues of PadModel are the
/// pulp, then layers from the inside out.
/// @throws InputError if a tissue, a length or a count makes no sense: PadChart, check_tissue()
[[nodiscard]] PadModel build_pad(const PadSpec& spec);

}  // namespace thenar
