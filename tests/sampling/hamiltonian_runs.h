#pragma once

/// Chains of Hamiltonian samplers for tests.

#include <cstdlib>
#include <memory>
#include <vector>

#include "sampling/methods/sampler.h"
#include "sampling/run/advance.h"

namespace thenar::sample {

/// Draws of some chains after their warm-up.
struct HamiltonianRun {
  std::vector<Eigen::MatrixXd> x;             // of each chain (n, draws)
  std::vector<std::vector<StepStats>> stats;  // of each chain and draw

  /// One coordinate of all (draws, chains).
  [[nodiscard]] Eigen::MatrixXd coordinate(int i) const {
    Eigen::MatrixXd all(x[0].cols(), static_cast<Eigen::Index>(x.size()));
    for (std::size_t c = 0; c < x.size(); ++c)
      all.col(static_cast<Eigen::Index>(c)) = x[c].row(i).transpose();
    return all;
  }
  template <typename Value>
  [[nodiscard]] double sum(Value StepStats::*of) const {
    double total = 0;
    for (const auto& chain : stats)
      for (const StepStats& step : chain) total += static_cast<double>(step.*of);
    return total;
  }
};

/// Chains from the columns of `starts`; the first has the number options.first_chain.
inline HamiltonianRun run_hamiltonian(const Target& target, SamplingMethod method,
                                      const SamplerOptions& options, const Eigen::MatrixXd& starts,
                                      long draws) {
  std::vector<std::unique_ptr<Sampler>> samplers;
  std::vector<Sampler*> chains;
  HamiltonianRun run;
  for (Eigen::Index c = 0; c < starts.cols(); ++c) {
    SamplerOptions own = options;
    own.first_chain += static_cast<int>(c);
    samplers.push_back(build_sampler(method, starts.col(c), own));
    chains.push_back(samplers.back().get());
    run.x.emplace_back(starts.rows(), draws);
    run.stats.emplace_back();
  }
  advance(chains, target, options.warm_up + draws, [&](std::size_t c) {
    const long draw = chains[c]->steps() - options.warm_up - 1;
    if (draw < 0) return;
    run.x[c].col(draw) = chains[c]->positions().col(0);
    run.stats[c].push_back(chains[c]->stats()[0]);
  });
  return run;
}

/// `few`, or what THENAR_SAMPLES asks for.
inline long draws_of(long few) {
  const char* asked = std::getenv("THENAR_SAMPLES");
  return asked ? std::atol(asked) : few;
}

}  // namespace thenar::sample
