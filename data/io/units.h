#pragma once

/// Units at the end of TOML keys, and their values in SI.

#include <string>
#include <vector>

namespace thenar {

/// Physical dimension of a number.
enum class Dimension {
  kNumber,  // dimensionless: no unit in the key
  kLength,
  kAngle,
  kMass,
  kForce,
  kMoment,
  kArea,
  kInertia,
  kStress,
  kAcceleration,
  kDensity,
  kAngularStiffness,
  kAngularDamping,
  kLinearStiffness,
  kLinearDamping,
  kTime,
  kSpeed,
  kAngularSpeed,
  kInverseSpeed
};

/// A unit: `point_mm = 5` is 5 * 0.001 m.
struct Unit {
  std::string suffix;  // suffix of the key, without the underscore; empty for kNumber
  Dimension dimension;
  double to_si;  // value in SI: [1] for kNumber, [m] for kLength, ..
};

/// Returns all known units, the usual unit of each dimension first.
[[nodiscard]] const std::vector<Unit>& all_units();

/// Returns the units of one dimension.
[[nodiscard]] std::vector<Unit> units_of(Dimension dimension);

/// Returns the name of a dimension in messages: "a length".
[[nodiscard]] std::string dimension_name(Dimension dimension);

/// Returns the largest size of a quantity that a file may state [SI]: far beyond any hand, robot or
/// object, small enough that no formula overflows and a wrong unit (120 m for 120 mm) is noticed.
[[nodiscard]] double largest_of(Dimension dimension);

/// Returns a value in SI, for messages: "10 m".
[[nodiscard]] std::string with_si_unit(double value, Dimension dimension);

}  // namespace thenar
