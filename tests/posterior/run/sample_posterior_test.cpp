// Tests for posterior/run: from files to draws to a file and back.

#include "posterior/run/sample_posterior.h"

#include <cmath>
#include <filesystem>

#include <gtest/gtest.h>

#include "base/error.h"
#include "posterior/run/posterior_file.h"
#include "posterior/run/posterior_summary.h"
#include "posterior/run/predict_draws.h"
#include "sampling/run/communicator.h"
#include "tests/kinematics_fit/fit_samples.h"
#include "tests/sampling/thread_ranks.h"

namespace thenar {
namespace {

/// A few path points of the middle finger of H01 move, and its noise.
FitInputs small_inputs(const std::vector<std::string>& specimens = {"H01"}) {
  FitInputs inputs = sample::finger_inputs("synek2019_middle", specimens);
  inputs.settings = {"fit.toml",
                     "source = 'Synek2019'\n"
                     "[[parameter]]\nmatch = 'hood/*/central'\nstate = 'free'\nsd = 0.3\n"
                     "between_sd = 0.27\n"
                     "[[parameter]]\nmatch = 'sensor/*'\nstate = 'free'\nsd_deg = 0\n"
                     "between_sd_deg = 4\n"};
  return inputs;
}

PosteriorSettings quick(long draws = 250) {
  PosteriorSettings settings;
  settings.run.sampler.warm_up = 250;
  settings.run.draws = draws;
  settings.run.threads = 1;
  settings.run.sampler.target_acceptance = 0.85;
  settings.run.sampler.max_depth = 9;
  settings.mode_starts = 4;
  return settings;
}

const PosteriorRun& sampled() {
  static const PosteriorRun run = sample_posterior(small_inputs(), quick());
  return run;
}

std::string temporary(const std::string& name) {
  return (std::filesystem::temp_directory_path() / name).string();
}

TEST(SamplePosterior, ConvergesOnASmallProblem) {
  EXPECT_EQ(sampled().draws.draws(), 250);
  EXPECT_TRUE(sampled().draws.complete);
  EXPECT_LT(sampled().convergence.worst_r_hat, 1.05);
  EXPECT_TRUE(std::isfinite(sampled().convergence.min_bulk_ess));
}

TEST(SamplePosterior, DependsOnNothingButTheSeed) {
  PosteriorSettings settings = quick(40);
  settings.run.sampler.warm_up = 40;
  const PosteriorRun one = sample_posterior(small_inputs(), settings);
  settings.run.threads = 2;
  const PosteriorRun two = sample_posterior(small_inputs(), settings);
  EXPECT_EQ(pooled(one.draws), pooled(two.draws));
  settings.run.sampler.seed = 2;
  EXPECT_NE(pooled(one.draws), pooled(sample_posterior(small_inputs(), settings).draws));
}

// The first rank alone searches for modes; all start from what it found.
TEST(SamplePosterior, DrawsAlikeOnSeveralRanks) {
  PosteriorSettings settings = quick(40);
  settings.run.sampler.warm_up = 40;
  const PosteriorRun alone = sample_posterior(small_inputs(), settings);
  PosteriorRun first;
  sample::ThreadRanks::run(3, [&](const Communicator& ranks) {
    const PosteriorRun run = sample_posterior(small_inputs(), settings, ranks);
    EXPECT_EQ(run.draws.chains(), ranks.rank() == 0 ? 4 : 0);
    if (ranks.rank() == 0) first = run;
  });
  EXPECT_EQ(pooled(first.draws), pooled(alone.draws));
  EXPECT_EQ(first.modes.size(), alone.modes.size());
}

// Half a search gives other starts than a whole one: nothing may be kept of it.
TEST(SamplePosterior, StoppedInItsSearchLeavesNothing) {
  PosteriorSettings settings = quick();
  settings.run.folder = temporary("thenar_stopped_search");
  int asked = 0;
  settings.run.progress.stop_requested = [&] { return ++asked > 30; };
  const PosteriorRun run = sample_posterior(small_inputs(), settings);
  EXPECT_GT(asked, 30);
  EXPECT_EQ(run.draws.chains(), 0);
  EXPECT_TRUE(run.modes.empty());
  EXPECT_FALSE(std::filesystem::exists(settings.run.folder));
}

TEST(SamplePosterior, RefusesChainsBeforeItSearches) {
  PosteriorSettings settings = quick();
  settings.run.method = SamplingMethod::kStretchMove;
  settings.run.walkers = 4;
  settings.run.progress.report = [](double, const std::string& what) { FAIL() << what; };
  EXPECT_THROW((void)sample_posterior(small_inputs(), settings), InputError);
  settings.run.method = SamplingMethod::kNuts;
  settings.run.walkers = 1;
  settings.run.temperatures = 2;
  settings.run.min_beta = 1;
  EXPECT_THROW((void)sample_posterior(small_inputs(), settings), InputError);
}

// What one rank could not do, none may go on from.
TEST(AgreedWork, FailsOnAllRanksIfItFailsOnOne) {
  std::vector<std::string> told(3);
  sample::ThreadRanks::run(3, [&](const Communicator& ranks) {
    collective_call(ranks, [] {});  // nothing fails, nothing is thrown
    try {
      collective_call(ranks, [&] { require(ranks.rank() != 1, "no disk on {}", ranks.rank()); });
    } catch (const Error& error) {
      told[static_cast<std::size_t>(ranks.rank())] = error.what();
    }
  });
  EXPECT_EQ(told, std::vector<std::string>(3, "no disk on 1"));
}

// The chi-square of forces that the model itself made has the mean m over replicates; measured
// ones come near it because their noise is learnt.
TEST(PosteriorSummary, SharesItsNumbersWithTheDraws) {
  const PosteriorSummary summary = summarise_posterior(sampled());
  ASSERT_EQ(summary.experiments.size(), 1U);
  const PredictiveCheck& check = summary.experiments[0].check;
  EXPECT_EQ(check.rank_share.size(), 72);
  EXPECT_NEAR(check.mean_chi_square, 72, 3 * std::sqrt(2.0 * 72));  // three of its sds
  ASSERT_TRUE(summary.left_out);
  EXPECT_EQ(summary.left_out->observations.size(), 24U);
  EXPECT_NEAR(summary.left_out->result.elpd, summary.left_out->result.pointwise.sum(), 1e-9);
  // Directions are of x, whose prior has unit variance: none is wider than it by chance alone.
  ASSERT_EQ(summary.directions.directions.size(), 8U);
  EXPECT_LT(summary.directions.directions.back().sd_ratio, 1.2);
  EXPECT_LT(summary.directions.directions.front().sd_ratio, 0.3);  // the noise
}

TEST(PosteriorFile, ComesBackWithEveryDrawAndVerdict) {
  const std::string path = temporary("thenar_posterior_test.nc");
  write_posterior(sampled(), path);
  const PosteriorRun back = read_posterior(path);
  std::filesystem::remove(path);
  EXPECT_EQ(pooled(back.draws), pooled(sampled().draws));
  EXPECT_EQ(back.convergence.worst_r_hat, sampled().convergence.worst_r_hat);
  EXPECT_EQ(back.convergence.warnings, sampled().convergence.warnings);
  EXPECT_EQ(back.inputs.settings.text, sampled().inputs.settings.text);
  EXPECT_EQ(back.draws.stats[1][7].energy, sampled().draws.stats[1][7].energy);
  EXPECT_EQ(describe_run(back), describe_run(sampled()));
  EXPECT_EQ(back.settings.run.sampler.target_acceptance, 0.85);
  EXPECT_EQ(back.settings.run.sampler.max_depth, 9);
}

TEST(PosteriorFile, RefusesOtherFiles) {
  const std::string path = temporary("thenar_not_a_posterior.nc");
  InferenceFile other;
  other.groups["posterior"].lengths["draw"] = 1;
  other.groups["posterior"].arrays["a"] = {{1}, {"draw"}, "1", ""};
  write_inference(other, path);
  EXPECT_THROW((void)read_posterior(path), DataError);
  std::filesystem::remove(path);
}

// Without noise, each draw's forces are those of its parameters.
TEST(PredictDraws, OfTheFittedExperimentAreItsOwnForces) {
  const HandPosterior& posterior = *sampled().posterior;
  const Experiment& experiment = posterior.problem().experiments()[0];
  const PredictedDraws predicted = predict_draws(sampled(), experiment, 0, 1000);
  ASSERT_EQ(predicted.expected.cols(), 1000);
  EXPECT_TRUE(predicted.expected.isApprox(posterior.forces(pooled(sampled().draws), 0), 1e-12));
}

// The variance of what is read again is that of what is expected plus that of the noise.
TEST(PredictDraws, AddTheNoise) {
  const Experiment& experiment = sampled().posterior->problem().experiments()[0];
  const PredictedDraws predicted = predict_draws(sampled(), experiment, 0, 1000);
  const PosteriorValues values = sampled().posterior->values(pooled(sampled().draws));
  const double noise = 0.15 * 0.15 * values.noise.row(0).squaredNorm() / 1000;  // [N^2]
  const Eigen::MatrixXd off = predicted.replicated - predicted.expected;
  // 1000 draws x 72 components: the standard error of a variance is 0.5 %.
  EXPECT_NEAR(off.squaredNorm() / double(off.size()), noise, 0.03 * noise);
}

// Student's t in three dimensions: m = |r|^2 / sd^2 has  P(m <= x) = P(F <= x nu / (3 c^2)), and
// for nu = 1 (c = 2) that is  2/pi (atan(a) - a / (1 + a^2)),  a = sqrt(x) / c.
TEST(PredictDraws, ReplicateRobustNoiseAsItsLikelihoodHasIt) {
  FitInputs inputs = small_inputs();
  inputs.settings.text = "robust_scale = 2\n" + inputs.settings.text;
  PosteriorSettings settings = quick(100);
  settings.posterior.learn_noise = false;
  const PosteriorRun run = sample_posterior(inputs, settings);
  const PredictedDraws predicted =
      predict_draws(run, run.posterior->problem().experiments()[0], 0, 400);
  const Eigen::ArrayXXd off =
      (predicted.replicated - predicted.expected).array() / predicted.sd.array();
  long within = 0;
  const long trials = off.size() / 3;
  for (long k = 0; k < trials; ++k)
    within += off.reshaped().segment(3 * k, 3).square().sum() <= 12;  // a = sqrt(3)
  const double a = std::sqrt(3.0), share = 2 / M_PI * (std::atan(a) - a / (1 + a * a));
  EXPECT_NEAR(double(within) / double(trials), share, 4 * std::sqrt(share * (1 - share) / trials));
}

// The ensemble could not leave a plane on which all its walkers began.
TEST(SamplePosterior, StartsFactorsApartForEveryWalker) {
  PosteriorSettings settings = quick(20);
  settings.run.method = SamplingMethod::kStretchMove;
  settings.run.walkers = 0;
  settings.run.groups = 2;
  const Draws draws = sample_posterior(small_inputs(), settings).draws;
  const Eigen::MatrixXd noise = draws.coordinate(draws.size() - 1);
  EXPECT_GT((noise.array() - noise.mean()).abs().maxCoeff(), 0.01);
}

TEST(PosteriorFile, HasNoPopulationOfOneSpecimen) {
  const InferenceFile file = describe_posterior(sampled());
  EXPECT_EQ(file.groups.at("posterior").arrays.count("hood_central"), 0U);
  EXPECT_EQ(file.groups.at("posterior").arrays.count("hood_central_specimen"), 1U);
}

TEST(PredictDraws, AStrangerIsLessSureThanTheFitted) {
  const Experiment& experiment = sampled().posterior->problem().experiments()[0];
  const auto spread = [&](int specimen) {
    const Eigen::MatrixXd f = predict_draws(sampled(), experiment, specimen, 1000).expected;
    return (f.colwise() - f.rowwise().mean()).norm();
  };
  EXPECT_GT(spread(-1), 1.5 * spread(0));
}

TEST(ReadQuantities, AreInTheUnitsOfPeople) {
  const std::vector<PosteriorQuantity> quantities = posterior_quantities(sampled(), 500);
  for (const PosteriorQuantity& q : quantities)
    if (q.name == "sensor/dorsal") {
      EXPECT_EQ(q.unit, "deg");
      EXPECT_NEAR(prior_sd(q), 4, 0.5);  // [deg]; 500 draws know it to 3 %
      return;
    }
  FAIL() << "no sensor tilt";
}

}  // namespace
}  // namespace thenar
