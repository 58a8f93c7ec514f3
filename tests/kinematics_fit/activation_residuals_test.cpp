// Tests for kinematics_fit/activation_residuals.cpp.

#include "kinematics_fit/activation_residuals.h"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "tests/matrix_near.h"

namespace thenar {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// A unit pull of 0.2 along x at 10 +- 3 N: 2 +- 0.6 N beside a noise of 0.8 N, so +- 1 N in all,
/// and 1.5 N was measured. The force is 0.5 sds off, and 1 / 0.8 times as wide as its noise.
TEST(ActivationResiduals, OfOneMuscleByHand) {
  const ActivationTask task{{{0, 10, 9}}, {1.5, 0.4, 0}, {0.8, 0.8, 0.8}};
  const Residuals of = activation_residuals(task, Vector3d(0.2, 0, 0), MatrixXd(3, 0));
  EXPECT_TRUE(
      matrix_near(of.r, Eigen::Vector4d(0.5, -0.5, 0, std::sqrt(2 * std::log(1 / 0.8))), 1e-14));
  EXPECT_EQ(of.J.size(), 0);
}

// A component that is not fitted adds nothing, and surely known tensions do not widen the force.
TEST(ActivationResiduals, LeaveOutWhatIsNotFittedAndWhatIsSure) {
  const double inf = std::numeric_limits<double>::infinity();
  const ActivationTask task{{{0, 10, 0}}, {1.5, 0.4, 0}, {0.5, 0.5, inf}};
  const Residuals of = activation_residuals(task, Vector3d(0.2, 0, 0), MatrixXd::Ones(3, 1));
  EXPECT_TRUE(matrix_near(of.r, Eigen::Vector4d(1, -0.8, 0, 0), 1e-14));
  EXPECT_EQ(of.J(3, 0), 0);
}

// Forces of two pulls that are linear in two coordinates, against central differences.
TEST(ActivationResiduals, SlopesAreThoseOfDifferences) {
  std::mt19937 rng(5);
  std::normal_distribution<double> normal;
  const auto draw = [&] { return normal(rng); };
  const ActivationTask task{{{0, 5, 4}, {1, 8, 9}}, {1, -2, 0.3}, {0.3, 0.4, 0.2}};
  const Eigen::Matrix3Xd A = 0.2 * MatrixXd::NullaryExpr(3, 2, draw);
  const MatrixXd A_u = 0.1 * MatrixXd::NullaryExpr(6, 2, draw);
  const auto at = [&](const VectorXd& u) {
    const VectorXd moved = A.reshaped() + A_u * u;
    return activation_residuals(task, moved.reshaped(3, 2), MatrixXd(6, 0)).r;
  };
  constexpr double kStep = 1e-6;
  const MatrixXd J = activation_residuals(task, A, A_u).J;
  for (Eigen::Index c = 0; c < 2; ++c) {
    const VectorXd step = kStep * VectorXd::Unit(2, c);
    EXPECT_TRUE(matrix_near(J.col(c), (at(step) - at(-step)) / (2 * kStep), 1e-7));
  }
}

}  // namespace
}  // namespace thenar
