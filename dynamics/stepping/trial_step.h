#pragma once

/// Trials of one step between events: extrapolated substeps on contacts, or a free step.

#include <algorithm>
#include <array>
#include <vector>

#include "dynamics/stepping/contact_step.h"
#include "dynamics/stepping/extrapolation.h"
#include "dynamics/stepping/free_step.h"
#include "dynamics/stepping/scene_run.h"

namespace thenar {

/// Counts contact problems, of which those of accepted steps belong to the run.
class ProblemCounts {
 public:
  explicit ProblemCounts(SceneCost& cost) : cost_(cost) {}

  /// Counts a contact problem of a trial, which may be rejected.
  void count(const StepOutcome& outcome) {
    ++cost_.substeps;
    if (!outcome.solved) ++unsolved_;
    residual_ = std::max(residual_, outcome.residual);
  }
  /// Counts a free step, and whether all elements could act.
  void count_free(bool acted) {
    if (!acted) ++unsolved_;
  }
  void count_stages(long stages) { cost_.substeps += stages; }
  void forget() { unsolved_ = 0, residual_ = 0; }
  /// Adds the contact problems since forget() to the run.
  void accept() {
    cost_.unsolved += unsolved_;
    cost_.worst_residual = std::max(cost_.worst_residual, residual_);
    forget();
  }
  /// Problems since forget() that were not solved.
  [[nodiscard]] long unsolved() const { return unsolved_; }

 private:
  SceneCost& cost_;
  long unsolved_ = 0;
  double residual_ = 0;  // [1]
};

/// Result of a trial of one step.
struct StepTrial {
  SceneState state;
  std::vector<ActiveContact> active;  // of its last substep, impulses over `h`
  double h = 0;                       // of that substep [s]
  double error = 0;                   // over the tolerance [1]
  int order = 1;                      // of the error in the length
  bool smooth = true;                 // extrapolated: all modes stayed
  double closes = -1;                 // >= 0: a gap closes about then, after the step began [s]
  double changes = -1;                // >= 0: the first mode changes about then, likewise [s]
};

/// Tries steps from one state. Owns the room that they need.
class StepTrials {
 public:
  using Verdict = Extrapolation::Verdict;

  /// @param step, options, counts  outlive it
  StepTrials(ContactStep& step, const SceneOptions& options, ProblemCounts& counts,
             const SceneState& like);

  /// State and contacts from which steps are tried.
  struct Beginning {
    const SceneState& state;
    const std::vector<ActiveContact>& closed;  // contacts that touch
    double impulse_time;                       // over which their impulses acted [s]
  };
  /// Tries one step, up to the first sign that it is too long.
  void attempt(const Beginning& from, double length);

  [[nodiscard]] StepTrial& result() { return table_[static_cast<std::size_t>(result_)]; }
  /// Verdict on the last column, if any.
  [[nodiscard]] Verdict verdict() const { return verdict_; }
  /// Length of the step after one whose columns were judged [s].
  [[nodiscard]] double next_length(double length, double longest) {
    return columns_.next_length(length, longest, verdict_);
  }
  /// Finds contacts where the result ends, if the trial has not looked there.
  void find_end();
  /// Contacts that were found there.
  [[nodiscard]] std::vector<ActiveContact>& found() { return found_; }
  /// Forgets rates at the end of the last free step.
  void forget_rates() { free_.forget(); }

 private:
  [[nodiscard]] bool extrapolates(StepTrial& column);
  [[nodiscard]] bool substeps(const Beginning& from, double length, int n, StepTrial& column);
  [[nodiscard]] double closing_time(double h, int substep) const;
  [[nodiscard]] double difference(const SceneState& a, const SceneState& b, double horizon) const;
  void free_step(const Beginning& from, double length);
  void look_between(const Beginning& from, double length, StepTrial& trial);
  void inspect(const Beginning& from, double length, StepTrial& trial);

  ContactStep& step_;
  const SceneOptions& options_;
  ProblemCounts& counts_;
  std::array<StepTrial, Extrapolation::kMostColumns> table_;
  int result_ = 0;
  bool inspected_ = false;  // found_ belongs to the trial
  std::vector<ActiveContact> found_;
  std::vector<ActiveContact> earlier_;  // of the column, a substep before its last
  SceneState middle_;
  StepOutcome outcome_;
  FreeStep free_;
  Extrapolation columns_;
  Verdict verdict_ = Verdict::kGoOn;
};

}  // namespace thenar
