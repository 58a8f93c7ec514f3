#include "posterior/run/posterior_file.h"

#include <cmath>
#include <ctime>
#include <sstream>
#include <type_traits>

#include <fmt/format.h>

#include "base/provenance.h"
#include "data/io/result_layout.h"
#include "posterior/hand_posterior.h"
#include "posterior/run/posterior_groups.h"
#include "posterior/run/posterior_quantities.h"

namespace thenar::internal {
namespace {

void add_source(const std::string& key, const SourceText& source, Attributes& to) {
  to[key + "_path"] = source.path;
  to[key + "_text"] = source.text;
  to[key + "_sha256"] = sha256(source.text);
}

/// Calls `use` with the name of each number of the settings, to write or read it.
template <typename Settings, typename Use>
void each_setting(Settings& settings, const Use& use) {
  // Priors and modes.
  auto& options = settings.posterior;
  use("learn_noise", options.learn_noise);
  use("noise_sd", options.noise_sd);
  use("learn_spread", options.learn_specimen_scale);
  use("spread_sd", options.specimen_scale_sd);
  use("sphere_priors", options.sphere_priors);
  use("mode_starts", settings.mode_starts);
  // Sampler, chains and temperatures.
  auto& run = settings.run;
  use("seed", run.sampler.seed);
  use("warm_up", run.sampler.warm_up);
  use("target_acceptance", run.sampler.target_acceptance);
  use("max_depth", run.sampler.max_depth);
  use("groups", run.groups);
  use("walkers", run.walkers);
  use("temperatures", run.temperatures);
  use("least_temper", run.min_beta);
  use("swap_every", run.swap_every);
  use("thin", run.thin);
  use("draws", run.draws);
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
  to["setting_sampler"] = name_of(settings.run.method);
  each_setting(settings, [&](const std::string& name, auto value) {
    to["setting_" + name] = fmt::format("{}", +value);
  });
}

void add_record(const RunRecord& run, Attributes& to) {
  for (const auto& [name, text] : texts_of(run)) to["run_" + name] = text;
}

RunRecord record_of(const AttributeReader& given) {
  std::map<std::string, std::string> texts;
  for (const char* const name : {"command", "folder", "date", "commit", "request"})
    if (const std::string key = fmt::format("run_{}", name); given.has(key))
      texts[name] = given.text(key);
  return record_of_texts(texts);
}

FitInputs inputs_of(const AttributeReader& given) {
  // Experiments are numbered consecutively.
  FitInputs inputs{given.source("input_subject"), given.source("input_settings"), {}, {}};
  for (int e = 0; given.has(fmt::format("input_experiment{}_text", e)); ++e)
    inputs.experiments.push_back(given.source(fmt::format("input_experiment{}", e)));
  // Glob patterns are separated by newlines.
  std::string rest = given.text("input_also_free");
  for (std::size_t end; (end = rest.find('\n')) != std::string::npos; rest.erase(0, end + 1))
    inputs.also_free.push_back(rest.substr(0, end));
  return inputs;
}

PosteriorSettings settings_of(const AttributeReader& given) {
  PosteriorSettings settings;
  settings.run.method = sampling_method(given.text("setting_sampler"));
  each_setting(settings, [&](const char* name, auto& value) {
    value = static_cast<std::decay_t<decltype(value)>>(given.number(name));
  });
  return settings;
}

}  // namespace thenar::internal

namespace thenar {
namespace {

constexpr int kPriorDraws = 1000;  // number of prior draws in the file

std::string now() {
  const std::time_t time = std::time(nullptr);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", std::gmtime(&time));
  return text;
}

/// Writes the statistics of the run: groups, swaps, time.
void add_run(const Draws& draws, InferenceGroup& stats) {
  // Groups of chains, and the ladder of temperatures.
  stats.arrays["group"] = {{draws.group.begin(), draws.group.end()},
                           {"chain"},
                           "1",
                           "independent chain or ensemble that the chain belongs to",
                           true};
  stats.lengths["temperature"] = static_cast<std::size_t>(draws.beta.size());
  stats.arrays["temper"] = {{draws.beta.data(), draws.beta.data() + draws.beta.size()},
                            {"temperature"},
                            "1",
                            "power of the likelihood"};
  if (draws.swap_rate.size() == 0) return;
  // Swaps, if there are several temperatures.
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
  // Describe the run, and store all inputs to repeat it.
  InferenceFile file;
  const HandPosterior& posterior = *run.posterior;
  file.attributes = {{"thenar_format", internal::kPosteriorFormat},
                     {"inference_library", "thenar"},
                     {"inference_library_version", versions().at("thenar")},
                     {"created_at", run.run.date.empty() ? now() : run.run.date},
                     {"fidelity", describe(posterior.problem().digit().fidelity)},
                     {"complete", run.draws.complete ? "yes" : "no"},
                     {"converged", run.convergence.warnings.empty() ? "yes" : "no"},
                     {"sampling_time", fmt::format("{}", run.draws.seconds)}};
  for (const auto& [name, version] : versions()) file.attributes["version_" + name] = version;
  internal::add_inputs(run.inputs, file.attributes);
  internal::add_settings(run.settings, file.attributes);
  internal::add_record(run.run, file.attributes);
  if (!run.abandoned.empty())
    file.attributes["abandoned_target_acceptances"] =
        fmt::format("{}", fmt::join(run.abandoned, " "));

  // Add the groups under ArviZ's names.
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

namespace {

using internal::AttributeReader;

/// Returns an array of a group. @throws InputError if it is missing.
const InferenceArray& array(const InferenceFile& file, const std::string& group,
                            const std::string& name) {
  const auto found = file.groups.find(group);
  require(found != file.groups.end(), "the group '{}' is missing", group);
  const auto values = found->second.arrays.find(name);
  require(values != found->second.arrays.end(), "'{}/{}' is missing", group, name);
  return values->second;
}

/// Returns the lengths of the array's dimensions.
std::vector<std::size_t> shape_of(const InferenceFile& file, const std::string& group,
                                  const std::string& name) {
  return shape_in(file.groups.at(group), array(file, group, name));
}

/// Returns x of every chain (n, draws).
std::vector<Eigen::MatrixXd> chains_of(const InferenceFile& file, int n) {
  // Check that the draws belong to the inputs.
  const std::vector<double>& values = array(file, "unconstrained_posterior", "x").values;
  const std::vector<std::size_t> shape = shape_of(file, "unconstrained_posterior", "x");
  const std::size_t chains = shape[0], draws = shape[1];
  require(shape[2] == static_cast<std::size_t>(n),
          "the draws have {} coordinates, the inputs in the file give {}", shape[2], n);

  // Copy the chains, which are stored one after another.
  std::vector<Eigen::MatrixXd> x;
  for (std::size_t c = 0; c < chains; ++c) {
    x.emplace_back(
        Eigen::Map<const Eigen::MatrixXd>(values.data() + c * draws * static_cast<std::size_t>(n),
                                          n, static_cast<Eigen::Index>(draws)));
    require(x.back().allFinite(), "chain {} has draws that are not finite", c);
  }
  return x;
}

std::vector<std::vector<StepStats>> stats_of(const InferenceFile& file, std::size_t chains,
                                             std::size_t draws) {
  // Copy each array to one field of all steps.
  std::vector<std::vector<StepStats>> stats(chains, std::vector<StepStats>(draws));
  internal::each_step_field([&](const char* name, const char*, auto StepStats::*field) {
    const std::vector<double>& values = array(file, "sample_stats", name).values;
    for (std::size_t c = 0; c < chains; ++c)
      for (std::size_t k = 0; k < draws; ++k) {
        auto& to = stats[c][k].*field;
        to = static_cast<std::decay_t<decltype(to)>>(values[c * draws + k]);
      }
  });
  return stats;
}

Draws draws_of(const InferenceFile& file, const AttributeReader& given, int n) {
  // Read draws and the statistics of their steps.
  Draws draws;
  draws.x = chains_of(file, n);
  draws.stats = stats_of(file, draws.x.size(), static_cast<std::size_t>(draws.draws()));
  for (const double group : array(file, "sample_stats", "group").values)
    draws.group.push_back(static_cast<int>(group));
  // Read temperatures and swaps.
  const std::vector<double>& beta = array(file, "sample_stats", "temper").values;
  draws.beta =
      Eigen::Map<const Eigen::VectorXd>(beta.data(), static_cast<Eigen::Index>(beta.size()));
  if (file.groups.at("sample_stats").arrays.count("swap_rate") > 0) {
    const std::vector<std::size_t> shape = shape_of(file, "sample_stats", "swap_rate");
    draws.swap_rate = Eigen::Map<const Eigen::MatrixXd>(
        array(file, "sample_stats", "swap_rate").values.data(), static_cast<Eigen::Index>(shape[1]),
        static_cast<Eigen::Index>(shape[0]));
  }
  // Read the outcome of the run.
  draws.warm_up = static_cast<long>(given.number("warm_up"));
  draws.complete = given.text("complete") == "yes";
  draws.seconds = std::stod(given.text("sampling_time"));
  return draws;
}

std::vector<Mode> modes_of(const InferenceFile& file, const HandPosterior& posterior) {
  const std::vector<double>& x = array(file, "modes", "x").values;
  const std::vector<double>& cost = array(file, "modes", "cost").values;
  std::vector<Mode> modes(cost.size());
  for (std::size_t m = 0; m < modes.size(); ++m) {
    // Convert x to the coordinates of the fit.
    modes[m].z = posterior.fit_coordinates(Eigen::Map<const Eigen::VectorXd>(
        x.data() + m * static_cast<std::size_t>(posterior.size()), posterior.size()));
    modes[m].cost = cost[m];
    modes[m].hits = static_cast<int>(array(file, "modes", "hits").values[m]);
    modes[m].laplace_mass = array(file, "modes", "laplace_mass").values[m];
    modes[m].status = Status::kSolved;
  }
  return modes;
}

/// Reads a run. @throws InputError if anything is missing or inconsistent.
PosteriorRun run_of(const InferenceFile& file) {
  const AttributeReader given(file.attributes);
  require(given.has("thenar_format") && given.text("thenar_format") == internal::kPosteriorFormat,
          "not a '{}' file", internal::kPosteriorFormat);
  // Read inputs and settings, and rebuild the posterior.
  for (const auto& [name, text] : file.attributes)
    require(name.rfind("setting_", 0) != 0 || name == "setting_sampler" ||
                std::abs(std::stod(text)) < 2147483648.0,
            "the attribute '{}': wanted a number below 2^31, got {}", name, text);
  PosteriorRun run;
  run.inputs = internal::inputs_of(given);
  run.settings = internal::settings_of(given);
  run.posterior =
      std::make_shared<const HandPosterior>(build_problem(run.inputs), run.settings.posterior);
  // Read the results; convergence and masses are assessed again.
  run.run = internal::record_of(given);
  if (given.has("abandoned_target_acceptances")) {
    std::istringstream abandoned(given.text("abandoned_target_acceptances"));
    for (double target; abandoned >> target;) run.abandoned.push_back(target);
  }
  run.draws = draws_of(file, given, run.posterior->size());
  require(run.draws.beta.size() == run.settings.run.temperatures,
          "'sample_stats/temper': wanted {} numbers, as the settings say, got {}",
          run.settings.run.temperatures, run.draws.beta.size());
  run.modes = modes_of(file, *run.posterior);
  assess_run(run);
  return run;
}

}  // namespace

PosteriorRun read_posterior(const std::string& path) {
  const InferenceFile file = read_inference(path);
  try {
    return run_of(file);
  } catch (const std::logic_error& e) {  // from std::stod and at()
    throw DataError(path, 0, fmt::format("not a posterior of thenar: {}", e.what()));
  } catch (const InputError& e) {
    throw DataError(path, 0, fmt::format("not a posterior of thenar: {}", e.what()));
  }
}

}  // namespace thenar
