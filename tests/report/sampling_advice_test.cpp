// Tests for report/sampling_advice.cpp.

#include "report/sampling_advice.h"

#include <gtest/gtest.h>

namespace thenar {
namespace {

using Words = std::vector<std::string>;

/// Four chains of 1000 draws whose diagnostics are as good as can be.
PosteriorRun good_run() {
  PosteriorRun run;
  run.settings.run.groups = 4;
  run.settings.run.draws = 1000;
  run.settings.run.sampler.warm_up = 1000;
  run.settings.run.sampler.target_acceptance = 0.9;
  run.draws.x.assign(4, Eigen::MatrixXd::Zero(1, 1000));
  run.convergence.worst_r_hat = 1.001;
  run.convergence.min_bulk_ess = run.convergence.min_tail_ess = 2000;
  run.run.arguments = {"fit", "H01.toml", "--method", "mcmc", "-o", "P.nc"};
  return run;
}

TEST(WithOptions, ReplacesAddsAndTakesAway) {
  const Words typed{"fit", "--draws", "100", "--thin=2", "--fresh", "-o", "P.nc"};
  EXPECT_EQ(with_options(typed, {{"--draws", "400"}}, false),
            (Words{"fit", "--thin=2", "-o", "P.nc", "--draws", "400"}));
  EXPECT_EQ(with_options(typed, {{"--thin", ""}, {"--seed", "2"}}, true),
            (Words{"fit", "--draws", "100", "-o", "P.nc", "--seed", "2", "--fresh"}));
}

TEST(SamplingAdvice, IsSilentWhereNothingIsWrong) { EXPECT_TRUE(advise(good_run()).empty()); }

// More draws go on from where the chains stand, so nothing is begun anew.
TEST(SamplingAdvice, AsksForMoreDrawsWithoutAFreshStart) {
  PosteriorRun run = good_run();
  run.convergence.warnings = {"R-hat of a is 1.2"};
  run.convergence.worst_r_hat = 1.2;
  const std::vector<SamplingAdvice> advice = advise(run);
  ASSERT_GE(advice.size(), 2U);
  EXPECT_EQ(advice[0].command, "thenar fit H01.toml --method mcmc -o P.nc --draws 4000");
  EXPECT_EQ(advice[1].command, "thenar fit H01.toml --method mcmc -o P.nc --warm-up 2000 --fresh");
}

// Halfway from 0.9 to 1.
TEST(SamplingAdvice, AsksForSmallerStepsAgainstDivergence) {
  PosteriorRun run = good_run();
  run.convergence.divergent = 3;
  run.convergence.cautions = {"3 of 4000 draws ended a divergent trajectory"};
  const std::vector<SamplingAdvice> advice = advise(run);
  ASSERT_EQ(advice.size(), 1U);
  EXPECT_NE(advice[0].remedy.find("--target-acceptance 0.95 (was 0.9)"), std::string::npos);
  EXPECT_EQ(advice[0].command,
            "thenar fit H01.toml --method mcmc -o P.nc --target-acceptance 0.95 --fresh");
}

TEST(SamplingAdvice, NamesNoCommandThatItDoesNotKnow) {
  PosteriorRun run = good_run();
  run.run = {};
  run.convergence.warnings = {"R-hat of a is 1.2"};
  run.convergence.worst_r_hat = 1.2;
  const std::vector<SamplingAdvice> advice = advise(run);
  EXPECT_EQ(advice[0].command, "");
  EXPECT_NE(advice_text(advice).find("--draws 4000"), std::string::npos);
}

}  // namespace
}  // namespace thenar
