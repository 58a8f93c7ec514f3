// Tests for tendons/wrapping/fitted_path.cpp: fitted -> wrapped as the order grows.

#include "tendons/wrapping/fitted_path.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "tests/matrix_near.h"
#include "tests/tendons/wrapping/wrap_samples.h"

namespace thenar {
namespace {

using Eigen::RowVectorXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

const Tree<double> kFinger = sample::finger();
const FitBox kBox{Vector3d(0.3, 0.3, 0.3), Vector3d(1.2, 1.2, 1.2)};

/// The via points of the extensor alone.
PathSet straight() {
  PathSet set = sample::extensor(SurfaceShape::kSphere);
  for (auto& bends : set.paths[0].bends) bends.clear();
  return set;
}

// Straight runs are analytic: each order gains digits, until rounding.
TEST(FittedPath, ComesNearerWithItsOrder) {
  const double coarse = fit_path(kFinger, straight(), 0, kBox, 4).error.arm;
  const double fine = fit_path(kFinger, straight(), 0, kBox, 8).error.arm;
  const double finest = fit_path(kFinger, straight(), 0, kBox, 20).error.arm;
  EXPECT_LT(fine, 0.1 * coarse);
  EXPECT_LT(finest, 1e-11);  // [m/rad]
}

// Always on the bone within this box, so analytic there too.
TEST(FittedPath, ReachesTheWrappedPath) {
  const PathSet set = sample::extensor(SurfaceShape::kCylinder);
  const FittedPath fit = fit_path(kFinger, set, 0, kBox, 16);
  const Vector3d q(0.5, 0.7, 0.4);
  EXPECT_NEAR(fitted_length(fit, q).length, sample::length_at(kFinger, set, q), 1e-10);
  EXPECT_TRUE(
      matrix_near(fitted_length(fit, q).arms, sample::measured_arms(kFinger, set, q), 1e-8));
}

TEST(FittedPath, HasArmsThatAreTheExactSlopesOfItsLength) {
  const FittedPath fit = fit_path(kFinger, sample::extensor(SurfaceShape::kCapsule), 0, kBox, 5);
  const Vector3d q(0.5, 0.7, 0.4);
  constexpr double h = 1e-3;  // [rad]
  for (int j = 0; j < 3; ++j) {
    const auto at = [&](double step) {
      return fitted_length(fit, q + step * Vector3d::Unit(j)).length;
    };
    const double slope = (8 * (at(h) - at(-h)) - (at(2 * h) - at(-2 * h))) / (12 * h);
    EXPECT_NEAR(fitted_length(fit, q).arms[j], -slope, 1e-12);
  }
}

// At 500 postures that are on no grid, through a touch-down where only the slope is continuous.
TEST(FittedPath, StaysWithinItsBound) {
  const PathSet set = sample::extensor(SurfaceShape::kCylinder);
  const FitBox box{Vector3d(-0.4, -0.4, -0.4), Vector3d(1.2, 1.2, 1.2)};
  const FittedPath fit = fit_path(kFinger, set, 0, box, 8);
  std::mt19937 rng(7);
  std::uniform_real_distribution<double> angle(-0.4, 1.2);
  PathSolver solver(set);
  for (int i = 0; i < 500; ++i) {
    const Vector3d q(angle(rng), angle(rng), angle(rng));
    const TreeState<double> state = pose_tree(kFinger, q);
    const auto& shapes = solver.solve(state);
    Eigen::MatrixXd R(1, 3);
    path_arms(kFinger, state, set, shapes, R);
    const FittedLength fitted = fitted_length(fit, q);
    ASSERT_LE(std::abs(fitted.length - shapes[0].length), fit.error.length_bound);
    ASSERT_LE((fitted.arms - R).cwiseAbs().maxCoeff(), fit.error.arm_bound);
  }
}

TEST(FittedPath, RefusesAJointWithoutARange) {
  const FitBox box{Vector3d(0, -3.15, 0), Vector3d(1, 3.15, 1)};
  EXPECT_THROW((void)fit_path(kFinger, straight(), 0, box, 4), InputError);
}

}  // namespace
}  // namespace thenar
