// Tests for posterior/run/sample_posterior.cpp: from input files to draws.

#include "posterior/run/sample_posterior.h"

#include <cmath>
#include <filesystem>

#include <gtest/gtest.h>

#include "base/error.h"
#include "sampling/run/communicator.h"
#include "tests/posterior/run/small_run.h"
#include "tests/sampling/thread_ranks.h"

namespace thenar {
namespace {

using sample::quick_settings;
using sample::sampled;
using sample::small_inputs;
using sample::temporary_path;

TEST(SamplePosterior, ConvergesOnASmallProblem) {
  EXPECT_EQ(sampled().draws.draws(), 250);
  EXPECT_TRUE(sampled().draws.complete);
  EXPECT_LT(sampled().convergence.worst_r_hat, 1.05);
  EXPECT_TRUE(std::isfinite(sampled().convergence.min_bulk_ess));
}

TEST(SamplePosterior, DependsOnNothingButTheSeed) {
  PosteriorSettings settings = quick_settings(40);
  settings.run.sampler.warm_up = 40;
  const PosteriorRun one = sample_posterior(small_inputs(), settings);
  settings.run.threads = 2;
  const PosteriorRun two = sample_posterior(small_inputs(), settings);
  EXPECT_EQ(pooled(one.draws), pooled(two.draws));
  settings.run.sampler.seed = 2;
  EXPECT_NE(pooled(one.draws), pooled(sample_posterior(small_inputs(), settings).draws));
}

// Forty draws are too few to believe: they are doubled, to the draws of one run as long, and the
// run that is asked again, as after an interruption, ends there too.
TEST(SamplePosterior, GoesOnByItselfWhereMoreDrawsMayHelp) {
  PosteriorSettings settings = quick_settings(160);
  settings.run.sampler.warm_up = 100;
  const PosteriorRun whole = sample_posterior(small_inputs(), settings);
  settings.run.draws = 40;
  settings.max_draws = 160;
  EXPECT_EQ(sample_posterior(small_inputs(), settings).draws.draws(),
            40);  // no folder to go on from
  settings.run.folder = temporary_path("thenar_growing_draws");
  std::filesystem::remove_all(settings.run.folder);
  for (int times = 0; times < 2; ++times) {
    const PosteriorRun grown = sample_posterior(small_inputs(), settings);
    ASSERT_GT(grown.draws.draws(), 40);
    EXPECT_EQ(grown.settings.run.draws, grown.draws.draws());
    EXPECT_EQ(grown.draws.x[1], whole.draws.x[1].leftCols(grown.draws.draws()));
    EXPECT_TRUE(grown.draws.draws() == 160 || grown.convergence.warnings.empty());
  }
  std::filesystem::remove_all(settings.run.folder);
}

// The first rank alone searches for modes; all start from what it found.
TEST(SamplePosterior, DrawsAlikeOnSeveralRanks) {
  PosteriorSettings settings = quick_settings(40);
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
  PosteriorSettings settings = quick_settings();
  settings.run.folder = temporary_path("thenar_stopped_search");
  int asked = 0;
  settings.run.progress.stop_requested = [&] { return ++asked > 30; };
  const PosteriorRun run = sample_posterior(small_inputs(), settings);
  EXPECT_GT(asked, 30);
  EXPECT_EQ(run.draws.chains(), 0);
  EXPECT_TRUE(run.modes.empty());
  EXPECT_FALSE(std::filesystem::exists(settings.run.folder));
}

TEST(SamplePosterior, RefusesChainsBeforeItSearches) {
  PosteriorSettings settings = quick_settings();
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

// The ensemble could not leave a plane on which all its walkers began.
TEST(SamplePosterior, StartsFactorsApartForEveryWalker) {
  PosteriorSettings settings = quick_settings(20);
  settings.run.method = SamplingMethod::kStretchMove;
  settings.run.walkers = 0;
  settings.run.groups = 2;
  const Draws draws = sample_posterior(small_inputs(), settings).draws;
  const Eigen::MatrixXd noise = draws.coordinate(draws.size() - 1);
  EXPECT_GT((noise.array() - noise.mean()).abs().maxCoeff(), 0.01);
}

// Two chains of six draws thinned to six: every second one of each.
TEST(SamplePosterior, ThinsAsManyDrawsOfEachChain) {
  const Eigen::RowVectorXd x = Eigen::RowVectorXd::LinSpaced(12, 0, 11);
  Eigen::RowVectorXd wanted(6);
  wanted << 0, 2, 4, 6, 8, 10;
  EXPECT_EQ(thinned(x, 6), wanted);
  EXPECT_EQ(thinned(x, 100), x);
}

}  // namespace
}  // namespace thenar
