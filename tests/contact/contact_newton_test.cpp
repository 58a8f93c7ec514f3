// Tests for contact/contact_newton.cpp: single steps whose ends are known.

#include "contact/contact_newton.h"

#include <cmath>

#include <gtest/gtest.h>

#include "contact/contact_problem.h"

namespace thenar::internal {
namespace {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kStepRounding = 1e-13;  // of a step that is exact but for rounding [1]

/// A problem without units, its impulses and velocities, and Newton's steps on them.
struct NewtonRun {
  ScaledContacts contacts;
  ContactNewton newton;
  VectorXd f, u;

  NewtonRun(const ContactProblem& problem, const VectorXd& start) : f(start) {
    contacts.assign(problem);
    newton.assign(contacts);
    u = contacts.A() * f + contacts.b();
  }
  bool step(double proximal = 0) { return newton.step(contacts, proximal, f, u); }
  [[nodiscard]] double residual() const { return contacts.residual(f, u); }
};

Matrix3d coupled() {
  Matrix3d W;
  W << 1, 0.3, -0.2, 0.3, 1, 0.1, -0.2, 0.1, 1;
  return W;
}

// Stick is linear: one step from where p = f - u is in the cone ends at  f = -W^-1 b.
TEST(ContactNewton, SticksInOneStep) {
  const Vector3d f(2, 0.1, -0.3), start(2, 0, 0);
  NewtonRun run({{coulomb_block(0.8)}, coupled(), -coupled() * f}, start);
  ASSERT_TRUE(run.step());
  EXPECT_LT((run.f - f).norm(), kStepRounding);
  EXPECT_LT(run.u.norm(), kStepRounding);
}

TEST(ContactNewton, OpensInOneStep) {
  NewtonRun run({{coulomb_block(0.8)}, coupled(), Vector3d(4, 1, 1)}, Vector3d(1, 0.2, 0));
  ASSERT_TRUE(run.step());
  EXPECT_EQ(run.f, Vector3d::Zero());
  EXPECT_EQ(run.u, Vector3d(4, 1, 1));
}

// A contact that slips is on its cone to rounding after every step, wherever it started.
TEST(ContactNewton, KeepsASlippingContactOnItsCone) {
  const double mu = 0.5;
  NewtonRun run({{coulomb_block(mu)}, coupled(), Vector3d(-1, 4, 3)}, Vector3d(1, -0.2, 0.3));
  for (int k = 0; k < 3; ++k) {
    ASSERT_TRUE(run.step());
    ASSERT_GT(run.f(0), 0);
    EXPECT_NEAR(run.f.tail<2>().norm(), mu * run.f(0), kStepRounding);
  }
}

// Quadratic: near the answer the residual of a step is at most a constant times the former squared.
TEST(ContactNewton, IsQuadraticNearASlidingAnswer) {
  NewtonRun run({{coulomb_block(0.5)}, coupled(), Vector3d(-1, 4, 3)}, Vector3d(1, -0.4, -0.3));
  ASSERT_TRUE(run.step());
  for (int k = 0; k < 4 && run.residual() > 1e-7; ++k) {
    const double before = run.residual();
    ASSERT_TRUE(run.step());
    EXPECT_LT(run.residual(), before * before + kStepRounding);
  }
  for (int k = 0; k < 2; ++k) ASSERT_TRUE(run.step());
  EXPECT_LT(run.residual(), kStepRounding);
}

// A box at its ends, and free between them:  u = f + b  with scale 1.
TEST(ContactNewton, MovesIntervalsToTheirEnds) {
  const ContactProblem problem{{box_block(-2, 3), box_block(-2, 3), box_block(-2, 3)},
                               MatrixXd::Identity(3, 3),
                               Vector3d(5, -7, 1)};
  NewtonRun run(problem, Vector3d::Zero());
  ASSERT_TRUE(run.step());
  EXPECT_LT((run.f - Vector3d(-2, 3, -1)).norm(), kStepRounding);
}

// Two rows that are one and the same share its load: the singular matrix is refined away.
TEST(ContactNewton, SolvesRedundantRows) {
  const ContactProblem problem{
      {bilateral_block(), bilateral_block()}, MatrixXd::Ones(2, 2), VectorXd::Constant(2, -3)};
  NewtonRun run(problem, VectorXd::Zero(2));
  ASSERT_TRUE(run.step());
  EXPECT_NEAR(run.f.sum(), 3, 1e-9);
  EXPECT_NEAR(run.f(0), run.f(1), 1e-6);
}

// One row with a proximal term p moves by -u / (1 + p): half way for p = 1.
TEST(ContactNewton, ProximalTermShortensTheStep) {
  const ContactProblem problem{
      {bilateral_block()}, MatrixXd::Identity(1, 1), VectorXd::Constant(1, -3)};
  NewtonRun run(problem, VectorXd::Zero(1));
  ASSERT_TRUE(run.step(1));
  EXPECT_NEAR(run.f(0), 1.5, kStepRounding);
  EXPECT_NEAR(run.u(0), -1.5, kStepRounding);
}

}  // namespace
}  // namespace thenar::internal
