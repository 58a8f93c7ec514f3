#include "sampling/methods/hamiltonian_warm_up.h"

#include <algorithm>

namespace thenar::internal {
namespace {

constexpr long kMinAdaptiveSteps = 20;  // of a warm-up that learns a metric

int first_window(Metric metric, int n) {
  return metric == Metric::kDense ? std::max(25, 2 * n) : 25;
}

}  // namespace

MetricWindows metric_windows(long warm_up, int first_window) {
  if (warm_up < kMinAdaptiveSteps) return {warm_up, {}};
  // Between the steps that find the typical set and those that settle the step size.
  MetricWindows windows;
  windows.first = std::min<long>(20, warm_up * 15 / 100);
  const long last = warm_up - std::min<long>(50, warm_up * 35 / 100);
  long begin = windows.first;
  for (long length = first_window; begin < last; length *= 2) {
    // A window that leaves no room for the next, which has twice the length, takes all.
    const long end = begin + 3 * length <= last ? begin + length : last;
    windows.ends.push_back(end);
    begin = end;
  }
  return windows;
}

WarmUp::WarmUp(int n, double target_acceptance, const SamplerOptions& options)
    : steps_(options.warm_up),
      windows_(metric_windows(options.warm_up, first_window(options.metric, n))),
      metric_(options.metric, n, options.covariance),
      estimate_(options.metric, n),
      averaging_(target_acceptance) {
  search_.start(1);
}

void WarmUp::learn_trial(double energy_error) {
  if (!search_.learn(energy_error)) return;
  searching_ = false;
  // Ten times as much is tried soon, which a short warm-up would not recover from.
  const bool brief = steps_ < kMinAdaptiveSteps;
  step_ = brief ? search_.step() / 2 : search_.step();
  averaging_.restart(step_, brief ? 1 : 10);
}

void WarmUp::learn(long step, const Eigen::VectorXd& x, double acceptance) {
  if (step > steps_) return;
  averaging_.learn(acceptance);
  step_ = averaging_.step();
  // Draws within windows are gathered; each window's end learns the metric anew.
  if (step > windows_.first && !metric_settled(step - 1)) estimate_.add(x);
  if (std::binary_search(windows_.ends.begin(), windows_.ends.end(), step)) learn_metric();
}

void WarmUp::settle(long step) {
  if (step < steps_) return;
  // A search that is not over ends with its next try, otherwise the average stays.
  if (searching_)
    step_ = search_.step();
  else if (step == steps_)
    step_ = averaging_.averaged();
  searching_ = false;
}

bool WarmUp::metric_settled(long steps) const {
  return windows_.ends.empty() || steps >= windows_.ends.back();
}

void WarmUp::learn_metric() {
  // In another metric the step size is searched again.
  if (estimate_.count() >= 2 && metric_.set(estimate_.shrunk(metric_.covariance()))) {
    searching_ = true;
    search_.start(step_);
  }
  estimate_.clear();
}

void WarmUp::save(StateWriter& to) const {
  metric_.save(to);
  estimate_.save(to);
  averaging_.save(to);
  to.put(search_.step());
  to.put(step_);
  to.put(std::int64_t{searching_ ? 1 : 0});
}

void WarmUp::restore(StateReader& from) {
  metric_.restore(from);
  estimate_.restore(from);
  averaging_.restore(from);
  search_.start(from.number());
  step_ = from.number();
  searching_ = from.integer() != 0;
}

}  // namespace thenar::internal
