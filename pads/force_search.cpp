#include "pads/force_search.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

namespace thenar {
namespace {

constexpr int kMostTrials = 60;  // Most depths that a search tries
// The next step in depth grows by this factor after a depth is solved [1]
constexpr double kWayGrowth = 1.5;
constexpr double kLongestWay = 4;  // Longest step in depth, over the first [1]
// Shortest step in depth, over the first; the search ends below it [1]
constexpr double kLeastWayShare = 1e-3;
// A new depth keeps this share of a bracket away from both of its ends [1]
constexpr double kEndShare = 0.05;

/// A depth that was solved.
struct SolvedDepth {
  double depth = 0;  // from the goal's pose [m]
  double force = 0;  // [N]
  PressState state;
};

class ForceSearch {
 public:
  ForceSearch(const PressStepper& step, const PressGoal& goal, double first,
              const PressState& start)
      : step_(step),
        goal_(goal),
        start_(start),
        shortest_(kLeastWayShare * first),
        longest_(kLongestWay * first),
        way_(first) {}

  PressOutcome run(PressState& state) {
    PressOutcome out;
    bool ended = false;
    // Depths until two enclose the force, then each time Newton's method to the force itself.
    while (!ended && trials_ < kMostTrials && way_ > shortest_) {
      out = try_depth(next_depth());
      ended = out.status == Status::kStopped;
      if (out.status == Status::kSolved && below_ && above_) ended = ends(state, out);
    }
    if (!ended) out = without_answer(out);
    out.iterations = iterations_;
    return out;
  }

 private:
  /// Returns the next depth to try [m]: by linear interpolation between two depths that enclose the
  /// force, otherwise one step beyond the last.
  [[nodiscard]] double next_depth() const {
    const SolvedDepth* near = nearest();
    if (near == nullptr) return first_depth_;
    if (!above_) return below_->depth + way_;
    if (!below_) return above_->depth - way_;
    // Interpolate within the bracket, off its ends, no farther than way_ from the nearer one.
    const double part = (*goal_.force - below_->force) / (above_->force - below_->force);
    const double line = below_->depth + std::clamp(part, kEndShare, 1 - kEndShare) *
                                            (above_->depth - below_->depth);
    return near->depth + std::clamp(line - near->depth, -way_, way_);
  }

  PressOutcome try_depth(double depth) {
    // Press to the depth, whatever the force.
    PressGoal goal = goal_;
    goal.force.reset();
    goal.X_PO.p += depth * goal_.along;
    const SolvedDepth* near = nearest();
    PressState answer;
    PressOutcome out = step_from(near, goal, answer);
    if (out.status == Status::kSolved) {
      // Solved: one end of the bracket moves, and the next way may be longer.
      const double force = goal_.along.dot(out.push.force);
      was_below_ = force < *goal_.force;
      (was_below_ ? below_ : above_) = SolvedDepth{depth, force, std::move(answer)};
      way_ = std::min(kWayGrowth * way_, longest_);
    } else if (near != nullptr) {
      // Not solved: half the way from the nearer end.
      way_ = std::abs(depth - near->depth) / 2;
    } else {
      // Nothing is solved yet: begin farther off, where the object presses less.
      first_depth_ -= way_;
      way_ = std::min(kWayGrowth * way_, longest_);
    }
    return out;
  }

  /// Returns the outcome of a search without an answer, with the forces between or beyond which it
  /// failed.
  [[nodiscard]] PressOutcome without_answer(PressOutcome out) const {
    if (out.status == Status::kSolved) out.status = Status::kStalled;
    const std::string why = out.message.empty() ? "too many trials" : out.message;
    if (below_ && above_)
      out.message = fmt::format("no solution between {:.3g} and {:.3g} N: {}", below_->force,
                                above_->force, why);
    else if (below_)
      out.message = fmt::format("no solution beyond {:.3g} N: {}", below_->force, why);
    else
      out.message = why;
    return out;
  }

  /// Newton's method from the depth that was solved last. @return whether it ended the search
  bool ends(PressState& state, PressOutcome& out) {
    PressGoal goal = goal_;
    const SolvedDepth& from = was_below_ ? *below_ : *above_;
    goal.X_PO.p += from.depth * goal_.along;
    PressState answer;
    const PressOutcome found = step_from(&from, goal, answer);
    if (found.status == Status::kSolved) state = std::move(answer);
    out = found;
    return found.status == Status::kSolved || found.status == Status::kStopped;
  }

  /// The end whose force is nearer; null: nothing was solved.
  [[nodiscard]] const SolvedDepth* nearest() const {
    if (!below_ || !above_) return below_ ? &*below_ : above_ ? &*above_ : nullptr;
    return above_->force - *goal_.force < *goal_.force - below_->force ? &*above_ : &*below_;
  }

  /// Solves a step from an answer, with the history of the beginning.
  PressOutcome step_from(const SolvedDepth* from, const PressGoal& goal, PressState& answer) {
    ++trials_;
    // Displacements and forces of the answer, history of the beginning.
    answer = start_;
    if (from != nullptr) {
      answer.x = from->state.x;
      answer.pressure = from->state.pressure;
      answer.normal_force = from->state.normal_force;
      answer.friction_force = from->state.friction_force;
      answer.spring_stiffness = from->state.spring_stiffness;
    }
    PressOutcome out = step_(goal, answer);
    iterations_ += out.iterations;
    return out;
  }

  const PressStepper& step_;
  const PressGoal& goal_;
  const PressState start_;
  double shortest_, longest_;  // of ways [m]
  double way_;                 // to the next depth [m]
  double first_depth_ = 0;     // where the first is sought [m]
  std::optional<SolvedDepth> below_, above_;
  bool was_below_ = false;  // the last depth that was solved
  int trials_ = 0, iterations_ = 0;
};

}  // namespace

PressOutcome seek_force(const PressStepper& step, const PressGoal& goal, double first,
                        PressState& state) {
  return ForceSearch(step, goal, first, state).run(state);
}

}  // namespace thenar
