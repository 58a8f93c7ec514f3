#include "pads/tissue.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Eigenvalues>

#include "base/error.h"

namespace thenar {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr std::array<int, 6> kRow{0, 1, 2, 0, 1, 2}, kColumn{0, 1, 2, 1, 2, 0};
// Relative difference of squared stretches up to which they count as equal [1]
constexpr double kEqualStretches = 1e-6;

/// Returns the deviator of a symmetric tensor.
Voigt deviator(const Voigt& a) {
  Voigt out = a;
  out.head<3>().array() -= (a[0] + a[1] + a[2]) / 3;
  return out;
}

/// Replaces a tangent by  P : a : P,  P the deviatoric projection.
void project(VoigtTangent& a) {
  for (int j = 0; j < 6; ++j) a.col(j).head<3>().array() -= a.col(j).head<3>().mean();
  for (int i = 0; i < 6; ++i) a.row(i).head<3>().array() -= a.row(i).head<3>().mean();
}

/// Adds  s (I - 1/3 1 x 1)  and  -2/3 (t x 1 + 1 x t)  of an isochoric tangent, eq. 6.168.
void add_isochoric_parts(double s, const Voigt& t, VoigtTangent& c) {
  for (int i = 0; i < 3; ++i) {
    c(i, i) += s;
    c(i + 3, i + 3) += 0.5 * s;
    for (int j = 0; j < 3; ++j) c(i, j) -= s / 3 + 2.0 / 3 * (t[i] + t[j]);
  }
  for (int i = 3; i < 6; ++i)
    for (int j = 0; j < 3; ++j) {
      c(i, j) -= 2.0 / 3 * t[i];
      c(j, i) -= 2.0 / 3 * t[i];
    }
}

/// Computes the response of laws in the invariants of bbar.
void invariant_response(const Tissue& tissue, const Matrix3d& F, bool with_tangent,
                        IsochoricResponse& out) {
  const double mu = tissue.shear_modulus;
  // Compute the isochoric left Cauchy-Green tensor  b = J^(-2/3) F F'.
  const double J = F.determinant();
  const double scale = 1 / std::cbrt(J * J);
  const Matrix3d b = scale * (F * F.transpose());
  const double I1 = b.trace();
  const Voigt bv = voigt_of(b);
  // Compute the first derivatives by I1 and I2, and the second one by I1.
  double W1 = mu / 2, W2 = 0, W11 = 0;
  out.energy = mu / 2 * (I1 - 3);
  const bool exponential = tissue.law == TissueLaw::kVerondaWestmann;
  Voigt b2v = Voigt::Zero();
  double I2 = 0;
  if (exponential) {
    const Matrix3d b2 = b * b;
    b2v = voigt_of(b2);
    I2 = 0.5 * (I1 * I1 - b2.trace());
    const double k = tissue.exponent, e = std::exp(k * (I1 - 3));
    W1 = mu * e;
    W11 = mu * k * e;
    W2 = -mu / 2;
    out.energy = mu / k * std::expm1(k * (I1 - 3)) - mu / 2 * (I2 - 3);
  }
  // Compute the Kirchhoff stress, the deviator of 2 (W1 + I1 W2) b - 2 W2 b^2.
  const Voigt bar = 2 * (W1 + I1 * W2) * bv - 2 * W2 * b2v;
  out.stress = deviator(bar);
  if (!with_tangent) return;
  if (exponential) {
    // Add  4 (W11 + W2) b x b - 4 W2 b [] b,  (b [] b)_ijkl = (b_ik b_jl + b_il b_jk) / 2.
    out.tangent.noalias() = 4 * (W11 + W2) * bv * bv.transpose();
    for (int p = 0; p < 6; ++p)
      for (int q = p; q < 6; ++q) {
        const int i = kRow[p], j = kColumn[p], k = kRow[q], l = kColumn[q];
        const double both = 2 * W2 * (b(i, k) * b(j, l) + b(i, l) * b(j, k));
        out.tangent(p, q) -= both;
        if (p != q) out.tangent(q, p) -= both;
      }
    project(out.tangent);
  } else {
    out.tangent.setZero();
  }
  add_isochoric_parts(2.0 / 3 * (bar[0] + bar[1] + bar[2]), out.stress, out.tangent);
}

/// Computes the response of Ogden's law, in principal stretches.
void principal_response(const Tissue& tissue, const Matrix3d& F, bool with_tangent,
                        IsochoricResponse& out) {
  const double mu = tissue.shear_modulus, k = tissue.exponent;
  // Compute the squares of the isochoric stretches l_a, and their directions.
  const double J = F.determinant();
  const Eigen::SelfAdjointEigenSolver<Matrix3d> spectrum(F * F.transpose() / std::cbrt(J * J));
  const Vector3d& square = spectrum.eigenvalues();  // squared isochoric stretches [1]
  const Matrix3d& n = spectrum.eigenvectors();
  const Vector3d power = square.array().pow(k / 2);
  out.energy = 2 * mu / (k * k) * (power.sum() - 3);
  // Compute the principal stresses,  2 mu / k (l_a^k - mean).
  const Vector3d beta = (2 * mu / k) * (power.array() - power.mean());
  out.stress = voigt_of(n * beta.asDiagonal() * n.transpose());
  if (!with_tangent) return;
  // Add  d beta_a / d ln l_b = 2 mu (delta_ab l_a^k - (l_a^k + l_b^k)/3 + mean/3).
  out.tangent.setZero();
  std::array<Voigt, 3> m;
  for (int a = 0; a < 3; ++a) m[a] = voigt_of(n.col(a) * n.col(a).transpose());
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b) {
      const double by =
          2 * mu * ((a == b ? power[a] : 0) - (power[a] + power[b]) / 3 + power.mean() / 3);
      out.tangent.noalias() += (by - (a == b ? 2 * beta[a] : 0)) * m[a] * m[b].transpose();
    }
  for (int a = 0; a < 3; ++a)
    for (int b = a + 1; b < 3; ++b) {
      // Add the shear factor  (beta_a l_b^2 - beta_b l_a^2) / (l_a^2 - l_b^2),  or its limit.
      const double apart = square[a] - square[b];
      const double factor = std::abs(apart) > kEqualStretches * square[a]
                                ? (beta[a] * square[b] - beta[b] * square[a]) / apart
                                : mu * 0.5 * (power[a] + power[b]) - 0.5 * (beta[a] + beta[b]);
      const Voigt both =
          voigt_of(n.col(a) * n.col(b).transpose() + n.col(b) * n.col(a).transpose());
      out.tangent.noalias() += factor * both * both.transpose();
    }
}

}  // namespace

double bulk_modulus(const Tissue& tissue) {
  const double nu = tissue.poisson_ratio;
  return 2 * tissue.shear_modulus * (1 + nu) / (3 * (1 - 2 * nu));
}

void check_tissue(const Tissue& tissue) {
  const std::string& name = tissue.name;
  require(tissue.shear_modulus > 0 && std::isfinite(tissue.shear_modulus),
          "shear modulus of '{}' must be above 0, got {} Pa", name, tissue.shear_modulus);
  require(tissue.poisson_ratio > -1 && tissue.poisson_ratio < 0.5,
          "Poisson's ratio of '{}' must be above -1 and below 0.5, got {}", name,
          tissue.poisson_ratio);
  require(std::isfinite(tissue.exponent), "exponent of '{}' is not finite", name);
  if (tissue.law == TissueLaw::kOgden)
    require(tissue.exponent != 0, "Ogden's exponent of '{}' must not be 0", name);
  if (tissue.law == TissueLaw::kVerondaWestmann)
    require(tissue.exponent > 0, "exponent of '{}' must be above 0, got {}", name, tissue.exponent);
  check_exponential_terms(tissue.relaxation, fmt::format("'{}'", name).c_str());
}

void isochoric_response(const Tissue& tissue, const Matrix3d& F, bool with_tangent,
                        IsochoricResponse& out) {
  if (tissue.law == TissueLaw::kOgden)
    principal_response(tissue, F, with_tangent, out);
  else
    invariant_response(tissue, F, with_tangent, out);
}

double tangent_shear_modulus(const Tissue& tissue, const IsochoricResponse& at) {
  constexpr double kMinModulusRatio = 0.1;  // least tangent shear modulus over that at rest [1]
  // The isotropic tangent is 2 mu times the deviatoric projection, whose trace is 5.
  const auto& diagonal = at.tangent.diagonal();
  const double trace = diagonal.head<3>().sum() + 2 * diagonal.tail<3>().sum();
  return std::max(trace / 10, kMinModulusRatio * tissue.shear_modulus);
}

VolumetricResponse volumetric_response(double bulk_modulus, double J) {
  const double e = J - 1;  // keeps small energies exact
  return {bulk_modulus / 4 * (e * (2 + e) - 2 * std::log1p(e)), bulk_modulus / 2 * (J - 1 / J),
          bulk_modulus / 2 * (1 + 1 / (J * J))};
}

}  // namespace thenar
