#pragma once

/// A fitted coordinate in its own unit.

#include <optional>
#include <string>

#include "kinematics_fit/fit.h"

namespace thenar {

/// Estimate of a coordinate of a fit, in a readable unit.
struct CoordinateInUnit {
  double value = 0, sd = 0;  // [unit]
  double prior_sd = 0;       // prior sd of the only specimen or of the population [unit]
  std::string unit;          // "mm", "deg", "1/rad", "1"
};

/// Returns the value of an entry of z in its own unit; absent for a deviation from a population, in
/// which it is not linear where there are bounds.
[[nodiscard]] std::optional<CoordinateInUnit> value_in_unit(const Fit& fit, int entry);

/// Returns the estimate in words: "+8.52 ± 0.30 mm".
[[nodiscard]] std::string words_of(const CoordinateInUnit& value);

}  // namespace thenar
