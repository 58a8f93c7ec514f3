// Tests for kinematics_fit/kernel/force_kernel.cpp: forces and their adjoint against Ceres'
// derivatives.

#include "kinematics_fit/kernel/force_kernel.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "kinematics_fit/fit_residuals.h"
#include "tests/kinematics_fit/kernel/kernel_cases.h"
#include "tests/posterior/thumb_scene.h"

namespace thenar {
namespace {

using sample::KernelCase;

constexpr double kExact = 1e-10;  // relative: rounding times the condition of the held tip

/// Greatest relative difference of forces, plus those of J' w and of J, from Ceres' at `points`
/// random places.
double error_against_ceres(const KernelCase& c, double spread, int points, std::mt19937& rng) {
  const ForceKernel kernel(c.digit, c.parameters, c.plan);
  double error = 0;
  for (int point = 0; point < points; ++point) {
    const Eigen::VectorXd u = sample::displacement(c, spread, rng);
    const Eigen::VectorXd w = sample::normal(3 * kernel.trials(), rng);
    const ForceJacobian expected = force_jacobian(c.digit, c.parameters, c.plan, u);
    const auto recorded = kernel.record(u);
    const Eigen::VectorXd force = expected.force.reshaped(), sd = sample::prior_sd(c);
    const Eigen::VectorXd pulled = sd.cwiseProduct(expected.J.transpose() * w);
    const Eigen::VectorXd gradient = sd.cwiseProduct(kernel.adjoint_product(recorded, w).col(0));
    const Eigen::MatrixXd J = expected.J * sd.asDiagonal();
    const ForceKernel::Slopes slopes = kernel.slopes(u);
    const double now = (recorded.forces - force).norm() / force.norm() +
                       (slopes.forces - force).norm() / force.norm() +
                       (slopes.J * sd.asDiagonal() - J).norm() / J.norm() +
                       (gradient - pulled).norm() / pulled.norm();
    if (!std::isfinite(now)) return now;
    error = std::max(error, now);
  }
  return error;
}

TEST(ForceKernel, HasTheDerivativesOfMeasuredFingers) {
  std::mt19937 rng(1);
  for (const char* subject : {"an_chao_middle", "synek2019_middle"})
    for (const char* specimen : {"H01", "H02", "B01"})
      EXPECT_LT(error_against_ceres(sample::measured_finger(subject, specimen), 0.5, 2, rng),
                kExact)
          << subject << ' ' << specimen;
}

TEST(ForceKernel, HasTheDerivativesOfTheThumbScene) {
  std::mt19937 rng(2);
  EXPECT_LT(error_against_ceres(sample::kernel_case(sample::thumb_problem()), 0.2, 5, rng), kExact);
}

// Every thumb of data/, pinned and clamped, with and without weight on out-of-plane moments: fewer
// loads than joints, as many, and more; forces stated in the tip, the base and between.
TEST(ForceKernel, HasTheDerivativesOfThumbsHoweverHeld) {
  std::mt19937 rng(3);
  for (const char* subject : {"arms_thumb", "graspit_skewed_thumb", "graspit_orthogonal_thumb",
                              "myohand_thumb", "mirakhorlo2016"})
    for (const sample::Held& held : sample::ways_to_hold())
      EXPECT_LT(error_against_ceres(sample::held_thumb(subject, held, rng), 0.3, 2, rng), kExact)
          << subject << ' ' << held.name;
}

// All parameters at once, so that each kind is there, on a finger with hood, paths and friction.
TEST(ForceKernel, HasTheDerivativesOfEveryKindOfParameter) {
  std::mt19937 rng(4);
  const KernelCase c = sample::everything_free();
  for (int kind = 0; kind <= static_cast<int>(ParameterKind::kPostureForce); ++kind)
    if (kind != static_cast<int>(ParameterKind::kArm)) {
      EXPECT_TRUE(sample::moves(c, static_cast<ParameterKind>(kind))) << kind;
    }
  EXPECT_LT(error_against_ceres(c, 0.3, 3, rng), kExact);
}

// A bone that hangs on the side, with tendons that run from it to the tip's branch.
TEST(ForceKernel, HasTheDerivativesOfBranchedChains) {
  std::mt19937 rng(8);
  KernelCase c = sample::everything_free();
  c.plan.hold = TipConstraint::kPinned;  // of three loads, as the bone's own joint carries none
  c.digit.model.tree.at(2).parent = 0;
  EXPECT_LT(error_against_ceres(c, 0.3, 3, rng), kExact);
}

// Each parameter alone: what does not move is folded into constants, and must be the same ones.
TEST(ForceKernel, FoldsWhatDoesNotMove) {
  std::mt19937 rng(5);
  for (const char* glob : {"axis/*/direction/*", "axis/*/point/*", "length/*", "path/*",
                           "hood/*/into", "hood/*/central", "hood/*/slope", "friction/*", "tip/*",
                           "sensor/*", "angle/*", "gain/*", "force/*/dorsal", "force/*/*/*"})
    EXPECT_LT(error_against_ceres(sample::one_kind_free(glob), 0.5, 1, rng), kExact) << glob;
}

// Central differences of the kernel's own forces: an error that Ceres' jets would share with it.
TEST(ForceKernel, PullsBackItsOwnDifferences) {
  std::mt19937 rng(6);
  const KernelCase c = sample::kernel_case(sample::thumb_problem());
  const ForceKernel kernel(c.digit, c.parameters, c.plan);
  const Eigen::VectorXd u = sample::displacement(c, 0.2, rng), sd = sample::prior_sd(c);
  const Eigen::VectorXd w = sample::normal(3 * kernel.trials(), rng);
  const Eigen::VectorXd gradient = kernel.adjoint_product(kernel.record(u), w);
  constexpr double kStep = 1e-5;  // in prior sds; its square is the error of a central difference
  for (Eigen::Index k = 0; k < u.size(); ++k) {
    Eigen::MatrixXd both = u.replicate(1, 2);
    both(k, 0) -= kStep * sd[k];
    both(k, 1) += kStep * sd[k];
    const Eigen::MatrixXd f = kernel.forces(both);
    EXPECT_NEAR(w.dot(f.col(1) - f.col(0)) / (2 * kStep), gradient[k] * sd[k],
                1e-7 * sd.cwiseProduct(gradient).norm())
        << k;
  }
}

// A straight thumb of parallel axes cannot say what pushes along it.
TEST(ForceKernel, IsNaNWhereTheTipIsSingular) {
  KernelCase c = sample::kernel_case(sample::thumb_problem());
  for (Eigen::VectorXd& q : c.plan.postures) q.setZero();
  for (Hinge<double>& hinge : c.digit.model.tree) {
    hinge.direction = Eigen::Vector3d::UnitX();
    hinge.point.head<2>().setZero();
  }
  const ForceKernel kernel(c.digit, c.parameters, c.plan);
  const Eigen::MatrixXd f = kernel.forces(Eigen::MatrixXd::Zero(kernel.coordinates(), 3));
  EXPECT_TRUE(f.array().isNaN().all());
}

TEST(ForceKernel, RejectsWrongShapes) {
  const KernelCase c = sample::measured_finger("an_chao_middle", "H01");
  const ForceKernel kernel(c.digit, c.parameters, c.plan);
  const auto recorded = kernel.record(Eigen::VectorXd::Zero(kernel.coordinates()));
  EXPECT_THROW((void)kernel.forces(Eigen::VectorXd::Zero(3)), InputError);
  EXPECT_THROW((void)kernel.record(Eigen::VectorXd::Zero(3)), InputError);
  EXPECT_THROW((void)kernel.adjoint_product(recorded, Eigen::VectorXd::Zero(3)), InputError);
}

// What thumb_scene.h promises to samplers.
TEST(ThumbScene, IsAsIllConditionedAsThumbsAre) {
  const FitProblem problem = sample::thumb_problem();
  ASSERT_EQ(problem.size(), 20);
  ASSERT_EQ(data_rows(problem), 54);
  const Solution mode = solve(least_squares(problem), Eigen::VectorXd::Zero(20));
  const Eigen::VectorXd sigma =
      fit_residuals(problem, mode.z, WithJacobian::kYes).J.jacobiSvd().singularValues();
  const double condition = std::pow(sigma[0] / sigma[19], 2);
  EXPECT_GT(condition, 1e7);
  EXPECT_LT(condition, 1e8);
}

}  // namespace
}  // namespace thenar
