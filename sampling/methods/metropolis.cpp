#include "sampling/methods/metropolis.h"

#include <cmath>
#include <limits>

#include <Eigen/Cholesky>

#include "base/error.h"
#include "sampling/methods/saved_shape.h"
#include "sampling/methods/target.h"

namespace thenar::internal {
namespace {

// Logarithm of zero density [nat]
constexpr double kLogZeroDensity = -std::numeric_limits<double>::infinity();
// Purpose of the random stream that decides acceptance
constexpr std::uint32_t kAcceptStream = 0xacce;

/// Returns the acceptance probability of a proposal.
double acceptance(double now, double there, double log_proposal_ratio) {
  if (there == kLogZeroDensity) return 0;
  if (now == kLogZeroDensity) return 1;
  return std::exp(std::min(0.0, there - now + log_proposal_ratio));
}

}  // namespace

Metropolis::Metropolis(const Eigen::MatrixXd& starts, SamplerOptions options)
    : options_(std::move(options)),
      x_(starts),
      before_(starts),
      prior_(Eigen::VectorXd::Zero(starts.cols())),
      likelihood_(prior_),
      value_(prior_),
      stats_(static_cast<std::size_t>(starts.cols())) {
  proposals_.x = starts;
}

bool Metropolis::has_density(int chain) const { return value_[chain] > kLogZeroDensity; }

RandomStream Metropolis::random(int chain, std::uint32_t purpose) const {
  return {options_.seed, static_cast<std::uint32_t>(options_.first_chain + chain),
          stream_step(steps_), purpose};
}

void Metropolis::begin(const Densities& at) {
  begun_ = true;
  prior_ = at.log_prior;
  likelihood_ = at.log_likelihood;
  for (int k = 0; k < chains(); ++k) value_[k] = tempered_density(at, k, options_.beta).value;
}

void Metropolis::decide(const Densities& at, Eigen::Index point) {
  // Evaluate the tempered density at the proposal.
  const int k = proposals_.chain[static_cast<std::size_t>(point)];
  TemperedDensity there = tempered_density(at, point, options_.beta);
  if (!proposals_.x.col(point).allFinite()) there.value = kLogZeroDensity;  // not a valid point
  // Accept or reject.
  StepStats& stats = stats_[static_cast<std::size_t>(k)];
  stats = {};
  stats.evaluations = 1;
  stats.non_finite = there.non_finite ? 1 : 0;
  stats.acceptance = acceptance(value_[k], there.value, proposals_.log_proposal_ratio[point]);
  if (random(k, kAcceptStream).uniform() < stats.acceptance) {
    x_.col(k) = proposals_.x.col(point);
    prior_[k] = at.log_prior[point];
    likelihood_[k] = at.log_likelihood[point];
    value_[k] = there.value;
  }
  // Record the densities at the resulting position.
  stats.log_prior = prior_[k];
  stats.log_likelihood = likelihood_[k];
}

void Metropolis::tell(const Densities& at) {
  require(
      at.log_prior.size() == proposals_.x.cols() && at.log_likelihood.size() == proposals_.x.cols(),
      "{} points were asked, densities of {} came", proposals_.x.cols(), at.log_prior.size());
  // The first densities are those of the starts.
  if (!begun_) {
    begin(at);
  } else {
    for (Eigen::Index point = 0; point < proposals_.x.cols(); ++point) decide(at, point);
    // Complete the step after the last round.
    if (++round_ == rounds()) {
      if (steps_ < options_.warm_up) learn(before_);
      ++steps_;
      round_ = 0;
      before_ = x_;
    }
  }
  proposals_ = propose(round_);
}

void Metropolis::move(int chain, const Eigen::VectorXd& x, const Densities& at) {
  require(round_ == 0, "a chain can be moved between steps only");
  require(chain >= 0 && chain < chains() && x.size() == size(), "no chain {} of {} entries", chain,
          x.size());
  // Store position and densities.
  x_.col(chain) = x;
  before_.col(chain) = x;
  prior_[chain] = at.log_prior[0];
  likelihood_[chain] = at.log_likelihood[0];
  value_[chain] = tempered_density(at, 0, options_.beta).value;
  // Discard proposals from the previous position.
  if (begun_)
    proposals_ = propose(0);
  else
    proposals_.x = x_;
}

void Metropolis::set_beta(double beta) {
  require(round_ == 0, "a sampler can change its temper between steps only");
  options_.beta = beta;
  if (!begun_) return;
  for (int k = 0; k < chains(); ++k) value_[k] = tempered_density(density(k), 0, beta).value;
  proposals_ = propose(0);
}

Densities Metropolis::density(int chain) const {
  return {prior_.segment<1>(chain), likelihood_.segment<1>(chain), {}, {}};
}

void Metropolis::save(StateWriter& to) const {
  require(round_ == 0, "a sampler can be saved between steps only");
  // Positions and densities.
  to.write(std::int64_t{steps_});
  to.write(std::int64_t{begun_ ? 1 : 0});
  to.write(x_);
  to.write(prior_);
  to.write(likelihood_);
  // Statistics of the last step, and adapted quantities.
  for (const StepStats& stats : stats_) {
    to.write(stats.acceptance);
    to.write(std::int64_t{stats.evaluations});
    to.write(std::int64_t{stats.non_finite});
  }
  save_learnt(to);
}

void Metropolis::restore(StateReader& from) {
  // Steps and positions.
  steps_ = static_cast<long>(from.integer());
  begun_ = from.integer() != 0;
  x_ = saved_matrix(from, "positions", x_.rows(), x_.cols());
  before_ = x_;
  round_ = 0;
  // Statistics of the last step.
  const Eigen::VectorXd prior = saved_vector(from, "log priors", chains());
  const Eigen::VectorXd likelihood = saved_vector(from, "log likelihoods", chains());
  for (int k = 0; k < chains(); ++k) {
    StepStats& stats = stats_[static_cast<std::size_t>(k)];
    stats = {};
    stats.acceptance = from.number();
    stats.evaluations = static_cast<int>(from.integer());
    stats.non_finite = static_cast<int>(from.integer());
    stats.log_prior = prior[k];
    stats.log_likelihood = likelihood[k];
  }
  // Tempered densities, adapted quantities, and the next proposals.
  const bool begun = begun_;
  begin({prior, likelihood, {}, {}});
  begun_ = begun;
  restore_learnt(from);
  proposals_ = begun_ ? propose(0) : Proposals{{}, x_, {}};
}

Eigen::MatrixXd initial_covariance_factor(const SamplerOptions& options, int size) {
  if (options.covariance.size() == 0) return Eigen::MatrixXd::Identity(size, size);
  const Eigen::LLT<Eigen::MatrixXd> llt(options.covariance);
  require(llt.info() == Eigen::Success && options.covariance.allFinite(),
          "the guess of the covariance is not positive definite");
  return llt.matrixL();
}

}  // namespace thenar::internal
