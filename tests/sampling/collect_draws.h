#pragma once

/// Runs samplers side by side and keeps what they draw.

#include <memory>
#include <vector>

#include "base/random_stream.h"
#include "sampling/diagnostics/convergence.h"
#include "sampling/run/advance.h"

namespace thenar::sample {

/// Starts from N(mean, sd^2) (n, chains).
inline Eigen::MatrixXd normal_starts(int n, int chains, double sd, unsigned seed = 99,
                                     double mean = 0) {
  Eigen::MatrixXd starts(n, chains);
  for (int k = 0; k < chains; ++k) {
    RandomStream random(seed, static_cast<std::uint32_t>(k), 0);
    for (int i = 0; i < n; ++i) starts(i, k) = mean + sd * random.normal();
  }
  return starts;
}

struct Collected {
  std::vector<Eigen::MatrixXd> x;        // of each coordinate (draws, chains)
  double acceptance = 0;                 // mean over draws [1]
  long evaluations = 0, non_finite = 0;  // while draws were kept

  [[nodiscard]] double worst_r_hat() const {
    double worst = 0;
    for (const Eigen::MatrixXd& draws : x) worst = std::max(worst, rank_r_hat(draws));
    return worst;
  }
  [[nodiscard]] double min_bulk_ess() const {
    double least = std::numeric_limits<double>::infinity();
    for (const Eigen::MatrixXd& draws : x) least = std::min(least, bulk_ess(draws));
    return least;
  }
};

/// `groups` samplers with chains of their own, of `each` chains.
/// @param starts  (n, groups * each)
inline std::vector<std::unique_ptr<Sampler>> build_groups(SamplingMethod method,
                                                          const Eigen::MatrixXd& starts, int each,
                                                          SamplerOptions options) {
  std::vector<std::unique_ptr<Sampler>> groups;
  for (int k = 0; k + each <= starts.cols(); k += each) {
    options.first_chain = k;
    groups.push_back(build_sampler(method, starts.middleCols(k, each), options));
  }
  return groups;
}

/// Goes on for thin * draws steps and keeps every `thin`-th position.
inline Collected collect(const std::vector<std::unique_ptr<Sampler>>& groups, const Target& target,
                         long draws, int thin = 1) {
  std::vector<Sampler*> samplers;
  std::vector<Eigen::Index> first;
  Eigen::Index chains = 0;
  for (const auto& group : groups) {
    samplers.push_back(group.get());
    first.push_back(chains);
    chains += group->chains();
  }
  Collected kept;
  kept.x.assign(static_cast<std::size_t>(target.size()), Eigen::MatrixXd(draws, chains));
  const long begun = samplers[0]->steps();
  double acceptance = 0;
  const auto heard = [&](std::size_t g) {
    const Sampler& sampler = *samplers[g];
    for (const StepStats& stats : sampler.stats()) {
      acceptance += stats.acceptance;
      kept.evaluations += stats.evaluations;
      kept.non_finite += stats.non_finite;
    }
    const long step = sampler.steps() - begun;
    if (step % thin != 0) return;
    for (std::size_t i = 0; i < kept.x.size(); ++i)
      kept.x[i].row(step / thin - 1).segment(first[g], sampler.chains()) =
          sampler.positions().row(static_cast<Eigen::Index>(i));
  };
  advance(samplers, target, begun + thin * draws, heard);
  kept.acceptance = acceptance / double(thin * draws * chains);
  return kept;
}

}  // namespace thenar::sample
