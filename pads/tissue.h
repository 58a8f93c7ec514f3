#pragma once

/// Constitutive laws of soft tissue at finite strain: nearly incompressible, quasi-linear
/// viscoelastic.

#include <array>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "base/enum_names.h"
#include "pad_laws/exponential_memory.h"

namespace thenar {

/// Isochoric energies W, functions of the stretches of  Fbar = J^(-1/3) F:
///   neo-Hookean      W = mu/2 (I1 - 3)
///   Ogden            W = 2 mu / k^2 (l1^k + l2^k + l3^k - 3), one term of exponent k
///   Veronda-Westmann W = mu/k (exp(k (I1 - 3)) - 1) - mu/2 (I2 - 3)
/// with shear modulus mu at rest; I1, I2 of Fbar Fbar'.
enum class TissueLaw { kNeoHookean, kOgden, kVerondaWestmann };
inline constexpr std::array kTissueLawNames{
    EnumName{TissueLaw::kNeoHookean, "neo-hookean"}, EnumName{TissueLaw::kOgden, "ogden"},
    EnumName{TissueLaw::kVerondaWestmann, "veronda-westmann"}};
[[nodiscard]] inline std::string name_of(TissueLaw law) { return name_in(kTissueLawNames, law); }

/// Material of a tissue. Its volumetric energy is  U(J) = K/4 (J^2 - 1 - 2 ln J),  with bulk
/// modulus K = 2 mu (1 + nu) / (3 (1 - 2 nu)); the pressure does not relax.
///
/// Stress relaxes quasi-linearly: the isochoric second Piola-Kirchhoff stress is
///   S(t) = integral of g(t - s) dSe(s),  g(t) = g_inf + sum g_i exp(-t / tau_i),
/// with the elastic stress Se of the law, g(0) = 1; steps are those of memory_step().
/// Sources: [Holzapfel2000] ch. 6 for the laws, [VerondaWestmann1970], [Ogden1972], [Fung1993] for
/// quasi-linear relaxation.
struct Tissue {
  std::string name = "tissue";
  TissueLaw law = TissueLaw::kNeoHookean;
  double shear_modulus = 0;                 // mu, instantaneous, at rest [Pa]
  double exponent = 0;                      // k, for Ogden and Veronda-Westmann [1]
  double poisson_ratio = 0.49;              // nu, at rest [1]
  std::vector<ExponentialTerm> relaxation;  // terms of g(t); empty: elastic
};

/// Returns the bulk modulus K [Pa].
[[nodiscard]] double bulk_modulus(const Tissue& tissue);

/// Checks the constants of a tissue.
/// @throws InputError unless mu > 0, -1 < nu < 1/2, k is not 0 (Ogden) or above 0
/// (Veronda-Westmann), shares are not negative and sum to less than 1, times are positive.
void check_tissue(const Tissue& tissue);

/// Six components of a symmetric tensor: xx, yy, zz, xy, yz, zx.
using Voigt = Eigen::Matrix<double, 6, 1>;
[[nodiscard]] inline Voigt voigt_of(const Eigen::Matrix3d& a) {
  Voigt out;
  out << a(0, 0), a(1, 1), a(2, 2), a(0, 1), a(1, 2), a(2, 0);
  return out;
}
[[nodiscard]] inline Eigen::Matrix3d tensor_of(const Voigt& a) {
  Eigen::Matrix3d out;
  out << a[0], a[3], a[5], a[3], a[1], a[4], a[5], a[4], a[2];
  return out;
}
/// Components c_ijkl of a tangent with minor and major symmetries, rows and columns ordered as in
/// Voigt.
using VoigtTangent = Eigen::Matrix<double, 6, 6>;

/// Isochoric response at a deformation.
struct IsochoricResponse {
  double energy = 0;             // W [J/m^3]
  Voigt stress = Voigt::Zero();  // Kirchhoff stress, deviatoric [Pa] (6)
  // Lie derivative of the Kirchhoff stress, F F F F : 4 d^2W/dC^2 [Pa]
  VoigtTangent tangent = VoigtTangent::Zero();
};

/// Computes energy, stress and tangent of the isochoric law.
/// @param F  deformation gradient, det F > 0 [1] (3, 3)
/// @param with_tangent  whether to compute `tangent`
/// Source: [Holzapfel2000] eqs 6.91, 6.103, 6.168; spectral form of Ogden's [Simo1998] sec. 2.4.
void isochoric_response(const Tissue& tissue, const Eigen::Matrix3d& F, bool with_tangent,
                        IsochoricResponse& out);

/// Returns the shear modulus of the isotropic tangent with the same trace as a response's tangent,
/// at least a tenth of that at rest, so that it can be a divisor [Pa].
[[nodiscard]] double tangent_shear_modulus(const Tissue& tissue, const IsochoricResponse& at);

/// Volumetric energy and its derivatives by J.
struct VolumetricResponse {
  double energy = 0, pressure = 0, stiffness = 0;  // U [J/m^3], U', U'' [Pa]
};
/// Computes the volumetric response. @param J  dilatation, > 0 [1]
[[nodiscard]] VolumetricResponse volumetric_response(double bulk_modulus, double J);

}  // namespace thenar
