#include "pads/tissue.h"

#include <cmath>

#include <gtest/gtest.h>
#include <Eigen/LU>

#include "base/error.h"

namespace thenar {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Tissue law_tissue(TissueLaw law) {
  Tissue tissue;
  tissue.law = law;
  tissue.shear_modulus = 3;
  tissue.exponent = law == TissueLaw::kOgden ? -3.3 : 1.7;
  return tissue;
}

Matrix3d some_deformation() {
  Matrix3d F;
  F << 1.3, .2, .1, -.1, .8, .05, .15, -.2, 1.1;
  return F;
}

class TissueLaws : public testing::TestWithParam<TissueLaw> {};

TEST_P(TissueLaws, StressIsTheDerivativeOfEnergy) {
  const Tissue tissue = law_tissue(GetParam());
  const Matrix3d F = some_deformation();
  IsochoricResponse at, plus, minus;
  isochoric_response(tissue, F, false, at);
  constexpr double kStep = 1e-6;
  Matrix3d P;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      Matrix3d moved = F;
      moved(i, j) += kStep;
      isochoric_response(tissue, moved, false, plus);
      moved(i, j) -= 2 * kStep;
      isochoric_response(tissue, moved, false, minus);
      P(i, j) = (plus.energy - minus.energy) / (2 * kStep);
    }
  EXPECT_LT((P * F.transpose() - tensor_of(at.stress)).norm(), 1e-8 * at.stress.norm() * 10);
}

TEST_P(TissueLaws, TangentIsTheLieDerivativeOfStress) {
  const Tissue tissue = law_tissue(GetParam());
  // Also at two equal stretches, where spectral forms have a limit.
  for (const Matrix3d& F : {some_deformation(), Matrix3d(Vector3d(1.2, 1.2, 0.9).asDiagonal()),
                            Matrix3d(1.1 * Matrix3d::Identity())}) {
    IsochoricResponse at, plus, minus;
    isochoric_response(tissue, F, true, at);
    constexpr double kStep = 1e-6;
    const Matrix3d tau = tensor_of(at.stress);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        Matrix3d H = Matrix3d::Zero();
        H(i, j) = 1;
        isochoric_response(tissue, F + kStep * H * F, false, plus);
        isochoric_response(tissue, F - kStep * H * F, false, minus);
        const Voigt rate = (plus.stress - minus.stress) / (2 * kStep);
        Voigt strain = voigt_of(0.5 * (H + H.transpose()));
        strain.tail<3>() *= 2;
        const Voigt expected = at.tangent * strain + voigt_of(H * tau + tau * H.transpose());
        EXPECT_LT((rate - expected).norm(), 1e-8 * at.tangent.norm()) << i << j;
      }
  }
}

TEST_P(TissueLaws, AtRestIsLinearElasticityWithItsShearModulus) {
  IsochoricResponse at;
  isochoric_response(law_tissue(GetParam()), Matrix3d::Identity(), true, at);
  VoigtTangent expected = VoigtTangent::Zero();  // 2 mu (I - 1/3 1 x 1)
  expected.topLeftCorner<3, 3>().setConstant(-2.0);
  expected.diagonal() << 4, 4, 4, 3, 3, 3;
  EXPECT_LT((at.tangent - expected).norm(), 1e-12);
  EXPECT_LT(at.stress.norm(), 1e-14);
}

TEST_P(TissueLaws, NoStressOfRotations) {
  const Matrix3d R = Eigen::AngleAxisd(0.7, Vector3d(1, 2, -1).normalized()).toRotationMatrix();
  IsochoricResponse at;
  isochoric_response(law_tissue(GetParam()), R, false, at);
  EXPECT_LT(at.stress.norm(), 1e-14);
  EXPECT_NEAR(at.energy, 0, 1e-14);
}

INSTANTIATE_TEST_SUITE_P(All, TissueLaws,
                         testing::Values(TissueLaw::kNeoHookean, TissueLaw::kOgden,
                                         TissueLaw::kVerondaWestmann));

/// Difference of two principal Kirchhoff stresses at volume-preserving stretches.
double difference(TissueLaw law, const Vector3d& stretch) {
  IsochoricResponse at;
  isochoric_response(law_tissue(law), stretch.asDiagonal(), false, at);
  return at.stress[0] - at.stress[2];
}

TEST(Tissue, UniaxialStressIsTheClosedForm) {
  for (const double l : {0.6, 1.0, 1.8}) {
    const Vector3d stretch(l, 1 / std::sqrt(l), 1 / std::sqrt(l));
    EXPECT_NEAR(difference(TissueLaw::kNeoHookean, stretch), 3 * (l * l - 1 / l), 1e-12);
    EXPECT_NEAR(difference(TissueLaw::kOgden, stretch),
                2 * 3 / -3.3 * (std::pow(l, -3.3) - std::pow(l, 3.3 / 2)), 1e-12);
    // 2 (l^2 - 1/l) (W1 + W2 / l)
    const double W1 = 3 * std::exp(1.7 * (l * l + 2 / l - 3));
    EXPECT_NEAR(difference(TissueLaw::kVerondaWestmann, stretch),
                2 * (l * l - 1 / l) * (W1 - 1.5 / l), 1e-11);
  }
}

TEST(Tissue, EquibiaxialStressIsTheClosedForm) {
  for (const double l : {0.8, 1.3}) {
    const Vector3d stretch(l, l, 1 / (l * l));
    const double square = l * l - std::pow(l, -4);
    EXPECT_NEAR(difference(TissueLaw::kNeoHookean, stretch), 3 * square, 1e-12);
    EXPECT_NEAR(difference(TissueLaw::kOgden, stretch),
                2 * 3 / -3.3 * (std::pow(l, -3.3) - std::pow(l, 2 * 3.3)), 1e-12);
    const double W1 = 3 * std::exp(1.7 * (2 * l * l + std::pow(l, -4) - 3));
    EXPECT_NEAR(difference(TissueLaw::kVerondaWestmann, stretch), 2 * square * (W1 - 1.5 * l * l),
                1e-11);
  }
}

TEST(Tissue, OgdenWithExponentTwoIsNeoHookean) {
  Tissue ogden = law_tissue(TissueLaw::kOgden);
  ogden.exponent = 2;
  IsochoricResponse a, b;
  isochoric_response(ogden, some_deformation(), true, a);
  isochoric_response(law_tissue(TissueLaw::kNeoHookean), some_deformation(), true, b);
  EXPECT_NEAR(a.energy, b.energy, 1e-13);
  EXPECT_LT((a.stress - b.stress).norm(), 1e-13);
  EXPECT_LT((a.tangent - b.tangent).norm(), 1e-12);
}

TEST(Tissue, VolumetricResponseIsDerivedFromItsEnergy) {
  constexpr double kBulk = 7, kStep = 1e-5;
  for (const double J : {0.5, 1.0, 1.4}) {
    const VolumetricResponse at = volumetric_response(kBulk, J);
    const VolumetricResponse plus = volumetric_response(kBulk, J + kStep),
                             minus = volumetric_response(kBulk, J - kStep);
    EXPECT_NEAR(at.pressure, (plus.energy - minus.energy) / (2 * kStep), 1e-8);
    EXPECT_NEAR(at.stiffness, (plus.pressure - minus.pressure) / (2 * kStep), 1e-8);
  }
  EXPECT_NEAR(volumetric_response(kBulk, 1).stiffness, kBulk, 1e-14);
}

TEST(Tissue, BulkModulusFollowsFromPoissonsRatio) {
  Tissue tissue = law_tissue(TissueLaw::kNeoHookean);
  tissue.poisson_ratio = 0.25;  // K = 5/3 mu
  EXPECT_NEAR(bulk_modulus(tissue), 5, 1e-14);
}

TEST(Tissue, RelaxationIsExactForRampsAndHolds) {
  Tissue tissue = law_tissue(TissueLaw::kNeoHookean);
  tissue.relaxation = {{0.3, 0.07}, {0.2, 1.4}};
  // The elastic stress rises straight from 0 to 1 in 0.1 s, then stays.
  constexpr double kRise = 0.1;
  const auto exact = [&](double t) {
    double sum = 0.5 * std::min(t / kRise, 1.0);
    for (const ExponentialTerm& term : tissue.relaxation) {
      const double end = std::min(t, kRise);
      sum += term.share * term.time / kRise *
             (std::exp((end - t) / term.time) - std::exp(-t / term.time));
    }
    return sum;
  };
  double t = 0, elastic = 0;
  std::vector<double> terms{0, 0};
  for (const double h : {0.04, 0.06, 0.5, 3.0}) {
    const MemoryStep step = memory_step(tissue.relaxation, h);
    const double next = std::min((t + h) / kRise, 1.0);
    double stress = step.now * next;
    for (std::size_t i = 0; i < terms.size(); ++i) {
      const double past = step.decay[i] * terms[i] - step.change[i] * elastic;
      stress += past;
      terms[i] = past + step.change[i] * next;
    }
    t += h;
    elastic = next;
    EXPECT_NEAR(stress, exact(t), 1e-14) << t;
  }
}

TEST(Tissue, NonsenseIsRefused) {
  const auto with = [](auto change) {
    Tissue tissue = law_tissue(TissueLaw::kVerondaWestmann);
    change(tissue);
    return tissue;
  };
  EXPECT_NO_THROW(check_tissue(with([](Tissue&) {})));
  EXPECT_THROW(check_tissue(with([](Tissue& t) { t.shear_modulus = 0; })), InputError);
  EXPECT_THROW(check_tissue(with([](Tissue& t) { t.shear_modulus = NAN; })), InputError);
  EXPECT_THROW(check_tissue(with([](Tissue& t) { t.poisson_ratio = 0.5; })), InputError);
  EXPECT_THROW(check_tissue(with([](Tissue& t) { t.exponent = 0; })), InputError);
  EXPECT_THROW(check_tissue(with([](Tissue& t) {
                 t.relaxation = {{0.6, 1}, {0.4, 2}};
               })),
               InputError);
  EXPECT_THROW(check_tissue(with([](Tissue& t) { t.relaxation = {{0.6, 0}}; })), InputError);
}

}  // namespace
}  // namespace thenar
