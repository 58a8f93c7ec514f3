#pragma once

/// Forces that the draws of a posterior predict.

#include <string>

#include "kinematics_fit/prediction.h"
#include "posterior/run/sample_posterior.h"

namespace thenar {

/// What each draw says of an experiment.
struct PredictedDraws {
  Experiment experiment;
  std::string specimen;         // whose parameters; empty: a new_specimen of the population
  Eigen::MatrixXd expected;     // forces without noise [N] (3 trials, draws)
  Eigen::MatrixXd replicated;   // what a repeated measurement would read [N] (3 trials, draws)
  Eigen::MatrixXd sd;           // of the noise [N] (3 trials, draws)
  bool calibrated_on_specimen;  // the subject of the prior was calibrated on this specimen
};

/// Any experiment on the fitted digit, also of a specimen that was not fitted: then every draw adds
/// a new_specimen's deviation from the population. Postures that the fit does not know by name err
/// by angles drawn from their prior. At most `draws` of the run, evenly spread.
///
/// The noise of an experiment that was not fitted, or that a new_specimen made, is its stated one
/// times a factor from the prior, as experiments err by themselves.
/// @param specimen  index in problem().specimens(), or -1: a new_specimen
/// @throws InputError if the experiment does not fit the digit, or there are no draws.
[[nodiscard]] PredictedDraws predict_draws(const PosteriorRun& run, const Experiment& experiment,
                                           int specimen, long draws = 2000);

/// Means beside the measured forces, with sds of the replicated ones: half their central 95 % over
/// 1.96, which robust noise of infinite variance has, too.
[[nodiscard]] Prediction summarise(const PredictedDraws& predicted);

/// Forces of the fitted trials as they would be measured again, for every
/// column of x [N] (3 trials of all experiments, points).
[[nodiscard]] Eigen::MatrixXd replicated_forces(const HandPosterior& posterior,
                                                const Eigen::MatrixXd& x, unsigned seed);

}  // namespace thenar
