#include "sampling/methods/hamiltonian_warm_up.h"

#include <algorithm>

#include "base/numbers.h"
#include "base/units.h"

namespace thenar::internal {
namespace {

constexpr long kMinAdaptiveSteps = 20;  // minimum length of a warm-up that adapts the metric
// Maximum length of a leapfrog step along orbits [rad]: two such steps are the longest trajectory
// of JitteredLength, and four points of a NUTS tree detect a U-turn.
constexpr double kLongestTurn = 0.8 * kPi / 2;

/// Returns the length of the first window [steps].
int first_window(Metric metric, int n) {
  return metric == Metric::kDense ? std::max(25, 2 * n) : 25;
}

}  // namespace

MetricWindows metric_windows(long warm_up, int first_window) {
  if (warm_up < kMinAdaptiveSteps) return {warm_up, {}};
  // Windows lie between the initial steps and those that adapt the step size.
  MetricWindows windows;
  windows.first = std::min<long>(20, warm_up * 15 / 100);
  const long last = warm_up - std::min<long>(50, warm_up * 35 / 100);
  long begin = windows.first;
  for (long length = first_window; begin < last; length *= 2) {
    // Extend a window to the end if the next one, of twice the length, would not fit.
    const long end = begin + 3 * length <= last ? begin + length : last;
    windows.ends.push_back(end);
    begin = end;
  }
  return windows;
}

WarmUp::WarmUp(const Eigen::VectorXd& start, double target_acceptance,
               const SamplerOptions& options)
    : steps_(options.warm_up),
      windows_(metric_windows(options.warm_up,
                              first_window(options.metric, static_cast<int>(start.size())))),
      whitening_(options.metric, start, options.covariance),
      draws_(static_cast<int>(start.size())),
      averaging_(target_acceptance) {
  search_.start(1);
}

double WarmUp::max_step() const { return whitening_.follows_orbits() ? kLongestTurn : kInfinity; }

double WarmUp::step() const { return std::min(searching_ ? search_.step() : step_, max_step()); }

void WarmUp::learn_trial(double energy_error) {
  // End the search at the maximum step size.
  const bool longest = search_.step() >= max_step();
  if (!search_.learn(energy_error) && !longest) return;
  searching_ = false;
  // In a short warm-up, start cautiously: dual averaging soon tries ten times the step size.
  const bool brief = steps_ < kMinAdaptiveSteps;
  step_ = brief ? search_.step() / 2 : search_.step();
  averaging_.restart(step_, brief ? 1 : 10);
}

bool WarmUp::learn(long step, const Eigen::VectorXd& x, const Eigen::VectorXd& gradient,
                   double acceptance) {
  if (step > steps_) return false;
  averaging_.learn(acceptance, max_step());
  step_ = averaging_.step();
  // Collect draws within windows, and update the metric at the end of each one.
  if (step > windows_.first && !metric_settled(step - 1)) draws_.add(x, gradient);
  return std::binary_search(windows_.ends.begin(), windows_.ends.end(), step) && learn_metric();
}

void WarmUp::freeze_after_warm_up(long step) {
  if (step < steps_) return;
  // End an unfinished search with its next trial; otherwise use the averaged step size.
  if (searching_)
    step_ = search_.step();
  else if (step == steps_)
    step_ = averaging_.averaged_step();
  searching_ = false;
}

bool WarmUp::metric_settled(long steps) const {
  return windows_.ends.empty() || steps >= windows_.ends.back();
}

bool WarmUp::learn_metric() {
  // Restart the step-size search after a change of the metric.
  const bool learnt = learn_whitening(draws_, whitening_);
  if (learnt) {
    search_.start(std::min(step_, max_step()));
    searching_ = true;
  }
  draws_.clear();
  return learnt;
}

void WarmUp::save(StateWriter& to) const {
  whitening_.save(to);
  draws_.save(to);
  averaging_.save(to);
  to.write(search_.step());
  to.write(step_);
  to.write(std::int64_t{searching_ ? 1 : 0});
}

void WarmUp::restore(StateReader& from) {
  whitening_.restore(from);
  draws_.restore(from);
  averaging_.restore(from);
  search_.start(from.number());
  step_ = from.number();
  searching_ = from.integer() != 0;
}

}  // namespace thenar::internal
