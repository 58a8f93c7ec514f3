#pragma once

/// A bed of springs under a pad's skin: its spring, and the contact of a curved gap in closed form.

#include "pad_laws/contact_law.h"

namespace thenar {

/// A spring of the bed, h thick, pressed by delta under a patch of area pi r^2:
///   p = E e^m (1 + s e^2) (1 + c h / r),   e = delta / h.
/// The last factor is the tissue around the patch, which alone bears it where the pad is thick:
/// with m = 1 and c h / r large the force goes with R^(1/2) depth^(3/2), as Hertz's does.
///
/// The skin sinks beside the object, too, so that a patch is smaller than where undeformed surfaces
/// overlap. With the greatest depth d,
///   delta = d - spread (d - overlap),
/// which is the overlap for spread = 1, a plain bed, and makes a patch as small as Hertz's for 2.
/// Source: [Johnson1985] sec. 4.3 for the plain bed; spread and c are ours.
struct FoundationConstants {
  double modulus = 0;     // E [Pa]
  double exponent = 1;    // m, above 0 [1]
  double stiffening = 0;  // s, 0 and more [1]
  double surround = 0;    // c, 0 and more [1]
  double spread = 1;      // 1 and more [1]
  double thickness = 0;   // h where the pad touches, for ElasticFoundation [m]
  double shear = 0;       // G: tangential stress per strain of a spring that sticks [Pa]
};

/// @throws InputError unless E > 0, m > 0, s >= 0, c >= 0, spread >= 1, h > 0, G >= 0, all finite.
void check_foundation(const FoundationConstants& constants);

/// Pressure of a spring alone (c = 0) and its derivative by e. @param e  [1]
struct SpringPressure {
  double pressure = 0;   // [Pa]
  double stiffness = 0;  // dp/de [Pa]
  double energy = 0;     // integral of p de [Pa]
};
[[nodiscard]] SpringPressure spring_pressure(const FoundationConstants& constants, double e);

/// A bed of springs, all h thick, below a gap of heights (k1 x^2 + k2 y^2) / 2. With
/// R = 1 / sqrt(k1 k2) and e = depth / h:
///   F = 2 pi R h / spread E e^(m+1) (1 / (m+1) + s e^2 / (m+3)) (1 + c h / sqrt(a b)),
///   a = sqrt(2 depth / (spread k2)),   b = sqrt(2 depth / (spread k1)).
/// Torsion is that of the pressure, share mu mean_radius(a, b), with the share
/// (m+1) B(3/2, m+1) of a power m of the depth. The stiffness across is G area / h.
class ElasticFoundation final : public ContactLaw {
 public:
  /// @throws InputError as check_foundation() and check_exponential_terms().
  explicit ElasticFoundation(const FoundationConstants& constants,
                             std::vector<ExponentialTerm> terms = {});
  [[nodiscard]] LawContact at_depth(const RelativeCurvatures& gap, double depth,
                                    double friction) const override;
  [[nodiscard]] LawContact at_force(const RelativeCurvatures& gap, double force,
                                    double friction) const override;
  [[nodiscard]] const std::vector<ExponentialTerm>& relaxation() const override { return terms_; }

 private:
  FoundationConstants c_;
  double share_, share_stiff_;  // of torsion, of the powers m and m + 2
  std::vector<ExponentialTerm> terms_;
};

}  // namespace thenar
