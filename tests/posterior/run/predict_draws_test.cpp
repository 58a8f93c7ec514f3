// Tests for posterior/run/predict_draws.cpp: forces that the draws predict.

#include "posterior/run/predict_draws.h"

#include <cmath>

#include <gtest/gtest.h>

#include "posterior/hand_posterior.h"
#include "tests/posterior/run/small_run.h"

namespace thenar {
namespace {

using sample::quick_settings;
using sample::sampled;
using sample::small_inputs;

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
  PosteriorSettings settings = quick_settings(100);
  settings.posterior.learn_noise = false;
  const PosteriorRun run = sample_posterior(inputs, settings);
  const PredictedDraws predicted =
      predict_draws(run, run.posterior->problem().experiments()[0], 0, 400);
  const Eigen::ArrayXXd off =
      (predicted.replicated - predicted.expected).array() / predicted.sd.array();
  long within = 0;
  const long trials = off.size() / 3;
  for (long k = 0; k < trials; ++k)
    if (off.reshaped().segment(3 * k, 3).square().sum() <= 12) ++within;  // a = sqrt(3)
  const double a = std::sqrt(3.0), share = 2 / M_PI * (std::atan(a) - a / (1 + a * a));
  EXPECT_NEAR(double(within) / double(trials), share, 4 * std::sqrt(share * (1 - share) / trials));
}

TEST(PredictDraws, AStrangerIsLessSureThanTheFitted) {
  const Experiment& experiment = sampled().posterior->problem().experiments()[0];
  const auto spread = [&](int specimen) {
    const Eigen::MatrixXd f = predict_draws(sampled(), experiment, specimen, 1000).expected;
    return (f.colwise() - f.rowwise().mean()).norm();
  };
  EXPECT_GT(spread(-1), 1.5 * spread(0));
}

// A load e times the fitted one: what forces are out of proportion by, 0.02 t, stands beside the
// noise of every draw, whose factor does not touch it. Draws of the same number have the same
// factor.
TEST(PredictDraws, NoiseFactorsLeaveWhatTheModelMisses) {
  FitInputs inputs = small_inputs();
  inputs.settings.text = "linearity = 0.02\n" + inputs.settings.text;
  const PosteriorRun run = sample_posterior(inputs, quick_settings(100));
  const Experiment& fitted = run.posterior->problem().experiments()[0];
  Experiment heavier = fitted;
  const double e = std::exp(1.0);
  for (Trial& trial : heavier.trials)
    for (auto& [muscle, tension] : trial.tension) tension *= e;
  const Eigen::MatrixXd as_fitted = predict_draws(run, fitted, 0, 50).sd,
                        with_missed = predict_draws(run, heavier, 0, 50).sd;
  for (std::size_t i = 0; i < fitted.trials.size(); ++i) {
    const double t = fitted.trials[i].tension.begin()->second;  // [N]
    for (Eigen::Index k = 0; k < 50; ++k)
      EXPECT_NEAR(with_missed(static_cast<Eigen::Index>(3 * i), k),
                  std::hypot(as_fitted(static_cast<Eigen::Index>(3 * i), k), 0.02 * e * t), 1e-12);
  }
  EXPECT_GT((as_fitted.row(0).array() - as_fitted(0, 0)).abs().maxCoeff(), 0.001);
}

// Of 101 draws one is a million times the others: their mean is 9902, which none is near, and what
// is told is their median, 1, with a warning. Of draws without such a tail it is the mean, 5.
TEST(Summarise, TellsMediansWhereTailsCarryMeansAway) {
  PredictedDraws predicted;
  predicted.experiment = sample::experiment("H01");
  predicted.experiment.trials.resize(2);
  predicted.expected = Eigen::MatrixXd::Ones(6, 101);
  predicted.expected.row(1)[100] = 1e6;
  for (Eigen::Index k = 0; k < 101; ++k) predicted.expected(4, k) = static_cast<double>(k) / 10;
  predicted.replicated = predicted.expected;
  predicted.sd = Eigen::MatrixXd::Ones(6, 101);
  const Prediction told = summarise(predicted);
  EXPECT_NEAR(predicted.expected.row(1).mean(), (100 + 1e6) / 101, 1e-6);
  EXPECT_EQ(told.trials[0].predicted, Eigen::Vector3d::Ones());
  EXPECT_TRUE(told.trials[0].by_draws);
  EXPECT_NEAR(told.trials[1].predicted[1], 5, 1e-12);
  EXPECT_FALSE(told.trials[1].by_draws);
  EXPECT_EQ(unsteady_force_warnings(told).size(), 1U);
}

}  // namespace
}  // namespace thenar
