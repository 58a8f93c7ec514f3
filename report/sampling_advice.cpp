#include "report/sampling_advice.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/lists.h"

namespace thenar {
namespace {

/// Do chains, or modes that they visit, disagree?
bool stuck_in_modes(const PosteriorRun& run) {
  const std::vector<ModeMass>& modes = run.mode_table.modes;
  const auto visited =
      std::count_if(modes.begin(), modes.end(), [](const ModeMass& mode) { return mode.mass > 0; });
  return visited > 1 && !run.mode_table.warnings.empty();
}

bool swaps_seldom(const PosteriorRun& run) {
  return run.draws.swap_rate.size() > 0 &&
         !(run.draws.swap_rate.minCoeff<Eigen::PropagateNaN>() >= run.settings.limits.swap_rate);
}

/// Returns true if convergence diagnostics are insufficient, for any reason.
bool too_short(const PosteriorRun& run) {
  const Convergence& c = run.convergence;
  const ConvergenceLimits& limits = run.settings.limits;
  const double least = limits.ess_per_chain * run.settings.run.groups;
  return !(c.worst_r_hat <= limits.r_hat) || !(std::min(c.min_bulk_ess, c.min_tail_ess) >= least);
}

/// Changed settings with the reasons for them.
struct Changes {
  std::vector<std::string> reasons;
  OptionChanges options;
  void add(const std::string& reason, const std::string& option, const std::string& value) {
    reasons.push_back(reason);
    options.emplace_back(option, value);
  }
};

/// Against divergent trajectories: a target halfway from here to 1.
void against_divergence(const SamplerOptions& options, Changes& changes) {
  const double now = target_acceptance_of(options);
  const std::string target = fmt::format("{:.4g}", 1 - (1 - now) / 2);
  changes.add(fmt::format("trajectories diverge, and smaller steps follow the density better: a "
                          "higher --target-acceptance {} (was {:.4g})",
                          target, now),
              "--target-acceptance", target);
}

/// Returns settings that remedy the problem, besides more draws.
Changes changed_settings(const PosteriorRun& run) {
  // Each cause has a setting that answers it.
  Changes changes;
  const RunOptions& options = run.settings.run;
  if (options.groups < 2)
    changes.add("one chain has none to be held against: --chains 4", "--chains", "4");
  if (run.convergence.divergent > 0 && is_hamiltonian(options.method))
    against_divergence(options.sampler, changes);
  if (stuck_in_modes(run)) {
    const std::string more = fmt::format("{}", std::max(6, 2 * options.temperatures));
    changes.add("chains are stuck in different modes: --temperatures " + more, "--temperatures",
                more);
  } else if (swaps_seldom(run)) {
    changes.add(fmt::format("neighbouring temperatures seldom swap: more --temperatures (was {}), "
                            "or a higher --least-temper (was {:.4g})",
                            options.temperatures, options.min_beta),
                "--temperatures", fmt::format("{}", 2 * options.temperatures));
  }
  // A tenth of all draws: fewer are cut short by chance.
  if (10 * run.convergence.depth_limit > run.draws.draws() * run.draws.chains()) {
    const std::string deeper = fmt::format("{}", options.sampler.max_depth + 2);
    changes.add(
        fmt::format("{} trees were cut short: --max-depth {}", run.convergence.depth_limit, deeper),
        "--max-depth", deeper);
  }
  return changes;
}

}  // namespace

std::vector<std::string> with_options(const std::vector<std::string>& arguments,
                                      const OptionChanges& changes, bool fresh) {
  // Leave out the options that change, with their values, then add the new ones.
  std::vector<std::string> out;
  const auto changed = [&](const std::string& argument) {
    return any_of(changes, [&](const auto& change) {
      return argument == change.first || argument.rfind(change.first + "=", 0) == 0;
    });
  };
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    if (arguments[i] == "--fresh") continue;
    if (!changed(arguments[i]))
      out.push_back(arguments[i]);
    else if (arguments[i].find('=') == std::string::npos)
      ++i;  // its value
  }
  for (const auto& [option, value] : changes)
    if (!value.empty()) out.insert(out.end(), {option, value});
  if (fresh) out.emplace_back("--fresh");
  return out;
}

std::vector<SamplingAdvice> advise(const PosteriorRun& run) {
  std::vector<SamplingAdvice> advice;
  if (run.convergence.warnings.empty() && run.convergence.cautions.empty()) return advice;
  const auto add = [&](const std::string& remedy, const OptionChanges& changes, bool fresh) {
    const bool known = !run.run.arguments.empty();
    RunRecord next = run.run;
    if (known) next.arguments = with_options(run.run.arguments, changes, fresh);
    advice.push_back({remedy, known ? command_line(next) : ""});
  };
  // More draws help only where settings are right.
  const RunOptions& options = run.settings.run;

  // Settings that answer a cause first: more draws of the same chains would not.
  const Changes changes = changed_settings(run);
  if (!changes.options.empty())
    add(fmt::format("{}; these settings start over, with --fresh",
                    fmt::join(changes.reasons, "; ")),
        changes.options, true);
  if (!too_short(run)) return advice;
  const std::string draws = fmt::format("{}", 4 * options.draws);
  add(fmt::format("R-hat or effective sizes ask for more draws: --draws {}, with which the same "
                  "command continues",
                  draws),
      {{"--draws", draws}}, false);
  const std::string warm_up = fmt::format("{}", std::max(1000L, 2 * options.sampler.warm_up));
  add(fmt::format("where that does not help, a longer --warm-up {} (was {}), with --fresh", warm_up,
                  options.sampler.warm_up),
      {{"--warm-up", warm_up}}, true);
  if (!is_hamiltonian(options.method))
    add("in many dimensions --sampler nuts needs far fewer steps",
        {{"--walkers", ""}, {"--thin", ""}, {"--sampler", "nuts"}}, true);
  return advice;
}

std::string advice_text(const std::vector<SamplingAdvice>& advice) {
  std::string text;
  for (const SamplingAdvice& one : advice) {
    text += "\n  * " + one.remedy;
    if (!one.command.empty()) text += ":\n      " + one.command;
  }
  return text;
}

}  // namespace thenar
