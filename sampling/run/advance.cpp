#include "sampling/run/advance.h"

namespace thenar {
namespace {

/// Samplers that have to advance, and the batch of their points. Memory is reused between batches.
class ChainBatch {
 public:
  explicit ChainBatch(const std::vector<Sampler*>& samplers) : samplers_(samplers) {}

  /// Collects the samplers below `steps`; returns false if there are none.
  bool gather(long steps) {
    // Count the points that they request.
    going_.clear();
    want_ = WithGradient::kNo;
    points_ = 0;
    for (std::size_t i = 0; i < samplers_.size(); ++i) {
      if (samplers_[i]->steps() >= steps) continue;
      going_.push_back(i);
      points_ += samplers_[i]->asks().cols();
      if (samplers_[i]->wants() == WithGradient::kYes) want_ = WithGradient::kYes;
    }
    return !going_.empty();
  }

  /// Evaluates the target at the requested points of all samplers.
  [[nodiscard]] Densities evaluate(const Target& target) {
    // Gather the points.
    x_.resize(target.size(), points_);
    Eigen::Index at = 0;
    for (const std::size_t i : going_) {
      const Eigen::MatrixXd& asks = samplers_[i]->asks();
      x_.middleCols(at, asks.cols()) = asks;
      at += asks.cols();
    }
    return target.evaluate(x_, want_);
  }

  /// Passes the densities to the samplers.
  void tell(const Densities& all, const StepObserver& observer) {
    Eigen::Index first = 0;
    for (const std::size_t i : going_) {
      // Each sampler gets the densities of its own points.
      Sampler& sampler = *samplers_[i];
      const Eigen::Index count = sampler.asks().cols();
      const long before = sampler.steps();
      sampler.tell(count == points_ ? all : part(all, first, count));
      first += count;
      if (observer && sampler.steps() > before) observer(i);
    }
  }

 private:
  /// Returns the densities of columns first .. first + count - 1.
  const Densities& part(const Densities& all, Eigen::Index first, Eigen::Index count) {
    part_.log_prior = all.log_prior.segment(first, count);
    part_.log_likelihood = all.log_likelihood.segment(first, count);
    if (want_ == WithGradient::kNo) return part_;
    part_.prior_gradient = all.prior_gradient.middleCols(first, count);
    part_.likelihood_gradient = all.likelihood_gradient.middleCols(first, count);
    return part_;
  }

  const std::vector<Sampler*>& samplers_;
  std::vector<std::size_t> going_;
  WithGradient want_ = WithGradient::kNo;
  Eigen::Index points_ = 0;
  Eigen::MatrixXd x_;  // (n, points)
  Densities part_;
};

}  // namespace

void advance(const std::vector<Sampler*>& samplers, const Target& target, long steps,
             const StepObserver& observer, const std::function<bool()>& stop) {
  ChainBatch batch(samplers);
  while (batch.gather(steps)) {
    if (stop && stop()) return;
    batch.tell(batch.evaluate(target), observer);
  }
}

}  // namespace thenar
