// Bodies in uniform strain against closed forms, at large stretches of every law and element.

#include <cmath>
#include <random>
#include <tuple>

#include <gtest/gtest.h>

#include "tests/pads/body_newton.h"
#include "tests/pads/tissue_samples.h"

namespace thenar {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

/// Principal Kirchhoff stresses at principal stretches, written in these.
Vector3d principal_stress(const Tissue& tissue, const Vector3d& stretch) {
  const double mu = tissue.shear_modulus, k = tissue.exponent, J = stretch.prod();
  const Eigen::Array3d bar = stretch.array() / std::cbrt(J);
  Eigen::Array3d out;
  if (tissue.law == TissueLaw::kOgden) {
    out = 2 * mu / k * bar.pow(k);
  } else if (tissue.law == TissueLaw::kNeoHookean) {
    out = mu * bar.square();
  } else {
    // l dW/dl with I1 = sum l^2 and, as their product is 1, I2 = sum l^-2.
    out = 2 * mu * std::exp(k * (bar.square().sum() - 3)) * bar.square() + mu * bar.pow(-2);
  }
  const double bulk = 2 * mu * (1 + tissue.poisson_ratio) / (3 * (1 - 2 * tissue.poisson_ratio));
  return out - out.mean() + bulk / 2 * (J * J - 1);
}

/// The stretch of the axes that are free, all alike, at which they carry no stress.
double free_stretch(const Tissue& tissue, Vector3d stretch, const std::vector<int>& free) {
  double low = 0.05, high = 5;
  for (int k = 0; k < 200; ++k) {
    const double middle = 0.5 * (low + high);
    for (const int axis : free) stretch[axis] = middle;
    (principal_stress(tissue, stretch)[free[0]] < 0 ? low : high) = middle;
  }
  return low;
}

/// Which axes of a cube are pulled, and which are free; others are held.
struct Pull {
  const char* name;
  std::vector<int> pulled, free;
};

using UniformCase = std::tuple<HexElement, TissueLaw>;
class UniformStrain : public testing::TestWithParam<UniformCase> {
 protected:
  /// A unit cube of 2 x 2 x 2 crooked cells, pulled in steps to a stretch; each face of the cube
  /// that holds or pulls is free to glide. Compares all forces with the closed form.
  static void pull(const Pull& pull, double stretch) {
    Tissue tissue = neo_hookean(3, 0.49);
    tissue.law = std::get<1>(GetParam());
    tissue.exponent = tissue.law == TissueLaw::kOgden ? -3.3 : 0.7;
    HexMesh mesh = crooked_cube();
    if (std::get<0>(GetParam()) == HexElement::kQuadratic)
      mesh.refine(std::vector<int>(mesh.active()));
    const std::vector<bool> none(static_cast<std::size_t>(mesh.nodes()), false);
    const TissueBody body(mesh, std::get<0>(GetParam()), {tissue}, none);
    // Planes through the origin hold; those at 1 hold or pull where the axis is not free.
    HeldComponents held(static_cast<std::size_t>(body.unknowns()), false);
    for (std::size_t i = 0; i < body.free_nodes().size(); ++i)
      for (int axis = 0; axis < 3; ++axis) {
        const double at = mesh.place(body.free_nodes()[i])[axis];
        const bool is_free = std::find(pull.free.begin(), pull.free.end(), axis) != pull.free.end();
        held[3 * i + static_cast<std::size_t>(axis)] = at < 1e-9 || (at > 1 - 1e-9 && !is_free);
      }
    VectorXd x = VectorXd::Zero(body.unknowns());
    constexpr int kSteps = 10;
    Vector3d to(1, 1, 1);
    for (int step = 1; step <= kSteps; ++step) {
      const Vector3d from = to;
      for (const int axis : pull.pulled) to[axis] = std::pow(stretch, step / (1.0 * kSteps));
      // The inside follows along the axes that are pulled; the others find their way.
      for (std::size_t i = 0; i < body.free_nodes().size(); ++i)
        for (int axis = 0; axis < 3; ++axis)
          x[static_cast<Eigen::Index>(3 * i) + axis] +=
              mesh.place(body.free_nodes()[i])[axis] * (to[axis] - from[axis]);
      ASSERT_GE(bring_to_rest(body, held, VectorXd::Zero(x.size()), x), 0)
          << pull.name << ' ' << to.transpose();
    }
    for (const int axis : pull.free) to[axis] = free_stretch(tissue, to, pull.free);
    // Nominal stress of each plane at 1, whose area was 1.
    const Eigen::Matrix3Xd reactions = body.reactions(body.node_displacements(x, {}), 0, {});
    const Vector3d expected = principal_stress(tissue, to).cwiseQuotient(to);
    const double scale = expected.lpNorm<Eigen::Infinity>();
    for (int axis = 0; axis < 3; ++axis) {
      double force = 0;
      for (int node = 0; node < mesh.nodes(); ++node)
        if (mesh.place(node)[axis] > 1 - 1e-9) force += reactions(axis, node);
      EXPECT_NEAR(force, expected[axis], 1e-9 * scale) << pull.name << ' ' << to.transpose();
    }
  }

  static HexMesh crooked_cube() {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> shift(-0.08, 0.08);
    const std::vector<double> halves = even_axis(0, 1, 2);
    return graded_box(halves, halves, halves, [&](const Vector3d& p) -> Vector3d {
      const bool inside = (p.array() > 0.1 && p.array() < 0.9).all();
      return inside ? Vector3d(p + Vector3d(shift(random), shift(random), shift(random))) : p;
    });
  }
};

TEST_P(UniformStrain, UniaxialIsTheClosedForm) {
  for (const double stretch : {0.5, 1.6, 2.0}) pull({"uniaxial", {2}, {0, 1}}, stretch);
}

TEST_P(UniformStrain, EquibiaxialIsTheClosedForm) {
  for (const double stretch : {0.7, 1.5}) pull({"equibiaxial", {0, 1}, {2}}, stretch);
}

TEST_P(UniformStrain, PlanarIsTheClosedForm) {
  for (const double stretch : {0.6, 1.7}) pull({"planar", {0}, {2}}, stretch);
}

INSTANTIATE_TEST_SUITE_P(
    All, UniformStrain,
    testing::Combine(testing::Values(HexElement::kDisplacement, HexElement::kMeanDilatation,
                                     HexElement::kCentroidDilatation, HexElement::kQuadratic),
                     testing::Values(TissueLaw::kNeoHookean, TissueLaw::kOgden,
                                     TissueLaw::kVerondaWestmann)),
    [](const auto& test) {
      std::string name = name_of(std::get<0>(test.param)) + name_of(std::get<1>(test.param));
      name.erase(std::remove(name.begin(), name.end(), '-'), name.end());
      return name;
    });

}  // namespace
}  // namespace thenar
