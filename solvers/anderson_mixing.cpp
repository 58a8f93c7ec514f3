#include "solvers/anderson_mixing.h"

#include <Eigen/QR>

namespace thenar {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

void AndersonMixing::clear() {
  steps_.clear();
  changes_.clear();
  motion_.resize(0);
}

VectorXd AndersonMixing::next(const VectorXd& motion) {
  // Store the last step and the change of the increment along it.
  if (motion_.size() == motion.size()) {
    changes_.emplace_back(motion - motion_);
    steps_.push_back(step_);
    if (steps_.size() > window_) {
      steps_.erase(steps_.begin());
      changes_.erase(changes_.begin());
    }
  }
  motion_ = step_ = motion;
  if (changes_.empty()) return step_;
  // Subtract the combination of changes that minimises the increment.
  const auto count = static_cast<Index>(changes_.size());
  MatrixXd change(motion.size(), count), step(motion.size(), count);
  for (Index k = 0; k < count; ++k) {
    change.col(k) = changes_[k];
    step.col(k) = steps_[k];
  }
  step_ -= (step + change) * change.colPivHouseholderQr().solve(motion);
  return step_;
}

}  // namespace thenar
