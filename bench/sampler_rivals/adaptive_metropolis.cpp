#include "bench/sampler_rivals/adaptive_metropolis.h"

#include <cmath>
#include <utility>

#include <Eigen/Cholesky>

namespace thenar::bench {

HaarioMetropolis::HaarioMetropolis(Density density, const Eigen::VectorXd& start,
                                   Eigen::MatrixXd covariance, const Options& options)
    : density_(std::move(density)),
      options_(options),
      rng_(options.seed),
      x_(start),
      proposal_(start.size()),
      w_(start.size()),
      mean_(start),
      deviation_(start.size()),
      value_(density_(start)),
      covariance_(std::move(covariance)) {
  factor();
}

void HaarioMetropolis::step() {
  for (Eigen::Index i = 0; i < w_.size(); ++i) w_[i] = normal_(rng_);
  proposal_.noalias() = L_.triangularView<Eigen::Lower>() * w_;
  proposal_ += x_;
  const double value = density_(proposal_);
  const double u = std::uniform_real_distribution<double>()(rng_);
  if (std::log(u) < value - value_) {
    x_.swap(proposal_);
    value_ = value;
    ++accepted_;
  }
  ++steps_;
  learn();
  if (steps_ % options_.refactor_every == 0) factor();
}

// Mean and covariance of all states, by one more.
void HaarioMetropolis::learn() {
  const double g = 1.0 / static_cast<double>(options_.guess_weight + steps_);
  deviation_ = x_ - mean_;
  mean_ += g * deviation_;
  covariance_ *= 1 - g;
  covariance_.selfadjointView<Eigen::Lower>().rankUpdate(deviation_, g * (1 - g));
}

void HaarioMetropolis::factor() {
  const auto n = covariance_.rows();
  const Eigen::MatrixXd regular = covariance_ + options_.epsilon * Eigen::MatrixXd::Identity(n, n);
  const Eigen::LLT<Eigen::MatrixXd> llt(regular);
  if (llt.info() == Eigen::Success)
    L_ = 2.4 / std::sqrt(double(n)) * Eigen::MatrixXd(llt.matrixL());
}

}  // namespace thenar::bench
