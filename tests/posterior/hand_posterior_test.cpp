// Tests for posterior/hand_posterior.cpp: the density, its gradient, and what troubles it survives.

#include "posterior/hand_posterior.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/units.h"
#include "kinematics_fit/fit_residuals.h"
#include "posterior/bounded_table.h"
#include "tests/kinematics_fit/fit_samples.h"
#include "tests/matrix_near.h"
#include "tests/posterior/thumb_scene.h"

namespace thenar {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using sample::FitSetup;
using sample::kAxes;
using sample::middle_finger;

const std::string kAll = kAxes + R"(
[[parameter]]
match = "axis/MCP3_FE/point/*"
state = "free"
[[parameter]]
match = "path/FD?/*/dorsal"
state = "free"
sd_mm = 0.7
between_sd_mm = 0.9
range_mm = 2
[[parameter]]
match = "gain/LU"
state = "free"
sd = 0
between_sd = 0.1
range = 0.25
[[parameter]]
match = "sensor/*"
state = "free"
sd_deg = 0
between_sd_deg = 4
)";

PosteriorOptions plain() {
  PosteriorOptions options;
  options.learn_noise = options.learn_specimen_scale = options.sphere_priors = false;
  return options;
}

/// Two rows of activations in postures of the experiment.
void add_activations(Experiment& experiment) {
  ActivationRow row;
  row.posture = experiment.postures[1].name;
  row.activation = {{"FDS", 0.05}, {"EDC", 0.02}, {"FDP", 0.0}};
  row.sd = {{"FDS", 0.02}, {"EDC", 0.01}, {"FDP", 0.03}};
  row.force = {-1, -2, 0.2};
  experiment.activations = {row, row};
  experiment.activations[1].posture = experiment.postures[2].name;
}

/// Two specimens with everything that a posterior knows: bounds, specimen_scales, tasks.
FitProblem two_specimens(double robust_scale = 0) {
  FitSetup setup = middle_finger(kAll);
  setup.experiments.push_back(sample::experiment("H02"));
  add_activations(setup.experiments[0]);
  return setup.problem(robust_scale);
}

/// One specimen with trials and rows of activations.
FitProblem with_activations(double robust_scale) {
  FitSetup setup = middle_finger(kAxes);
  add_activations(setup.experiments.front());
  return setup.problem(robust_scale);
}

VectorXd some_point(const HandPosterior& posterior, unsigned seed = 1, double size = 0.5) {
  std::mt19937 rng(seed);
  return size * sample::normal(posterior.size(), rng);
}

/// Log prior and log likelihood.
std::pair<double, double> at(const HandPosterior& posterior, const VectorXd& x) {
  const Densities one = posterior.evaluate(x, WithGradient::kNo);
  return {one.log_prior[0], one.log_likelihood[0]};
}

// -- Gradients --------------------------------------------------------------------------------

/// Largest error of a gradient against central differences, by its largest entry.
double difference_error(const HandPosterior& posterior, const VectorXd& x) {
  constexpr double kStep = 1e-5;
  const Densities here = posterior.evaluate(x, WithGradient::kYes);
  VectorXd prior(x.size()), likelihood(x.size());
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    const VectorXd step = kStep * VectorXd::Unit(x.size(), i);
    const auto more = at(posterior, x + step), less = at(posterior, x - step);
    prior[i] = (more.first - less.first) / (2 * kStep);
    likelihood[i] = (more.second - less.second) / (2 * kStep);
  }
  const auto error = [](const VectorXd& a, const VectorXd& b) {
    return (a - b).cwiseAbs().maxCoeff() / b.cwiseAbs().maxCoeff();
  };
  return std::max(error(here.prior_gradient.col(0), prior),
                  error(here.likelihood_gradient.col(0), likelihood));
}

// Steps of 1e-5 err by their square and by rounding of a likelihood of 1e3: 1e-13 / 1e-5.
TEST(HandPosterior, GradientIsThatOfDifferences) {
  for (const double robust : {0.0, 2.5}) {
    const HandPosterior posterior(two_specimens(robust));
    for (const unsigned seed : {1U, 2U, 3U})
      EXPECT_LT(difference_error(posterior, some_point(posterior, seed)), 1e-7);
  }
}

/// The derivative of the likelihood by x from the residuals of the fit, differentiated by Jets:
/// -J' r, where bounded entries have dz/dx = (Phi(h) - Phi(l)) phi(x) / phi(z).
VectorXd gradient_of_fit(const FitProblem& problem, const HandPosterior& posterior,
                         const VectorXd& x) {
  const VectorXd z = posterior.fit_coordinates(x);
  const Residuals residuals = fit_residuals(problem, z, WithJacobian::kYes);
  const int rows = data_rows(problem);
  VectorXd by_z = -residuals.J.topRows(rows).transpose() * residuals.r.head(rows);
  for (Eigen::Index i = 0; i < z.size(); ++i)
    by_z[i] *= (normal_probability(problem.coordinates().upper()[i]) -
                normal_probability(problem.coordinates().lower()[i])) *
               std::exp(0.5 * (z[i] * z[i] - x[i] * x[i]));
  return by_z;
}

TEST(HandPosterior, GradientIsThatOfTheFitsJets) {
  FitSetup setup = middle_finger(kAxes + R"(
[[parameter]]
match = "path/FD?/*/dorsal"
state = "free"
range_mm = 2
)");
  for (const double robust : {0.0, 2.5}) {
    for (const FitProblem& problem :
         {setup.problem(robust), sample::thumb_problem(), with_activations(robust),
          sample::planar_finger().problem(robust)}) {
      const HandPosterior posterior(problem, plain());
      ASSERT_EQ(posterior.size(), problem.size());
      for (const unsigned seed : {1U, 2U}) {
        const VectorXd x = some_point(posterior, seed);
        const VectorXd expected = gradient_of_fit(problem, posterior, x);
        const VectorXd gradient =
            posterior.evaluate(x, WithGradient::kYes).likelihood_gradient.col(0);
        EXPECT_TRUE(matrix_near(gradient, expected, 1e-10 * expected.cwiseAbs().maxCoeff()));
      }
    }
  }
}

// With plain options the log likelihood is -cost up to a constant, whatever the robust scale.
// Its kernel is linear in tensions: a net would be left out without a word.
TEST(HandPosterior, RefusesANet) {
  FitInputs inputs = sample::finger_inputs("an_chao_middle", {"H01"});
  inputs.net = sample::source("nets/winslow");
  EXPECT_THROW(HandPosterior{build_problem(inputs)}, InputError);
}

TEST(HandPosterior, LikelihoodIsTheCostOfTheFit) {
  for (const FitProblem& problem :
       {middle_finger(kAxes).problem(0), middle_finger(kAxes).problem(2.5), with_activations(0),
        with_activations(2.5)}) {
    const HandPosterior posterior(problem, plain());
    const auto cost = [&](const VectorXd& x) {
      const VectorXd z = posterior.fit_coordinates(x);
      return 0.5 *
             fit_residuals(problem, z, WithJacobian::kNo).r.head(data_rows(problem)).squaredNorm();
    };
    const VectorXd a = some_point(posterior, 1), b = some_point(posterior, 2);
    EXPECT_NEAR(at(posterior, a).second - at(posterior, b).second, cost(b) - cost(a),
                1e-12 * cost(a));
  }
}

TEST(HandPosterior, PointsDoNotDependOnTheirNeighbours) {
  const HandPosterior posterior(two_specimens());
  MatrixXd x(posterior.size(), 11);
  for (Eigen::Index p = 0; p < x.cols(); ++p)
    x.col(p) = some_point(posterior, static_cast<unsigned>(p));
  const Densities together = posterior.evaluate(x, WithGradient::kYes);
  for (Eigen::Index p = 0; p < x.cols(); ++p) {
    const Densities alone = posterior.evaluate(x.col(p), WithGradient::kYes);
    EXPECT_EQ(alone.log_prior[0], together.log_prior[p]);
    EXPECT_EQ(alone.log_likelihood[0], together.log_likelihood[p]);
    EXPECT_TRUE(matrix_near(alone.prior_gradient, together.prior_gradient.col(p), 0));
    EXPECT_TRUE(matrix_near(alone.likelihood_gradient, together.likelihood_gradient.col(p), 0));
  }
}

TEST(HandPosterior, PointwiseAddsUpToTheLikelihood) {
  const FitProblem problem = two_specimens(2.5);
  const HandPosterior posterior(problem);
  const VectorXd x = some_point(posterior);
  const MatrixXd summands = posterior.pointwise(x);
  EXPECT_EQ(summands.rows(), (force_rows(problem, 0) + force_rows(problem, 1)) / 3);
  const double whole = at(posterior, x).second;
  EXPECT_NEAR(summands.sum(), whole, 1e-12 * std::abs(whole));
}

// -- Noise and specimen_scale
// -------------------------------------------------------------------------

// sum log N(r; 0, (s sd)^2), by hand.
TEST(HandPosterior, NoiseIsAFactorWithItsConstant) {
  const FitProblem problem = middle_finger(kAxes).problem();
  PosteriorOptions options = plain();
  options.learn_noise = true;
  options.noise_sd = 0.4;
  const HandPosterior posterior(problem, options);
  EXPECT_EQ(posterior.names().back(), "noise/synek2019_H01");
  VectorXd x = some_point(posterior);
  x[posterior.size() - 1] = 1.5;
  const double s = std::exp(0.4 * 1.5);
  EXPECT_NEAR(posterior.values(x).noise(0, 0), s, 1e-14);
  double expected = 0;
  const Eigen::Matrix3Xd predicted = posterior.forces(x, 0).reshaped(3, 24);
  for (Eigen::Index i = 0; i < 72; ++i) {
    const double sd = s * problem.plans()[0].sd.data()[i];
    const double r = predicted.data()[i] - problem.plans()[0].force.data()[i];
    expected -= 0.5 * r * r / (sd * sd) + std::log(sd) + 0.5 * std::log(2 * kPi);
  }
  EXPECT_NEAR(at(posterior, x).second, expected, 1e-10 * std::abs(expected));
}

TEST(HandPosterior, SpreadScalesDeviationsOfItsKind) {
  const HandPosterior posterior(two_specimens());
  EXPECT_EQ(posterior.specimen_scale_kinds(),
            (std::vector<std::string>{"axis/direction", "axis/point", "path", "sensor", "gain"}));
  const std::vector<std::string> names = posterior.names();
  const auto entry = [&](const std::string& name) {
    return std::find(names.begin(), names.end(), name) - names.begin();
  };
  VectorXd x = VectorXd::Zero(posterior.size());
  x[entry("H01: axis/PIP3/direction/1")] = 1;
  x[entry("spread/axis/direction")] = 2;  // exp(2 x 0.5) = e
  const PosteriorValues values = posterior.values(x);
  const std::vector<int> moving = posterior.moving_parameters();
  const auto& all = posterior.problem().parameters().all;
  Eigen::Index row = 0;
  while (all[moving[row]].name != "axis/PIP3/direction/1") ++row;
  EXPECT_NEAR(values.specimen_scale(0, 0), std::exp(1.0), 1e-14);
  EXPECT_NEAR(values.specimens[0](row, 0), std::exp(1.0) * 4 * kDegree, 1e-12);
  EXPECT_EQ(values.specimens[1](row, 0), 0);
  EXPECT_EQ(values.population(row, 0), 0);
}

// Where a population has bounds, so has every specimen of it, whatever the specimen_scale; and what
// moves the population moves them with it, as the gradient knows.
TEST(HandPosterior, BoundsHoldForSpecimensOfAPopulation) {
  FitSetup setup = middle_finger(R"(
[[parameter]]
match = "friction/FDP"
state = "free"
mean = 0.1
sd = 0.05
between_sd = 0.08
lower = 0
upper = 0.5
)");
  setup.experiments.push_back(sample::experiment("H02"));
  const HandPosterior posterior(setup.problem());
  for (const double far : {-30.0, -6.0, -1.0, 1.0, 6.0, 30.0})
    for (const double specimen_scale : {-2.0, 0.0, 2.0}) {
      VectorXd x = VectorXd::Constant(posterior.size(), far);
      x.tail(1).setConstant(specimen_scale);
      const PosteriorValues values = posterior.values(x);
      for (const MatrixXd& specimen : values.specimens) {
        EXPECT_GE(specimen(0, 0), -1e-15);
        EXPECT_LE(specimen(0, 0), 0.5 + 1e-15);
      }
    }
  for (const unsigned seed : {1U, 2U, 3U})
    EXPECT_LT(difference_error(posterior, some_point(posterior, seed, 1.5)), 1e-7);
  // The kernel sees what people read.
  const VectorXd x = some_point(posterior, 4, 1.5);
  EXPECT_TRUE(matrix_near(posterior.forces(x, 1).reshaped(3, 24),
                          predict_trials(posterior.problem(), posterior.fit_coordinates(x), 1),
                          1e-9));
}

// A specimen-only parameter stays within its bounds whatever the specimen_scale.
TEST(HandPosterior, BoundsHoldForAnySpread) {
  const HandPosterior posterior(two_specimens());
  const std::vector<int> moving = posterior.moving_parameters();
  const auto& all = posterior.problem().parameters().all;
  for (const double far : {-30.0, -6.0, 6.0, 30.0}) {
    const PosteriorValues values = posterior.values(VectorXd::Constant(posterior.size(), far));
    for (std::size_t i = 0; i < moving.size(); ++i) {
      if (all[moving[i]].name != "gain/LU") continue;
      EXPECT_GE(values.specimens[0](static_cast<Eigen::Index>(i), 0), 0.75);
      EXPECT_LE(values.specimens[0](static_cast<Eigen::Index>(i), 0), 1.25);
    }
  }
}

}  // namespace
}  // namespace thenar
