#include "sampling/methods/hamiltonian_warm_up.h"

#include <algorithm>

#include "base/numbers.h"
#include "base/units.h"

namespace thenar::internal {
namespace {

constexpr long kMinAdaptiveSteps = 20;  // Fewest steps of a warm-up that learns a metric
// Along orbits two leapfrogs of this length are the longest trajectory of JitteredLength, and four
// points of a tree of NUTS see that they turn [rad].
constexpr double kLongestTurn = 0.8 * kPi / 2;

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

double WarmUp::greatest_step() const { return whitening_.orbits() ? kLongestTurn : kInfinity; }

double WarmUp::step() const {
  return std::min(searching_ ? search_.step() : step_, greatest_step());
}

void WarmUp::learn_trial(double energy_error) {
  // The search ends at the greatest step.
  const bool longest = search_.step() >= greatest_step();
  if (!search_.learn(energy_error) && !longest) return;
  searching_ = false;
  // Ten times as much is tried soon, which a short warm-up would not recover from.
  const bool brief = steps_ < kMinAdaptiveSteps;
  step_ = brief ? search_.step() / 2 : search_.step();
  averaging_.restart(step_, brief ? 1 : 10);
}

bool WarmUp::learn(long step, const Eigen::VectorXd& x, const Eigen::VectorXd& gradient,
                   double acceptance) {
  if (step > steps_) return false;
  averaging_.learn(acceptance, greatest_step());
  step_ = averaging_.step();
  // Draws within windows are gathered; each window's end learns the metric anew.
  if (step > windows_.first && !metric_settled(step - 1)) draws_.add(x, gradient);
  return std::binary_search(windows_.ends.begin(), windows_.ends.end(), step) && learn_metric();
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

bool WarmUp::learn_metric() {
  // In another metric the step size is searched again.
  const bool learnt = learn_whitening(draws_, whitening_);
  if (learnt) {
    search_.start(std::min(step_, greatest_step()));
    searching_ = true;
  }
  draws_.clear();
  return learnt;
}

void WarmUp::save(StateWriter& to) const {
  whitening_.save(to);
  draws_.save(to);
  averaging_.save(to);
  to.put(search_.step());
  to.put(step_);
  to.put(std::int64_t{searching_ ? 1 : 0});
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
