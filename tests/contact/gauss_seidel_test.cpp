// Tests for contact/gauss_seidel.cpp: sweeps against the classical method and closed forms.

#include "contact/gauss_seidel.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "contact/contact_problem.h"

namespace thenar::internal {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

VectorXd swept(const ContactProblem& problem, int sweeps, VectorXd f) {
  ScaledContacts contacts;
  contacts.assign(problem);
  GaussSeidel method;
  method.assign(contacts);
  method.sweep(contacts, sweeps, f);
  return f;
}

// Rows with diagonal 1 are their own scale. Projected Gauss-Seidel by hand, row after row.
TEST(GaussSeidel, IsTheProjectedMethodOnSingleRows) {
  MatrixXd W(3, 3);
  W << 1, 0.4, -0.3, 0.4, 1, 0.2, -0.3, 0.2, 1;
  const Eigen::Vector3d b(-2, 1, 4);
  const ContactProblem problem{{unilateral_block(), box_block(-0.5, 0.5), bilateral_block()}, W, b};
  const double low[] = {0, -0.5, -1e300}, high[] = {1e300, 0.5, 1e300};
  Eigen::Vector3d wanted = Eigen::Vector3d::Zero();
  for (int sweeps = 1; sweeps <= 3; ++sweeps) {
    for (int i = 0; i < 3; ++i)
      wanted(i) = std::clamp(wanted(i) - (W.row(i).dot(wanted) + b(i)), low[i], high[i]);
    EXPECT_LT((swept(problem, sweeps, VectorXd::Zero(3)) - wanted).norm(), 1e-14) << sweeps;
  }
}

// Blocks that do not feel each other are answered by one sweep, and stay.
TEST(GaussSeidel, AnswersUncoupledConesInOneSweep) {
  const ContactProblem problem{{coulomb_block(0.5), coulomb_block(0.3)},
                               MatrixXd::Identity(6, 6),
                               (VectorXd(6) << -1, 0.3, 0, -2, 0, 8).finished()};
  const VectorXd wanted = (VectorXd(6) << 1, -0.3, 0, 2, 0, -0.6).finished();
  const VectorXd once = swept(problem, 1, VectorXd::Zero(6));
  EXPECT_LT((once - wanted).norm(), 1e-8);  // the local answer has a proximal term of 1e-10
  EXPECT_LT((swept(problem, 5, once) - once).norm(), 1e-8);
}

// Without friction  f' W f / 2 + b' f  never rises: each block is its minimum there.
TEST(GaussSeidel, EverySweepLowersTheEnergyOfNormals) {
  MatrixXd W(4, 4);
  W << 1, 0.6, 0.3, 0, 0.6, 1, 0.5, 0.2, 0.3, 0.5, 1, 0.4, 0, 0.2, 0.4, 1;
  const ContactProblem problem{std::vector<ContactBlock>(4, unilateral_block()), W,
                               Eigen::Vector4d(-1, -2, 1, -0.5)};
  VectorXd f = VectorXd::Constant(4, 3);
  double energy = f.dot(W * f) / 2 + problem.b.dot(f);
  for (int k = 0; k < 10; ++k) {
    f = swept(problem, 1, f);
    const double now = f.dot(W * f) / 2 + problem.b.dot(f);
    EXPECT_LE(now, energy + 1e-14);
    energy = now;
  }
  EXPECT_LT(contact_residual(problem, swept(problem, 200, f)).natural, 1e-12);
}

TEST(GaussSeidel, LeavesImpulsesWithoutASweep) {
  const ContactProblem problem{
      {unilateral_block()}, MatrixXd::Identity(1, 1), VectorXd::Constant(1, -1)};
  EXPECT_EQ(swept(problem, 0, VectorXd::Constant(1, 7))(0), 7);
}

}  // namespace
}  // namespace thenar::internal
