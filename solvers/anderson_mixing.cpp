#include "solvers/anderson_mixing.h"

#include <Eigen/QR>

namespace thenar {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

void AndersonMixing::clear() {
  steps_.clear();
  increment_changes_.clear();
  increment_.resize(0);
}

VectorXd AndersonMixing::next_step(const VectorXd& increment) {
  // Store the last step and the change of the increment along it.
  if (increment_.size() == increment.size()) {
    increment_changes_.emplace_back(increment - increment_);
    steps_.push_back(step_);
    if (steps_.size() > window_) {
      steps_.erase(steps_.begin());
      increment_changes_.erase(increment_changes_.begin());
    }
  }
  increment_ = step_ = increment;
  if (increment_changes_.empty()) return step_;
  // Subtract the combination of changes that minimises the increment.
  const auto count = static_cast<Index>(increment_changes_.size());
  MatrixXd change(increment.size(), count), step(increment.size(), count);
  for (Index k = 0; k < count; ++k) {
    change.col(k) = increment_changes_[k];
    step.col(k) = steps_[k];
  }
  step_ -= (step + change) * change.colPivHouseholderQr().solve(increment);
  return step_;
}

}  // namespace thenar
