#include <ctime>

#include <fmt/format.h>

#include "base/provenance.h"
#include "posterior/run/posterior_attributes.h"
#include "posterior/run/posterior_file.h"
#include "posterior/run/posterior_groups.h"
#include "posterior/run/run_quantities.h"

namespace thenar {
namespace {

constexpr int kPriorDraws = 1000;

std::string now() {
  const std::time_t time = std::time(nullptr);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", std::gmtime(&time));
  return text;
}

/// What the run, rather than a step, has to say: groups, swaps, time.
void add_run(const Draws& draws, InferenceGroup& stats) {
  stats.arrays["group"] = {{draws.group.begin(), draws.group.end()},
                           {"chain"},
                           "1",
                           "independent chain or ensemble that the chain belongs to",
                           true};
  stats.lengths["temperature"] = static_cast<std::size_t>(draws.temper.size());
  stats.arrays["temper"] = {{draws.temper.data(), draws.temper.data() + draws.temper.size()},
                            {"temperature"},
                            "1",
                            "power of the likelihood"};
  if (draws.swap_rate.size() == 0) return;
  stats.lengths["neighbours"] = static_cast<std::size_t>(draws.swap_rate.rows());
  stats.lengths["ladder"] = static_cast<std::size_t>(draws.swap_rate.cols());
  stats.arrays["swap_rate"] = {
      {draws.swap_rate.data(), draws.swap_rate.data() + draws.swap_rate.size()},
      {"ladder", "neighbours"},
      "1",
      "accepted share of swaps of neighbouring temperatures"};
}

}  // namespace

InferenceFile describe_posterior(const PosteriorRun& run) {
  InferenceFile file;
  const HandPosterior& posterior = *run.posterior;
  file.attributes = {{"thenar_format", internal::kPosteriorFormat},
                     {"inference_library", "thenar"},
                     {"inference_library_version", versions().at("thenar")},
                     {"created_at", now()},
                     {"fidelity", describe(posterior.problem().digit().fidelity)},
                     {"complete", run.draws.complete ? "yes" : "no"},
                     {"converged", run.convergence.reasons.empty() ? "yes" : "no"},
                     {"sampling_time", fmt::format("{}", run.draws.seconds)}};
  for (const auto& [name, version] : versions()) file.attributes["version_" + name] = version;
  internal::add_inputs(run.inputs, file.attributes);
  internal::add_settings(run.settings, file.attributes);

  using namespace internal;
  file.groups["posterior"] = parameter_group(posterior, pooled(run.draws), run.draws.chains());
  file.groups["prior"] = parameter_group(posterior, prior_draws(run, kPriorDraws), 1);
  file.groups["unconstrained_posterior"] = coordinate_group(run);
  file.groups["sample_stats"] = statistics_group(run);
  add_run(run.draws, file.groups["sample_stats"]);
  file.groups["log_likelihood"] = likelihood_group(run);
  file.groups["posterior_predictive"] = predictive_group(run);
  file.groups["observed_data"] = observed_group(run);
  file.groups["constant_data"] = noise_group(run);
  file.groups["modes"] = mode_group(run);
  return file;
}

void write_posterior(const PosteriorRun& run, const std::string& path) {
  write_inference(describe_posterior(run), path);
}

}  // namespace thenar
