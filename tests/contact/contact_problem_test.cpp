// Tests for contact/contact_problem.cpp.

#include "contact/contact_problem.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/error.h"
#include "tests/contact/contact_samples.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::Vector4d;
using Eigen::VectorXd;

constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// One point of unit mass that comes down at 1 m/s and slides at 2 m/s, mu = 0.5.
ContactProblem sliding_point() {
  return {{coulomb_block(0.5)}, Matrix3d::Identity(), Vector3d(-1, 2, 0)};
}

TEST(ContactProblem, ResidualIsZeroAtTheAnswer) {
  const ContactResidual found = contact_residual(sliding_point(), Vector3d(1, -0.5, 0));
  EXPECT_EQ(found.natural, 0);
  EXPECT_EQ(found.outside, 0);
  EXPECT_EQ(found.approach, 0);
  EXPECT_EQ(found.complementarity, 0);
  EXPECT_EQ(found.alignment, 0);
}

// Each fault by hand, in its own unit.
TEST(ContactProblem, ResidualNamesEveryFault) {
  const ContactProblem problem = sliding_point();
  // |ft| = 0.6 where 0.5 is allowed.
  EXPECT_NEAR(contact_residual(problem, Vector3d(1, -0.6, 0)).outside, 0.1, 1e-15);
  // fn = 0.8 leaves un = -0.2.
  EXPECT_NEAR(contact_residual(problem, Vector3d(0.8, -0.4, 0)).approach, 0.2, 1e-15);
  // fn = 1.5 throws the point up at 0.5 m/s: fn un = 0.75 J.
  EXPECT_NEAR(contact_residual(problem, Vector3d(1.5, -0.75, 0)).complementarity, 0.75, 1e-15);
  // No friction while it slides at 2 m/s: mu fn |ut| = 1 J is missing.
  EXPECT_NEAR(contact_residual(problem, Vector3d(1, 0, 0)).alignment, 1, 1e-15);
  for (const Vector3d& f : {Vector3d(1, -0.6, 0), Vector3d(0.8, -0.4, 0), Vector3d(1.5, -0.75, 0),
                            Vector3d(1, 0, 0), Vector3d(-1, 0, 0)})
    EXPECT_GT(contact_residual(problem, f).natural, 0.02);
}

// The convex relaxation lifts a sliding body: un = mu |ut|. The exact cone does not.
TEST(ContactProblem, ResidualRefusesTheConvexRelaxation) {
  // minimise |f - (1, -2, 0)|^2 / 2 on the cone |ft| <= fn / 2: f = 1.6 (1, -0.5, 0).
  const Vector3d relaxed = 1.6 * Vector3d(1, -0.5, 0);
  EXPECT_GT(contact_residual(sliding_point(), relaxed).natural, 0.1);
}

TEST(ContactProblem, ResidualOfBoxesAndBilateralRows) {
  const ContactProblem box{{box_block(-2, 3)}, MatrixXd::Identity(1, 1), VectorXd::Constant(1, -5)};
  EXPECT_EQ(contact_residual(box, VectorXd::Constant(1, 3)).natural, 0);  // u = -2 at the top
  // f = 1: u = -4 could take 4 * (3 - 1) J.
  EXPECT_NEAR(contact_residual(box, VectorXd::Constant(1, 1)).complementarity, 8, 1e-15);
  const ContactProblem tied{{bilateral_block()}, MatrixXd::Identity(1, 1), VectorXd::Ones(1)};
  EXPECT_NEAR(contact_residual(tied, VectorXd::Constant(1, -0.75)).bilateral, 0.25, 1e-15);
}

// Metres or millimetres, kilograms or grams: natural is one number. Lengths by l, masses by m:
// W by 1 / m (rows of turning by 1 / (m l^2), cross terms between), b by l or 1, f by m l or m l^2.
TEST(ContactProblem, NaturalResidualDoesNotDependOnUnits) {
  std::mt19937 rng(3);
  const double l = 1000, m = 1000;
  sample::RandomTouch like;
  like.contacts = 5;
  like.soft = 1;
  like.limits = 0;
  const ContactProblem si = sample::random_touch(rng, like).problem();
  ContactProblem other = si;
  VectorXd to_u = VectorXd::Constant(si.b.size(), l);
  for (Eigen::Index i = 3; i < to_u.size(); i += 4) to_u(i) = 1;  // spin
  const VectorXd to_f = (m * l * l) * to_u.cwiseInverse();
  other.W = to_u.asDiagonal() * si.W * to_f.cwiseInverse().asDiagonal();
  other.b = to_u.cwiseProduct(si.b);
  for (ContactBlock& block : other.blocks) block.torsion_radius *= l;
  VectorXd f = VectorXd::Zero(si.b.size());
  for (Eigen::Index i = 0; i < f.size(); ++i) f(i) = std::sin(1.0 + static_cast<double>(i));
  const double one = contact_residual(si, f).natural,
               two = contact_residual(other, f.cwiseProduct(to_f)).natural;
  EXPECT_NEAR(one / two, 1, 1e-12);
}

// Friction and radius of 0 leave normal impulses alone.
TEST(ContactProblem, RowsThatCannotBeLoadedMustNotBe) {
  const ContactProblem smooth{{coulomb_block(0)}, Matrix3d::Identity(), Vector3d(-1, 2, 0)};
  EXPECT_EQ(contact_residual(smooth, Vector3d(1, 0, 0)).natural, 0);
  EXPECT_GT(contact_residual(smooth, Vector3d(1, -0.1, 0)).natural, 0.04);
  const ContactProblem point{
      {soft_finger_block(0.5, 0)}, Eigen::Matrix4d::Identity(), Vector4d(-1, 2, 0, 7)};
  EXPECT_EQ(contact_residual(point, Vector4d(1, -0.5, 0, 0)).natural, 0);
  EXPECT_GT(contact_residual(point, Vector4d(1, -0.5, 0, 0.1)).natural, 0.04);
}

TEST(ContactProblem, RefusesBadBlocksAndShapes) {
  EXPECT_EQ(message_of([] { (void)coulomb_block(-0.1); }), "friction must be >= 0, got -0.1");
  EXPECT_EQ(message_of([] { (void)box_block(2, 1); }),
            "bounds of a box must be in order, got 2 to 1");
  EXPECT_EQ(message_of([] { (void)box_block(kInfinite, kInfinite); }),
            "a box must hold a finite impulse, got inf to inf");
  EXPECT_EQ(message_of([] { (void)soft_finger_block(0.5, -1); }),
            "a torsion radius must be >= 0, got -1 m");
  ContactProblem problem = sliding_point();
  problem.b = VectorXd::Zero(2);
  EXPECT_EQ(message_of([&] { check_contact_problem(problem); }), "blocks have 3 rows, b has 2");
  problem = sliding_point();
  problem.W(0, 1) = 0.5;
  EXPECT_EQ(message_of([&] { check_contact_problem(problem); }),
            "W must be symmetric, mirrored entries differ by 0.5");
  problem = sliding_point();
  problem.b(1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(message_of([&] { check_contact_problem(problem); }), "W and b must be finite");
}

}  // namespace
}  // namespace thenar
