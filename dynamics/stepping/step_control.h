#pragma once

/// Step size control between events: by error estimates, closing gaps and changes of contact mode.

#include "dynamics/stepping/trial_step.h"

namespace thenar {

/// Chooses the length of a step, of its repeated trials and of the step after it.
class StepControl {
 public:
  /// @param options  must outlive the object
  explicit StepControl(const SceneOptions& options)
      : options_(options), max_length_(options.max_step) {}

  /// Returns the largest step length at present [s].
  [[nodiscard]] double max_length() const { return max_length_; }
  /// Sets the largest step length: SceneOptions::max_step, or a multiple of it for a quiet scene.
  /// @param is_quiet  no position changed by kSearchMargin in the last step
  void set_max_length(bool is_quiet);

  /// Returns the length of the first trial of a step: `wanted`, or less to end just before an
  /// expected change of mode [s]. @param t  start of the step [s];  @param wanted  [s]
  [[nodiscard]] double first_trial_length(double t, double wanted);
  /// Returns the length of the next trial after one rejected for a closing gap, its error or a
  /// change of mode [s]. @param t  start of the step [s];  @param length  of the rejected trial [s]
  [[nodiscard]] double shorten_after_rejection(StepTrials& trials, double t, double length);
  /// Returns the length of the next trial after one rejected by force elements [s].
  /// @param step_error  error of the elements over their tolerance, above 1 [1]
  [[nodiscard]] double shorten_for_elements(double step_error, double length);
  /// Returns the length of the next trial after one longer than SceneOptions::max_step in which
  /// positions moved too far [s].
  [[nodiscard]] double cap_at_max_step();
  /// Records a rejected trial that cannot be shortened.
  void record_rejection();
  /// Returns the length of the next step after an accepted one [s].
  [[nodiscard]] double next_step_length(StepTrials& trials, double length);

 private:
  [[nodiscard]] double length_by_error(StepTrials& trials, double length);
  [[nodiscard]] double free_growth(const StepTrial& trial);

  const SceneOptions& options_;
  double max_length_;            // largest step length at present [s]
  double usual_length_ = 0;      // length of the last step unaffected by mode changes [s]
  double expected_change_ = -1;  // instant of the next mode change, from a rejected trial [s]; < 0:
                                 // none known
  double last_error_ = 1;        // error of the last accepted free step over the tolerance [1]
  bool was_shortened_for_change_ = false;  // the previous step ended before a mode change
  // Flags of the current step.
  bool rejected_ = false;                 // at least one trial was rejected
  bool is_shortened_for_change_ = false;  // shortened because a mode changes
  bool ends_before_change_ = false;       // shortened to end just before that change
};

}  // namespace thenar
