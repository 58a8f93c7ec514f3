#pragma once

/// The units that a TOML key may end with, and what they are in SI.

#include <string>
#include <vector>

namespace thenar {

/// What a number measures.
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
  kLinearDamping
};

/// One way to write a dimension: `point_mm = 5` is 5 * 0.001 m.
struct Unit {
  std::string suffix;  // of the key, without the underscore; empty for kNumber
  Dimension dimension;
  double to_si;  // SI units in one of these
};

/// Every unit known, the usual one of each dimension first.
[[nodiscard]] const std::vector<Unit>& all_units();

/// The units of one dimension.
[[nodiscard]] std::vector<Unit> units_of(Dimension dimension);

/// How a dimension is called in messages: "a length".
[[nodiscard]] std::string dimension_name(Dimension dimension);

}  // namespace thenar
