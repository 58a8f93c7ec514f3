// Tests for contact/sliding_pivots.cpp: steps whose ends are known.

#include "contact/sliding_pivots.h"

#include <cmath>

#include <gtest/gtest.h>
#include <Eigen/LU>

#include "contact/contact_problem.h"

namespace thenar::internal {
namespace {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kPivotRounding = 1e-13;  // of small dense systems [1]

/// Impulses after one step of pivots.
VectorXd pivoted(const ContactProblem& problem, VectorXd f, bool* solved) {
  ScaledContacts contacts;
  contacts.assign(problem);
  const VectorXd u = contacts.A() * f + contacts.b();
  int pivots = 0;
  *solved = take_pivoting_step(contacts, f, u, pivots);
  return f;
}

// Slip along t1:  (W_nn - mu W_nt) fn = -b_n  is found from any point that slides that way.
TEST(SlidingPivots, SlidesStraightWhereNormalAndTangentAreCoupled) {
  Matrix3d W;
  W << 1, 0.3, 0, 0.3, 1, 0, 0, 0, 1;
  const double mu = 0.5, fn = 2 / (1 - mu * 0.3);
  bool solved = false;
  const VectorXd f =
      pivoted({{coulomb_block(mu)}, W, Vector3d(-2, 9, 0)}, Vector3d(1, -0.5, 0), &solved);
  ASSERT_TRUE(solved);
  EXPECT_LT((f - Vector3d(fn, -mu * fn, 0)).norm(), kPivotRounding);
}

// A contact that bears and does not slide keeps u = 0 in all its rows:  f = -W^-1 b.
TEST(SlidingPivots, HoldsAContactThatSticks) {
  Matrix3d W;
  W << 1, 0.3, 0, 0.3, 1, 0.1, 0, 0.1, 1;
  const Vector3d answer(2, 0.2, -0.1);
  // Near the answer, but with tangents at rest.
  Vector3d start(2.5, 0, 0);
  start.tail<2>() = W.bottomRightCorner<2, 2>().inverse() *
                    ((W * answer).tail<2>() - W.bottomLeftCorner<2, 1>() * start(0));
  bool solved = false;
  const VectorXd f = pivoted({{coulomb_block(0.9)}, W, -W * answer}, start, &solved);
  ASSERT_TRUE(solved);
  EXPECT_LT((f - answer).norm(), kPivotRounding);
}

// Which normals bear is not chosen beforehand: of two that both carry a load at the start, the
// linear complementarity problem  [1 0.5; 0.5 1] z + (-1, 2) >= 0  leaves z = (1, 0).
TEST(SlidingPivots, DropsALimitThatDoesNotBear) {
  MatrixXd W(2, 2);
  W << 1, 0.5, 0.5, 1;
  bool solved = false;
  const VectorXd f = pivoted({{unilateral_block(), unilateral_block()}, W, Eigen::Vector2d(-1, 2)},
                             Eigen::Vector2d(1, 1), &solved);
  ASSERT_TRUE(solved);
  EXPECT_LT((f - Eigen::Vector2d(1, 0)).norm(), kPivotRounding);
}

// Boxes stay at an end for the step; between their ends, and without ends, u = 0.
TEST(SlidingPivots, KeepsABoxAtItsEnd) {
  const ContactProblem problem{{box_block(-2, 3), box_block(-2, 3), bilateral_block()},
                               MatrixXd::Identity(3, 3),
                               Vector3d(0.5, 0.5, -4)};
  bool solved = false;
  const VectorXd f = pivoted(problem, Vector3d(3, 1, 0), &solved);
  ASSERT_TRUE(solved);
  EXPECT_LT((f - Vector3d(3, -0.5, 4)).norm(), kPivotRounding);
}

// A matrix of zeros cannot stop what approaches: the step says so, and leaves the impulses alone.
TEST(SlidingPivots, SaysWhereNoStepIs) {
  bool solved = true;
  const VectorXd f = pivoted({{unilateral_block(), unilateral_block()},
                              Eigen::Vector2d(1, 0).asDiagonal().toDenseMatrix(),
                              Eigen::Vector2d(-1, -1)},
                             Eigen::Vector2d(0.3, 0.4), &solved);
  EXPECT_FALSE(solved);
  EXPECT_EQ(f, Eigen::Vector2d(0.3, 0.4));
}

}  // namespace
}  // namespace thenar::internal
