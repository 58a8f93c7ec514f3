#pragma once

/// Point contact laws of a pad: hard point, power law, soft finger.

#include "pad_laws/contact_law.h"

namespace thenar {

/// Reference lengths of the constants of laws.
inline constexpr double kLawDepth = 1e-3;    // reference depth [m]
inline constexpr double kLawRadius = 10e-3;  // reference radius 1 / sqrt(k1 k2) of a gap [m]

/// Rigid point: any force at depth 0, no patch, no torsion; beyond depth 0 the force is infinite.
class HardPoint final : public ContactLaw {
 public:
  [[nodiscard]] LawContact at_depth(const RelativeCurvatures& gap, double depth,
                                    double friction) const override;
  [[nodiscard]] LawContact at_force(const RelativeCurvatures& gap, double force,
                                    double friction) const override;
  [[nodiscard]] const std::vector<ExponentialTerm>& relaxation() const override { return none_; }

 private:
  std::vector<ExponentialTerm> none_;
};

/// Constants of a force that is a power of depth, and a patch that is a power of force, for all
/// objects:
///   F = k (depth / 1 mm)^n,   a = b = c (F / 1 N)^gamma,   torsion = share mu a,
/// with the tangential stiffness 16/3 G a, where G is the shear modulus of a half space.
/// Source: [XydasKao1999] for the radius, [Johnson1985] section 7.2 for the stiffness.
struct PowerLawConstants {
  double force = 0;           // k: force at 1 mm [N]
  double depth_exponent = 1;  // n, > 0 [1]
  double patch = 0;           // c: radius at 1 N [m]
  double patch_exponent = 0;  // gamma: 1/3 for linear elasticity, 0 for ideal softness [1]
  double torsion = 0;         // share: 2/3 for even pressure, 3 pi/16 for Hertz's [1]
  double shear = 0;           // G [Pa]
};

class PowerLaw final : public ContactLaw {
 public:
  /// @throws InputError unless k > 0, n > 0, c >= 0, gamma in [0, 1/3], share in [0, 1], all
  /// finite, and the terms pass check_exponential_terms().
  explicit PowerLaw(const PowerLawConstants& constants, std::vector<ExponentialTerm> terms = {});
  [[nodiscard]] LawContact at_depth(const RelativeCurvatures& gap, double depth,
                                    double friction) const override;
  [[nodiscard]] LawContact at_force(const RelativeCurvatures& gap, double force,
                                    double friction) const override;
  [[nodiscard]] const std::vector<ExponentialTerm>& relaxation() const override { return terms_; }

 private:
  [[nodiscard]] LawContact answer(double depth, double force, double friction) const;
  PowerLawConstants c_;
  std::vector<ExponentialTerm> terms_;
};

/// Constants of a soft finger, whose force and elliptical patch depend on the shape of the gap.
/// With R = 1 / sqrt(k1 k2),
///   F = k (depth / 1 mm)^n (R / 10 mm)^q,        torsion = share mu mean_radius(a, b),
///   sqrt(a b) = c (F / 1 N)^gamma (R / 10 mm)^s,  a / b = (k1 / k2)^e.
/// Hertz's contact of balls has n = 3/2, q = 1/2, gamma = s = 1/3; a layer of linear springs n = 2,
/// q = 1, gamma = s = 1/4, e = 1/2. The limit surface is the ellipsoid of [Howe1996] with this
/// torsion, the tangential stiffness that of PowerLawConstants at sqrt(a b).
struct SoftFingerConstants {
  double force = 0;            // k: force at a depth of 1 mm and a radius of 10 mm [N]
  double depth_exponent = 1;   // n, > 0 [1]
  double radius_exponent = 0;  // q: exponent of the radius in the force [1]
  double patch = 0;            // c: mean radius of the patch at 1 N and a radius of 10 mm [m]
  double patch_exponent = 0;   // gamma, >= 0: exponent of the force in the patch [1]
  double patch_radius = 0;     // s: exponent of the radius in the patch [1]
  double aspect = 0;           // e: exponent of the ratio of curvatures in a / b [1]
  double torsion = 0;          // share of torsion [1]
  double shear = 0;            // G [Pa]
};

class SoftFinger final : public ContactLaw {
 public:
  /// @throws InputError unless k > 0, n > 0, c >= 0, gamma >= 0, share in [0, 1], all finite, and
  /// the terms pass check_exponential_terms().
  explicit SoftFinger(const SoftFingerConstants& constants,
                      std::vector<ExponentialTerm> terms = {});
  [[nodiscard]] LawContact at_depth(const RelativeCurvatures& gap, double depth,
                                    double friction) const override;
  [[nodiscard]] LawContact at_force(const RelativeCurvatures& gap, double force,
                                    double friction) const override;
  [[nodiscard]] const std::vector<ExponentialTerm>& relaxation() const override { return terms_; }

 private:
  [[nodiscard]] LawContact answer(const internal::GapRadius& gap, double depth, double force,
                                  double friction) const;
  SoftFingerConstants c_;
  std::vector<ExponentialTerm> terms_;
};

}  // namespace thenar
