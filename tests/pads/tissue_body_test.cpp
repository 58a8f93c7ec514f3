#include "pads/tissue_body.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "base/error.h"
#include "tests/pads/tissue_samples.h"

namespace thenar {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using Eigen::VectorXd;

Tissue tissue_of(double poisson_ratio) {
  Tissue tissue;
  tissue.shear_modulus = 1;
  tissue.poisson_ratio = poisson_ratio;
  return tissue;
}

/// Newton's method of the mixed problem from a start; how many iterations it took, -1 if it failed.
int solve(const TissueBody& body, const Matrix3Xd& at_fixed, VectorXd& x) {
  SparseCholesky factor(body.pattern());
  TissueResponse at;
  // The tangent at rest predicts how the inside follows its boundary.
  const VectorXd rest = VectorXd::Zero(body.unknowns());
  body.evaluate(body.node_displacements(rest, {}), 0, {}, {}, ElementRequest::kStiffness, at);
  if (!factor.factor(at.tangent)) return -1;
  constexpr double kSmall = 1e-5;
  body.evaluate(body.node_displacements(rest, kSmall * at_fixed), 0, {}, {}, ElementRequest::kForce,
                at);
  x = -factor.solve(at.force) / kSmall;
  TissuePressure pressure = body.predict_pressure(body.node_displacements(rest, {}),
                                                  body.node_displacements(x, at_fixed));
  for (int k = 0; k < 20; ++k) {
    const Matrix3Xd u = body.node_displacements(x, at_fixed);
    body.evaluate(u, 0, {}, pressure, ElementRequest::kStiffness, at);
    if (at.inverted || !factor.factor(at.tangent)) return -1;
    // Rounding of forces grows with the stiffness, which bulk moduli make large.
    const double stiffest = *std::max_element(at.tangent.begin(), at.tangent.end());
    if (at.force.lpNorm<Eigen::Infinity>() < 1e-12 * stiffest) return k;
    const VectorXd dx = -factor.solve(at.force);
    pressure = body.predict_pressure(u, body.node_displacements(dx, {}));
    x += dx;
  }
  return -1;
}

class TissueBodies : public testing::TestWithParam<HexElement> {
 protected:
  /// Cells with hanging nodes between them, which quadratic elements have not.
  [[nodiscard]] static HexMesh mesh() {
    HexMesh out = box_mesh({1, 1, 1}, {2, 2, 2});
    if (GetParam() == HexElement::kQuadratic) {
      out.refine(std::vector<int>(out.active()));
    } else {
      out.refine({0});
      out.refine({out.cells()[0].first_child + 7});
    }
    return out;
  }
};

// Of a body that was turned, sheared and stretched evenly.
TEST_P(TissueBodies, ContainWhatLiesInTheirElements) {
  const HexMesh mesh = this->mesh();
  const TissueBody body(mesh, GetParam(), {tissue_of(0.4)},
                        std::vector<bool>(static_cast<std::size_t>(mesh.nodes())));
  Eigen::Matrix3d F;
  F << .2, -1.1, .1, .9, .1, -.2, .3, .05, 1.2;
  Matrix3Xd u(3, mesh.nodes());
  for (int node = 0; node < mesh.nodes(); ++node)
    u.col(node) = F * mesh.place(node) - mesh.place(node);
  std::mt19937 random(4);
  std::uniform_real_distribution<double> place(-0.3, 1.3);
  int inside = 0;
  for (int k = 0; k < 2000; ++k) {
    const Vector3d p(place(random), place(random), place(random));
    const bool expected = (p.array() > 0).all() && (p.array() < 1).all();
    EXPECT_EQ(body.contains(F * p, u), expected) << p.transpose();
    inside += expected ? 1 : 0;
  }
  EXPECT_GT(inside, 300);
}

/// An even strain of a mesh whose rim is held to it is at rest within.
void expect_even_strain(const HexMesh& mesh, HexElement kind) {
  Eigen::Matrix3d G;
  G << .1, .05, -.02, .03, -.1, .04, .01, .02, .05;
  std::vector<bool> fixed(static_cast<std::size_t>(mesh.nodes()));
  Matrix3Xd at_fixed = Matrix3Xd::Zero(3, mesh.nodes());
  for (int node = 0; node < mesh.nodes(); ++node) {
    const Vector3d& p = mesh.place(node);
    if ((p.array() > 1e-9 && p.array() < 1 - 1e-9).all()) continue;
    fixed[static_cast<std::size_t>(node)] = true;
    at_fixed.col(node) = G * p;
  }
  const TissueBody body(mesh, kind, {tissue_of(0.49)}, fixed);
  VectorXd x;
  ASSERT_GE(solve(body, at_fixed, x), 0);
  const Matrix3Xd u = body.node_displacements(x, at_fixed);
  for (int node = 0; node < mesh.nodes(); ++node)
    if (mesh.in_use(node)) {
      EXPECT_LT((u.col(node) - G * mesh.place(node)).norm(), 1e-9);
    }
}

TEST_P(TissueBodies, PassThePatchTest) { expect_even_strain(mesh(), GetParam()); }

TEST_P(TissueBodies, PassThePatchTestOnCrookedCells) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> shift(-0.1, 0.1);
  const std::vector<double> thirds = even_axis(0, 1, 3);
  HexMesh crooked = graded_box(thirds, thirds, thirds, [&](const Vector3d& p) -> Vector3d {
    const bool inside = (p.array() > 0.1 && p.array() < 0.9).all();
    return inside ? Vector3d(p + Vector3d(shift(random), shift(random), shift(random))) : p;
  });
  if (GetParam() == HexElement::kQuadratic) crooked.refine(std::vector<int>(crooked.active()));
  expect_even_strain(crooked, GetParam());
}

TEST_P(TissueBodies, StiffnessIsTheDerivativeOfForce) {
  const HexMesh mesh = this->mesh();
  std::vector<bool> fixed;
  for (int node = 0; node < mesh.nodes(); ++node) fixed.push_back(mesh.place(node)[2] < 1e-9);
  const TissueBody body(mesh, GetParam(), {tissue_of(0.4)}, fixed);
  std::mt19937 random(2);
  std::normal_distribution<double> normal;
  VectorXd x(body.unknowns()), d(body.unknowns());
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    x[i] = 0.01 * normal(random);
    d[i] = normal(random);
  }
  TissueResponse at, plus, minus;
  constexpr double kStep = 1e-6;
  body.evaluate(body.node_displacements(x, {}), 0, {}, {}, ElementRequest::kStiffness, at);
  body.evaluate(body.node_displacements(x + kStep * d, {}), 0, {}, {}, ElementRequest::kForce,
                plus);
  body.evaluate(body.node_displacements(x - kStep * d, {}), 0, {}, {}, ElementRequest::kForce,
                minus);
  VectorXd product = VectorXd::Zero(x.size());
  const SymmetricPattern& pattern = body.pattern();
  for (int j = 0; j < pattern.size; ++j)
    for (int k = pattern.starts[static_cast<std::size_t>(j)];
         k < pattern.starts[static_cast<std::size_t>(j) + 1]; ++k) {
      const int i = pattern.rows[static_cast<std::size_t>(k)];
      const double value = at.tangent[static_cast<std::size_t>(k)];
      product[i] += value * d[j];
      if (i != j) product[j] += value * d[i];
    }
  EXPECT_LT((product - (plus.force - minus.force) / (2 * kStep)).norm(), 1e-7 * product.norm());
}

INSTANTIATE_TEST_SUITE_P(All, TissueBodies,
                         testing::Values(HexElement::kDisplacement, HexElement::kMeanDilatation,
                                         HexElement::kCentroidDilatation, HexElement::kQuadratic));

/// A block of 20 x 16 x 10 mm on a floor, a stuck patch on top pushed in by 1 mm.
struct Block {
  Block(HexElement kind, double poisson_ratio, int finer)
      : mesh(box_mesh({20, 16, 10}, Eigen::Vector3i(4, 4, 3) * finer)) {
    if (kind == HexElement::kQuadratic) mesh.refine(std::vector<int>(mesh.active()));
    std::vector<bool> fixed(static_cast<std::size_t>(mesh.nodes()));
    at_fixed = Matrix3Xd::Zero(3, mesh.nodes());
    for (int node = 0; node < mesh.nodes(); ++node) {
      const Vector3d& p = mesh.place(node);
      const bool patch = p[2] > 10 - 1e-9 && std::abs(p[0] - 10) < 5.1 && std::abs(p[1] - 8) < 4.1;
      fixed[static_cast<std::size_t>(node)] = patch || p[2] < 1e-9;
      if (patch) at_fixed(2, node) = -1;
    }
    body = std::make_unique<TissueBody>(mesh, kind, std::vector{tissue_of(poisson_ratio)}, fixed);
  }
  [[nodiscard]] double force(int& iterations) const {
    VectorXd x;
    iterations = solve(*body, at_fixed, x);
    const Matrix3Xd reactions = body->reactions(body->node_displacements(x, at_fixed), 0, {});
    double sum = 0;
    for (int node = 0; node < mesh.nodes(); ++node)
      if (at_fixed(2, node) < 0) sum -= reactions(2, node);
    return sum;
  }
  HexMesh mesh;
  Matrix3Xd at_fixed;
  std::unique_ptr<TissueBody> body;
};

TEST(TissueBody, OneStepOfATenthOfTheThicknessConvergesAtAnyPoissonRatio) {
  for (const HexElement kind :
       {HexElement::kMeanDilatation, HexElement::kCentroidDilatation, HexElement::kQuadratic})
    for (const double nu : {0.45, 0.49, 0.499, 0.49999}) {
      int iterations = 0;
      (void)Block(kind, nu, 1).force(iterations);
      EXPECT_GE(iterations, 0) << name_of(kind) << nu;
      EXPECT_LE(iterations, 6) << name_of(kind) << nu;
    }
}

TEST(TissueBody, WeakIncompressibilityDoesNotLock) {
  // From nu = 0.49 to 0.499 the true force rises by some per cent; locking multiplies it.
  int iterations = 0;
  const auto rise = [&](HexElement kind) {
    return Block(kind, 0.499, 1).force(iterations) / Block(kind, 0.49, 1).force(iterations);
  };
  EXPECT_LT(rise(HexElement::kMeanDilatation), 1.05);
  EXPECT_LT(rise(HexElement::kCentroidDilatation), 1.05);
  EXPECT_LT(rise(HexElement::kQuadratic), 1.05);
}

TEST(TissueBody, ForcesAreThoseOfAnotherProgram) {
  // Reactions of the block by a program of its own in numpy, with derivatives by complex steps.
  int iterations = 0;
  EXPECT_NEAR(Block(HexElement::kMeanDilatation, 0.45, 1).force(iterations), 68.5407835192, 1e-8);
  EXPECT_NEAR(Block(HexElement::kMeanDilatation, 0.499, 1).force(iterations), 77.2521844108, 1e-8);
  EXPECT_NEAR(Block(HexElement::kMeanDilatation, 0.49, 2).force(iterations), 72.4757045404, 1e-8);
  EXPECT_NEAR(Block(HexElement::kQuadratic, 0.49, 1).force(iterations), 68.2104951992, 1e-8);
}

TEST(TissueBody, ForcesOfFinerMeshesFall) {
  // Displacements of a coarse mesh are among those of a finer one: its energy is no smaller. Mean
  // dilatations keep that order here.
  int iterations = 0;
  const double coarse = Block(HexElement::kMeanDilatation, 0.49, 1).force(iterations);
  const double fine = Block(HexElement::kMeanDilatation, 0.49, 2).force(iterations);
  const double quadratic = Block(HexElement::kQuadratic, 0.49, 1).force(iterations);
  EXPECT_GT(coarse, fine);
  EXPECT_GT(fine, quadratic);
  EXPECT_LT(coarse, 1.15 * quadratic);
}

TEST(TissueBody, AHeldStretchRelaxesAsItsExponentials) {
  const HexMesh mesh = box_mesh({1, 1, 1}, {1, 1, 2});
  std::vector<bool> fixed;
  Matrix3Xd at_fixed = Matrix3Xd::Zero(3, mesh.nodes());
  for (int node = 0; node < mesh.nodes(); ++node) {
    const Vector3d& p = mesh.place(node);
    fixed.push_back(p[2] < 1e-9 || p[2] > 1 - 1e-9);
    // Volume stays: the pressure is 0 and does not relax.
    at_fixed.col(node) = Vector3d(0.3 * p[2], 0, 0);
  }
  Tissue tissue = tissue_of(0.49);
  tissue.relaxation = {{0.3, 0.004}, {0.25, 0.07}, {0.2, 1.4}};
  const TissueBody body(mesh, HexElement::kMeanDilatation, {tissue}, fixed);
  ASSERT_TRUE(body.relaxes());
  VectorXd x(body.unknowns());
  for (std::size_t i = 0; i < body.free_nodes().size(); ++i)
    x.segment<3>(static_cast<Eigen::Index>(3 * i)) = at_fixed.col(body.free_nodes()[i]);
  const Matrix3Xd u = body.node_displacements(x, at_fixed);
  const auto shear = [&](double h, const TissueHistory& history) {
    const Matrix3Xd f = body.reactions(u, h, history);
    double sum = 0;
    for (int node = 0; node < mesh.nodes(); ++node)
      if (mesh.place(node)[2] > 1 - 1e-9) sum += f(0, node);
    return sum;
  };
  // Stretched at once, then held, in steps of any size.
  const double first = shear(0, {});
  TissueHistory history = body.advance_history(u, 0, {});
  double t = 0;
  for (const double h : {0.001, 0.002, 0.05, 0.2, 1.0, 30.0}) {
    t += h;
    double expected = 0.25;
    for (const ExponentialTerm& term : tissue.relaxation)
      expected += term.share * std::exp(-t / term.time);
    EXPECT_NEAR(shear(h, history) / first, expected, 1e-12) << t;
    history = body.advance_history(u, h, history);
  }
}

TEST(TissueBody, ErrorEnergyVanishesWhereStrainIsUniform) {
  const HexMesh mesh = box_mesh({1, 1, 1}, {2, 2, 2});
  std::vector<bool> fixed(static_cast<std::size_t>(mesh.nodes()), false);
  fixed[0] = true;
  const TissueBody body(mesh, HexElement::kMeanDilatation, {tissue_of(0.49)}, fixed);
  Matrix3Xd u(3, mesh.nodes());
  for (int node = 0; node < mesh.nodes(); ++node)
    u.col(node) = Vector3d(0.2 * mesh.place(node)[1], 0, 0.1 * mesh.place(node)[0]);
  EXPECT_LT(body.error_energies(u).sum(), 1e-25);
  // Bent, it does not, and falls with the square of the cells.
  const auto bent = [](int cells) {
    const HexMesh own = box_mesh({1, 1, 1}, Eigen::Vector3i::Constant(cells));
    std::vector<bool> first(static_cast<std::size_t>(own.nodes()), false);
    first[0] = true;
    const TissueBody part(own, HexElement::kMeanDilatation, {tissue_of(0.49)}, first);
    Matrix3Xd way(3, own.nodes());
    for (int node = 0; node < own.nodes(); ++node)
      way.col(node) = Vector3d(0.05 * std::pow(own.place(node)[1], 2), 0, 0);
    return part.error_energies(way).sum();
  };
  EXPECT_NEAR(bent(4) / bent(8), 4, 0.8);
}

TEST(TissueBody, BadMeshesAreRefused) {
  HexMesh mesh = box_mesh({1, 1, 1}, {2, 2, 2});
  const std::vector<bool> none(static_cast<std::size_t>(mesh.nodes()), false);
  const std::vector<bool> all(static_cast<std::size_t>(mesh.nodes()), true);
  const std::vector<Tissue> tissues{tissue_of(0.4)};
  EXPECT_THROW(TissueBody(mesh, HexElement::kMeanDilatation, tissues, all), InputError);
  EXPECT_THROW(TissueBody(mesh, HexElement::kMeanDilatation, {}, none), InputError);
  EXPECT_THROW(TissueBody(mesh, HexElement::kMeanDilatation, tissues, {true}), InputError);
  EXPECT_THROW(TissueBody(mesh, HexElement::kQuadratic, tissues, none), InputError);
}

}  // namespace
}  // namespace thenar
