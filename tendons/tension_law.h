#pragma once

/// Tension of what stretches.

namespace thenar {

/// Response of a band or tendon at some length.
struct BandResponse {
  double energy;     // integral of the tension over the length [J]
  double tension;    // >= 0 [N]
  double stiffness;  // d tension / d length [N/m]
};

/// Tension of a band or tendon by its length.
class TensionLaw {
 public:
  virtual ~TensionLaw() = default;
  /// @param length  [m]
  [[nodiscard]] virtual BandResponse at(double length) const = 0;
};

}  // namespace thenar
