#pragma once

/// Trials of one step between events: extrapolated Euler substeps on contacts, or a free step.

#include <algorithm>
#include <array>
#include <vector>

#include "dynamics/stepping/contact_step.h"
#include "dynamics/stepping/extrapolation.h"
#include "dynamics/stepping/free_step.h"
#include "dynamics/stepping/scene_run.h"

namespace thenar {

/// Counter of contact problems. Work counts at once; unsolved problems and residuals count only
/// once their trial is accepted.
class ProblemCounts {
 public:
  /// @param cost  must outlive the object
  explicit ProblemCounts(SceneCost& cost) : cost_(cost) {}

  /// Counts one contact problem of a trial, which may still be rejected.
  void count_problem(const StepOutcome& outcome) {
    ++cost_.substeps;
    if (!outcome.solved) ++unsolved_;
    residual_ = std::max(residual_, outcome.residual);
  }
  /// Counts a free step. @param acted  all elements had a valid force
  void count_free_step(bool acted) {
    if (!acted) ++unsolved_;
  }
  /// Counts the stages of a free step as substeps.
  void count_stages(long stages) { cost_.substeps += stages; }
  /// Discards the unsolved problems and residuals of a rejected trial.
  void clear() { unsolved_ = 0, residual_ = 0; }
  /// Adds unsolved problems and residuals since clear() to the cost of the run.
  void accept() {
    cost_.unsolved += unsolved_;
    cost_.worst_residual = std::max(cost_.worst_residual, residual_);
    clear();
  }
  /// Returns the number of unsolved problems since clear().
  [[nodiscard]] long unsolved() const { return unsolved_; }

 private:
  SceneCost& cost_;
  long unsolved_ = 0;    // unsolved problems since clear()
  double residual_ = 0;  // largest residual since clear() [1]
};

/// Result of a trial of one step.
struct StepTrial {
  SceneState state;                   // state at the end
  std::vector<ActiveContact> active;  // contacts of the last substep, with impulses over `h`
  double h = 0;                       // length of the last substep [s]
  double error = 0;                   // error estimate over the tolerance [1]
  int order = 1;                      // exponent of the error in the step length
  bool is_smooth = true;              // no contact changed its mode; the state is extrapolated
  double closing_time = -1;  // time from the start until a gap closes [s]; < 0: none closes
  double change_time = -1;   // time from the start until the first mode change [s]; < 0: none
};

/// Integrator of trial steps from one state. Owns their workspace.
class StepTrials {
 public:
  /// @param step, options, counts  must outlive the object
  /// @param like  any state of the scene, for the sizes
  StepTrials(ContactStep& step, const SceneOptions& options, ProblemCounts& counts,
             const SceneState& like);

  /// State and contacts at which a step starts.
  struct Beginning {
    const SceneState& state;
    const std::vector<ActiveContact>& closed;  // contacts that touch
    double impulse_time;                       // time over which their impulses acted [s]
  };
  /// Integrates one trial; stops early at a closing gap or an overflow. Sets result() and
  /// extrapolation().
  /// @param length  [s]
  void try_step(const Beginning& from, double length);

  [[nodiscard]] StepTrial& result() { return table_[result_]; }
  /// Returns the extrapolation of the last trial: its verdict, if it gave one, and its proposal for
  /// the length of the next step or trial.
  [[nodiscard]] Extrapolation& extrapolation() { return extrapolation_; }
  /// Finds the contacts at the end of the result, unless try_step() has done so.
  void find_end_contacts();
  /// Returns these contacts.
  [[nodiscard]] std::vector<ActiveContact>& end_contacts() { return found_; }
  /// Discards the rates that the next free step would reuse.
  void discard_rates() { free_.discard_first_stage(); }

 private:
  [[nodiscard]] bool extrapolate_column(StepTrial& column, int n);
  [[nodiscard]] bool take_substeps(const Beginning& from, double length, int n, StepTrial& column);
  [[nodiscard]] double estimate_closing_time(double h, int substep) const;
  [[nodiscard]] double scaled_difference(const SceneState& a, const SceneState& b,
                                         double horizon) const;
  void take_free_step(const Beginning& from, double length);
  void check_middle(const Beginning& from, double length, StepTrial& trial);
  void check_end(const Beginning& from, double length, StepTrial& trial);

  ContactStep& step_;
  const SceneOptions& options_;
  ProblemCounts& counts_;
  std::array<StepTrial, Extrapolation::kMaxColumns> table_;  // one trial per column
  int result_ = 0;                               // column of table_ that holds the result
  bool checked_end_ = false;                     // found_ holds the contacts at the result's end
  std::vector<ActiveContact> found_;             // contacts of the last search
  std::vector<ActiveContact> earlier_contacts_;  // contacts of the last substep but one
  SceneState middle_;                            // workspace of check_middle()
  StepOutcome outcome_;
  FreeStep free_;
  Extrapolation extrapolation_;
};

}  // namespace thenar
