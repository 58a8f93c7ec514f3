// Tests for posterior/run/posterior_summary.cpp.

#include "posterior/run/posterior_summary.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/posterior/run/small_run.h"

namespace thenar {
namespace {

using sample::sampled;

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

Estimate noise_of(double q05) {
  Estimate estimate{};
  estimate.q05 = q05;
  estimate.median = 1.5 * q05;
  estimate.q95 = 2 * q05;
  return estimate;
}

TEST(NoiseWarnings, AreOfNoiseThatIsSurelyTwiceWhatWasStated) {
  const std::vector<PosteriorQuantity> quantities{
      {"noise/H01", "1", {}, {}}, {"noise/H02", "1", {}, {}}, {"gain/FDP", "1", {}, {}}};
  const std::vector<std::string> warnings =
      noise_warnings(quantities, {noise_of(1.9), noise_of(4), noise_of(4)});
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_EQ(
      warnings[0].find("experiment 'H02': its forces scatter by 6.0 times the stated noise (5 "
                       "to 95 %: 4.0 to 8.0)"),
      0U)
      << warnings[0];
}

}  // namespace
}  // namespace thenar
