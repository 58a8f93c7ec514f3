// Tests for tendons/wrapping/path_arms.cpp.

#include "tendons/wrapping/path_arms.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "tests/matrix_near.h"
#include "tests/tendons/wrapping/path_wrenches.h"
#include "tests/tendons/wrapping/wrap_samples.h"

namespace thenar {
namespace {

using Eigen::MatrixXd;
using Eigen::RowVectorXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

struct PosedPath {
  TreeState<double> state;
  std::vector<PathShape> shapes;
  MatrixXd R;
};

PosedPath pose(const Tree<double>& tree, const PathSet& set, const VectorXd& q) {
  PosedPath posed{pose_tree(tree, q), {}, MatrixXd(set.paths.size(), q.size())};
  posed.shapes = PathSolver(set).solve(posed.state);
  path_arms(tree, posed.state, set, posed.shapes, posed.R);
  return posed;
}

/// A flexor with via points, and a lumbrical from it to the first bone.
PathSet lumbrical() {
  PathSet set;
  WrappedPath flexor, rider;
  flexor.name = "FDP";
  flexor.points = {{2, {-0.1, -0.004, 0}},
                   {1, {-0.07, -0.006, 0.001}},
                   {0, {-0.02, -0.008, 0}},
                   {-1, {0.01, -0.01, -0.001}},
                   {-1, {0.06, -0.01, -0.002}}};
  flexor.bends.resize(4);
  rider.name = "LU";
  rider.points = {{0, {-0.02, 0.001, 0.006}}, {-1, {0.03, -0.01, -0.0014}}};
  rider.bends.resize(1);
  rider.carrier = 0;
  rider.ride = 0.135;  // about the same place, between the flexor's last two points
  set.paths = {flexor, rider};
  return set;
}

const VectorXd kBentFinger = Vector3d(0.5, 0.7, 0.4);

class PathArmsOver : public testing::TestWithParam<SurfaceShape> {};

TEST_P(PathArmsOver, AreTheSlopesOfTheLength) {
  const PathSet set = sample::extensor(GetParam());
  const PosedPath posed = pose(sample::finger(), set, kBentFinger);
  ASSERT_EQ(posed.shapes[0].status, PathStatus::kTaut);
  ASSERT_EQ(posed.shapes[0].arcs.size(), 2U);
  // Differences of lengths good to 1e-15 m over 1e-3 rad.
  EXPECT_TRUE(matrix_near(RowVectorXd(posed.R.row(0)),
                          sample::measured_arms(sample::finger(), set, kBentFinger), 2e-11));
}

TEST_P(PathArmsOver, AreThoseOfTheContactForces) {
  const PathSet set = sample::extensor(GetParam());
  const PosedPath posed = pose(sample::finger(), set, kBentFinger);
  const auto wrenches = sample::path_wrenches(posed.state, set, posed.shapes, 0);
  EXPECT_TRUE(matrix_near(VectorXd(posed.R.row(0).transpose()),
                          joint_torque(sample::finger(), posed.state, wrenches, 3), 1e-12));
}

TEST_P(PathArmsOver, PushTheBonesWithoutPushingTheHand) {
  const PathSet set = sample::extensor(GetParam());
  const PosedPath posed = pose(sample::finger(), set, kBentFinger);
  Wrench sum;
  for (const LinkWrench& on : sample::path_wrenches(posed.state, set, posed.shapes, 0))
    sum += on.wrench;
  EXPECT_LT(sum.force.norm(), 1e-12);
  EXPECT_LT(sum.moment.norm(), 1e-13);
}

INSTANTIATE_TEST_SUITE_P(EveryShape, PathArmsOver,
                         testing::Values(SurfaceShape::kCylinder, SurfaceShape::kSphere,
                                         SurfaceShape::kEllipsoid, SurfaceShape::kCapsule,
                                         SurfaceShape::kTorus),
                         [](const auto& test) { return "Shape" + std::to_string(test.index); });

TEST(PathArms, OfALumbricalIncludeTheMotionOfItsOrigin) {
  const PathSet set = lumbrical();
  const PosedPath posed = pose(sample::finger(), set, kBentFinger);
  EXPECT_TRUE(matrix_near(RowVectorXd(posed.R.row(1)),
                          sample::measured_arms(sample::finger(), set, kBentFinger, 1), 2e-11));
}

TEST(PathArms, OfALumbricalAreThoseOfTheContactForces) {
  const PathSet set = lumbrical();
  const PosedPath posed = pose(sample::finger(), set, kBentFinger);
  const auto wrenches = sample::path_wrenches(posed.state, set, posed.shapes, 1);
  EXPECT_TRUE(matrix_near(VectorXd(posed.R.row(1).transpose()),
                          joint_torque(sample::finger(), posed.state, wrenches, 3), 1e-14));
}

// A lumbrical crosses neither distal joint, yet turns them: it takes tension off the deep flexor.
TEST(PathArms, OfALumbricalExtendTheJointsThatItDoesNotCross) {
  const PosedPath posed = pose(sample::finger(), lumbrical(), kBentFinger);
  EXPECT_GT(posed.R(0, 2), 0.002);   // the flexor flexes
  EXPECT_LT(posed.R(1, 2), -0.001);  // the lumbrical extends
}

TEST(PathArms, GiveThePathsVelocity) {
  const PathSet set = sample::extensor(SurfaceShape::kCapsule);
  const Tree<double> tree = sample::finger();
  const PosedPath posed = pose(tree, set, kBentFinger);
  const Vector3d q_dot(0.3, -1.1, 0.7);
  constexpr double h = 1e-4;  // [s]
  const double measured = (sample::length_at(tree, set, kBentFinger + h * q_dot) -
                           sample::length_at(tree, set, kBentFinger - h * q_dot)) /
                          (2 * h);
  EXPECT_NEAR(-posed.R.row(0).dot(q_dot), measured, 1e-9);
}

// Runs within one bone make no arm: without them arms are the very bits, and the length stays.
// Paths that carry keep them.
TEST(PathArms, NeedNoRunsWithinOneBone) {
  const Tree<double> tree = sample::finger();
  const TreeState<double> state = pose_tree(tree, kBentFinger);
  for (const bool carries : {false, true}) {
    PathSet set = lumbrical();
    if (!carries) set.paths.pop_back();
    const PosedPath whole = pose(tree, set, kBentFinger);
    PathSolver solver(set);
    const std::vector<PathShape>& shapes = solver.solve_for_arms(state);
    MatrixXd R(whole.R.rows(), whole.R.cols());
    path_arms(tree, state, set, shapes, R);
    EXPECT_EQ(R, whole.R);
    EXPECT_NEAR(shapes[0].length, whole.shapes[0].length, 1e-16);
    EXPECT_EQ(whole.shapes[0].spans.size(), 4U);
    EXPECT_EQ(shapes[0].spans.size(), carries ? 4U : 3U);
  }
}

TEST(PathArms, GoToTheRowsTheyAreGiven) {
  const PathSet set = lumbrical();
  const Tree<double> tree = sample::finger();
  const PosedPath posed = pose(tree, set, kBentFinger);
  MatrixXd R = MatrixXd::Constant(4, 3, 7);
  path_arms(tree, posed.state, set, posed.shapes, {-1, 2}, R);
  EXPECT_EQ(R.row(2), posed.R.row(1));
  for (const int row : {0, 1, 3}) EXPECT_TRUE((R.row(row).array() == 7).all());
  EXPECT_THROW(path_arms(tree, posed.state, set, posed.shapes, {0}, R), InputError);
}

}  // namespace
}  // namespace thenar
