#pragma once

/// Study of thumb models: how well orthogonal and skewed axes explain forces of a skewed thumb, and
/// how well these forces determine the axes.

#include <optional>
#include <string>
#include <vector>

#include "posterior/run/posterior_quantities.h"
#include "posterior/run/sample_posterior.h"
#include "sampling/diagnostics/leave_one_out.h"
#include "studies/thumb/coordination_tasks.h"
#include "studies/thumb/thumb_experiment.h"
#include "studies/thumb/thumb_types.h"

namespace thenar {

/// Files of the study.
struct ThumbStudyInputs {
  SourceText truth;       // subject that forces are simulated with
  SourceText start;       // initial subject of both models
  SourceText orthogonal;  // settings: axes tied in crossing pairs
  SourceText skewed;      // settings: every axis is free
  SourceText criteria;    // variability of axes, which defines types of thumbs
};

/// Reads files of a folder with subjects/, fits/ and studies/. @throws InputError if a file cannot
/// be read.
[[nodiscard]] ThumbStudyInputs thumb_study_inputs(const std::string& data);

/// State of the moment arms. Fixed: both models have the true ones. Free: they are fitted too, with
/// priors about the true arms that are as wide as the disagreement between sources.
enum class Arms { kFixed, kFree };

/// Model and data of one fit of the study.
struct ThumbFitSettings {
  bool skewed = true;
  Arms arms = Arms::kFixed;
  double noise = 0.1;   // relative noise of forces [1]
  int postures = 2;     // 1..4
  double skewness = 1;  // true tilts and shifts from the start, as multiples of the published [1]
  bool with_tasks = false;  // the tasks with electromyography are fitted too
  double prior_width = 1;   // factor on the prior sds of axes [1]
};

/// Returns true for the fits that pages compare: known arms, 10 % noise, 2 postures.
[[nodiscard]] bool is_compared(const ThumbFitSettings& settings);

struct ThumbStudySettings {
  std::vector<ThumbFitSettings> fits;  // empty: none
  long draws = 1000, warm_up = 1000;   // draws of each of 4 chains [1]
  int retries = 2;                     // doublings of both where chains do not agree [1]
  int mode_starts = 16;                // starts of the search for modes [1]
  int scored_draws = 100;              // draws on which tasks are scored [1]
  unsigned seed = 1;
  Progress progress;
};

/// Returns the settings of the full study, which takes minutes. Both models, arms fixed: at 1, 5,
/// 10 and 20 % noise, at twice the published skewness, in 1 to 4 postures, with tasks beside the
/// pulls, and with priors three times as wide; arms free: at 5, 10 and 20 % noise.
[[nodiscard]] ThumbStudySettings full_thumb_study();
/// Returns the settings of a study that takes less than 20 s on one core: both models at three
/// noises, and 1 to 4 postures, arms fixed.
[[nodiscard]] ThumbStudySettings quick_thumb_study();

/// Means and sds over tasks, each a mean over draws.
struct TaskScores {
  double direction = 0, direction_sd = 0;  // misdirection [rad]
  double torque = 0, torque_sd = 0;        // unbalanced joint torque [N m]
  double explained = 0;                    // share of tasks within kChiSquare3At95, 0..1
};
[[nodiscard]] TaskScores task_scores(const std::vector<TaskMisfit>& misfits);

/// Posterior of one parameter of the axes or the arms.
struct LearntNumber {
  std::string name, unit;       // "axis/CMC1_FE/direction/1", "deg"
  double mean, sd, prior_sd;    // [unit]
  double q05, q95;              // [unit]
  std::optional<double> truth;  // [unit]; empty for orthogonal models
};

/// Probability of a type of thumb, before the forces and after.
struct TypeProbability {
  ThumbType type;
  double prior, posterior;  // shares of draws [1]
  double mcse;              // Monte Carlo error of `posterior` [1]
};

/// One fit with its scores.
struct ThumbFit {
  ThumbFitSettings settings;
  PosteriorRun run;
  double direction = 0, direction_sd = 0;  // angle between posterior mean and measured forces [rad]
  double relative_error = 0;               // rms of predicted less true force over rms force [1]
  TaskScores tasks;                        // scores of tasks, which are fitted only if with_tasks
  std::vector<LearntNumber> learnt;        // every free or tied parameter of axes, and free arms
  LeaveOneOut left_out;                    // leave-one-out check of the trials
  std::vector<TypeProbability> types;      // all four types; empty for orthogonal models
  [[nodiscard]] bool converged() const { return run.convergence.warnings.empty(); }
};

/// Scores of thumbs that were not fitted, on the same data.
struct ThumbReference {
  double noise, skewness;          // [1]
  double direction, direction_sd;  // angle between forces of the start and measured forces [rad]
  TaskScores start;                // scores of the orthogonal thumb of its file
  TaskScores truth;                // scores of the true thumb: the effect of noise alone
};

/// Results of the study.
struct ThumbStudy {
  ThumbStudyInputs inputs;
  TendonDigit truth;  // true thumb in the frame of the start
  TendonDigit start;
  std::vector<ThumbReference> references;  // references for each noise and skewness of the fits
  std::vector<ThumbFit> fits;              // fits in the order of the settings
  MeanThumb criteria;                      // criteria of thumb types, in the frame of the start
  bool complete = false;                   // false: stopped; `fits` has the finished ones
};

/// Runs the study. The same settings give bitwise equal results.
[[nodiscard]] ThumbStudy study_thumb(const ThumbStudyInputs& inputs,
                                     const ThumbStudySettings& settings);

/// Returns the thumb with which the data of a fit are simulated.
[[nodiscard]] TendonDigit true_thumb(const ThumbStudy& study, double skewness);

/// Returns a description of a fit: "skewed, arms free, 10 % noise, 2 postures".
[[nodiscard]] std::string describe_fit(const ThumbFitSettings& settings);

}  // namespace thenar
