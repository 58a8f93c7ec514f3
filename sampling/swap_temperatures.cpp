#include "sampling/swap_temperatures.h"

#include <cmath>
#include <limits>

#include "base/error.h"
#include "sampling/random_stream.h"

namespace thenar {
namespace {

constexpr std::uint32_t kSwapStream = 0x73776170;  // purpose of the stream: no sampler uses it
constexpr double kLadderPower = 5;
constexpr double kNothing = -std::numeric_limits<double>::infinity();

double sound(double log_likelihood) {
  return std::isnan(log_likelihood) || log_likelihood == -kNothing ? kNothing : log_likelihood;
}

/// P(exchange) of a colder and a hotter place.
double swap_probability(double temper_drop, double cold, double hot) {
  cold = sound(cold);
  hot = sound(hot);
  if (hot == kNothing) return 0;
  if (cold == kNothing) return 1;
  return std::exp(std::min(0.0, temper_drop * (hot - cold)));
}

/// What is refused between neighbours; never quite nothing, so that the barrier rises.
Eigen::VectorXd known_refusals(const Eigen::VectorXd& refused) {
  constexpr double kLeast = 1e-3;
  double sum = 0;
  int known = 0;
  for (const double r : refused)
    if (!std::isnan(r)) sum += r, ++known;
  const double mean = known > 0 ? sum / known : 1;
  Eigen::VectorXd all = refused;
  for (double& r : all) r = std::max(kLeast, std::isnan(r) ? mean : r);
  return all;
}

}  // namespace

Eigen::VectorXd temperature_ladder(int temperatures, double least) {
  require(temperatures >= 1, "temperatures must be >= 1, got {}", temperatures);
  Eigen::VectorXd temper = Eigen::VectorXd::Ones(temperatures);
  if (temperatures == 1) return temper;
  require(least >= 0 && least < 1, "least temper must be in 0 .. below 1, got {}", least);
  for (int i = 1; i < temperatures; ++i) {
    const double part = double(i) / (temperatures - 1);
    temper[i] = least > 0 ? std::pow(least, part) : std::pow(1 - part, kLadderPower);
  }
  return temper;
}

Swaps decide_swaps(const Eigen::VectorXd& temper, const Eigen::MatrixXd& log_likelihood,
                   std::uint64_t seed, std::uint32_t group, std::uint32_t round) {
  require(temper.size() >= 1 && log_likelihood.cols() == temper.size(),
          "{} temperatures, likelihoods of {}", temper.size(), log_likelihood.cols());
  const Eigen::Index walkers = log_likelihood.rows(), pairs = temper.size() - 1;
  Swaps swaps{SwapMask::Constant(walkers, pairs, false), SwapMask::Constant(walkers, pairs, false),
              Eigen::ArrayXXd::Zero(walkers, pairs)};
  RandomStream random(seed, group, round, kSwapStream);
  for (Eigen::Index i = round % 2; i < pairs; i += 2)
    for (Eigen::Index w = 0; w < walkers; ++w) {
      swaps.tried(w, i) = true;
      swaps.probability(w, i) = swap_probability(temper[i] - temper[i + 1], log_likelihood(w, i),
                                                 log_likelihood(w, i + 1));
      swaps.exchange(w, i) = random.uniform() < swaps.probability(w, i);
    }
  return swaps;
}

SwapTally::SwapTally(int temperatures)
    : tried(Eigen::VectorXd::Zero(temperatures - 1)), accepted(tried), probability(tried) {}

void SwapTally::add(const Swaps& swaps) {
  tried += swaps.tried.cast<double>().colwise().sum().matrix().transpose();
  accepted += swaps.exchange.cast<double>().colwise().sum().matrix().transpose();
  probability += swaps.probability.colwise().sum().matrix().transpose();
}

Eigen::VectorXd SwapTally::rate() const { return accepted.cwiseQuotient(tried); }

Eigen::VectorXd SwapTally::rejected() const {
  return (1 - probability.cwiseQuotient(tried).array()).matrix();
}

void SwapTally::save(StateWriter& to) const {
  to.put(tried);
  to.put(accepted);
  to.put(probability);
}

void SwapTally::restore(StateReader& from) {
  tried = from.matrix();
  accepted = from.matrix();
  probability = from.matrix();
}

Eigen::VectorXd adapted_ladder(const Eigen::VectorXd& temper, const Eigen::VectorXd& refused) {
  require(temper.size() >= 1 && refused.size() == temper.size() - 1,
          "{} temperatures, refusals of {} pairs", temper.size(), refused.size());
  const Eigen::VectorXd steps = known_refusals(refused);
  const Eigen::VectorXd s = temper.array().pow(1 / kLadderPower);
  const Eigen::Index pairs = steps.size();
  Eigen::VectorXd ladder = temper;
  double passed = 0;  // of the barrier, up to rung `below`
  Eigen::Index below = 0;
  for (Eigen::Index i = 1; i < pairs; ++i) {
    const double wanted = steps.sum() * double(i) / double(pairs);
    while (below < pairs - 1 && passed + steps[below] < wanted) passed += steps[below++];
    const double part = (wanted - passed) / steps[below];
    ladder[i] = std::pow(s[below] + part * (s[below + 1] - s[below]), kLadderPower);
  }
  return ladder;
}

}  // namespace thenar
