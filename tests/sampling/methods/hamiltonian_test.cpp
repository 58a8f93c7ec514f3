// Tests for sampling/methods/hamiltonian.cpp. THENAR_SAMPLES sets how many draws each chain makes
// of the known posteriors (50000 take half a minute).

#include <cmath>

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/numbers.h"
#include "base/random_stream.h"
#include "sampling/diagnostics/convergence.h"
#include "tests/matrix_near.h"
#include "tests/sampling/hamiltonian_runs.h"
#include "tests/sampling/known_posteriors.h"

namespace thenar {
namespace {

SamplerOptions options_of(long warm_up, Metric metric = Metric::kDense) {
  SamplerOptions options;
  options.warm_up = warm_up;
  options.metric = metric;
  return options;
}

/// Four starts, spread over `spread` of every coordinate.
Eigen::MatrixXd starts_of(Eigen::Index n, double spread) {
  Eigen::MatrixXd starts(n, 4);
  for (Eigen::Index c = 0; c < 4; ++c) {
    RandomStream random(77, static_cast<std::uint32_t>(c), 0);
    for (Eigen::Index i = 0; i < n; ++i) starts(i, c) = spread * random.normal();
  }
  return starts;
}

/// Whether one coordinate has converged to what is known of it, within 4 standard errors.
/// @param draws  (draws, chains)
/// @param error  of the known values themselves
void expect_gaussian_moments(const Eigen::MatrixXd& draws, double mean, double sd, double error = 0,
                             double r_hat = 1.01) {
  EXPECT_LT(rank_r_hat(draws), r_hat);
  const double got = draws.mean();
  const double got_sd = std::sqrt((draws.array() - got).square().mean());
  if (!std::isnan(mean)) {
    EXPECT_NEAR(got, mean, 4 * std::hypot(mean_mcse(draws), error));
  }
  if (!std::isnan(sd)) {
    EXPECT_NEAR(got_sd, sd, 4 * std::hypot(sd_mcse(draws), error));
  }
}

void expect_known(const sample::KnownPosterior& known, SamplingMethod method, long draws,
                  double spread = 1, double target_acceptance = 0) {
  SamplerOptions options = options_of(1000);
  options.target_acceptance = target_acceptance;
  const auto run = sample::run_hamiltonian(known.target, method, options,
                                           starts_of(known.mean.size(), spread), draws);
  for (Eigen::Index i = 0; i < known.mean.size(); ++i) {
    SCOPED_TRACE(known.name + " " + std::to_string(i));
    expect_gaussian_moments(run.coordinate(static_cast<int>(i)), known.mean[i], known.sd[i],
                            known.mcse[i]);
  }
  EXPECT_EQ(run.sum(&StepStats::non_finite), 0);
}

TEST(Hamiltonian, FindsAGaussianOfCondition1e8) {
  for (const SamplingMethod method : {SamplingMethod::kNuts, SamplingMethod::kHmc})
    expect_known(sample::gaussian(20, 1e8), method, sample::draws_of(2000), 100);
}

// At x the bend wants steps below 2 / sqrt(40 x^2), 0.03 at three sds: only a high acceptance leads
// to them.
TEST(Hamiltonian, FindsTheBanana) {
  expect_known(sample::banana(), SamplingMethod::kNuts, sample::draws_of(4000), 1, 0.998);
}

TEST(Hamiltonian, SaysThatItsStepsAreTooLongForTheEndsOfTheBanana) {
  const auto run = sample::run_hamiltonian(sample::banana().target, SamplingMethod::kNuts,
                                           options_of(1000), starts_of(2, 1), 4000);
  EXPECT_GT(run.sum(&StepStats::divergent), 10);
}

TEST(Hamiltonian, FindsTheFunnelThatIsNotCentred) {
  expect_known(sample::funnel(10, false), SamplingMethod::kNuts, sample::draws_of(2000));
}

TEST(Hamiltonian, FindsTheEightSchools) {
  const auto known = sample::eight_schools();
  SamplerOptions options = options_of(1000);
  options.target_acceptance = 0.95;
  const auto run = sample::run_hamiltonian(known.target, SamplingMethod::kNuts, options,
                                           starts_of(10, 1), sample::draws_of(4000));
  // Means of posteriordb's reference draws; their Monte Carlo errors are 0.03 to 0.06.
  const double theta[] = {6.1505, 4.9396, 3.9059, 4.7960, 3.6144, 4.0511, 6.3172, 4.8840};
  const Eigen::MatrixXd mu = run.coordinate(0);
  const Eigen::MatrixXd tau = run.coordinate(1).array().exp();
  expect_gaussian_moments(mu, 4.4105, 3.3093, 0.06);
  expect_gaussian_moments(tau, 3.6021, 3.1985, 0.06);
  for (int school = 0; school < 8; ++school) {
    SCOPED_TRACE(school);
    expect_gaussian_moments(mu + tau.cwiseProduct(run.coordinate(school + 2)), theta[school], kNaN,
                            0.06);
  }
}

// The neck of the centred funnel is too narrow for any step that suits its mouth.
TEST(Hamiltonian, SaysThatItCannotEnterTheNeckOfAFunnel) {
  const auto run = sample::run_hamiltonian(sample::funnel(10, true).target, SamplingMethod::kNuts,
                                           options_of(500), starts_of(10, 1), 500);
  EXPECT_GT(run.sum(&StepStats::divergent), 0);
}

TEST(Hamiltonian, TakesADiagonalMetric) {
  const sample::FunctionTarget target(3, [](const Eigen::VectorXd& x, Eigen::VectorXd& by) {
    by = -x.cwiseQuotient(Eigen::Vector3d(1e-6, 1, 1e6));
    return 0.5 * x.dot(by);
  });
  const auto run = sample::run_hamiltonian(
      target, SamplingMethod::kNuts, options_of(500, Metric::kDiagonal), starts_of(3, 1e-3), 1000);
  for (int i = 0; i < 3; ++i)
    expect_gaussian_moments(run.coordinate(i), 0, std::pow(10, 3 * (i - 1)));
  // Whitened, three dimensions of a normal need a few leapfrogs a draw.
  EXPECT_LT(run.sum(&StepStats::evaluations), 10 * 4000);
}

TEST(Hamiltonian, NeedsNoWarmUpWithAGoodCovariance) {
  const auto known = sample::gaussian(5, 1e6);
  SamplerOptions options = options_of(0);
  const Eigen::VectorXd u = Eigen::VectorXd::LinSpaced(5, 1, 2).normalized();
  const Eigen::MatrixXd Q = Eigen::MatrixXd::Identity(5, 5) - 2 * u * u.transpose();
  const Eigen::VectorXd variance = Eigen::VectorXd::LinSpaced(5, 0, 6).unaryExpr(
      [](double power) { return std::pow(10, power); });
  options.covariance = Q * variance.asDiagonal() * Q;
  const Eigen::MatrixXd starts = Q * variance.cwiseSqrt().asDiagonal() * starts_of(5, 1);
  for (const SamplingMethod method : {SamplingMethod::kNuts, SamplingMethod::kHmc}) {
    const auto run = sample::run_hamiltonian(known.target, method, options, starts, 2000);
    for (int i = 0; i < 5; ++i) expect_gaussian_moments(run.coordinate(i), 0, known.sd[i]);
  }
}

// Not efficient, so R-hat may be larger, but right.
TEST(Hamiltonian, IsValidAfterAnyShortWarmUp) {
  const auto known = sample::gaussian(3, 10);
  for (const long warm_up : {0, 1, 5, 19, 20, 30, 100})
    for (const SamplingMethod method : {SamplingMethod::kNuts, SamplingMethod::kHmc}) {
      SCOPED_TRACE(std::to_string(warm_up) + " " + name_of(method));
      const auto run =
          sample::run_hamiltonian(known.target, method, options_of(warm_up), starts_of(3, 2), 2000);
      for (int i = 0; i < 3; ++i)
        expect_gaussian_moments(run.coordinate(i), 0, known.sd[i], 0, 1.05);
    }
}

// While a step size is learnt, the mean acceptance is gamma ln(10) / sqrt(N) off at most, 0.004
// after N = 1000, and as much again by chance. In straight coordinates: along orbits of a normal
// target all is accepted.
TEST(Hamiltonian, AcceptsAsOftenAsAskedInWarmUp) {
  const auto known = sample::gaussian(10, 100);
  for (const SamplingMethod method : {SamplingMethod::kNuts, SamplingMethod::kHmc})
    for (const double target : {0.6, 0.8, 0.95}) {
      SamplerOptions options = options_of(2000, Metric::kDiagonal);
      options.target_acceptance = target;
      const auto chain = build_sampler(method, starts_of(10, 1).col(0), options);
      double sum = 0;
      // The last window, in which the metric is constant, is from 795 to 1950.
      advance({chain.get()}, known.target, 1950, [&](std::size_t) {
        if (chain->steps() > 950) sum += chain->stats()[0].acceptance;
      });
      EXPECT_NEAR(sum / 1000, target, 0.01) << name_of(method);
    }
}

TEST(Hamiltonian, KeepsItsStepAfterWarmUp) {
  const auto known = sample::gaussian(10, 100);
  for (const SamplingMethod method : {SamplingMethod::kNuts, SamplingMethod::kHmc}) {
    const auto run = sample::run_hamiltonian(
        known.target, method, options_of(300, Metric::kDiagonal), starts_of(10, 1), 300);
    for (const auto& chain : run.stats)
      for (const StepStats& step : chain) EXPECT_EQ(step.step_size, chain[0].step_size);
    EXPECT_NE(run.stats[0][0].step_size, run.stats[1][0].step_size);
  }
}

// Energies of a normal target of n dimensions are n on average (half kinetic), variance n.
TEST(Hamiltonian, StatesTheEnergyOfItsDraws) {
  const auto run = sample::run_hamiltonian(sample::gaussian(10, 1).target, SamplingMethod::kNuts,
                                           options_of(500), starts_of(10, 1), 2000);
  Eigen::MatrixXd energy(2000, 4);
  for (int c = 0; c < 4; ++c)
    for (int i = 0; i < 2000; ++i)
      energy(i, c) = run.stats[static_cast<std::size_t>(c)][static_cast<std::size_t>(i)].energy;
  expect_gaussian_moments(energy, 10, std::sqrt(10));
}

TEST(Hamiltonian, ObeysTheLimitOfDepth) {
  SamplerOptions options = options_of(0);
  options.max_depth = 3;
  const auto run = sample::run_hamiltonian(sample::gaussian(5, 1e8).target, SamplingMethod::kNuts,
                                           options, starts_of(5, 1), 50);
  for (const StepStats& step : run.stats[0]) EXPECT_LE(step.depth, 3);
  // The search for a step comes on top, in the first.
  for (std::size_t i = 1; i < 50; ++i) EXPECT_LE(run.stats[0][i].evaluations, 7);
}

/// A standard normal with something else where x_0 < -1.
sample::FunctionTarget cut_normal(double value, double slope) {
  return sample::FunctionTarget(2, [value, slope](const Eigen::VectorXd& x, Eigen::VectorXd& by) {
    by = -x;
    if (x[0] >= -1) return -0.5 * x.squaredNorm();
    by.setConstant(slope);
    return value;
  });
}

// N(0, 1) above -1: mean phi(1) / Phi(1), variance 1 - m - m^2.
TEST(Hamiltonian, DrawsTheRestWhereARegionIsMissing) {
  const double m = 0.24197072451914337 / 0.8413447460685429;
  struct Region {
    double value, slope;
    bool non_finite;
  };
  for (const Region& region : {Region{kNaN, kNaN, true}, Region{kInfinity, 0, true},
                               Region{-kInfinity, kNaN, false}, Region{-0.5, kNaN, true}}) {
    SCOPED_TRACE(region.value);
    for (const SamplingMethod method : {SamplingMethod::kNuts, SamplingMethod::kHmc}) {
      const auto run = sample::run_hamiltonian(cut_normal(region.value, region.slope), method,
                                               options_of(500), starts_of(2, 0.1), 4000);
      expect_gaussian_moments(run.coordinate(0), m, std::sqrt(1 - m - m * m));
      expect_gaussian_moments(run.coordinate(1), 0, 1);
      EXPECT_EQ(run.sum(&StepStats::non_finite) > 0, region.non_finite);
      EXPECT_GT(run.sum(&StepStats::divergent), 0);
    }
  }
}

// Prior N(0, 1)^3, likelihood of x_0 + x_1 alone, sd 1e-3. Given the sum, the difference has the
// prior's variance: var x_0 = (1 + 1e-6 / 2 ...) / 2; x_2 is flat.
TEST(Hamiltonian, BearsDuplicatedAndFlatDirections) {
  const sample::FunctionTarget target(
      3,
      [](const Eigen::VectorXd& x, Eigen::VectorXd& by) {
        const double sum = x[0] + x[1];
        by = -x;
        by.head(2).array() -= 1e6 * sum;
        return -0.5 * x.squaredNorm() - 0.5e6 * sum * sum;
      },
      1);
  const auto run = sample::run_hamiltonian(target, SamplingMethod::kNuts, options_of(500),
                                           starts_of(3, 1), 2000);
  // Covariance (I + 1e6 1 1')^-1 = I - 1e6 / (1 + 2e6) 1 1'.
  const double sd = std::sqrt(1 - 1e6 / (1 + 2e6));
  expect_gaussian_moments(run.coordinate(0), 0, sd);
  expect_gaussian_moments(run.coordinate(1), 0, sd);
  expect_gaussian_moments(run.coordinate(2), 0, 1);
  expect_gaussian_moments(run.coordinate(0) + run.coordinate(1), 0, std::sqrt(2 / (1 + 2e6)));
}

// Step by step through warm-up and beyond, also where the metric has just changed (31, 65).
TEST(Hamiltonian, ContinuesToTheBitFromWhatItSaved) {
  const auto known = sample::banana();
  for (const SamplingMethod method : {SamplingMethod::kNuts, SamplingMethod::kHmc})
    for (const Metric metric : {Metric::kDense, Metric::kDiagonal}) {
      const auto build = [&] {
        return build_sampler(method, Eigen::Vector2d(1, 1), options_of(100, metric));
      };
      const auto whole = build();
      auto parts = build();
      for (long step = 1; step <= 120; ++step) {
        advance({whole.get()}, known.target, step);
        advance({parts.get()}, known.target, step);
        StateWriter saved;
        parts->save(saved);
        parts = build();
        StateReader reader(saved.bytes());
        parts->restore(reader);
        ASSERT_TRUE(reader.at_end());
        ASSERT_EQ(parts->positions(), whole->positions()) << step;
        ASSERT_EQ(parts->asks(), whole->asks()) << step;
      }
    }
}

TEST(Hamiltonian, RestoresBeforeTheStartIsKnown) {
  StateWriter saved;
  build_sampler(SamplingMethod::kNuts, Eigen::Vector2d(3, 4), {})->save(saved);
  const auto other = build_sampler(SamplingMethod::kNuts, Eigen::Vector2d(0, 0), {});
  StateReader reader(saved.bytes());
  other->restore(reader);
  EXPECT_TRUE(matrix_near(other->asks(), Eigen::Vector2d(3, 4), 0));
  const auto wider = build_sampler(SamplingMethod::kNuts, Eigen::Vector3d(0, 0, 0), {});
  StateReader again(saved.bytes());
  EXPECT_THROW(wider->restore(again), InputError);
}

TEST(Hamiltonian, StaysAtAStartWithoutDensityUntilItIsMoved) {
  const auto target = cut_normal(kNaN, kNaN);
  const auto chain = build_sampler(SamplingMethod::kNuts, Eigen::Vector2d(-2, 0), options_of(20));
  advance({chain.get()}, target, 3);
  EXPECT_EQ(chain->positions(), Eigen::Vector2d(-2, 0));
  EXPECT_TRUE(chain->stats()[0].divergent);
  EXPECT_EQ(chain->stats()[0].non_finite, 1);
  const Eigen::Vector2d there(0.5, 0.5);
  chain->move(0, there, target.evaluate(there, WithGradient::kYes));
  EXPECT_EQ(chain->positions(), there);
  advance({chain.get()}, target, 60);
  EXPECT_NE(chain->positions(), there);
  EXPECT_GE(chain->positions()(0), -1);
}

// Where a swap frees it after warm-up: it goes on with the step that it had.
TEST(Hamiltonian, LearnsNothingWhenItIsMovedAfterWarmUp) {
  const auto target = cut_normal(kNaN, kNaN);
  for (const long warm_up : {0, 5, 40}) {
    const auto chain =
        build_sampler(SamplingMethod::kNuts, Eigen::Vector2d(-2, 0), options_of(warm_up));
    advance({chain.get()}, target, 50);
    const double step_size = chain->stats()[0].step_size;
    const Eigen::Vector2d there(0.5, 0.5);
    chain->move(0, there, target.evaluate(there, WithGradient::kYes));
    for (long step = 51; step <= 80; ++step) {
      advance({chain.get()}, target, step);
      EXPECT_EQ(chain->stats()[0].step_size, step_size) << warm_up;
      // Leapfrogs of the tree alone, none of a search.
      EXPECT_LT(chain->stats()[0].evaluations, 1 << (chain->stats()[0].depth + 1));
    }
    EXPECT_NE(chain->positions(), there);
  }
}

// Likelihood N(0, 1 / 3) to the power of 1 / 4 times prior N(0, 1): precision 1 + 3 / 4.
TEST(Hamiltonian, TempersTheLikelihoodAlone) {
  const sample::FunctionTarget target(
      1,
      [](const Eigen::VectorXd& x, Eigen::VectorXd& by) {
        by = -4 * x;
        return -2 * x[0] * x[0];
      },
      1);
  for (const double beta : {0.0, 0.25, 1.0}) {
    SamplerOptions options = options_of(200);
    options.beta = beta;
    const auto run =
        sample::run_hamiltonian(target, SamplingMethod::kNuts, options, starts_of(1, 1), 2000);
    expect_gaussian_moments(run.coordinate(0), 0, 1 / std::sqrt(1 + 3 * beta));
  }
}

TEST(Hamiltonian, RefusesWhatItCannotRun) {
  const Eigen::MatrixXd starts = Eigen::MatrixXd::Zero(2, 2);
  EXPECT_THROW((void)build_sampler(SamplingMethod::kNuts, starts, {}), InputError);
  SamplerOptions options;
  options.covariance = -Eigen::Matrix2d::Identity();
  EXPECT_THROW((void)build_sampler(SamplingMethod::kNuts, starts.col(0), options), InputError);
  options = {};
  options.max_depth = 31;
  EXPECT_THROW((void)build_sampler(SamplingMethod::kHmc, starts.col(0), options), InputError);
}

}  // namespace
}  // namespace thenar
