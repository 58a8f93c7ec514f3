// Tests for posterior/run: from files to draws to a file and back.

#include "posterior/run/sample_posterior.h"

#include <cmath>
#include <filesystem>

#include <gtest/gtest.h>

#include "base/error.h"
#include "posterior/run/posterior_file.h"
#include "posterior/run/predict_draws.h"
#include "posterior/run/run_quantities.h"
#include "tests/kinematics_fit/fit_samples.h"

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
  EXPECT_TRUE(std::isfinite(sampled().convergence.least_bulk_ess));
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

TEST(PosteriorFile, ComesBackWithEveryDrawAndVerdict) {
  const std::string path = temporary("thenar_posterior_test.nc");
  write_posterior(sampled(), path);
  const PosteriorRun back = read_posterior(path);
  std::filesystem::remove(path);
  EXPECT_EQ(pooled(back.draws), pooled(sampled().draws));
  EXPECT_EQ(back.convergence.worst_r_hat, sampled().convergence.worst_r_hat);
  EXPECT_EQ(back.convergence.reasons, sampled().convergence.reasons);
  EXPECT_EQ(back.inputs.settings.text, sampled().inputs.settings.text);
  EXPECT_EQ(back.draws.stats[1][7].energy, sampled().draws.stats[1][7].energy);
  EXPECT_EQ(describe_run(back), describe_run(sampled()));
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

TEST(PredictDraws, AStrangerIsLessSureThanTheFitted) {
  const Experiment& experiment = sampled().posterior->problem().experiments()[0];
  const auto spread = [&](int specimen) {
    const Eigen::MatrixXd f = predict_draws(sampled(), experiment, specimen, 1000).expected;
    return (f.colwise() - f.rowwise().mean()).norm();
  };
  EXPECT_GT(spread(-1), 1.5 * spread(0));
}

TEST(ReadQuantities, AreInTheUnitsOfPeople) {
  const std::vector<ReadQuantity> quantities = read_quantities(sampled(), 500);
  for (const ReadQuantity& q : quantities)
    if (q.name == "sensor/dorsal") {
      EXPECT_EQ(q.unit, "deg");
      EXPECT_NEAR(prior_sd(q), 4, 0.5);  // [deg]; 500 draws know it to 3 %
      return;
    }
  FAIL() << "no sensor tilt";
}

}  // namespace
}  // namespace thenar
