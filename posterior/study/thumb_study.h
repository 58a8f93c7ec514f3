#pragma once

/// How well do thumbs with orthogonal and with skewed axes explain forces of a skewed thumb, and
/// what do these tell of its axes?

#include <optional>
#include <string>
#include <vector>

#include "posterior/run/posterior_quantities.h"
#include "posterior/run/sample_posterior.h"
#include "posterior/study/coordination_tasks.h"
#include "posterior/study/thumb_experiment.h"
#include "sampling/diagnostics/leave_one_out.h"

namespace thenar {

/// The files of the study.
struct ThumbStudyInputs {
  SourceText truth;       // subject that forces are made with
  SourceText start;       // subject that both models start from
  SourceText orthogonal;  // settings: axes tied in crossing pairs
  SourceText skewed;      // settings: every axis by itself
};

/// From a folder with subjects/ and fits/. @throws InputError if a file cannot be read.
[[nodiscard]] ThumbStudyInputs thumb_study_inputs(const std::string& data);

/// Fixed: both models are told the true moment arms. Free: arms are learnt too, from priors that
/// are as wide as sources disagree, about the true ones: both fit as well as they can.
enum class Arms { kFixed, kFree };

/// One fit of the study.
struct ThumbFitSettings {
  bool skewed = true;
  Arms arms = Arms::kFixed;
  double noise = 0.1;   // of forces [1]
  int postures = 2;     // 1..4
  double skewness = 1;  // true tilts and shifts from the start, as multiples of the published [1]
  bool with_tasks = false;  // the tasks with electromyography are fitted too
  double prior_width = 1;   // factor on the prior sds of axes [1]
};

struct ThumbStudySettings {
  std::vector<ThumbFitSettings> fits;  // empty: nothing is done
  long draws = 1000, warm_up = 1000;   // of each of 4 chains [1]
  int retries = 2;                     // doublings of both where chains do not agree [1]
  int mode_starts = 16;                // of the search for modes [1]
  int scored_draws = 100;              // on which tasks are scored [1]
  unsigned seed = 1;
  Progress progress;
};

/// Both models, arms fixed: at 1, 5, 10 and 20 % noise, at twice the published skewness, in 1 to 4
/// postures, with tasks beside the pulls, and with priors three times as wide; arms free: at 5, 10
/// and 20 % noise. Minutes.
[[nodiscard]] ThumbStudySettings full_thumb_study();
/// Both models at three noises, and 1 to 4 postures, arms fixed: less than 20 s on one core.
[[nodiscard]] ThumbStudySettings quick_thumb_study();

/// Means and sds over tasks, each a mean over draws.
struct TaskScores {
  double direction = 0, direction_sd = 0;  // misdirection [rad]
  double torque = 0, torque_sd = 0;        // joint torque that is not balanced [N m]
  double explained = 0;                    // share of tasks within kChiSquare3At95, 0..1
};
[[nodiscard]] TaskScores task_scores(const std::vector<TaskMisfit>& misfits);

/// What a fit taught of one number of the axes, or of the arms.
struct LearntNumber {
  std::string name, unit;       // "axis/CMC1_FE/direction/1", "deg"
  double mean, sd, prior_sd;    // [unit]
  double q05, q95;              // [unit]
  std::optional<double> truth;  // [unit]; of the orthogonal thumb none
};

/// One fit and what it says.
struct ThumbFit {
  ThumbFitSettings settings;
  PosteriorRun run;
  double direction = 0, direction_sd = 0;  // posterior mean and measured forces of pulls [rad]
  double relative_error = 0;               // rms of predicted less true force over rms force [1]
  TaskScores tasks;                        // not fitted unless with_tasks
  std::vector<LearntNumber> learnt;        // every free or tied parameter of axes, and free arms
  LeaveOneOut left_out;                    // of the trials
  [[nodiscard]] bool converged() const { return run.convergence.warnings.empty(); }
};

/// Thumbs that were not fitted, on the same data.
struct ThumbReference {
  double noise, skewness;          // [1]
  double direction, direction_sd;  // forces of pulls by the start and as measured [rad]
  TaskScores start;                // the orthogonal thumb as it stands in its file
  TaskScores truth;                // the true thumb: what noise alone does
};

struct ThumbStudy {
  ThumbStudyInputs inputs;
  TendonDigit truth;  // in the frame of the start
  TendonDigit start;
  std::vector<ThumbReference> references;  // of the noises and skewnesses met, in turn
  std::vector<ThumbFit> fits;              // in the order of the settings
  bool complete = false;                   // false: stopped; fits are those that were finished
};

/// Runs the study; same settings, same bits.
[[nodiscard]] ThumbStudy study_thumb(const ThumbStudyInputs& inputs,
                                     const ThumbStudySettings& settings);

/// The thumb that a fit's data are made with.
[[nodiscard]] TendonDigit true_thumb(const ThumbStudy& study, double skewness);

/// "skewed, arms free, 10 % noise, 2 postures".
[[nodiscard]] std::string describe_fit(const ThumbFitSettings& settings);

}  // namespace thenar
