#pragma once

#include <string>

#include "data/io/units.h"

namespace thenar {

/// The largest size of a quantity that a file may state [SI]: far beyond any hand, robot or object,
/// near enough that no formula overflows and a wrong unit (120 m for 120 mm) is noticed.
[[nodiscard]] double largest_of(Dimension dimension);

/// A value in SI, for messages: "10 m".
[[nodiscard]] std::string with_si_unit(double value, Dimension dimension);

}  // namespace thenar
