#include "pads/force_search.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

namespace thenar {
namespace {

constexpr int kMaxTrials = 60;       // solved and failed steps of a search
constexpr double kStepGrowth = 1.5;  // growth of the step in depth after a solved depth [1]
constexpr double kMaxStepRatio = 4;  // longest step in depth over the first [1]
// Shortest step in depth over the first; the search fails below it [1]
constexpr double kMinStepRatio = 1e-3;
// Least distance of a new depth from the ends of a bracket, over its length [1]
constexpr double kBracketMargin = 0.05;

/// Solution at a depth.
struct SolvedDepth {
  double depth = 0;  // distance from the goal's pose along its direction [m]
  double force = 0;  // [N]
  PressState state;
};

class ForceSearch {
 public:
  ForceSearch(const PressStepper& step, const PressGoal& goal, double first_step,
              const PressState& start)
      : step_(step),
        goal_(goal),
        start_(start),
        min_step_(kMinStepRatio * first_step),
        max_step_(kMaxStepRatio * first_step),
        depth_step_(first_step) {}

  PressOutcome run(PressState& state) {
    PressOutcome out;
    bool ended = false;
    // Try depths; once two of them bracket the force, also try Newton's method to the force itself.
    while (!ended && trials_ < kMaxTrials && depth_step_ > min_step_) {
      out = try_depth(next_depth());
      ended = out.status == Status::kStopped;
      if (out.status == Status::kSolved && below_ && above_) ended = solve_to_force(state, out);
    }
    if (!ended) out = failed_outcome(out);
    out.iterations = iterations_;
    return out;
  }

 private:
  /// Returns the next depth to try [m]: by linear interpolation between two depths that bracket the
  /// force, otherwise one step beyond the last.
  [[nodiscard]] double next_depth() const {
    const SolvedDepth* nearer = nearer_end();
    if (nearer == nullptr) return first_depth_;
    if (!above_) return below_->depth + depth_step_;
    if (!below_) return above_->depth - depth_step_;
    // Interpolate within the bracket, away from its ends, at most depth_step_ from the nearer one.
    const double part = (*goal_.force - below_->force) / (above_->force - below_->force);
    const double line = below_->depth + std::clamp(part, kBracketMargin, 1 - kBracketMargin) *
                                            (above_->depth - below_->depth);
    return nearer->depth + std::clamp(line - nearer->depth, -depth_step_, depth_step_);
  }

  PressOutcome try_depth(double depth) {
    // Press to the depth without a goal for the force.
    PressGoal goal = goal_;
    goal.force.reset();
    goal.X_PO.p += depth * goal_.along;
    const SolvedDepth* nearer = nearer_end();
    PressState answer;
    PressOutcome out = solve_from(nearer, goal, answer);
    if (out.status == Status::kSolved) {
      // Solved: move one end of the bracket, and lengthen the next step.
      const double force = goal_.along.dot(out.push.force);
      last_is_below_ = force < *goal_.force;
      (last_is_below_ ? below_ : above_) = SolvedDepth{depth, force, std::move(answer)};
      depth_step_ = std::min(kStepGrowth * depth_step_, max_step_);
    } else if (nearer != nullptr) {
      // Failed: try half the distance from the nearer end.
      depth_step_ = std::abs(depth - nearer->depth) / 2;
    } else {
      // Nothing is solved yet: start farther out, where the object presses less.
      first_depth_ -= depth_step_;
      depth_step_ = std::min(kStepGrowth * depth_step_, max_step_);
    }
    return out;
  }

  /// Returns the outcome of a failed search, with the forces between or beyond which it failed.
  [[nodiscard]] PressOutcome failed_outcome(PressOutcome out) const {
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

  /// Tries Newton's method to the force from the depth solved last. @return whether the search ends
  bool solve_to_force(PressState& state, PressOutcome& out) {
    PressGoal goal = goal_;
    const SolvedDepth& from = last_is_below_ ? *below_ : *above_;
    goal.X_PO.p += from.depth * goal_.along;
    PressState answer;
    const PressOutcome found = solve_from(&from, goal, answer);
    if (found.status == Status::kSolved) state = std::move(answer);
    out = found;
    return found.status == Status::kSolved || found.status == Status::kStopped;
  }

  /// Returns the end of the bracket whose force is nearer; null: nothing is solved yet.
  [[nodiscard]] const SolvedDepth* nearer_end() const {
    if (!below_ || !above_) return below_ ? &*below_ : above_ ? &*above_ : nullptr;
    return above_->force - *goal_.force < *goal_.force - below_->force ? &*above_ : &*below_;
  }

  /// Solves a step from the solution at a depth, with the history of the start.
  PressOutcome solve_from(const SolvedDepth* from, const PressGoal& goal, PressState& answer) {
    ++trials_;
    // Take displacements and forces from that solution, and the history from the start.
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
  double min_step_, max_step_;  // bounds of steps in depth [m]
  double depth_step_;           // step to the next depth [m]
  double first_depth_ = 0;      // first depth to try [m]
  std::optional<SolvedDepth> below_, above_;
  bool last_is_below_ = false;  // the depth solved last is below_
  int trials_ = 0, iterations_ = 0;
};

}  // namespace

PressOutcome seek_force(const PressStepper& step, const PressGoal& goal, double first_step,
                        PressState& state) {
  return ForceSearch(step, goal, first_step, state).run(state);
}

}  // namespace thenar
