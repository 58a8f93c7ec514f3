#pragma once

/// Recovery of a thumb from simulated forces and muscle activity, by least squares and by draws:
/// the method by which [Miller2005] (sec. 3.2) found its thumb, with known truth.

#include <optional>
#include <string>
#include <vector>

#include "kinematics_fit/fit.h"
#include "kinematics_fit/undetermined_tilts.h"
#include "studies/thumb/thumb_study.h"

namespace thenar {

/// Options of the simulated data and of their fits.
struct ThumbRecoverySettings {
  int postures = 4;     // postures of pulls of single muscles, see thumb_postures() [1]
  double noise = 0.05;  // relative noise of forces, see SimulatedPullOptions::noise [1]
  int people = 8;       // people with electromyography, each five tasks in two postures [1]
  long draws = 1000, warm_up = 1000;  // draws of each of 4 chains [1]
  int retries = 1;                    // doublings of both where chains do not agree [1]
  int mode_starts = 8;                // starts of the search for modes [1]
  unsigned seed = 1;                  // seed of noise and chains
  Progress progress;
};

/// Estimate of one number by one method.
struct RecoveredValue {
  double value, sd;  // best point or mean [unit]
  double low, high;  // bounds of the central 95 % interval [unit]
};

/// Estimates of a tilt or a shift of an axis, with the truth.
struct RecoveredNumber {
  std::string name, unit;     // "axis/CMC1_FE/direction/1", "deg"
  double truth, prior_sd;     // [unit]; the prior's mean is 0
  RecoveredValue fit, drawn;  // values by least squares, and by the draws
};

/// Errors of the direction of an axis.
struct RecoveredAxis {
  std::string joint;
  double start_error;  // angle from the true axis to that of the start [rad]
  double fit_error,
      drawn_error;      // angles to the best point, and to the mean direction of draws [rad]
  double drawn_within;  // 95 % of draws are within this angle of their mean [rad]
  double fit_left, drawn_left;  // rms over both tilts of sd / prior sd [1]

  /// Returns true if the truth is within the central 95 %.
  [[nodiscard]] bool covered() const { return drawn_error <= drawn_within; }
};

/// Largest rms difference of two methods that agree: half of the posterior sd [sds of the draws].
inline constexpr double kMethodsAgree = 0.5;

/// Agreement of two methods: differences of their estimates in sds of the draws, and ratios of
/// their sds.
struct MethodAgreement {
  double rms = 0, worst = 0;                     // |fit - mean of draws| / sd of draws [1]
  std::string worst_name;                        // name of the number with the worst value
  double least_sd_ratio = 0, most_sd_ratio = 0;  // sd of the fit over that of the draws [1]
  int fit_covered = 0, drawn_covered = 0;        // truths within their 95 % intervals [1]
  std::vector<std::string> fit_undecided,
      drawn_undecided;  // numbers whose sd is above kUndecidedShare of their prior sd
};

/// Thumb, its simulated data, and the estimates of both methods.
struct ThumbRecovery {
  ThumbStudyInputs inputs;
  ThumbRecoverySettings settings;
  TendonDigit truth, start;              // thumbs in one frame
  Experiment made_up;                    // pulls of single muscles, and rows of activations
  std::optional<Fit> fit;                // least squares; absent: stopped before
  PosteriorRun run;                      // run; stopped early: without complete draws
  std::vector<RecoveredNumber> numbers;  // numbers of axes: two tilts and two shifts each
  std::vector<RecoveredAxis> axes;       // axes from base to tip
  MethodAgreement agreement;
  bool complete = false;
};

/// Simulates pulls and tasks of `inputs.truth`, with errors of the stated sds, and fits the axes of
/// `inputs.start` to them, with known arms. The same settings give bitwise equal results.
[[nodiscard]] ThumbRecovery recover_thumb(const ThumbStudyInputs& inputs,
                                          const ThumbRecoverySettings& settings);

/// Compares estimates of both methods over all numbers.
/// @throws InputError without numbers.
[[nodiscard]] MethodAgreement compare_methods(const std::vector<RecoveredNumber>& numbers);

}  // namespace thenar
