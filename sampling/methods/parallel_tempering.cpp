#include "sampling/methods/parallel_tempering.h"

#include <cmath>
#include <limits>

#include "base/error.h"
#include "base/random_stream.h"
#include "sampling/methods/saved_shape.h"

namespace thenar {
namespace {

// Purpose of the random stream of swaps; no sampler uses it
constexpr std::uint32_t kSwapStream = 0x73776170;
constexpr double kLadderPower = 5;  // power of the initial ladder, from 1 down to 0
// Logarithm of zero likelihood [nat]
constexpr double kLogZeroLikelihood = -std::numeric_limits<double>::infinity();

/// Replaces a log likelihood of NaN or +inf by that of zero likelihood.
double sound(double log_likelihood) {
  return std::isnan(log_likelihood) || log_likelihood == -kLogZeroLikelihood ? kLogZeroLikelihood
                                                                             : log_likelihood;
}

/// Returns the probability that a colder and a hotter state are exchanged.
double swap_probability(double temper_drop, double cold, double hot) {
  cold = sound(cold);
  hot = sound(hot);
  if (hot == kLogZeroLikelihood) return 0;
  if (cold == kLogZeroLikelihood) return 1;
  return std::exp(std::min(0.0, temper_drop * (hot - cold)));
}

/// Returns the rejection rates between neighbours [1], unknown ones replaced by the mean of the
/// others; always positive, so that the barrier increases.
Eigen::VectorXd known_rejection_rates(const Eigen::VectorXd& rejection_rate) {
  constexpr double kMinRejection = 1e-3;  // minimum rejection rate of a pair [1]
  // Average the known rates.
  double sum = 0;
  int known = 0;
  for (const double r : rejection_rate)
    if (!std::isnan(r)) sum += r, ++known;
  const double mean = known > 0 ? sum / known : 1;
  Eigen::VectorXd all = rejection_rate;
  for (double& r : all) r = std::max(kMinRejection, std::isnan(r) ? mean : r);
  return all;
}

}  // namespace

Eigen::VectorXd temperature_ladder(int temperatures, double min_beta) {
  require(temperatures >= 1, "temperatures must be >= 1, got {}", temperatures);
  // Geometric ladder, or by the fifth power down to the prior.
  Eigen::VectorXd beta = Eigen::VectorXd::Ones(temperatures);
  if (temperatures == 1) return beta;
  require(min_beta >= 0 && min_beta < 1, "least temper must be in 0 .. below 1, got {}", min_beta);
  for (int i = 1; i < temperatures; ++i) {
    const double part = double(i) / (temperatures - 1);
    beta[i] = min_beta > 0 ? std::pow(min_beta, part) : std::pow(1 - part, kLadderPower);
  }
  return beta;
}

Swaps decide_swaps(const Eigen::VectorXd& beta, const Eigen::MatrixXd& log_likelihood,
                   std::uint64_t seed, std::uint32_t group, std::uint32_t round) {
  require(beta.size() >= 1 && log_likelihood.cols() == beta.size(),
          "{} temperatures, likelihoods of {}", beta.size(), log_likelihood.cols());
  const Eigen::Index walkers = log_likelihood.rows(), pairs = beta.size() - 1;
  // Even pairs swap in even rounds, odd pairs in odd ones, with one random stream.
  Swaps swaps{SwapMask::Constant(walkers, pairs, false), SwapMask::Constant(walkers, pairs, false),
              Eigen::ArrayXXd::Zero(walkers, pairs)};
  RandomStream random(seed, group, round, kSwapStream);
  for (Eigen::Index i = round % 2; i < pairs; i += 2)
    for (Eigen::Index w = 0; w < walkers; ++w) {
      swaps.tried(w, i) = true;
      swaps.probability(w, i) =
          swap_probability(beta[i] - beta[i + 1], log_likelihood(w, i), log_likelihood(w, i + 1));
      swaps.exchange(w, i) = random.uniform() < swaps.probability(w, i);
    }
  return swaps;
}

SwapCounts::SwapCounts(int temperatures)
    : tried(Eigen::VectorXd::Zero(temperatures - 1)), accepted(tried), probability(tried) {}

void SwapCounts::add(const Swaps& swaps) {
  tried += swaps.tried.cast<double>().colwise().sum().matrix().transpose();
  accepted += swaps.exchange.cast<double>().colwise().sum().matrix().transpose();
  probability += swaps.probability.colwise().sum().matrix().transpose();
}

Eigen::VectorXd SwapCounts::swap_rate() const { return accepted.cwiseQuotient(tried); }

Eigen::VectorXd SwapCounts::rejection_rate() const {
  return (1 - probability.cwiseQuotient(tried).array()).matrix();
}

void SwapCounts::save(StateWriter& to) const {
  to.write(tried);
  to.write(accepted);
  to.write(probability);
}

void SwapCounts::restore(StateReader& from) {
  const Eigen::Index pairs = tried.size();
  tried = internal::saved_vector(from, "swaps that were tried", pairs);
  accepted = internal::saved_vector(from, "swaps that were accepted", pairs);
  probability = internal::saved_vector(from, "probabilities of swaps", pairs);
}

Eigen::VectorXd adapted_ladder(const Eigen::VectorXd& beta, const Eigen::VectorXd& rejection_rate) {
  require(beta.size() >= 1 && rejection_rate.size() == beta.size() - 1,
          "{} temperatures, refusals of {} pairs", beta.size(), rejection_rate.size());
  // Communication barrier between neighbours, as a function of beta^(1/5).
  const Eigen::VectorXd steps = known_rejection_rates(rejection_rate);
  const Eigen::VectorXd s = beta.array().pow(1 / kLadderPower);
  const Eigen::Index pairs = steps.size();
  Eigen::VectorXd ladder = beta;
  double passed = 0;  // barrier up to temperature `below`
  Eigen::Index below = 0;
  for (Eigen::Index i = 1; i < pairs; ++i) {
    // Interpolate the temperature at the i-th equal part.
    const double wanted = steps.sum() * double(i) / double(pairs);
    while (below < pairs - 1 && passed + steps[below] < wanted) passed += steps[below++];
    const double part = (wanted - passed) / steps[below];
    ladder[i] = std::pow(s[below] + part * (s[below + 1] - s[below]), kLadderPower);
  }
  return ladder;
}

}  // namespace thenar
