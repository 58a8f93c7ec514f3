// Tests for solvers/anderson_mixing.cpp.

#include "solvers/anderson_mixing.h"

#include <gtest/gtest.h>

namespace thenar {
namespace {

using Eigen::Vector4d;
using Eigen::VectorXd;

TEST(AndersonMixing, ArrivesWhereThreeSlowModesTendTo) {
  // x -> x + m(x) leaves .9, -.7, .5 and 0 of four parts: a combination of four motions vanishes.
  const Vector4d left(0.9, -0.7, 0.5, 0), goal(1, 2, 3, 4);
  AndersonMixing mixing(3);
  VectorXd x = Vector4d::Zero();
  for (int k = 0; k < 6; ++k)
    x += mixing.next_step((Vector4d::Ones() - left).cwiseProduct(goal - Vector4d(x)));
  EXPECT_LT((x - goal).norm(), 1e-12);
}

TEST(AndersonMixing, BeginsAnewWhereItForgets) {
  AndersonMixing mixing(3);
  const Vector4d first(1, 0, 0, 0), second(0.5, 0, 0, 0);
  EXPECT_EQ(mixing.next_step(first), VectorXd(first));
  EXPECT_NE(mixing.next_step(second), VectorXd(second));
  mixing.clear();
  EXPECT_EQ(mixing.next_step(second), VectorXd(second));
}

TEST(AndersonMixing, IsAGeometricSeriesInOneDirection) {
  // 1 + 1/2 + 1/4 + .. = 2, of which 1 is gone after the first step.
  AndersonMixing mixing(1);
  EXPECT_DOUBLE_EQ(mixing.next_step(VectorXd::Constant(1, 1))[0], 1);
  EXPECT_DOUBLE_EQ(mixing.next_step(VectorXd::Constant(1, 0.5))[0], 1);
}

}  // namespace
}  // namespace thenar
