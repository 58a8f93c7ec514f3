#pragma once

/// Posterior predictive forces.

#include <string>

#include "kinematics_fit/prediction.h"
#include "posterior/run/sample_posterior.h"

namespace thenar {

/// Forces of an experiment predicted from each draw.
struct PredictedDraws {
  Experiment experiment;
  std::string specimen;      // specimen of the parameters; empty: a new specimen of the population
  Eigen::MatrixXd expected;  // forces without noise; 0 if not fitted [N] (3 trials, draws)
  Eigen::MatrixXd
      replicated;      // forces that a repeated measurement would give [N] (3 trials, draws)
  Eigen::MatrixXd sd;  // noise sd; infinite if not fitted [N] (3 trials, draws)
  bool calibrated_on_specimen = false;  // the prior's subject was calibrated on this specimen
};

/// Predicts any experiment on the fitted digit. For a specimen that was not fitted, every draw adds
/// the deviation of a new specimen from the population. Postures whose names are not part of the
/// fit have angle errors drawn from their prior. At most `draws` draws of the run are used, evenly
/// thinned.
///
/// The noise of an experiment that was not fitted, or of a new specimen, is the stated noise times
/// a factor drawn from the prior, because every experiment has its own factor. The model error
/// under the experiment's loads, missed_force_sd(), is added without that factor.
/// @param specimen  index in problem().specimens(), or kUnfittedSpecimen: a new specimen
/// @throws InputError if the experiment does not fit the digit, or there are no draws.
[[nodiscard]] PredictedDraws predict_draws(const PosteriorRun& run, const Experiment& experiment,
                                           int specimen, long draws = 2000);

/// Summarises predicted draws by their means or, for components with a long tail, as near a
/// singular tip, by their medians. A tail is long if the sd exceeds 1.5 times that of
/// robust_moments(), or the mean is further from the median than a quarter of that. The sds are
/// half the central 95 % range of the replicated forces over 1.96, which also exists for robust
/// noise of infinite variance.
[[nodiscard]] Prediction summarise(const PredictedDraws& predicted);

/// Returns replicated forces of the fitted trials at every column of x [N] (3 trials of all
/// experiments, points).
[[nodiscard]] Eigen::MatrixXd replicated_forces(const HandPosterior& posterior,
                                                const Eigen::MatrixXd& x, unsigned seed);

}  // namespace thenar
