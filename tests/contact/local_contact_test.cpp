// Tests for contact/local_contact.cpp: one block against closed forms and its own conditions.

#include "contact/local_contact.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>
#include <Eigen/Core>

#include "base/numbers.h"
#include "contact/friction_cone.h"

namespace thenar::internal {
namespace {

using Eigen::Matrix3d;
using Eigen::Matrix4d;
using Eigen::Vector3d;
using Eigen::Vector4d;

constexpr double kProximalError = 1e-8;  // of impulses, by the term of 1e-10 that S is given

Vector3d solve_point(const Matrix3d& A, const Vector3d& q, double mu) {
  LocalContact contact;
  contact.assign(A);
  return contact.solve(q, mu, Vector3d::Zero()).head<3>();
}

// With A = I:  fn = -q_n, and friction is -q_t until it is longer than mu fn.
TEST(LocalContact, SticksOrSlidesOnAUnitMatrix) {
  const Matrix3d A = Matrix3d::Identity();
  EXPECT_LT((solve_point(A, {-2, 0.3, -0.4}, 0.5) - Vector3d(2, -0.3, 0.4)).norm(), kProximalError);
  EXPECT_LT((solve_point(A, {-2, 3, -4}, 0.5) - Vector3d(2, -0.6, 0.8)).norm(), kProximalError);
}

TEST(LocalContact, HasNoImpulseWhereBodiesSeparate) {
  EXPECT_EQ(solve_point(Matrix3d::Identity(), {0, 5, 5}, 1), Vector3d::Zero());
  EXPECT_EQ(solve_point(Matrix3d::Identity(), {1e-12, -5, 5}, 1), Vector3d::Zero());
}

// Slip along t1 with coupling:  un = 0  gives  fn = -q_n / (A_nn - mu A_nt), as ft = -mu fn.
TEST(LocalContact, SlidesWhereRowsAreCoupled) {
  Matrix3d A;
  A << 1, 0.3, 0, 0.3, 1, 0, 0, 0, 1;
  const double mu = 0.5, fn = 2 / (1 - mu * 0.3);
  EXPECT_LT((solve_point(A, {-2, 9, 0}, mu) - Vector3d(fn, -mu * fn, 0)).norm(), kProximalError);
}

// Every answer of random positive definite blocks has a natural map of zero.
TEST(LocalContact, AnswersRandomBlocksOfFourRows) {
  std::mt19937 rng(3);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 200; ++trial) {
    const Matrix4d B = Matrix4d::NullaryExpr([&] { return normal(rng); });
    const Matrix4d A = B * B.transpose() + 0.1 * Matrix4d::Identity();
    Vector4d q = Vector4d::NullaryExpr([&] { return normal(rng); });
    q(0) = -std::abs(q(0)) - 0.1;
    const double mu = 0.1 + std::abs(normal(rng));
    LocalContact contact;
    contact.assign(A);
    const Vector4d f = contact.solve(q, mu, Vector4d::Zero()), u = A * f + q;
    EXPECT_LT(cone_natural_map<4>(f, u, mu).norm(), 1e-7 * (1 + f.norm())) << trial;
  }
}

// Tangents that the matrix does not feel keep the former friction where the cone has room for it.
TEST(LocalContact, KeepsTheFormerFrictionWhereNothingFeelsIt) {
  Matrix3d A = Matrix3d::Zero();
  A(0, 0) = 1;
  LocalContact contact;
  contact.assign(A);
  const Vector3d former(0, 0.2, -0.1);
  const Vector4d f = contact.solve(Vector3d(-1, 0, 0), 0.5, former);
  EXPECT_LT((f.head<3>() - Vector3d(1, 0.2, -0.1)).norm(), kProximalError);
}

TEST(LocalContact, ClampsAnIntervalToItsEnds) {
  const ScaledBlock block{0, 1, -1, -2, 3};
  EXPECT_EQ(solve_interval(block, 4, -2, 0), 0.5);
  EXPECT_EQ(solve_interval(block, 4, -20, 0), 3);
  EXPECT_EQ(solve_interval(block, 4, 20, 0), -2);
}

// Without a matrix the sign of the velocity says which end, and an infinite end is none.
TEST(LocalContact, GoesToTheEndThatAVelocityLeadsTo) {
  const ScaledBlock block{0, 1, -1, -2, kInfinity};
  EXPECT_EQ(solve_interval(block, 0, 1, 0.7), -2);
  EXPECT_EQ(solve_interval(block, 0, -1, 0.7), 0.7);
  EXPECT_EQ(solve_interval(block, 0, 0, 0.7), 0.7);
}

}  // namespace
}  // namespace thenar::internal
