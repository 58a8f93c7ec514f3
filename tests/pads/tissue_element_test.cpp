#include "pads/tissue_element.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "base/error.h"

namespace thenar {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

/// A unit cube's nodes, of any kind.
Matrix3Xd cube(HexElement kind) {
  const int n = node_count(kind) == 8 ? 2 : 3;
  Matrix3Xd X(3, node_count(kind));
  for (int a = 0; a < X.cols(); ++a) X.col(a) = Vector3d(a % n, a / n % n, a / (n * n)) / (n - 1.0);
  return X;
}

/// A crooked element with a displacement and a past.
struct Case {
  explicit Case(HexElement element) : kind(element) {
    std::mt19937 random(1);
    std::normal_distribution<double> normal;
    X = cube(kind);
    u.resize(3, X.cols());
    for (Eigen::Index i = 0; i < X.size(); ++i) {
      X.data()[i] += 0.03 * normal(random);
      u.data()[i] = 0.05 * normal(random);
    }
    tissue.law = TissueLaw::kVerondaWestmann;
    tissue.shear_modulus = 2;
    tissue.exponent = 2;
    tissue.relaxation = {{0.3, 0.1}, {0.2, 1}};
    shape = element_shape(kind, X);
    step = memory_step(tissue.relaxation, 0.05);
    const auto points = static_cast<std::size_t>(gauss_point_count(kind));
    history.elastic.resize(points);
    history.terms.resize(2 * points);
    for (auto* list : {&history.elastic, &history.terms})
      for (Voigt& each : *list)
        for (int i = 0; i < 6; ++i) each[i] = 0.3 * normal(random);
  }
  ElementResponse at(const Matrix3Xd& where, ElementRequest ask) const {
    ElementResponse out;
    element_response({kind, shape, tissue, where, &step, &history}, ask, out);
    return out;
  }

  HexElement kind;
  Matrix3Xd X, u;
  Tissue tissue;
  ElementShape shape;
  MemoryStep step;
  ElementHistory history;
};

class TissueElements : public testing::TestWithParam<HexElement> {};

TEST_P(TissueElements, ForceAndStiffnessAreDerivativesOfTheEnergy) {
  const Case c(GetParam());
  const ElementResponse at = c.at(c.u, ElementRequest::kStiffness);
  ASSERT_FALSE(at.inverted);
  constexpr double kStep = 1e-6;
  for (Eigen::Index i = 0; i < c.u.size(); ++i) {
    Matrix3Xd moved = c.u;
    moved.data()[i] += kStep;
    const ElementResponse plus = c.at(moved, ElementRequest::kForce);
    moved.data()[i] -= 2 * kStep;
    const ElementResponse minus = c.at(moved, ElementRequest::kForce);
    EXPECT_NEAR(at.force[i], (plus.energy - minus.energy) / (2 * kStep), 1e-8);
    const Eigen::VectorXd column = (plus.force - minus.force) / (2 * kStep);
    for (Eigen::Index j = 0; j <= i; ++j) EXPECT_NEAR(at.stiffness(j, i), column[j], 1e-7);
  }
}

TEST_P(TissueElements, NoForceOfRigidMotions) {
  Case c(GetParam());
  c.history = {std::vector<Voigt>(c.history.elastic.size(), Voigt::Zero()),
               std::vector<Voigt>(c.history.terms.size(), Voigt::Zero())};
  const Eigen::Matrix3d R =
      Eigen::AngleAxisd(1.1, Vector3d(1, -1, 2).normalized()).toRotationMatrix();
  const Matrix3Xd moved = ((R * c.X).colwise() + Vector3d(0.2, 0.1, -0.4)) - c.X;
  const ElementResponse at = c.at(moved, ElementRequest::kForce);
  EXPECT_LT(at.force.norm(), 1e-12);
  EXPECT_NEAR(at.energy, 0, 1e-13);
}

TEST_P(TissueElements, ForcesAreInBalance) {
  const Case c(GetParam());
  const ElementResponse at = c.at(c.u, ElementRequest::kForce);
  Vector3d force(0, 0, 0), moment(0, 0, 0);
  for (Eigen::Index a = 0; a < c.X.cols(); ++a) {
    const Vector3d f = at.force.segment<3>(3 * a);
    force += f;
    moment += Vector3d(c.X.col(a) + c.u.col(a)).cross(f);
  }
  EXPECT_LT(force.norm(), 1e-12);
  EXPECT_LT(moment.norm(), 1e-12);
}

TEST_P(TissueElements, PressureAfterAChangeIsLinearised) {
  if (GetParam() == HexElement::kDisplacement) GTEST_SKIP() << "its pressure is no unknown";
  const Case c(GetParam());
  // Nothing moved: the pressure itself; twice as far: twice the change.
  const Matrix3Xd du = 1e-3 * c.u.rowwise().reverse();
  const Eigen::Vector4d p0 = linear_pressure({c.kind, c.shape, c.tissue, c.u}, 0 * du);
  const Eigen::Vector4d p1 = linear_pressure({c.kind, c.shape, c.tissue, c.u}, du);
  const Eigen::Vector4d p2 = linear_pressure({c.kind, c.shape, c.tissue, c.u}, 2 * du);
  EXPECT_LT((p2 - 2 * p1 + p0).norm(), 1e-12 * p0.norm() + 1e-12);
  // By differences of the pressure.
  constexpr double kStep = 1e-5;
  const Eigen::Vector4d plus =
      linear_pressure({c.kind, c.shape, c.tissue, c.u + kStep * du}, 0 * du);
  const Eigen::Vector4d minus =
      linear_pressure({c.kind, c.shape, c.tissue, c.u - kStep * du}, 0 * du);
  EXPECT_LT(((plus - minus) / (2 * kStep) - (p1 - p0)).norm(), 1e-7 * p0.norm());
}

TEST_P(TissueElements, TurnedInsideOutIsTold) {
  const Case c(GetParam());
  const Matrix3Xd u = -2 * c.X;
  EXPECT_TRUE(c.at(u, ElementRequest::kForce).inverted);
}

INSTANTIATE_TEST_SUITE_P(All, TissueElements,
                         testing::Values(HexElement::kDisplacement, HexElement::kMeanDilatation,
                                         HexElement::kCentroidDilatation, HexElement::kQuadratic));

TEST(TissueElement, AFoldedOneIsRefused) {
  Matrix3Xd X = cube(HexElement::kMeanDilatation);
  X.row(0) *= -1;
  EXPECT_THROW((void)element_shape(HexElement::kMeanDilatation, X), InputError);
}

TEST(TissueElement, VolumesAreThoseOfTheCube) {
  for (const HexElement kind : {HexElement::kMeanDilatation, HexElement::kQuadratic}) {
    double sum = 0;
    for (const double w : element_shape(kind, 2 * cube(kind)).volume) sum += w;
    EXPECT_NEAR(sum, 8, 1e-13);
  }
}

}  // namespace
}  // namespace thenar
