// Tests for force_map.h and tests/hand/simd_pair.h; Simbody is the oracle.

#include "tests/tendons/forces/force_map.h"

#include <ceres/jet.h>
#include <gtest/gtest.h>
#include <Eigen/QR>

#include "tests/hand/simd_pair.h"
#include "tests/hand/thumb_axes.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

using sample::kThumbHinges;
using sample::kThumbPostures;
using sample::kThumbTendons;

TEST(ForceMap, EqualsTheOneOfARebuiltSimbodySystem) {
  sample::Draw draw(81);
  const sample::ThumbTask task = sample::thumb_task(draw);
  for (int trial = 0; trial < 20; ++trial) {
    const sample::AxisParameters by = sample::axis_parameters(draw);
    const sample::ThumbMaps expected = sample::thumb_maps_by_simbody(task, by);
    EXPECT_LT(sample::difference(sample::thumb_maps(task, by), expected), 1e-11);
    const auto both = sample::apart(sample::thumb_maps(task, sample::paired(task), by));
    EXPECT_LT(sample::difference(both, expected), 1e-11);
  }
}

TEST(ForceMap, IsTheLeastSquaresSolution) {
  sample::Draw draw(82);
  const sample::ThumbTask task = sample::thumb_task(draw);
  for (int k = 0; k < kThumbPostures; ++k) {
    const Eigen::Matrix<double, 3, kThumbHinges> J =
        serial_jacobian(task.axes, task.tip, task.q[k]);
    const Eigen::MatrixXd A = Eigen::MatrixXd(J.transpose())
                                  .colPivHouseholderQr()
                                  .solve(Eigen::MatrixXd(task.arms[k].transpose()));
    EXPECT_TRUE(matrix_near(force_map(J, task.arms[k]).At.transpose(), A, 1e-13));
  }
}

// Every hinge moves the tip 0.1 m/rad along its own axis, so that f = R' t / 0.1 by hand.
TEST(ForceMap, MatchesHandComputedDigit) {
  const Eigen::Matrix3d J = 0.1 * Eigen::Matrix3d::Identity();
  const Eigen::Matrix3d R = Eigen::Vector3d(0.010, 0.008, 0.005).asDiagonal();
  const ForceMap<double, 3> map = force_map(J, R);
  EXPECT_TRUE(matrix_near(map.At.transpose() * Eigen::Vector3d(10, 20, 30),
                          Eigen::Vector3d(1.0, 1.6, 1.5), 1e-15));
  EXPECT_TRUE(matrix_near(map.squares, Eigen::Vector3d::Constant(0.01), 1e-17));
}

// A planar digit cannot resist a force out of its plane: that column is zero.
TEST(ForceMap, ReportsLostDirections) {
  Eigen::Matrix3d J = 0.1 * Eigen::Matrix3d::Identity();
  J(2, 2) = 0;
  const ForceMap<double, 3> map = force_map<double, 3, 3, double>(J, Eigen::Matrix3d::Identity());
  EXPECT_EQ(map.squares[2], 0);
  EXPECT_FALSE(map.At.col(2).allFinite());
}

TEST(SerialJacobian, EqualsTheChain) {
  sample::Draw draw(83);
  const sample::ThumbTask task = sample::thumb_task(draw);
  Tree<double> tree;
  for (int i = 0; i < kThumbHinges; ++i)
    tree.push_back({i - 1, i, 1, 0, task.axes[i].direction, task.axes[i].point});
  const TreeState<double> state = pose_tree(tree, task.q[0]);
  EXPECT_TRUE(matrix_near(serial_jacobian(task.axes, task.tip, task.q[0]),
                          position_jacobian(tree, state, kThumbHinges - 1,
                                            moved(state, kThumbHinges - 1, task.tip), kThumbHinges),
                          1e-15));
}

// The gradient of the whole map by one axis, automatic against central differences.
TEST(ForceMap, DifferentiatesByAxes) {
  using Jet = ceres::Jet<double, 4>;
  sample::Draw draw(84);
  const sample::ThumbTask task = sample::thumb_task(draw);
  const int moved = 2;
  std::array<Axis<Jet>, kThumbHinges> axes;
  for (int i = 0; i < kThumbHinges; ++i) {
    std::array<Jet, 4> by;
    for (int k = 0; k < 4; ++k) by[k] = i == moved ? Jet(0.0, k) : Jet(0.0);
    axes[i] = moved_axis<Jet>(task.axes[i], task.frames[i], by);
  }
  const Vec3<Jet> tip = task.tip.cast<Jet>();
  const auto At = force_map(serial_jacobian(axes, tip, task.q[0]), task.arms[0]).At;

  const double h = 1e-6;
  for (int k = 0; k < 4; ++k) {
    sample::AxisParameters plus{}, minus{};
    plus[moved][k] = h;
    minus[moved][k] = -h;
    const sample::ThumbMap expected =
        (sample::thumb_maps(task, plus)[0] - sample::thumb_maps(task, minus)[0]) / (2 * h);
    const sample::ThumbMap automatic = At.unaryExpr([&](const Jet& jet) { return jet.v[k]; });
    // Shifts of 1 m would change the map a hundredfold: scale the tolerance with the size.
    EXPECT_TRUE(matrix_near(automatic, expected, 1e-8 * (1 + expected.cwiseAbs().maxCoeff())));
  }
}

TEST(MovedAxis, TiltsAndShiftsAcrossItself) {
  const Axis<double> reference{{0, 0, 1}, {1, 2, 3}};
  const Tangents frame = tangents(reference.direction);
  const std::array<double, 4> by{3.0 / 4.0, 0, 0.1, -0.2};
  const Axis<double> axis = moved_axis<double>(reference, frame, by);
  EXPECT_TRUE(matrix_near(axis.direction, 0.6 * frame.e1 + 0.8 * reference.direction, 2e-16));
  EXPECT_TRUE(matrix_near(axis.point, reference.point + 0.1 * frame.e1 - 0.2 * frame.e2, 1e-15));
}

TEST(SimdPair, CalculatesWithBothHalves) {
  const SimdPair a(2, -3), b(5, 4);
  const auto expect = [](const SimdPair& p, double first, double second) {
    EXPECT_NEAR(p[0], first, 1e-15);
    EXPECT_NEAR(p[1], second, 1e-15);
  };
  expect(a + b, 7, 1);
  expect(a - b, -3, -7);
  expect(a * b, 10, -12);
  expect(a / b, 0.4, -0.75);
  expect(-a, -2, 3);
  expect(sqrt(b), std::sqrt(5.0), 2);
  expect(sin(a), std::sin(2.0), std::sin(-3.0));
  expect(cos(a), std::cos(2.0), std::cos(-3.0));
}

}  // namespace
}  // namespace thenar
