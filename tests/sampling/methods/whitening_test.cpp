// Tests for sampling/methods/whitening.cpp.

#include "sampling/methods/whitening.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <Eigen/LU>

#include "base/error.h"
#include "tests/matrix_near.h"

namespace thenar::internal {
namespace {

using Eigen::VectorXd;

// [4 2; 2 5] = F F' with F = [2 0; 1 2], by hand.
const Eigen::Matrix2d kCovariance = (Eigen::Matrix2d() << 4, 2, 2, 5).finished();

TEST(Whitening, PlacesByItsFactorAndPullsByTheTranspose) {
  const Whitening whitening(Metric::kDense, Eigen::Vector2d(1, -1), kCovariance);
  VectorXd x, slope(2);
  whitening.to_position(Eigen::Vector2d(3, -1), x);  // F y = (6, 1)
  EXPECT_TRUE(matrix_near(x, Eigen::Vector2d(7, 0), 1e-15));
  EXPECT_TRUE(matrix_near(whitening.to_whitened(x), Eigen::Vector2d(3, -1), 1e-15));
  whitening.whiten_gradient(Eigen::Vector2d(3, -1), Eigen::Vector2d(3, -1), slope);  // F' g
  EXPECT_TRUE(matrix_near(slope, Eigen::Vector2d(5, -2), 1e-15));
  EXPECT_TRUE(matrix_near(whitening.covariance(), kCovariance, 1e-15));
}

TEST(Whitening, DiagonalTakesTheDiagonal) {
  const Whitening whitening(Metric::kDiagonal, Eigen::Vector2d(1, 1), kCovariance);
  VectorXd x, slope(2);
  whitening.to_position(Eigen::Vector2d(1.5, -0.5), x);
  EXPECT_TRUE(matrix_near(x, Eigen::Vector2d(4, 1 - std::sqrt(5) / 2), 1e-15));
  EXPECT_TRUE(matrix_near(whitening.to_whitened(x), Eigen::Vector2d(1.5, -0.5), 1e-15));
  whitening.whiten_gradient(x, Eigen::Vector2d(3, -1), slope);
  EXPECT_TRUE(matrix_near(slope, Eigen::Vector2d(6, -std::sqrt(5)), 1e-15));
}

TEST(Whitening, RefusesWhatIsNoCovariance) {
  const Eigen::Matrix2d indefinite = (Eigen::Matrix2d() << 1, 2, 2, 1).finished();
  const Eigen::Matrix2d skewed = (Eigen::Matrix2d() << 2, 1, 0, 2).finished();
  const VectorXd none = VectorXd::Zero(2), three = VectorXd::Zero(3);
  EXPECT_THROW(Whitening(Metric::kDense, none, indefinite), InputError);
  EXPECT_THROW(Whitening(Metric::kDense, none, skewed), InputError);
  EXPECT_THROW(Whitening(Metric::kDiagonal, none, -kCovariance), InputError);
  EXPECT_THROW(Whitening(Metric::kDense, three, kCovariance), InputError);
}

TEST(Whitening, KeepsItsOwnWhereAnotherIsRefused) {
  Whitening whitening(Metric::kDense, Eigen::Vector2d(0, 0), kCovariance);
  EXPECT_FALSE(whitening.set_covariance(-kCovariance));
  EXPECT_FALSE(whitening.set_covariance(kCovariance * std::numeric_limits<double>::quiet_NaN()));
  EXPECT_FALSE(whitening.set_map(Eigen::Vector2d(0, 0), Eigen::Matrix2d::Ones(), {}, false));
  EXPECT_TRUE(matrix_near(whitening.covariance(), kCovariance, 1e-15));
}

/// Two drivers in four coordinates: pairs 00, 01 and 11.
Bend bend() {
  Bend bend;
  bend.drivers = 2;
  bend.strength.resize(4, 3);
  bend.strength << 0, 0, 0, 0.3, 0, 0, -0.2, 0.5, 0.1, 0.7, -0.4, 0.6;
  return bend;
}
const Eigen::Vector4d kY(0.7, -1.2, 0.4, 2.0);

// By hand: z_1 = -1.2 + 0.3 (0.49 - 1); z_2 = 0.4 - 0.2 (-0.51) + 0.5 (-0.84) + 0.1 (0.44).
TEST(Bend, MovesEachEntryByThoseBeforeIt) {
  const VectorXd z = bend().apply(kY);
  EXPECT_TRUE(
      matrix_near(z, Eigen::Vector4d(0.7, -1.353, 0.126, 2 - 0.357 + 0.336 + 0.264), 1e-15));
  EXPECT_TRUE(matrix_near(bend().invert(z), kY, 1e-15));
}

/// dx/dy by central differences, exact for a quadratic map but for rounding.
Eigen::MatrixXd jacobian(const Whitening& whitening) {
  Eigen::MatrixXd J(4, 4);
  const double h = 1e-3;
  for (int k = 0; k < 4; ++k) {
    VectorXd ahead, behind;
    whitening.to_position(kY + h * VectorXd::Unit(4, k), ahead);
    whitening.to_position(kY - h * VectorXd::Unit(4, k), behind);
    J.col(k) = (ahead - behind) / (2 * h);
  }
  return J;
}

Whitening bent_whitening(bool orbits) {
  Whitening whitening(Metric::kDense, VectorXd::Zero(4));
  Eigen::Matrix4d F;
  F << 2, 0.3, -0.1, 0, 0.2, 1.5, 0, 0.4, 0, -0.6, 0.8, 0.1, 0.5, 0, 0.2, 3;
  EXPECT_TRUE(whitening.set_map(Eigen::Vector4d(1, 2, 3, 4), F, bend(), orbits));
  return whitening;
}

TEST(Whitening, KeepsVolumeHoweverItBends) {
  const Whitening whitening = bent_whitening(false);
  const double squared = whitening.covariance().determinant();  // of F F'
  EXPECT_NEAR(std::pow(jacobian(whitening).determinant(), 2), squared, 1e-10 * squared);
}

TEST(Whitening, UndoesItsBend) {
  const Whitening whitening = bent_whitening(false);
  VectorXd x;
  whitening.to_position(kY, x);
  EXPECT_TRUE(matrix_near(whitening.to_whitened(x), kY, 1e-14));
}

// The gradient by y is J' g; along orbits without that of a standard normal, -y.
TEST(Whitening, PullsGradientsBackThroughTheBend) {
  const Eigen::Vector4d g(0.3, -2, 1.1, 0.6);
  for (const bool orbits : {false, true}) {
    const Whitening whitening = bent_whitening(orbits);
    VectorXd slope(4);
    whitening.whiten_gradient(kY, g, slope);
    const VectorXd wanted = jacobian(whitening).transpose() * g;
    EXPECT_TRUE(matrix_near(slope, orbits ? VectorXd(wanted + kY) : wanted, 1e-11));
  }
}

TEST(Whitening, ComesBackToTheBitFromWhatItSaved) {
  const Whitening whitening = bent_whitening(true);
  StateWriter saved;
  whitening.save(saved);
  Whitening other(Metric::kDense, VectorXd::Zero(4));
  StateReader reader(saved.bytes());
  other.restore(reader);
  EXPECT_TRUE(reader.at_end());
  VectorXd x, same;
  whitening.to_position(kY, x);
  other.to_position(kY, same);
  EXPECT_EQ(same, x);
  EXPECT_EQ(other.to_whitened(x), whitening.to_whitened(x));
  EXPECT_TRUE(other.follows_orbits());
}

}  // namespace
}  // namespace thenar::internal
