#include "dynamics/stepping/step_control.h"

#include <algorithm>
#include <cmath>

namespace thenar {
namespace {

// Ratios of step lengths [1].
constexpr double kQuietFactor = 5;      // longest step of a quiet scene over SceneOptions::max_step
constexpr double kChangeMargin = 0.97;  // step before a mode change over the time to the change
constexpr double kAfterChangeRatio = 0.5;   // shortest step after a mode change over the usual one
constexpr double kModeChangeGrowth = 1.5;   // step after one that contains a mode change over it
constexpr double kClosingRatio = 0.999999;  // longest repetition over a trial in which a gap closed
constexpr double kSafety = 0.9;             // safety factor of repeated steps
constexpr double kFreeSafety = 0.8;         // safety factor of the step after a free step

// PI controller of free steps [Hairer1993]: exponents of the errors times the order [1].
constexpr double kErrorExponent = 0.7, kLastErrorExponent = 0.4;
constexpr double kMinError = 1e-9;  // smaller errors do not lengthen the next step further [1]

}  // namespace

void StepControl::set_max_length(bool is_quiet) {
  max_length_ = (is_quiet ? kQuietFactor : 1) * options_.max_step;
}

double StepControl::first_trial_length(double t, double wanted) {
  rejected_ = is_shortened_for_change_ = ends_before_change_ = false;
  double length = wanted;
  // End just before the mode change that a rejected trial of the previous step predicted.
  const double ahead = kChangeMargin * (expected_change_ - t);
  if (ahead > options_.min_step && ahead < length) {
    is_shortened_for_change_ = ends_before_change_ = true;
    length = ahead;
  }
  expected_change_ = -1;
  return length;
}

double StepControl::cap_at_max_step() {
  rejected_ = true;
  return options_.max_step;
}

void StepControl::record_rejection() {
  rejected_ = true;
  ends_before_change_ = false;
}

double StepControl::shorten_for_elements(double step_error, double length) {
  record_rejection();
  // The error of elements is quadratic in the step length.
  return std::max(length * std::clamp(kSafety / std::sqrt(step_error), 0.2, 0.8),
                  options_.min_step);
}

double StepControl::shorten_after_rejection(StepTrials& trials, double t, double length) {
  const StepTrial& trial = trials.result();
  record_rejection();
  if (trial.closing_time >= 0 && trial.closing_time > options_.min_step) {
    // End at the instant at which the gap closes.
    length = std::min(trial.closing_time, kClosingRatio * length);
  } else if (trials.extrapolation().verdict() == Extrapolation::Verdict::kReject) {
    length = trials.extrapolation().plan_next(length, max_length_);
  } else if (trial.is_smooth && std::isfinite(trial.error)) {
    // Scale by the error and its order in the length.
    length *= std::clamp(kSafety * std::pow(trial.error, -1.0 / trial.order), 0.1, 0.9);
  } else {
    // End just before the mode change if it is in the first half; otherwise halve the step, and
    // remember the change for the next one.
    is_shortened_for_change_ = true;
    ends_before_change_ =
        trial.change_time >= 0 && kChangeMargin * trial.change_time < 0.5 * length;
    if (trial.change_time >= 0 && !ends_before_change_) expected_change_ = t + trial.change_time;
    length = ends_before_change_ ? kChangeMargin * trial.change_time : 0.5 * length;
  }
  return std::max(length, options_.min_step);
}

double StepControl::next_step_length(StepTrials& trials, double length) {
  const StepTrial& trial = trials.result();
  double next = length_by_error(trials, length);
  if (!trial.is_smooth) {
    // After a mode change, return towards the usual length.
    next = std::max(next, kAfterChangeRatio * usual_length_);
  } else if (ends_before_change_) {
    // Cross the change that is just ahead with a short step.
    next = 2 * (1 - kChangeMargin) * length;
  } else if (!is_shortened_for_change_ && !was_shortened_for_change_) {
    usual_length_ = next;
  }
  was_shortened_for_change_ = is_shortened_for_change_ && trial.is_smooth;
  return next;
}

/// Computes the length of the next step from the error, no longer than this one after a rejection
/// [s].
double StepControl::length_by_error(StepTrials& trials, double length) {
  const StepTrial& trial = trials.result();
  if (!trial.is_smooth) return length * (rejected_ ? 1 : kModeChangeGrowth);
  const double next = trials.extrapolation().verdict() == Extrapolation::Verdict::kAccept
                          ? trials.extrapolation().plan_next(length, max_length_)
                          : length * free_growth(trial);
  return rejected_ ? std::min(next, length) : next;
}

/// Computes the growth of the step length by PI control [Hairer1993], from the errors of this free
/// step and of the previous one [1]. The gains are cautious: hardly any step is rejected.
double StepControl::free_growth(const StepTrial& trial) {
  const double error = std::max(trial.error, kMinError);
  const double growth = kFreeSafety * std::pow(error, -kErrorExponent / trial.order) *
                        std::pow(last_error_, kLastErrorExponent / trial.order);
  last_error_ = error;
  return std::clamp(growth, 0.2, 4.0);
}

}  // namespace thenar
