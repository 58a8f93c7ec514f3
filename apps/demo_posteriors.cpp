#include "apps/demo_posteriors.h"

#include <fmt/format.h>

#include "base/error.h"
#include "posterior/run/posterior_file.h"
#include "posterior/run/posterior_summary.h"
#include "posterior/run/predict_draws.h"
#include "report/pages/posterior_picture.h"

namespace thenar {
namespace {

constexpr double kTargetAcceptance = 0.9;

/// One posterior by the name it goes by.
struct NamedPage {
  std::string name;
  PosteriorRun run;
};

PosteriorRun sampled(const FitInputs& inputs, long draws, const Progress& progress) {
  PosteriorSettings settings;
  settings.posterior = posterior_options(inputs.settings);
  settings.mode_starts = 8;
  settings.run.sampler.warm_up = draws;
  settings.run.sampler.target_acceptance = kTargetAcceptance;
  settings.run.draws = draws;
  settings.run.progress = progress;
  return sample_posterior(inputs, settings);
}

Json posterior_row(const NamedPage& named, const Experiment& experiment, const std::string& how) {
  const FitProblem& problem = named.run.posterior->problem();
  const int specimen = find_specimen(problem, experiment.specimen);
  const Prediction prediction = summarise(predict_draws(named.run, experiment, specimen));
  const ForceError& error = prediction.error;
  return {named.name,
          experiment.name,
          prediction.calibrated_on_specimen ? how + "; the subject has seen it" : how,
          error.relative,
          error.relative_flexion,
          100 * error.covered.value_or(0)};
}

/// Errors of every posterior on every experiment, seen or not.
Json glance(const std::vector<NamedPage>& posteriors, const std::vector<Experiment>& unseen) {
  Json rows = Json::array(), runs = Json::array();
  for (const NamedPage& named : posteriors) {
    const HandPosterior& posterior = *named.run.posterior;
    for (const Experiment& experiment : posterior.problem().experiments())
      rows.push_back(posterior_row(named, experiment, "in sample"));
    for (const Experiment& experiment : unseen)
      rows.push_back(posterior_row(named, experiment, "never fitted: a stranger"));
    const auto left_out = leave_out_observations(named.run);
    require(left_out.has_value(), "a likelihood of the posterior of '{}' is not finite",
            named.name);
    const LeaveOneOut& loo = left_out->result;
    const Convergence& c = named.run.convergence;
    runs.push_back({named.name, posterior.size(), c.worst_r_hat, c.min_bulk_ess, c.divergent,
                    named.run.modes.size(), loo.elpd, loo.se, loo.effective_parameters,
                    (loo.k.array() > loo.good_k).count(), named.run.draws.seconds});
  }
  return section(
      "posteriors", "Posteriors at a glance",
      "Draws instead of one best point: how sure the forces make us. Errors are of the posterior "
      "mean; the interval is the predictive one, noise included.",
      Json::array({table_block("Predicted forces",
                               {{"posterior", ""},
                                {"experiment", ""},
                                {"how", ""},
                                {"relative error", "", 3},
                                {"in flexion", "", 3},
                                {"within 95 %", "%", 0}},
                               rows),
                   table_block("Runs of the sampler (NUTS, 4 chains)",
                               {{"posterior", ""},
                                {"entries", "", 0},
                                {"worst R-hat", "", 4},
                                {"least bulk ESS", "", 0},
                                {"divergent", "", 0},
                                {"modes", "", 0},
                                {"elpd, one trial left out", "", 1},
                                {"se", "", 1},
                                {"effective parameters", "", 1},
                                {"Pareto k too large", "", 0},
                                {"sampling", "s", 1}},
                               runs)}));
}

}  // namespace

Json posterior_pages(const StudyInputs& inputs, const std::string& output,
                     const Progress& progress) {
  std::vector<NamedPage> posteriors;
  const auto add = [&](const std::string& name, const FitInputs& of, long draws) {
    if (progress.stop()) return;
    progress(0, "posterior of " + name);
    posteriors.push_back({name, sampled(of, draws, progress)});
    if (posteriors.back().run.draws.complete)
      write_posterior(posteriors.back().run, fmt::format("{}/{}.nc", output, name));
  };
  for (const SourceText& experiment : inputs.specimen.experiments) {
    FitInputs alone = inputs.specimen;
    alone.experiments = {experiment};
    add(parse_experiment(experiment.text, experiment.path).name, alone, 1000);
  }
  FitInputs together = inputs.specimen;
  together.subject = inputs.population_subject;
  add("population", together, 600);
  if (progress.stop()) return Json::array();

  std::vector<Experiment> unseen;
  for (const SourceText& source : inputs.unseen)
    unseen.push_back(parse_experiment(source.text, source.path));
  Json sections = Json::array({glance(posteriors, unseen)});
  for (const NamedPage& named : posteriors) {
    PictureOptions options;
    options.title = "Posterior of " + named.name;
    options.prefix = "posterior-" + named.name + "-";
    for (Json& part : posterior_sections(posterior_picture(named.run, options)))
      sections.push_back(std::move(part));
  }
  return sections;
}

}  // namespace thenar
