#pragma once

/// Simulation-based calibration of thumb posteriors: truths from the prior, forces from the model.

#include "sampling/diagnostics/simulation_based_calibration.h"
#include "studies/thumb/thumb_study.h"

namespace thenar {

/// Simulations and chains of a calibration.
struct ThumbCalibrationSettings {
  ThumbFitSettings thumb;  // model, noise and postures; no tasks
  int simulations = 200;
  int ranked = 99;                  // number L of draws among which each truth is ranked [1]
  long draws = 500, warm_up = 500;  // draws of each of 4 chains [1]
  int retries = 2;                  // doublings of both where chains do not agree [1]
  int mode_starts = 4;              // starts of the search for modes [1]
  unsigned seed = 1;
  Progress progress;
};

/// Ranks of the truths and their tests.
struct ThumbCalibration {
  std::vector<std::string> names;  // entries of x, and the log likelihood
  Eigen::MatrixXi rank;            // ranks of the truths, 0 .. ranked (names, simulations done)
  int ranked = 0;
  int not_converged = 0;  // runs that did not converge after retries; their ranks are counted
  RankCalibration judged;
  double covered = 0, covered_error = 0;  // share of truths within central 90 % intervals of
                                          // ranks, and its error, runs being independent [1]
};

/// Calibrates the sampler: every simulation draws a thumb from the prior of the fit, simulates its
/// pulls with noise of the stated sds times a factor from its prior, and samples the posterior. The
/// stated sds are those of the thumb at the start: they must not depend on the truth. After a stop
/// request the simulations so far are tested; fewer than 20 simulations are not tested. Source:
/// [Talts2018]; the log likelihood is ranked too, as [Sailynoja2022] advise.
[[nodiscard]] ThumbCalibration calibrate_thumb(const ThumbStudyInputs& inputs,
                                               const ThumbCalibrationSettings& settings);

}  // namespace thenar
