#pragma once

/// Bed of springs under a pad's skin: law of a spring, and contact of a curved gap in closed form.

#include "pad_laws/contact_law.h"

namespace thenar {

/// Constants of the springs of a bed. A spring of thickness h, compressed by delta under a patch of
/// area pi r^2, has the pressure
///   p = E e^m (1 + s e^2) (1 + c h / r),   e = delta / h.
/// The last factor accounts for the tissue around the patch, which dominates where the pad is
/// thick: with m = 1 and c h / r large, force scales with R^(1/2) depth^(3/2), as in Hertz contact.
///
/// The skin also sinks beside the object, so the patch is smaller than the overlap of the
/// undeformed surfaces. With the largest depth d,
///   delta = d - spread (d - overlap),
/// which is the overlap for spread = 1, a plain bed, and gives a patch as small as Hertz's for 2.
/// Source: [Johnson1985] sec. 4.3 for the plain bed; spread and c are ours.
struct FoundationConstants {
  double modulus = 0;     // E [Pa]
  double exponent = 1;    // m, > 0 [1]
  double stiffening = 0;  // s, >= 0 [1]
  double surround = 0;    // c, >= 0 [1]
  double spread = 1;      // factor of the sinking skin, >= 1 [1]
  double thickness = 0;   // h where the pad touches, for ElasticFoundation [m]
  double shear = 0;       // G, tangential stress per strain of a sticking spring [Pa]
};

/// Checks the constants of a bed.
/// @throws InputError unless E > 0, m > 0, s >= 0, c >= 0, spread >= 1, h > 0, G >= 0, all finite.
void check_foundation(const FoundationConstants& constants);

/// Pressure of a spring alone (c = 0), its derivative and its integral by the strain e.
struct SpringPressure {
  double pressure = 0;   // [Pa]
  double stiffness = 0;  // dp/de [Pa]
  double energy = 0;     // integral of p de [Pa]
};
/// Computes the pressure of a spring. @param e  compressive strain [1]
[[nodiscard]] SpringPressure spring_pressure(const FoundationConstants& constants, double e);

/// Bed of springs of equal thickness h below a gap of height (k1 x^2 + k2 y^2) / 2. With
/// R = 1 / sqrt(k1 k2) and e = depth / h:
///   F = 2 pi R h / spread E e^(m+1) (1 / (m+1) + s e^2 / (m+3)) (1 + c h / sqrt(a b)),
///   a = sqrt(2 depth / (spread k2)),   b = sqrt(2 depth / (spread k1)).
/// Torsion follows from the pressure, share mu mean_radius(a, b), with the share
/// (m+1) B(3/2, m+1) for a power m of the depth. The tangential stiffness is G area / h.
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
  double share_, share_stiff_;  // shares of torsion for the powers m and m + 2 [1]
  std::vector<ExponentialTerm> terms_;
};

}  // namespace thenar
