// Tests for contact/scaled_contacts.cpp: blocks, scales and the residual of scaled problems.

#include "contact/scaled_contacts.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "tests/contact/contact_samples.h"
#include "tests/matrix_near.h"

namespace thenar::internal {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kScaledRounding = 1e-12;  // of sums of some twenty products [1]

ScaledContacts scaled(const ContactProblem& problem) {
  ScaledContacts out;
  out.assign(problem);
  return out;
}

// The mean diagonal of every block of A is 1 where torsion has the radius that makes it so.
TEST(ScaledContacts, ScalesABlockToAUnitMeanDiagonal) {
  const double e = 0.01;
  const MatrixXd W = Eigen::Vector4d(2, 2, 2, 2 / (e * e)).asDiagonal();
  const ScaledContacts contacts =
      scaled({{soft_finger_block(0.5, e)}, W, Eigen::Vector4d(-1, 3, 0, 500)});
  EXPECT_TRUE(matrix_near(contacts.A(), MatrixXd::Identity(4, 4), kScaledRounding));
  const double s = 1 / std::sqrt(2.0);  // and e s for torsion
  EXPECT_TRUE(
      matrix_near(contacts.b(), Eigen::Vector4d(-s, 3 * s, 0, 500 * e * s), kScaledRounding));
  EXPECT_NEAR(contacts.scale(), 5 * s, kScaledRounding);  // the spin, 500 e, is the largest
}

// A soft finger without radius is a cone of three rows and a row that stays zero; without friction
// only its normal is left; a bilateral row has no ends.
TEST(ScaledContacts, SplitsBlocksIntoConesAndIntervals) {
  const ScaledContacts contacts =
      scaled({{soft_finger_block(0.5, 0), coulomb_block(0), bilateral_block()},
              MatrixXd::Identity(8, 8),
              VectorXd::Ones(8)});
  const auto& blocks = contacts.blocks();
  ASSERT_EQ(blocks.size(), 6U);
  EXPECT_TRUE(blocks[0].is_cone());
  EXPECT_EQ(blocks[0].rows, 3);
  EXPECT_EQ(blocks[0].mu, 0.5);
  for (const std::size_t fixed : {1U, 3U, 4U}) {
    EXPECT_EQ(blocks[fixed].lower, 0) << fixed;
    EXPECT_EQ(blocks[fixed].upper, 0) << fixed;
  }
  EXPECT_EQ(blocks[2].lower, 0);
  EXPECT_EQ(blocks[2].upper, kInfinity);
  EXPECT_EQ(blocks[5].start, 7);
  EXPECT_EQ(blocks[5].lower, -kInfinity);
  EXPECT_EQ(blocks[5].upper, kInfinity);
}

// f = s f' : a box of 6 N s on a row with W = 4 is one of 12 scaled units.
TEST(ScaledContacts, ScalesTheEndsOfABox) {
  const ScaledContacts contacts =
      scaled({{box_block(-6, 2)}, MatrixXd::Constant(1, 1, 4), VectorXd::Ones(1)});
  EXPECT_DOUBLE_EQ(contacts.blocks()[0].lower, -12);
  EXPECT_DOUBLE_EQ(contacts.blocks()[0].upper, 4);
}

// Scaling changes nothing: the residual is that of the problem in its own units.
TEST(ScaledContacts, AgreesWithTheResidualInUnits) {
  std::mt19937 rng(5);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 20; ++trial) {
    const ContactProblem problem = sample::random_touch(rng, {}).problem();
    const ScaledContacts contacts = scaled(problem);
    const VectorXd f = VectorXd::NullaryExpr(contacts.rows(), [&] { return normal(rng); });
    const VectorXd in_units = f.cwiseProduct(contacts.s());
    const VectorXd u = contacts.A() * f + contacts.b();
    const ContactResidual residual = contact_residual(problem, in_units);
    EXPECT_NEAR(contacts.residual(f, u), residual.natural, 1e-9 * residual.natural) << trial;
    EXPECT_NEAR(contacts.scale(), residual.scale, 1e-12 * residual.scale) << trial;
    EXPECT_NEAR(contacts.rounding(f), residual.rounding, 1e-9 * residual.rounding) << trial;
  }
}

TEST(ScaledContacts, CountsNanAsInfinite) {
  const ScaledContacts contacts =
      scaled({{coulomb_block(0.5)}, MatrixXd::Identity(3, 3), Eigen::Vector3d(-1, 0, 0)});
  EXPECT_EQ(contacts.residual(Eigen::Vector3d(std::nan(""), 0, 0), Eigen::Vector3d::Zero()),
            kInfinity);
}

// A smaller problem after a larger one leaves nothing of the larger one behind.
TEST(ScaledContacts, ForgetsALargerProblem) {
  ScaledContacts contacts;
  contacts.assign({{coulomb_block(0.5), box_block(-9, 9)},
                   3 * MatrixXd::Identity(4, 4),
                   100 * VectorXd::Ones(4)});
  contacts.assign({{unilateral_block()}, MatrixXd::Constant(1, 1, 4), VectorXd::Constant(1, -3)});
  EXPECT_EQ(contacts.rows(), 1);
  ASSERT_EQ(contacts.blocks().size(), 1U);
  EXPECT_DOUBLE_EQ(contacts.A()(0, 0), 1);
  EXPECT_DOUBLE_EQ(contacts.b()(0), -1.5);
  EXPECT_DOUBLE_EQ(contacts.scale(), 1.5);
}

}  // namespace
}  // namespace thenar::internal
