// Tests for tendons/wrapping/: strings whose end lies on the surface that they bend over, or next
// to it.

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "base/units.h"
#include "tests/matrix_near.h"
#include "tests/tendons/wrapping/path_wrenches.h"
#include "tests/tendons/wrapping/wrap_samples.h"

namespace thenar {
namespace {

using Eigen::Vector3d;
using sample::measured_arms;
using sample::surface;

constexpr double kHeights[] = {0, 1e-18, 1e-15, -1e-15, 1e-12, -1e-12, 1e-9, -0.99e-9, 1e-7, 1e-5};

/// A string that begins at a height over a surface and ends away from it, both in its frame.
struct Start {
  SurfaceShape shape;
  Vector3d size, near, b;  // `near`: next to where it begins
};
const Start kStarts[] = {
    {SurfaceShape::kCylinder, {0.006, 0, 0}, {-0.004, 0.005, 0.001}, {0.03, -0.004, 0.004}},
    {SurfaceShape::kSphere, {0.006, 0, 0}, {-0.004, 0.005, 0.001}, {0.03, -0.004, 0.004}},
    {SurfaceShape::kEllipsoid,
     {0.008, 0.006, 0.010},
     {-0.004, 0.005, 0.001},
     {0.03, -0.004, 0.004}},
    {SurfaceShape::kCapsule, {0.006, 0.004, 0}, {-0.004, 0.005, 0.001}, {0.03, -0.004, 0.004}},
    {SurfaceShape::kCapsule, {0.006, 0.004, 0}, {-0.003, 0.004, 0.007}, {0.03, -0.004, 0.012}},
    {SurfaceShape::kTorus, {0.0015, 0.0035, 0}, {0.00235, 0, -0.00096}, {0.012, 0.001, 0.02}},
};

Vector3d at_height(const BoneSurface& over, const Vector3d& near, double height) {
  const Vector3d on = nearest_point(over, near);
  return on + height * probe(over, on).normal;
}

/// The string with its surface on a link; it ends on the base.
PathSet carried_string(const Start& start, double height) {
  BoneSurface over = surface(start.shape, start.size);
  over.link = 0;
  PathSet set =
      sample::string_over({over}, at_height(over, start.near, height), start.b, {0, 0.02, 0.001});
  set.paths[0].points[0].link = 0;
  return set;
}

const Tree<double> kHinge{{-1, 0, 1, 0, Vector3d(0.1, -0.05, 1).normalized(), {0.003, 0.002, 0}},
                          {0, 1, 1, 0, Vector3d(1, 0.2, -0.1).normalized(), {0.001, 0.002, 0.001}}};

Eigen::MatrixXd arms_of(const Tree<double>& tree, const PathSet& set, const Eigen::VectorXd& q) {
  const TreeState<double> state = pose_tree(tree, q);
  Eigen::MatrixXd R(set.paths.size(), q.size());
  path_arms(tree, state, set, PathSolver(set).solve(state), R);
  return R;
}

/// Arms by the pressure on the surface and the pulls at the ends.
Eigen::RowVectorXd arms_of_wrenches(const Tree<double>& tree, const PathSet& set,
                                    const Eigen::VectorXd& q) {
  const TreeState<double> state = pose_tree(tree, q);
  PathSolver solver(set);
  return joint_torque(tree, state, sample::path_wrenches(state, set, solver.solve(state), 0),
                      static_cast<int>(q.size()))
      .transpose();
}

constexpr double kMeasured = 2e-9;  // of differences over 1 mrad [m/rad]

TEST(EndOnSurface, ArmsAreMinusTheSlopeOfTheLengthOnEverySurface) {
  for (const Start& start : kStarts)
    for (const double height : kHeights)
      for (const double angle : {-0.3, 0.0, 0.4}) {
        PathSet set = carried_string(start, height);
        const Tree<double> tree{kHinge[0]};
        const Eigen::VectorXd q = Eigen::VectorXd::Constant(1, angle);
        const PathShape shape = PathSolver(set).solve(pose_tree(tree, q))[0];
        ASSERT_EQ(shape.status, PathStatus::kTaut)
            << int(start.shape) << ' ' << height << ' ' << shape.error;
        EXPECT_EQ(shape.arcs.size(), 1U) << int(start.shape) << ' ' << height;
        EXPECT_TRUE(matrix_near(arms_of(tree, set, q), measured_arms(tree, set, q), kMeasured))
            << int(start.shape) << ' ' << height;
        EXPECT_TRUE(matrix_near(arms_of_wrenches(tree, set, q), arms_of(tree, set, q),
                                1e-10 - std::min(height, 0.0)))
            << int(start.shape) << ' ' << height;
      }
}

// From one point of a surface to another: all of the string lies on it.
TEST(EndOnSurface, BothEndsMayLieOnIt) {
  for (const Start& start : kStarts) {
    if (start.shape == SurfaceShape::kTorus) continue;
    for (const double height : kHeights) {
      PathSet set = carried_string(start, height);
      set.paths[0].points[1].p = at_height(set.surfaces[0], {0.004, 0.004, 0.002}, height);
      const PathShape shape =
          PathSolver(set).solve(pose_tree(Tree<double>{kHinge[0]}, Eigen::VectorXd::Zero(1)))[0];
      EXPECT_EQ(shape.status, PathStatus::kTaut) << int(start.shape) << ' ' << height;
      ASSERT_EQ(shape.arcs.size(), 1U) << int(start.shape) << ' ' << height;
      EXPECT_NEAR(shape.spans[0].u.norm(), 1, 1e-15);
      EXPECT_NEAR(shape.spans[1].u.norm(), 1, 1e-15);
    }
  }
}

// The string winds up as the point goes round the axis: its arm is the radius, whatever the angle.
// Over more than half a turn it slips off a sphere.
TEST(EndOnSurface, APointThatGoesRoundACylinderHasItsRadiusForAnArm) {
  const Tree<double> tree{{-1, 0, 1, 0, Vector3d::UnitZ(), Vector3d::Zero()}};
  for (const SurfaceShape shape : {SurfaceShape::kCylinder, SurfaceShape::kSphere})
    for (const double height : kHeights) {
      const double rho = 0.01 + height;
      PathSet set = sample::string_over({surface(shape, {0.01, 0, 0})}, {0, rho, 0},
                                        {0.03, 0.01, 0}, {0, 0.02, 0});
      set.paths[0].points[0].link = 0;
      for (const double angle : {0.3, 1.0, 1.7, 2.6}) {
        if (shape == SurfaceShape::kSphere && angle > 2) continue;
        const Eigen::VectorXd q = Eigen::VectorXd::Constant(1, angle);
        EXPECT_NEAR(arms_of(tree, set, q)(0, 0), -0.01, 1e-11 - 1.01 * std::min(height, 0.0))
            << height << ' ' << angle;
        EXPECT_NEAR(arms_of_wrenches(tree, set, q)[0], -0.01, 1e-11 - 1.01 * std::min(height, 0.0))
            << height << ' ' << angle;
      }
    }
}

// On the way it meets a second bone, carried by another link.
TEST(EndOnSurface, SeveralSurfacesMayFollow) {
  for (const Start& start : kStarts) {
    if (start.shape == SurfaceShape::kTorus) continue;
    for (const double height : {0.0, 1e-15, -1e-12, 1e-9}) {
      PathSet set = carried_string(start, height);
      set.paths[0].points[0].link = set.surfaces[0].link = 1;
      BoneSurface next = surface(SurfaceShape::kEllipsoid, {0.005, 0.005, 0.006});
      next.link = 0;
      next.X.p = {0.022, -0.001, 0.003};
      set.surfaces.push_back(next);
      set.paths[0].bends[0].push_back({1, {0, 0.02, 0}});
      set.paths[0].points[1].p = {0.04, -0.008, 0.004};
      const Eigen::VectorXd q = Eigen::Vector2d(0.1, 0.05);
      const PathShape shape = PathSolver(set).solve(pose_tree(kHinge, q))[0];
      ASSERT_EQ(shape.status, PathStatus::kTaut)
          << int(start.shape) << ' ' << height << ' ' << shape.error;
      EXPECT_EQ(shape.arcs.size(), 2U) << int(start.shape) << ' ' << height;
      EXPECT_TRUE(matrix_near(arms_of(kHinge, set, q), measured_arms(kHinge, set, q), kMeasured))
          << int(start.shape) << ' ' << height;
    }
  }
}

}  // namespace
}  // namespace thenar
