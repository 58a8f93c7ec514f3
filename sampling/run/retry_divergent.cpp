#include "sampling/run/retry_divergent.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/error.h"

namespace thenar {
namespace {

/// Returns the target acceptances of all attempts; the first is that of the options.
std::vector<double> attempts_of(const RunOptions& options, const std::vector<double>& next) {
  const bool within =
      std::all_of(next.begin(), next.end(), [](double a) { return a > 0 && a < 1; });
  require(within && std::is_sorted(next.begin(), next.end()),
          "wanted ascending target acceptances between 0 and 1, got {}", fmt::join(next, " "));
  std::vector<double> attempts{options.sampler.target_acceptance};
  if (!is_hamiltonian(options.method)) return attempts;
  const double first = target_acceptance_of(options.sampler);
  for (const double a : next)
    if (a > std::max(first, attempts.back())) attempts.push_back(a);
  return attempts;
}

}  // namespace

RetriedDraws retry_divergent(const Target& target, const Eigen::MatrixXd& starts,
                             const RunOptions& options,
                             const std::vector<double>& target_acceptances,
                             const Communicator& ranks) {
  const std::vector<double> attempts = attempts_of(options, target_acceptances);
  RetriedDraws result;
  for (const double target_acceptance : attempts) {
    // Use separate checkpoints for each attempt.
    RunOptions attempt = options;
    attempt.sampler.target_acceptance = target_acceptance;
    attempt.end_at_divergence = target_acceptance != attempts.back();
    if (!result.abandoned.empty()) {
      if (!options.folder.empty())
        attempt.folder += fmt::format("/acceptance_{}", target_acceptance);
      if (options.progress.report)
        attempt.progress.report = [&](double fraction, const std::string& what) {
          options.progress.report(
              fraction, fmt::format("anew at target acceptance {}: {}", target_acceptance, what));
        };
    }
    result.draws = run_chains(target, starts, attempt, ranks);
    result.target_acceptance = target_acceptance;
    if (!result.draws.ended_at_divergence) break;
    result.abandoned.push_back(target_acceptance_of(attempt.sampler));
  }
  return result;
}

}  // namespace thenar
