#include "posterior/run/posterior_attributes.h"

#include <fmt/format.h>

#include "base/provenance.h"

namespace thenar::internal {
namespace {

void add_source(const std::string& key, const SourceText& source, Attributes& to) {
  to[key + "_path"] = source.path;
  to[key + "_text"] = source.text;
  to[key + "_sha256"] = sha256(source.text);
}

}  // namespace

void add_inputs(const FitInputs& inputs, Attributes& to) {
  add_source("input_subject", inputs.subject, to);
  add_source("input_settings", inputs.settings, to);
  for (std::size_t e = 0; e < inputs.experiments.size(); ++e)
    add_source(fmt::format("input_experiment{}", e), inputs.experiments[e], to);
  std::string free;
  for (const std::string& glob : inputs.also_free) free += glob + "\n";
  to["input_also_free"] = free;
}

void add_settings(const PosteriorSettings& settings, Attributes& to) {
  const RunOptions& run = settings.run;
  const PosteriorOptions& options = settings.posterior;
  const auto add = [&](const std::string& name, auto value) {
    to["setting_" + name] = fmt::format("{}", value);
  };
  add("sampler", name_of(run.method));
  add("seed", run.sampler.seed);
  add("warm_up", run.sampler.warm_up);
  add("target_acceptance", run.sampler.target_acceptance);
  add("max_depth", run.sampler.max_depth);
  add("groups", run.groups);
  add("walkers", run.walkers);
  add("temperatures", run.temperatures);
  add("least_temper", run.least_temper);
  add("swap_every", run.swap_every);
  add("thin", run.thin);
  add("draws", run.draws);
  add("mode_starts", settings.mode_starts);
  add("learn_noise", int{options.learn_noise});
  add("noise_sd", options.noise_sd);
  add("learn_spread", int{options.learn_spread});
  add("spread_sd", options.spread_sd);
  add("sphere_priors", int{options.sphere_priors});
}

FitInputs inputs_of(const Given& given) {
  FitInputs inputs{given.source("input_subject"), given.source("input_settings"), {}, {}};
  for (int e = 0; given.has(fmt::format("input_experiment{}_text", e)); ++e)
    inputs.experiments.push_back(given.source(fmt::format("input_experiment{}", e)));
  std::string rest = given.text("input_also_free");
  for (std::size_t end; (end = rest.find('\n')) != std::string::npos; rest.erase(0, end + 1))
    inputs.also_free.push_back(rest.substr(0, end));
  return inputs;
}

PosteriorSettings settings_of(const Given& given) {
  PosteriorSettings settings;
  settings.posterior = {given.integer("learn_noise") != 0, given.number("noise_sd"),
                        given.integer("learn_spread") != 0, given.number("spread_sd"),
                        given.integer("sphere_priors") != 0};
  settings.mode_starts = given.integer("mode_starts");
  RunOptions& run = settings.run;
  run.method = sampling_method(given.text("setting_sampler"));
  run.sampler.seed = static_cast<unsigned>(given.number("seed"));
  run.sampler.warm_up = static_cast<long>(given.number("warm_up"));
  run.sampler.target_acceptance = given.number("target_acceptance");
  run.sampler.max_depth = given.integer("max_depth");
  run.groups = given.integer("groups");
  run.walkers = given.integer("walkers");
  run.temperatures = given.integer("temperatures");
  run.least_temper = given.number("least_temper");
  run.swap_every = given.integer("swap_every");
  run.thin = given.integer("thin");
  run.draws = static_cast<long>(given.number("draws"));
  return settings;
}

}  // namespace thenar::internal
