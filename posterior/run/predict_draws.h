#pragma once

/// Posterior predictive forces.

#include <string>

#include "kinematics_fit/prediction.h"
#include "posterior/run/sample_posterior.h"

namespace thenar {

/// Forces of an experiment predicted by each draw.
struct PredictedDraws {
  Experiment experiment;
  std::string specimen;         // of the parameters; empty: a new specimen of the population
  Eigen::MatrixXd expected;     // forces without noise; 0 if not fitted [N] (3 trials, draws)
  Eigen::MatrixXd replicated;   // what a repeated measurement would read [N] (3 trials, draws)
  Eigen::MatrixXd sd;           // of the noise; infinite if not fitted [N] (3 trials, draws)
  bool calibrated_on_specimen;  // the subject of the prior was calibrated on this specimen
};

/// Predicts any experiment on the fitted digit. For a specimen that was not fitted, every draw adds
/// the deviation of a new specimen from the population. Postures that the fit does not know by name
/// have angle errors drawn from their prior. At most `draws` draws of the run are used, evenly
/// thinned.
///
/// The noise of an experiment that was not fitted, or of a new specimen, is the stated noise times
/// a factor drawn from the prior, since every experiment has its own factor. What the model misses
/// under its loads, missed_force_sd(), is added to that as it is.
/// @param specimen  index in problem().specimens(), or kUnfittedSpecimen: a new specimen
/// @throws InputError if the experiment does not fit the digit, or there are no draws.
[[nodiscard]] PredictedDraws predict_draws(const PosteriorRun& run, const Experiment& experiment,
                                           int specimen, long draws = 2000);

/// Means of the draws beside the measured forces; of a component whose draws have a long tail, as
/// near a singular tip, the median. A tail is long where the sd is more than 1.5 times that of
/// robust_moments(), or the mean further from the median than a quarter of that. The sds are half
/// the central 95 % range of the replicated forces over 1.96, which exists also for robust noise of
/// infinite variance.
[[nodiscard]] Prediction summarise(const PredictedDraws& predicted);

/// Replicated forces of the fitted trials at every column of x [N] (3 trials of all experiments,
/// points).
[[nodiscard]] Eigen::MatrixXd replicated_forces(const HandPosterior& posterior,
                                                const Eigen::MatrixXd& x, unsigned seed);

}  // namespace thenar
