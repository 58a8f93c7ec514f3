#include "sampling/methods/step_size.h"

#include <algorithm>
#include <cmath>

namespace thenar::internal {

void DualAveraging::restart(double step, double bias) {
  count_ = error_ = 0;
  log_step_ = log_averaged_ = std::log(step);
  log_bias_ = std::log(bias * step);
}

void DualAveraging::learn(double acceptance, double max_step) {
  ++count_;
  const double weight = 1 / (count_ + 10);
  error_ += weight * (target_ - acceptance - error_);
  log_step_ = std::min(log_bias_ - error_ * std::sqrt(count_) / 0.05, std::log(max_step));
  log_averaged_ += std::pow(count_, -0.75) * (log_step_ - log_averaged_);
}

double DualAveraging::step() const { return std::exp(log_step_); }

double DualAveraging::averaged_step() const { return std::exp(log_averaged_); }

void DualAveraging::save(StateWriter& to) const {
  for (const double value : {count_, log_bias_, error_, log_step_, log_averaged_}) to.write(value);
}

void DualAveraging::restore(StateReader& from) {
  for (double* value : {&count_, &log_bias_, &error_, &log_step_, &log_averaged_})
    *value = from.number();
}

void StepSearch::start(double step) {
  step_ = step;
  trial_count_ = 0;
}

bool StepSearch::learn(double energy_error) {
  // Limit of 2^60 either way, for targets without scale.
  constexpr int kMaxTries = 60;
  const bool accepted = -energy_error > std::log(0.8);
  if (trial_count_++ == 0) grow_ = accepted;
  if (accepted != grow_ || trial_count_ > kMaxTries) return true;
  step_ *= grow_ ? 2 : 0.5;
  return false;
}

}  // namespace thenar::internal
