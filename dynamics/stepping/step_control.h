#pragma once

/// Lengths of steps between events: by errors, by gaps that close, by modes that change.

#include "dynamics/stepping/trial_step.h"

namespace thenar {

/// Chooses the length of a step, of its trials and of the next one.
class StepControl {
 public:
  explicit StepControl(const SceneOptions& options) : options_(options), reach_(options.longest) {}

  /// The longest step for now [s].
  [[nodiscard]] double reach() const { return reach_; }
  /// Sets it: longer where positions hardly move.
  void set_reach(bool is_quiet);

  /// Length of the first trial of a step from t that should be `wanted` long [s].
  [[nodiscard]] double begin(double t, double wanted);
  /// Length of a trial after one that a gap or its error ended [s].
  /// @param t  at the beginning of the step [s]
  [[nodiscard]] double shorten(StepTrials& trials, double t, double length);
  /// Length of a trial after one whose elements were in doubt by that much [s].
  [[nodiscard]] double shorten_for(double doubt, double length);
  /// Notes a trial that was rejected, but cannot be shorter.
  void note_rejected();
  /// Length of a trial after one that was too long for how far it moved [s].
  [[nodiscard]] double shorten_to_longest();
  /// Length of the step after one that was accepted [s].
  [[nodiscard]] double after(StepTrials& trials, double length);

 private:
  [[nodiscard]] double next_length(StepTrials& trials, double length);
  [[nodiscard]] double free_growth(const StepTrial& trial);

  const SceneOptions& options_;
  double reach_;              // no step is longer for now [s]
  double usual_ = 0;          // length of a step that no change of modes bounds [s]
  double change_ahead_ = -1;  // instant at which a mode may change, seen from before [s]; < 0: none
  double last_error_ = 1;     // of the last accepted free step over the tolerance [1]
  bool was_before_ = false;   // the last step was shortened for a change of modes ahead
  // Of the step that is tried: some trial was rejected; it was shortened for a change of modes
  // within it, and to end just before that change.
  bool rejected_ = false, is_before_ = false, is_cut_ = false;
};

}  // namespace thenar
