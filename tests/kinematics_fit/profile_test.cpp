// Tests for kinematics_fit/profile.cpp on a quadratic problem, where profiles are parabolas.

#include "kinematics_fit/profile.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/error.h"
#include "tests/kinematics_fit/fit_samples.h"

namespace thenar {
namespace {

/// r = (A z - b, z): its profile is  (z_i - m_i)^2 / (2 C_ii)  with  C = (A'A + 1)^-1.
struct Quadratic {
  Eigen::Matrix<double, 2, 3> A;
  Eigen::Vector2d b{1, -2};
  Eigen::Matrix3d C;
  Eigen::Vector3d m;

  Quadratic() {
    A << 2, 1, 0, 0.5, -1, 0;  // the third coordinate is not seen
    C = (A.transpose() * A + Eigen::Matrix3d::Identity()).inverse();
    m = C * A.transpose() * b;
  }

  [[nodiscard]] LeastSquares problem(double bound = 100) const {
    LeastSquares out;
    out.lower = Eigen::Vector3d::Constant(-bound);
    out.upper = Eigen::Vector3d::Constant(bound);
    out.residuals = [this](const Eigen::VectorXd& z, WithJacobian) {
      Residuals r{Eigen::VectorXd(5), Eigen::MatrixXd(5, 3)};
      r.r << A * z - b, z;
      r.J << A, Eigen::Matrix3d::Identity();
      return r;
    };
    return out;
  }
};

ProfileOptions precise() {
  ProfileOptions options;
  options.solver.tolerance = 1e-14;
  return options;
}

TEST(Profile, IsTheParabolaOfAQuadraticProblem) {
  const Quadratic quadratic;
  const Profile profile = profile_likelihood(quadratic.problem(), quadratic.m, 0, precise());
  ASSERT_EQ(profile.points.size(), 17U);
  EXPECT_EQ(profile.not_converged, 0);
  for (const ProfilePoint& point : profile.points)
    EXPECT_NEAR(point.rise, std::pow(point.z - quadratic.m[0], 2) / (2 * quadratic.C(0, 0)), 1e-9);
}

TEST(Profile, BoundsAreThoseOfTheParabola) {
  const Quadratic quadratic;
  const Profile profile = profile_likelihood(quadratic.problem(), quadratic.m, 0, precise());
  const double half = std::sqrt(2 * 1.92 * quadratic.C(0, 0));
  ASSERT_TRUE(profile.bounds.lower && profile.bounds.upper);
  EXPECT_NEAR(*profile.bounds.lower, quadratic.m[0] - half, 1e-8);
  EXPECT_NEAR(*profile.bounds.upper, quadratic.m[0] + half, 1e-8);
}

// Without its own prior the coordinate's curvature is 1 / C_ii - 1, about another minimum.
TEST(Profile, WithoutItsOwnPriorOnlyTheDataHoldACoordinate) {
  const Quadratic quadratic;
  const double curvature = 1 / quadratic.C(0, 0) - 1;
  const double centre = quadratic.m[0] / quadratic.C(0, 0) / curvature;
  const double half = std::sqrt(2 * 1.92 / curvature);
  const Profile profile = profile_likelihood(quadratic.problem(), quadratic.m, 0, precise());
  ASSERT_TRUE(profile.without_own_prior.lower && profile.without_own_prior.upper);
  EXPECT_NEAR(*profile.without_own_prior.lower, centre - half, 1e-7);
  EXPECT_NEAR(*profile.without_own_prior.upper, centre + half, 1e-7);
}

TEST(Profile, IsOpenWhereTheDataSayNothing) {
  const Quadratic quadratic;
  const Profile profile = profile_likelihood(quadratic.problem(), quadratic.m, 2, precise());
  EXPECT_TRUE(profile.bounds.lower && profile.bounds.upper);  // the prior holds it
  EXPECT_NEAR(*profile.bounds.upper, std::sqrt(2 * 1.92), 1e-7);
  EXPECT_FALSE(profile.without_own_prior.lower || profile.without_own_prior.upper);
}

TEST(Profile, EndsAtTheBounds) {
  const Quadratic quadratic;
  const Profile profile = profile_likelihood(quadratic.problem(1), quadratic.m, 2, precise());
  EXPECT_DOUBLE_EQ(profile.points.front().z, -1);
  EXPECT_DOUBLE_EQ(profile.points.back().z, 1);
  EXPECT_FALSE(profile.bounds.lower || profile.bounds.upper);  // 1/2 < 1.92
}

TEST(Profile, HasOneSideWhereTheEstimateSitsOnItsBound) {
  const Quadratic quadratic;
  LeastSquares problem = quadratic.problem();
  problem.lower[2] = 0;  // where the prior has it
  const Profile profile = profile_likelihood(problem, quadratic.m, 2, precise());
  EXPECT_EQ(profile.points.size(), 9U);
  EXPECT_FALSE(profile.bounds.lower);
  ASSERT_TRUE(profile.bounds.upper);
  EXPECT_NEAR(*profile.bounds.upper, std::sqrt(2 * 1.92), 1e-7);
}

// With little noise a finger is nearly linear within its posterior.
TEST(Profile, OfAFingerAgreesWithItsCurvature) {
  sample::FitSetup setup =
      sample::middle_finger("[[parameter]]\nmatch='axis/*/direction/*'\nstate='free'\n");
  setup.experiments.front().sd_floor = 0.003;  // [N]
  std::mt19937 rng(6);
  sample::simulate(setup, Eigen::VectorXd::Zero(8), 0.003, rng, setup.experiments.front());
  const FitProblem problem = setup.problem();
  SolveOptions options;
  options.tolerance = 1e-14;
  const Solution fit =
      solve(least_squares(problem), Eigen::VectorXd::Zero(problem.size()), options);
  const Covariance covariance = posterior_covariance(problem, fit.z);
  ProfileOptions near = precise();
  near.half_width = 3 * covariance.learnt[0].sd;
  const Profile profile = profile_likelihood(problem, fit.z, 0, near);
  EXPECT_EQ(profile.name, covariance.learnt[0].name);
  ASSERT_TRUE(profile.bounds.lower && profile.bounds.upper);
  const double half = (*profile.bounds.upper - *profile.bounds.lower) / 2;
  EXPECT_NEAR(half / (std::sqrt(2 * 1.92) * covariance.learnt[0].sd), 1, 0.05);
}

TEST(Profile, NamesAMissingCoordinate) {
  const Quadratic quadratic;
  EXPECT_THROW((void)profile_likelihood(quadratic.problem(), quadratic.m, 3), InputError);
}

}  // namespace
}  // namespace thenar
