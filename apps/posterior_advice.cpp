#include "apps/posterior_advice.h"

#include <cmath>

#include <fmt/format.h>

namespace thenar {
namespace {

bool is_hamiltonian(SamplingMethod method) {
  return method == SamplingMethod::kNuts || method == SamplingMethod::kHmc;
}

/// Do chains, or modes that they visit, disagree?
bool stuck_in_modes(const PosteriorRun& run) {
  int visited = 0;
  for (const ModeMass& mode : run.mode_table.modes) visited += mode.mass > 0;
  return visited > 1 && !run.mode_table.warnings.empty();
}

bool swaps_seldom(const PosteriorRun& run) {
  return run.draws.swap_rate.size() > 0 &&
         !(run.draws.swap_rate.minCoeff<Eigen::PropagateNaN>() >= run.settings.limits.swap_rate);
}

/// Are figures of convergence below what is wanted, whatever the cause?
bool too_short(const PosteriorRun& run) {
  const Convergence& c = run.convergence;
  const ConvergenceLimits& limits = run.settings.limits;
  const double least = limits.ess_per_chain * run.settings.run.groups;
  return !(c.worst_r_hat <= limits.r_hat) || !(std::min(c.min_bulk_ess, c.min_tail_ess) >= least);
}

/// Against divergent trajectories: a target halfway from here to 1.
std::string against_divergence(const SamplerOptions& options) {
  const double now = options.target_acceptance > 0 ? options.target_acceptance : 0.8;
  return fmt::format("trajectories diverge: a higher --target-acceptance {:.4g} (was {:.4g})",
                     1 - (1 - now) / 2, now);
}

}  // namespace

std::vector<std::string> advise(const PosteriorRun& run) {
  std::vector<std::string> advice;
  const RunOptions& options = run.settings.run;
  if (run.convergence.warnings.empty()) return advice;
  if (options.groups < 2) advice.emplace_back("one chain has none to be held against: --chains 4");
  if (run.convergence.divergent > 0 && is_hamiltonian(options.method))
    advice.push_back(against_divergence(options.sampler));
  if (stuck_in_modes(run))
    advice.push_back(fmt::format("chains do not cross between modes: --temperatures {}",
                                 std::max(6, 2 * options.temperatures)));
  if (swaps_seldom(run))
    advice.push_back(
        fmt::format("neighbouring temperatures seldom swap: more --temperatures (was {}), or a "
                    "higher --least-temper (was {:.4g})",
                    options.temperatures, options.min_beta));
  if (!too_short(run)) return advice;
  advice.push_back(fmt::format("more draws: --draws {}, with which the same command goes on",
                               4 * options.draws));
  advice.push_back(fmt::format("more --warm-up (was {}), with --fresh", options.sampler.warm_up));
  if (run.convergence.depth_limit > 0)
    advice.push_back(
        fmt::format("{} trees were cut short, if not for too little warm-up: "
                    "--max-depth {}",
                    run.convergence.depth_limit, options.sampler.max_depth + 2));
  if (!is_hamiltonian(options.method))
    advice.emplace_back("in many dimensions --sampler nuts needs far fewer steps");
  return advice;
}

}  // namespace thenar
