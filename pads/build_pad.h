#pragma once

/// Pads from their files.

#include "data/io/pad/pad.h"
#include "pads/pad_model.h"

namespace thenar {

/// The law called as data files call it: name_of(TissueLaw). @throws InputError with the names
[[nodiscard]] TissueLaw tissue_law_named(const std::string& name);
/// The element called as data files call it: name_of(HexElement). @throws InputError with the names
[[nodiscard]] HexElement pad_element_named(const std::string& name);

/// A pad ready to be pressed. Layers of PadSpec run from the outside in; tissues of PadModel are
/// the pulp, then layers from the inside out.
/// @throws InputError if a tissue, a length or a count makes no sense: PadChart, check_tissue()
[[nodiscard]] PadModel build_pad(const PadSpec& spec);

}  // namespace thenar
