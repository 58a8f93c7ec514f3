#pragma once

/// Tension of an elastic band or tendon.

namespace thenar {

/// Response of a band or tendon at one length.
struct BandResponse {
  double energy = 0;     // integral of the tension over the length [J]
  double tension = 0;    // >= 0 [N]
  double stiffness = 0;  // d tension / d length [N/m]
};

/// Tension of a band or tendon as a function of its length.
class TensionLaw {
 public:
  virtual ~TensionLaw() = default;
  /// Computes energy, tension and stiffness. @param length  length of the band or tendon [m]
  [[nodiscard]] virtual BandResponse response_at(double length) const = 0;
};

}  // namespace thenar
