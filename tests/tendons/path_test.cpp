// Tests for tendons/path.cpp.

#include "tendons/path.h"

#include <gtest/gtest.h>

#include "tendons/wrapping/arm_slopes.h"
#include "tests/matrix_near.h"
#include "tests/tendons/wrapping/wrap_samples.h"

namespace thenar {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

const VectorXd kBent = Vector3d(0.5, 0.7, 0.4);

TendonPath<double> flexor() {
  return {{2, {-0.1, -0.004, 0.001}},
          {1, {-0.07, -0.006, 0.001}},
          {1, {-0.05, -0.007, -0.002}},
          {-1, {0.01, -0.01, -0.001}}};
}

TEST(PathSlopes, AreThoseOfTheSamePathAmongWrappedOnes) {
  const Tree<double> tree = sample::finger();
  const TreeState<double> state = pose_tree(tree, kBent);
  PathSet set;
  WrappedPath same;
  for (const PathNode<double>& node : flexor()) same.points.push_back({node.link, node.p});
  same.bends.resize(3);
  set.paths = {same};
  PathSolver solver(set);
  const std::vector<ArmDerivatives> slopes =
      arm_derivatives(tree, state, set, solver.solve(state), 3);
  ASSERT_TRUE(slopes[0].exist);
  EXPECT_TRUE(matrix_near(arm_derivatives(tree, state, flexor(), 3), slopes[0].dR, 1e-15));
}

TEST(PathSlopes, AreTheSlopesOfTheArms) {
  constexpr double h = 1e-4;  // [rad]
  const Tree<double> tree = sample::finger();
  const auto arms = [&](const VectorXd& q) {
    return VectorXd(moment_arms(tree, pose_tree(tree, q), flexor(), 3));
  };
  const MatrixXd dR = arm_derivatives(tree, pose_tree(tree, kBent), flexor(), 3);
  EXPECT_TRUE(matrix_near(dR, MatrixXd(dR.transpose()), 1e-16));
  for (Eigen::Index l = 0; l < 3; ++l) {
    const VectorXd step = h * VectorXd::Unit(3, l);
    const VectorXd slope = (arms(kBent + step) - arms(kBent - step)) / (2 * h);
    EXPECT_TRUE(matrix_near(VectorXd(dR.col(l)), slope, 1e-9));
  }
}

}  // namespace
}  // namespace thenar
