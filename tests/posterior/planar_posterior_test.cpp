// Tests for the posterior of forces in the plane of flexion: density, adjoint, robust noise.

#include <cmath>

#include <gtest/gtest.h>

#include "base/units.h"
#include "kinematics_fit/fit_residuals.h"
#include "posterior/force_density.h"
#include "posterior/hand_posterior.h"
#include "tests/kinematics_fit/fit_samples.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

using Eigen::VectorXd;
using sample::FitSetup;

/// The finger with every parameter free, at made-up forces stated in a segment; out-of-plane
/// moments, which no plane has, from a mean that is not zero.
FitSetup all_free(TipConstraint hold, const std::string& segment) {
  FitSetup setup = sample::planar_finger();
  Experiment& experiment = setup.experiments.front();
  experiment.hold = hold;
  experiment.force_segment = segment;
  setup.parameters = choose_parameters(
      setup.digit, sample::postures_of(experiment),
      sample::settings("[[parameter]]\nmatch = '*'\nstate = 'free'\n"
                       "[[parameter]]\nmatch = 'hold/out_of_plane'\nmean_mm = 15\n"));
  return setup;
}

TEST(PlanarPosterior, KernelHasTheForcesAndDerivativesOfJets) {
  std::mt19937 rng(4);
  for (const TipConstraint hold : {TipConstraint::kPinned, TipConstraint::kRigid})
    for (const char* segment : {"DP2", "PP2"}) {
      const FitSetup setup = all_free(hold, segment);
      const ExperimentPlan plan =
          plan_experiment(setup.digit, setup.parameters, setup.experiments.front());
      const ForceKernel kernel(setup.digit, setup.parameters, plan);
      const VectorXd sd =
          sample::population_sds(setup.parameters) + sample::between_sds(setup.parameters);
      const VectorXd u = 0.3 * sd.cwiseProduct(sample::normal(sd.size(), rng));
      const VectorXd w = sample::normal(3 * kernel.trials(), rng);
      const ForceJacobian expected = force_jacobian(setup.digit, setup.parameters, plan, u);
      const auto recorded = kernel.record(u);
      const VectorXd gradient = sd.cwiseProduct(kernel.adjoint_product(recorded, w).col(0));
      const VectorXd pulled = sd.cwiseProduct(expected.J.transpose() * w);
      EXPECT_TRUE(matrix_near(recorded.forces, expected.force.reshaped(), 1e-10)) << segment;
      EXPECT_LT((gradient - pulled).norm(), 1e-10 * pulled.norm()) << segment;
    }
}

// log p = - cost of the data - sum over two components a trial of log(sd sqrt(2 pi)).
TEST(PlanarPosterior, LogLikelihoodIsTheCostOfTheFit) {
  const FitProblem problem = all_free(TipConstraint::kRigid, "DP2").problem();
  PosteriorOptions options;
  options.learn_noise = options.learn_specimen_scale = options.sphere_priors = false;
  const HandPosterior posterior(problem, options);
  const VectorXd z = posterior.fit_coordinates(VectorXd::Constant(posterior.size(), 0.2));
  const VectorXd r = fit_residuals(problem, z, WithJacobian::kNo).r.head(data_rows(problem));
  const double expected =
      -0.5 * r.squaredNorm() - 4 * std::log(0.05 * std::sqrt(2 * kPi));  // sd 0.05 N
  const Densities at =
      posterior.evaluate(VectorXd::Constant(posterior.size(), 0.2), WithGradient::kNo);
  EXPECT_NEAR(at.log_likelihood[0], expected, 1e-9 * std::abs(expected));
}

// Also by the factor on the noise, normal and robust.
TEST(PlanarPosterior, GradientIsThatOfDifferences) {
  for (const double robust : {0.0, 3.0}) {
    const HandPosterior posterior(all_free(TipConstraint::kPinned, "DP2").problem(robust), {});
    std::mt19937 rng(5);
    const VectorXd x = 0.2 * sample::normal(posterior.size(), rng);
    const Densities at = posterior.evaluate(x, WithGradient::kYes);
    constexpr double kStep = 1e-5;
    for (Eigen::Index i = 0; i < x.size(); ++i) {
      const VectorXd step = kStep * VectorXd::Unit(x.size(), i);
      const double slope = (posterior.evaluate(x + step, WithGradient::kNo).log_likelihood[0] -
                            posterior.evaluate(x - step, WithGradient::kNo).log_likelihood[0]) /
                           (2 * kStep);
      EXPECT_NEAR(at.likelihood_gradient(i, 0), slope, 1e-6 * at.likelihood_gradient.col(0).norm());
    }
  }
}

// In rings of the plane; tails of Student's t are long.
TEST(PlanarPosterior, RobustNoiseIsAProperDensity) {
  for (const double robust : {0.0, 2.0, 3.0}) {
    const ForceNoise model(robust);
    constexpr int kSteps = 20000;
    double sum = 0;
    for (int i = 0; i < kSteps; ++i) {
      const double a = (i + 0.5) / kSteps * kPi / 2, r = std::tan(a);
      const double ring = 2 * kPi * r / std::pow(std::cos(a), 2) * (kPi / 2 / kSteps);
      sum += ring * std::exp(model.log_constant(2) + model.tail(r * r).log_density);
    }
    EXPECT_NEAR(sum, 1, 1e-6) << robust;
  }
}

// A third component of infinite sd changes neither the density nor its slopes.
TEST(PlanarPosterior, TasksLeaveOutWhatIsNotFitted) {
  const std::vector<MuscleTension> pulls{{0, 12, 9}};
  const double inf = std::numeric_limits<double>::infinity();
  const Eigen::Matrix3Xd unit = Eigen::Vector3d(0.3, -0.1, 0);
  const TaskDensity at = task_density(ForceNoise(0), unit, pulls, {3, -1, 0}, {0.5, 0.8, inf}, 1.4);
  // By hand: S = diag(0.49, 1.2544) + 9 a a', r = (3 - 3.6, -1 + 1.2).
  Eigen::Matrix2d S;
  S << 0.49 + 0.81, -0.27, -0.27, 1.2544 + 0.09;
  const Eigen::Vector2d r(-0.6, 0.2);
  EXPECT_NEAR(at.log_density,
              -std::log(2 * kPi) - 0.5 * std::log(S.determinant()) - 0.5 * r.dot(S.inverse() * r),
              1e-12);
  EXPECT_EQ(at.by_unit(2, 0), 0);
  EXPECT_TRUE(std::isfinite(at.by_log_noise));
}

}  // namespace
}  // namespace thenar
