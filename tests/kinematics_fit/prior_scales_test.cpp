#include "kinematics_fit/prior_scales.h"

#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "kinematics_fit/undetermined_tilts.h"
#include "tests/kinematics_fit/fit_samples.h"

namespace thenar {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

TEST(LogEvidence, IsTheMarginalNormalDensity) {
  // b = s j z + noise with j = (3, 4): V = n^2 I + s^2 j j', det V = n^2 (n^2 + 25 s^2) and
  // b' V^-1 b = (b'b - s^2 (j'b)^2 / (n^2 + 25 s^2)) / n^2, by Sherman and Morrison.
  const VectorXd j = Eigen::Vector2d(3, 4), b = Eigen::Vector2d(1, -2);
  const LinearForces forces{b, MatrixXd::Zero(2, 2), {j * j.transpose()}};
  for (const double s : {0.0, 0.1, 1.0})
    for (const double n : {1.0, 3.0}) {
      const double along = n * n + 25 * s * s;
      const double quadratic = (5 - s * s * 25 / along) / (n * n);
      EXPECT_NEAR(log_evidence(forces, {s}, n), -0.5 * quadratic - 0.5 * std::log(n * n * along),
                  1e-12);
    }
}

/// Default settings of the finger on a measured specimen of [Synek2019].
FitProblem measured(const std::string& specimen) {
  return build_problem(sample::finger_inputs("an_chao_middle", {specimen}));
}

/// The same with forces that the subject makes with its axes tilted by 5 degrees, and 0.03 N of
/// noise.
FitProblem geometric(unsigned seed, double stated_noise = 0.03) {
  const FitProblem problem = measured("H01");
  const FitParameters& parameters = problem.parameters();
  sample::FitSetup setup{problem.digit(), parameters, problem.experiments()};
  std::mt19937 rng(seed);
  VectorXd u = VectorXd::Zero(parameters.coordinates());
  for (int c = 0; c < parameters.coordinates(); ++c)
    if (parameters.all[static_cast<std::size_t>(parameters.leader[c])].kind ==
        ParameterKind::kAxisDirection)
      u[c] = 5 * kDegree * sample::normal(1, rng)[0];
  Experiment& experiment = setup.experiments.front();
  experiment.sd_floor = stated_noise;
  sample::simulate(setup, u, 0.03, rng, experiment);
  return setup.problem();
}

TEST(PriorScales, StayAsStatedForMeasuredFingers) {
  for (const char* specimen : {"H01", "H02"}) {
    const FitProblem problem = measured(specimen);
    const ScaledFit fit = fit_with_scales(problem);
    EXPECT_LT(fit.gain, kScaleGain) << specimen;
    for (const ScaledPriors& scale : fit.problem.parameters().scales)
      EXPECT_EQ(scale.factor, 1) << scale.name;
    const Solution stated = solve(least_squares(problem), VectorXd::Zero(problem.size()));
    EXPECT_EQ(fit.solution.z, stated.z);
  }
}

TEST(PriorScales, ShrinkWhereGeometryExplainsTheForcesAndFreeTheAxes) {
  for (const unsigned seed : {1U, 2U}) {
    const ScaledFit fit = fit_with_scales(geometric(seed));
    EXPECT_GT(fit.gain, 2 * kScaleGain);
    EXPECT_TRUE(fit.settled);
    EXPECT_EQ(fit.solution.status, Status::kSolved);
    for (const ScaledPriors& scale : fit.problem.parameters().scales) {
      if (scale.name == "tilts of axes")
        EXPECT_GT(scale.factor, 1.5);
      else
        EXPECT_LT(scale.factor, 0.35) << scale.name;
    }
  }
}

TEST(PriorScales, AreOneWithoutForcesToTellThem) {
  // A scale whose parameters no force feels has no evidence, and is not even asked.
  const ScaledFit fit = fit_with_scales(sample::planar_finger().problem());
  EXPECT_TRUE(fit.problem.parameters().scales.empty());
  EXPECT_EQ(fit.gain, 0);
}

TEST(NoiseEvidence, TellsNoiseThatWasStatedTooSmall) {
  for (const unsigned seed : {1U, 2U, 3U}) {
    for (const bool understated : {false, true}) {
      const ScaledFit fit = fit_with_scales(geometric(seed, understated ? 0.003 : 0.03));
      const NoiseEvidence noise = noise_evidence(fit.problem, fit.solution.z).front();
      EXPECT_EQ(noise.understated(), understated) << noise.factor << ' ' << noise.gain;
      EXPECT_NEAR(noise.factor, understated ? 10 : 1, understated ? 4 : 0.5);
    }
  }
}

TEST(NoiseEvidence, DoesNotAccuseMeasuredFingers) {
  for (const char* specimen : {"H01", "H02"}) {
    const ScaledFit fit = fit_with_scales(measured(specimen));
    EXPECT_FALSE(noise_evidence(fit.problem, fit.solution.z).front().understated()) << specimen;
  }
}

/// Doubts of a finger on one load in one posture, its axes and its load cell free.
UndeterminedTilts tilts_of_one_force() {
  sample::FitSetup setup = sample::middle_finger(R"(
[[parameter]]
match = "axis/DIP3/direction/*"
state = "free"
sd_deg = 0
between_sd_deg = 5
[[parameter]]
match = "sensor/*"
state = "free"
sd_deg = 0
between_sd_deg = 8
)");
  setup.experiments.front().trials.resize(1);
  const FitProblem problem = setup.problem();
  const VectorXd z = sample::fit_precisely(problem).z;
  return find_undetermined_tilts(problem, z, posterior_covariance(problem, z));
}

TEST(UndeterminedTilts, NamesTiltsThatNoForceFeels) {
  // Five tilts, three numbers of one force; the DIP axis tilts more than it can tell.
  const UndeterminedTilts tilts = tilts_of_one_force();
  EXPECT_EQ(tilts.tilt_count, 2);
  ASSERT_FALSE(tilts.undecided.empty());
  EXPECT_GT(tilts.undecided.front().sd, 0.9);
  const std::vector<std::string> told = describe(tilts);
  ASSERT_FALSE(told.empty());
  EXPECT_NE(told.front().find("axis/DIP3/direction/"), std::string::npos);
}

// Of one force of each joint's axis and the cell: those pairs are correlated whose correlation in
// the posterior, read from its covariance, is above 0.8.
TEST(UndeterminedTilts, TellThePairsThatTradePlaces) {
  for (const char* joint : {"MCP3_FE", "MCP3_AA", "PIP3", "DIP3"}) {
    sample::FitSetup setup = sample::middle_finger(
        "[[parameter]]\nmatch = 'axis/" + std::string(joint) +
        "/direction/*'\nstate = 'free'\nsd_deg = 0\nbetween_sd_deg = 5\n"
        "[[parameter]]\nmatch = 'sensor/*'\nstate = 'free'\nsd_deg = 0\nbetween_sd_deg = 8\n");
    Experiment& experiment = setup.experiments.front();
    experiment.trials.resize(1);
    experiment.sd_floor = 1e-4;
    const FitProblem problem = setup.problem();
    const VectorXd z = VectorXd::Zero(problem.size());
    const Covariance covariance = posterior_covariance(problem, z);
    const MatrixXd C = covariance.C.block_entries(0);
    double largest = 0;
    for (int a = 0; a < problem.size(); ++a)
      for (int b = 0; b < problem.size(); ++b) {
        const std::string axis = covariance.learnt[static_cast<std::size_t>(a)].name,
                          cell = covariance.learnt[static_cast<std::size_t>(b)].name;
        if (axis.rfind("axis/", 0) == 0 && cell.rfind("sensor/", 0) == 0)
          largest = std::max(largest, std::abs(C(a, b)) / std::sqrt(C(a, a) * C(b, b)));
      }
    const UndeterminedTilts tilts = find_undetermined_tilts(problem, z, covariance);
    ASSERT_EQ(tilts.correlated.empty(), largest <= 0.8) << joint << " " << largest;
    if (tilts.correlated.empty()) continue;
    EXPECT_NEAR(std::abs(tilts.correlated.front().correlation), largest, 1e-6) << joint;
    EXPECT_NE(describe(tilts).back().find("trade places"), std::string::npos);
  }
}

}  // namespace
}  // namespace thenar
