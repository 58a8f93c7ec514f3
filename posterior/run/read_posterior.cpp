#include <type_traits>

#include <fmt/format.h>

#include "base/error.h"
#include "posterior/run/assess_run.h"
#include "posterior/run/posterior_attributes.h"
#include "posterior/run/posterior_file.h"

namespace thenar {
namespace {

using internal::Given;

const InferenceArray& array(const InferenceFile& file, const std::string& group,
                            const std::string& name) {
  const auto found = file.groups.find(group);
  require(found != file.groups.end(), "the group '{}' is missing", group);
  const auto values = found->second.arrays.find(name);
  require(values != found->second.arrays.end(), "'{}/{}' is missing", group, name);
  return values->second;
}

/// x of every chain (n, draws).
std::vector<Eigen::MatrixXd> chains_of(const InferenceFile& file, int n) {
  const std::vector<double>& values = array(file, "unconstrained_posterior", "x").values;
  const InferenceGroup& group = file.groups.at("unconstrained_posterior");
  const auto chains = group.lengths.at("chain"), draws = group.lengths.at("draw");
  require(group.lengths.at("coordinate") == static_cast<std::size_t>(n),
          "the draws have {} coordinates, the inputs in the file give {}",
          group.lengths.at("coordinate"), n);
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
  std::vector<std::vector<StepStats>> stats(chains, std::vector<StepStats>(draws));
  const auto fill = [&](const std::string& name, auto StepStats::*field) {
    const std::vector<double>& values = array(file, "sample_stats", name).values;
    for (std::size_t c = 0; c < chains; ++c)
      for (std::size_t k = 0; k < draws; ++k) {
        auto& to = stats[c][k].*field;
        to = static_cast<std::decay_t<decltype(to)>>(values.at(c * draws + k));
      }
  };
  fill("log_prior", &StepStats::log_prior);
  fill("log_likelihood", &StepStats::log_likelihood);
  fill("acceptance_rate", &StepStats::acceptance);
  fill("step_size", &StepStats::step_size);
  fill("energy", &StepStats::energy);
  fill("tree_depth", &StepStats::depth);
  fill("n_steps", &StepStats::evaluations);
  fill("broken", &StepStats::broken);
  fill("diverging", &StepStats::divergent);
  return stats;
}

Draws draws_of(const InferenceFile& file, const Given& given, int n) {
  Draws draws;
  draws.x = chains_of(file, n);
  draws.stats = stats_of(file, draws.x.size(), static_cast<std::size_t>(draws.draws()));
  for (const double group : array(file, "sample_stats", "group").values)
    draws.group.push_back(static_cast<int>(group));
  const std::vector<double>& temper = array(file, "sample_stats", "temper").values;
  draws.temper =
      Eigen::Map<const Eigen::VectorXd>(temper.data(), static_cast<Eigen::Index>(temper.size()));
  const InferenceGroup& stats = file.groups.at("sample_stats");
  if (const auto rates = stats.arrays.find("swap_rate"); rates != stats.arrays.end())
    draws.swap_rate = Eigen::Map<const Eigen::MatrixXd>(
        rates->second.values.data(), static_cast<Eigen::Index>(stats.lengths.at("neighbours")),
        static_cast<Eigen::Index>(stats.lengths.at("ladder")));
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
    modes[m].z = posterior.fit_coordinates(Eigen::Map<const Eigen::VectorXd>(
        x.data() + m * static_cast<std::size_t>(posterior.size()), posterior.size()));
    modes[m].cost = cost[m];
    modes[m].hits = static_cast<int>(array(file, "modes", "hits").values[m]);
    modes[m].laplace_mass = array(file, "modes", "laplace_mass").values[m];
    modes[m].status = SolveStatus::kConverged;
  }
  return modes;
}

/// @throws InputError for what is missing or does not fit together.
PosteriorRun run_of(const InferenceFile& file) {
  const Given given(file.attributes);
  require(given.has("thenar_format") && given.text("thenar_format") == internal::kPosteriorFormat,
          "not a '{}' file", internal::kPosteriorFormat);
  PosteriorRun run;
  run.inputs = internal::inputs_of(given);
  run.settings = internal::settings_of(given);
  run.posterior =
      std::make_shared<const HandPosterior>(build_problem(run.inputs), run.settings.posterior);
  run.modes = modes_of(file, *run.posterior);
  run.draws = draws_of(file, given, run.posterior->size());
  assess_run(run);
  return run;
}

}  // namespace

PosteriorRun read_posterior(const std::string& path) {
  const InferenceFile file = read_inference(path);
  try {
    return run_of(file);
  } catch (const std::logic_error& e) {  // of std::stod and at()
    throw DataError(path, 0, fmt::format("not a posterior of thenar: {}", e.what()));
  } catch (const InputError& e) {
    throw DataError(path, 0, fmt::format("not a posterior of thenar: {}", e.what()));
  }
}

}  // namespace thenar
