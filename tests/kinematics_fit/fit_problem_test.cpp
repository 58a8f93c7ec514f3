// Tests for kinematics_fit/fit_problem.cpp: which experiments are refused, and which draw a
// warning.

#include "kinematics_fit/fit_problem.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/units.h"
#include "tests/kinematics_fit/fit_samples.h"

namespace thenar {
namespace {

using sample::FitSetup;
using sample::kAxes;
using sample::middle_finger;

const std::string kAxesAndPaths = kAxes + R"(
[[parameter]]
match = "path/FD?/*/dorsal"
state = "free"
sd_mm = 0.7
between_sd_mm = 0.9
)";

Solution fit(const FitProblem& problem) {
  SolveOptions options;
  options.tolerance = 1e-14;
  return solve(least_squares(problem), VectorXd::Zero(problem.size()), options);
}

VectorXd between_sds(const FitParameters& parameters) {
  VectorXd sd(parameters.coordinates());
  for (int c = 0; c < parameters.coordinates(); ++c)
    sd[c] = parameters.all[parameters.leader[c]].between_sd;
  return sd;
}

VectorXd population_sds(const FitParameters& parameters) {
  VectorXd sd(parameters.coordinates());
  for (int c = 0; c < parameters.coordinates(); ++c)
    sd[c] = parameters.all[parameters.leader[c]].sd;
  return sd;
}

/// A person's displacements, drawn as the prior says.
VectorXd draw_person(const FitParameters& parameters, const VectorXd& population,
                     std::mt19937& rng) {
  const VectorXd sd = between_sds(parameters);
  return population + sd.cwiseProduct(sample::normal(sd.size(), rng));
}

// -- Gauge ------------------------------------------------------------------------------------

TEST(PosteriorCovariance, NamesWhatNoForceCanTell) {
  const FitProblem problem =
      middle_finger("[[parameter]]\nmatch='axis/MCP3_FE/*'\nstate='free'\n").problem();
  const Covariance covariance = posterior_covariance(problem, VectorXd::Zero(problem.size()));
  ASSERT_EQ(covariance.null_directions.size(), 1U);
  EXPECT_EQ(covariance.null_directions[0].text, "axis/MCP3_FE/point/along: not identifiable");
  for (const CoordinateEstimate& learnt : covariance.learnt) {
    const bool along = learnt.name == "axis/MCP3_FE/point/along";
    EXPECT_NEAR(learnt.null_share, along ? 1 : 0, 1e-9) << learnt.name;
    EXPECT_EQ(learnt.sd > 1 - 1e-9, along) << learnt.name;
  }
}

TEST(PosteriorCovariance, IsTheInverseOfTheCurvature) {
  const FitProblem problem = middle_finger(kAxesAndPaths).problem();
  const VectorXd z = VectorXd::Constant(problem.size(), 0.1);
  const Covariance covariance = posterior_covariance(problem, z);
  const Eigen::MatrixXd J = problem.evaluate(z, WithJacobian::kYes).J;
  EXPECT_TRUE(matrix_near(covariance.C * (J.transpose() * J),
                          Eigen::MatrixXd::Identity(z.size(), z.size()), 1e-8));
  // Each parameter is learnt by 1 - C_ii; their sum is the trace of data curvature times C.
  EXPECT_NEAR(covariance.effective_parameters, static_cast<double>(z.size()) - covariance.C.trace(),
              1e-9);
}

// -- Synthetic recovery -----------------------------------------------------------------------

TEST(FitProblem, RecoversPredictionsAndIdentifiableParametersWithoutNoise) {
  FitSetup setup = middle_finger(kAxesAndPaths);
  Experiment& experiment = setup.experiments.front();
  experiment.sd_floor = 1e-6;  // [N]: the data outweigh the prior a million times
  experiment.sd_relative = 0;
  std::mt19937 rng(5);
  const VectorXd truth =
      draw_person(setup.parameters, VectorXd::Zero(setup.parameters.coordinates()), rng);
  sample::simulate(setup, truth, 0, rng, experiment);
  const FitProblem problem = setup.problem();
  const Solution found = fit(problem);
  ASSERT_EQ(found.status, Status::kSolved) << found.message;

  const Eigen::Matrix3Xd force = problem.predict(found.z, 0, WithJacobian::kNo).force;
  EXPECT_LT((force - problem.plans()[0].force).cwiseAbs().maxCoeff(), 1e-8);  // [N]

  const VectorXd total =
      (population_sds(setup.parameters).cwiseAbs2() + between_sds(setup.parameters).cwiseAbs2())
          .cwiseSqrt();
  const VectorXd z_true = truth.cwiseQuotient(total);
  int identifiable = 0;
  const Covariance covariance = posterior_covariance(problem, found.z);
  for (Eigen::Index i = 0; i < z_true.size(); ++i) {
    if (covariance.learnt[i].sd > 1e-3) continue;
    EXPECT_NEAR(found.z[i], z_true[i], 1e-4) << covariance.learnt[i].name;
    ++identifiable;
  }
  EXPECT_GE(identifiable, 8);  // at least the axes
}

// (z - truth)' C^-1 (z - truth) is chi squared: truth drawn from the prior, noise as stated.
TEST(FitProblem, EstimatesScatterAsTheirCovarianceSays) {
  FitSetup setup = middle_finger(kAxes);
  setup.experiments.front().sd_floor = 0.02;  // [N]; small, so that the model is nearly linear
  std::mt19937 rng(11);
  constexpr int kDraws = 40;
  double chi_squared = 0, count = 0;
  for (int draw = 0; draw < kDraws; ++draw) {
    const VectorXd sd =
        (population_sds(setup.parameters).cwiseAbs2() + between_sds(setup.parameters).cwiseAbs2())
            .cwiseSqrt();
    const VectorXd z_true = sample::normal(sd.size(), rng);
    sample::simulate(setup, sd.cwiseProduct(z_true), 0.02, rng, setup.experiments.front());
    const FitProblem problem = setup.problem();
    const Solution found = fit(problem);
    const VectorXd error = found.z - z_true;
    chi_squared += error.dot(posterior_covariance(problem, found.z).C.llt().solve(error));
    count += static_cast<double>(error.size());
  }
  // Four standard deviations of a chi squared of `count` degrees of freedom.
  EXPECT_NEAR(chi_squared / count, 1, 4 * std::sqrt(2 / count));
}

// -- Population -------------------------------------------------------------------------------

// One specimen, written with population and deviation apart, has the same most probable
// population: p = sd^2 / (sd^2 + between^2) u.
TEST(FitProblem, OneSpecimenIsTheTwoLevelProblemSummedUp) {
  const FitSetup setup = middle_finger(kAxes);
  const FitProblem alone = setup.problem();
  const VectorXd sd = population_sds(setup.parameters), between = between_sds(setup.parameters);
  const VectorXd total = (sd.cwiseAbs2() + between.cwiseAbs2()).cwiseSqrt();
  const Eigen::Index n = sd.size();

  LeastSquares apart;
  apart.lower = VectorXd::Constant(2 * n, -100);
  apart.upper = VectorXd::Constant(2 * n, 100);
  apart.residuals = [&](const VectorXd& z, WithJacobian) {
    const VectorXd u = sd.cwiseProduct(z.head(n)) + between.cwiseProduct(z.tail(n));
    const Residuals data = alone.evaluate(u.cwiseQuotient(total), WithJacobian::kYes);
    const int rows = alone.data_rows();
    Residuals out{VectorXd(rows + 2 * n), Eigen::MatrixXd(rows + 2 * n, 2 * n)};
    out.r << data.r.head(rows), z;
    const Eigen::MatrixXd by_u = data.J.topRows(rows) * total.cwiseInverse().asDiagonal();
    out.J.topLeftCorner(rows, n) = by_u * sd.asDiagonal();
    out.J.topRightCorner(rows, n) = by_u * between.asDiagonal();
    out.J.bottomRows(2 * n).setIdentity();
    return out;
  };
  SolveOptions options;
  options.tolerance = 1e-15;
  const Solution two_level = solve(apart, VectorXd::Zero(2 * n), options);
  const Solution one = fit(alone);
  EXPECT_NEAR(two_level.cost, one.cost, 1e-9 * one.cost);
  EXPECT_TRUE(matrix_near(alone.displacements(one.z, -1), sd.cwiseProduct(two_level.z.head(n)),
                          1e-5));  // [rad]
  const VectorXd person =
      sd.cwiseProduct(two_level.z.head(n)) + between.cwiseProduct(two_level.z.tail(n));
  EXPECT_TRUE(matrix_near(alone.displacements(one.z, 0), person, 1e-5));
}

// Where data say nothing (C = 1), an unseen person varies by sd^2 + between^2 again.
TEST(FitProblem, UnseenVarianceAddsUpToThePrior) {
  const FitSetup setup = middle_finger(kAxes);
  const FitProblem problem = setup.problem();
  const Eigen::MatrixXd J = problem.displacement_jacobian(VectorXd::Zero(problem.size()), -1);
  const VectorXd variance = (J * J.transpose()).diagonal() + problem.unseen_variance();
  EXPECT_TRUE(matrix_near(
      variance,
      population_sds(setup.parameters).cwiseAbs2() + between_sds(setup.parameters).cwiseAbs2(),
      1e-15));
}

TEST(FitProblem, TwoSpecimensHaveAPopulationAndTwoDeviations) {
  FitSetup setup = middle_finger(kAxes);
  setup.experiments.push_back(sample::experiment("H02"));
  const FitProblem problem = setup.problem();
  EXPECT_EQ(problem.size(), 3 * setup.parameters.coordinates());
  EXPECT_EQ(problem.names()[0], "axis/MCP3_FE/direction/1");
  EXPECT_EQ(problem.names()[8], "H01: axis/MCP3_FE/direction/1");
  EXPECT_EQ(problem.names()[16], "H02: axis/MCP3_FE/direction/1");
  VectorXd z = VectorXd::Zero(problem.size());
  z[0] = 1;
  z[16] = 2;
  EXPECT_NEAR(problem.displacements(z, -1)[0], 3 * kDegree, 1e-12);
  EXPECT_NEAR(problem.displacements(z, 0)[0], 3 * kDegree, 1e-12);
  EXPECT_NEAR(problem.displacements(z, 1)[0], (3 + 2 * 4) * kDegree, 1e-12);
}

TEST(FitProblem, BoundsHoldWhereOnlySpecimensDiffer) {
  FitSetup setup = middle_finger(
      "[[parameter]]\nmatch='gain/LU'\nstate='free'\nsd=0\nbetween_sd=0.1\nrange=0.2\n");
  setup.experiments.push_back(sample::experiment("H02"));
  const FitProblem problem = setup.problem();
  ASSERT_EQ(problem.size(), 2);
  EXPECT_TRUE(matrix_near(problem.lower(), Eigen::Vector2d(-2, -2), 1e-12));
  EXPECT_TRUE(matrix_near(problem.upper(), Eigen::Vector2d(2, 2), 1e-12));
}

const std::string kFriction = R"(
[[parameter]]
match = "friction/FDP"
state = "free"
mean = 0.1
sd = 0.05
between_sd = 0.08
lower = 0
upper = 0.5
)";

// The sum of population and deviation is bounded, which no box about either could do.
TEST(FitProblem, BoundsHoldForSpecimensOfAPopulation) {
  FitSetup setup = middle_finger(kFriction);
  setup.experiments.push_back(sample::experiment("H02"));
  const FitProblem problem = setup.problem();
  ASSERT_EQ(problem.size(), 3);
  for (const double population : {problem.lower()[0], -1.0, 0.0, 2.0, problem.upper()[0]})
    for (const double own : {-20.0, -3.0, 0.0, 3.0, 20.0}) {
      const double friction =
          0.1 + problem.displacements(Eigen::Vector3d(population, own, 0), 0)[0];
      EXPECT_GE(friction, -1e-15) << population << " " << own;
      EXPECT_LE(friction, 0.5 + 1e-15) << population << " " << own;
    }
}

// A standard normal entry is the normal deviation cut off at the bounds: with the population at
// 0.1 and bounds 1.25 sds below and 5 above, the median of the deviation is that of the rest.
TEST(FitProblem, DeviationsKeepTheirPriorWithinBounds) {
  FitSetup setup = middle_finger(kFriction);
  setup.experiments.push_back(sample::experiment("H02"));
  const FitProblem problem = setup.problem();
  const auto below = [](double z) { return 0.5 * std::erfc(-z / std::sqrt(2.0)); };
  const double u = problem.displacements(Eigen::Vector3d::Zero(), 0)[0] / 0.08;
  EXPECT_NEAR((below(u) - below(-1.25)) / (below(5) - below(-1.25)), 0.5, 1e-14);
}

TEST(FitProblem, SlopesOfSpecimensNearBoundsAreThoseOfDifferences) {
  FitSetup setup = middle_finger(kFriction + kAxes);
  setup.experiments.push_back(sample::experiment("H02"));
  const FitProblem problem = setup.problem();
  std::mt19937 rng(8);
  VectorXd z = sample::normal(problem.size(), rng);
  const Residuals at = problem.evaluate(z, WithJacobian::kYes);
  constexpr double kStep = 1e-5;
  for (Eigen::Index i = 0; i < z.size(); ++i) {
    const VectorXd step = kStep * VectorXd::Unit(z.size(), i);
    const VectorXd slope = (problem.evaluate(z + step, WithJacobian::kNo).r -
                            problem.evaluate(z - step, WithJacobian::kNo).r) /
                           (2 * kStep);
    EXPECT_TRUE(matrix_near(at.J.col(i), slope, 1e-7 * std::max(1.0, slope.cwiseAbs().maxCoeff())));
  }
}

// What no force can tell does not hang on how exactly forces were measured.
TEST(PosteriorCovariance, FindsTheSameNullsWhateverTheNoise) {
  FitSetup setup = middle_finger(
      "[[parameter]]\nmatch='axis/*'\nstate='free'\n[[parameter]]\n"
      "match='path/*'\nstate='free'\n");
  std::vector<std::size_t> null_directions;
  for (const double sd : {0.15, 1e-4}) {
    setup.experiments.front().sd_floor = sd;
    setup.experiments.front().sd_relative = 0;
    const FitProblem problem = setup.problem();
    const VectorXd z = VectorXd::Zero(problem.size());
    null_directions.push_back(posterior_covariance(problem, z).null_directions.size());
    const Eigen::MatrixXd J =
        problem.evaluate(z, WithJacobian::kYes).J.topRows(problem.data_rows());
    const VectorXd sigma = J.bdcSvd().singularValues();
    EXPECT_EQ(null_directions.back(), z.size() - (sigma.array() > 3.2e-5).count());
  }
  EXPECT_GT(null_directions[0], 0U);
}

// Blocks of specimens are another order of the same sums.
TEST(FitProblem, BlocksHaveTheDenseAnswer) {
  FitSetup setup = middle_finger(kAxesAndPaths + kFriction);
  setup.experiments.push_back(sample::experiment("H02"));
  setup.experiments.push_back(sample::experiment("B01"));
  const FitProblem problem = setup.problem();
  LeastSquares blocks = least_squares(problem), dense = blocks;
  ASSERT_FALSE(blocks.parts.empty());
  dense.parts.clear();
  SolveOptions options;
  options.tolerance = 1e-15;
  const VectorXd start = VectorXd::Zero(problem.size());
  const Solution a = solve(blocks, start, options), b = solve(dense, start, options);
  EXPECT_EQ(a.status, Status::kSolved) << a.message;
  EXPECT_NEAR(a.cost, b.cost, 1e-10 * b.cost);
  EXPECT_TRUE(matrix_near(a.z, b.z, 1e-4));
  EXPECT_LT(a.newton_step, 0.01);
  const CostSlopes one = cost_slopes(blocks, a.z), other = cost_slopes(dense, a.z);
  EXPECT_NEAR(one.cost, other.cost, 1e-11 * other.cost);
  EXPECT_TRUE(matrix_near(one.gradient, other.gradient, 1e-8));
  const Eigen::MatrixXd J = problem.evaluate(a.z, WithJacobian::kYes).J;
  const Covariance covariance = posterior_covariance(problem, a.z);
  EXPECT_TRUE(matrix_near(covariance.C * (J.transpose() * J),
                          Eigen::MatrixXd::Identity(J.cols(), J.cols()), 1e-7));
}

// Directions of single specimens and of all together, no two alike. Both kinds are orthonormal with
// |J v| below the limit, so along them all |J v| < sqrt(2) limit, and no more than so many singular
// values can be (Courant and Fischer). Those far below the limit must all be found.
TEST(PosteriorCovariance, NullsOfSpecimensSpanThoseOfTheDenseJacobian) {
  FitSetup setup = middle_finger(
      "[[parameter]]\nmatch='axis/*'\nstate='free'\n[[parameter]]\n"
      "match='path/*'\nstate='free'\n");
  setup.experiments.push_back(sample::experiment("H02"));
  setup.experiments.push_back(sample::experiment("B01"));
  const FitProblem problem = setup.problem();
  const VectorXd z = VectorXd::Zero(problem.size());
  const Eigen::MatrixXd J = problem.evaluate(z, WithJacobian::kYes).J.topRows(problem.data_rows());
  const Covariance covariance = posterior_covariance(problem, z);
  const auto count = static_cast<Eigen::Index>(covariance.null_directions.size());
  const VectorXd sigma = J.bdcSvd().singularValues();
  const double limit = std::sqrt(1e-9);
  EXPECT_LE(count, z.size() - (sigma.array() > std::sqrt(2) * limit).count());
  EXPECT_GE(count, z.size() - (sigma.array() > 0.5 * limit).count());
  Eigen::MatrixXd N(z.size(), count);
  for (Eigen::Index k = 0; k < count; ++k)
    N.col(k) = covariance.null_directions[static_cast<std::size_t>(k)].direction;
  EXPECT_TRUE(matrix_near(N.colwise().norm().transpose(), VectorXd::Ones(count), 1e-12));
  EXPECT_LT((J * N).colwise().norm().maxCoeff(), 1e-3);
  EXPECT_GT(N.bdcSvd().singularValues().minCoeff(), 1e-6);
  double shares = 0;
  for (const CoordinateEstimate& learnt : covariance.learnt) shares += learnt.null_share;
  EXPECT_NEAR(shares, static_cast<double>(count), 1e-9);  // the trace of a projection
}

// Unseen people drawn from the prior lie within the 95 % intervals 95 % of the time.
TEST(PredictExperiment, IntervalsCoverNewPeople) {
  FitSetup setup = middle_finger(kAxes);
  setup.experiments.push_back(sample::experiment("H02"));
  constexpr double kNoise = 0.05;  // [N]
  constexpr int kDraws = 60;
  for (Experiment& experiment : setup.experiments) experiment.sd_floor = kNoise;
  Experiment unseen = setup.experiments.front();
  std::mt19937 rng(17);
  double covered = 0;
  for (int draw = 0; draw < kDraws; ++draw) {
    const VectorXd sd = population_sds(setup.parameters);
    const VectorXd population = sd.cwiseProduct(sample::normal(sd.size(), rng));
    for (Experiment& experiment : setup.experiments)
      sample::simulate(setup, draw_person(setup.parameters, population, rng), kNoise, rng,
                       experiment);
    sample::simulate(setup, draw_person(setup.parameters, population, rng), kNoise, rng, unseen);
    const FitProblem problem = setup.problem();
    const Solution found = fit(problem);
    const Eigen::MatrixXd C = posterior_covariance(problem, found.z).C;
    covered += predict_experiment(problem, found.z, C, unseen, -1).error.covered.value() / kDraws;
  }
  // One person's 72 components hang on 8 numbers: 60 x 8 trials of p = 0.95, four deviations.
  EXPECT_NEAR(covered, 0.95, 4 * std::sqrt(0.95 * 0.05 / (kDraws * 8)));
}

// A name is no knowledge: an unseen posture is as uncertain whatever it is called.
TEST(PredictExperiment, IntervalsDoNotDependOnNamesOfPostures) {
  FitSetup setup = middle_finger(kAxes + R"(
[[parameter]]
match = "angle/*/*"
state = "free"
sd_deg = 0
between_sd_deg = 4
)");
  const FitProblem problem = setup.problem();
  const Solution found = fit(problem);
  const Eigen::MatrixXd C = posterior_covariance(problem, found.z).C;
  Experiment unseen = sample::experiment("H02");
  const Prediction named = predict_experiment(problem, found.z, C, unseen, -1);
  for (PostureRecord& posture : unseen.postures) posture.name += "'";
  for (Trial& trial : unseen.trials) trial.posture += "'";
  const Prediction renamed = predict_experiment(problem, found.z, C, unseen, -1);
  for (std::size_t i = 0; i < named.trials.size(); ++i) {
    EXPECT_TRUE(matrix_near(renamed.trials[i].predicted, named.trials[i].predicted, 1e-12));
    EXPECT_TRUE(matrix_near(renamed.trials[i].sd, named.trials[i].sd, 1e-12));
  }
}

// The published middle finger was calibrated on H01, H02 and B01, the normative one on nobody.
TEST(FitProblem, SaysWhichSpecimensItsSubjectHasSeen) {
  for (const char* specimen : {"H01", "H02", "B01"}) {
    const FitProblem seen = middle_finger(kAxes, specimen).problem();
    const std::string name = std::string("synek2019_") + specimen;
    EXPECT_EQ(seen.warnings(),
              std::vector<std::string>{"experiment '" + name + "': the subject has seen specimen " +
                                       specimen + ": it was calibrated on '" + name +
                                       "'. Errors of its forces, also left out, do not tell how "
                                       "well strangers are predicted"});
    const Eigen::VectorXd z = Eigen::VectorXd::Zero(seen.size());
    EXPECT_TRUE(predict_fitted(seen, z, 0).calibrated_on_specimen);

    const FitProblem unseen = middle_finger(kAxes, specimen, "an_chao_middle").problem();
    EXPECT_TRUE(unseen.warnings().empty());
    EXPECT_FALSE(predict_fitted(unseen, z, 0).calibrated_on_specimen);
  }
}

TEST(FitProblem, RefusesWhenNothingIsFree) {
  try {
    (void)middle_finger("").problem();
    FAIL() << "expected InputError";
  } catch (const InputError& e) {
    EXPECT_STREQ(e.what(), "nothing to fit: every parameter is fixed");
  }
}

}  // namespace
}  // namespace thenar
