// thenar fit EXPERIMENT.toml... --subject SUBJECT.toml -o FIT.h5
//
// Fits the parameters of a digit to measured fingertip forces. Several specimens are fitted
// together, as people who differ from their population. With --method mcmc the whole posterior is
// sampled instead: under mpirun by all ranks, and an interrupted run goes on where it stopped.

#include <algorithm>
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "api/files.h"
#include "apps/commands.h"
#include "apps/fit_posterior.h"
#include "apps/terminal.h"
#include "base/error.h"
#include "base/interrupt.h"
#include "base/progress_parts.h"
#include "kinematics_fit/cross_validation.h"
#include "kinematics_fit/prediction.h"
#include "report/json.h"

namespace thenar {
namespace {

struct FitArguments {
  std::vector<std::string> experiments;
  std::string subject, settings, output, method = "ceres";
  std::vector<std::string> free, leave_out;
  unsigned seed = 1;
  int max_evaluations = 0;
  bool json = false;
  ChainOptions chains;
};

FitInputs inputs_of(const FitArguments& options) {
  FitInputs inputs;
  inputs.subject = read_source(options.subject);
  for (const std::string& path : options.experiments)
    inputs.experiments.push_back(read_source(path));
  const SourceText& first = inputs.experiments.front();
  inputs.settings = options.settings.empty()
                        ? built_in_settings(parse_experiment(first.text, first.path).digit)
                        : read_source(options.settings);
  inputs.also_free = options.free;
  return inputs;
}

LeaveOut leave_out(const std::string& name) {
  if (name == "posture") return LeaveOut::kPosture;
  if (name == "tendon") return LeaveOut::kTendon;
  if (name == "specimen") return LeaveOut::kSpecimen;
  throw InputError(
      fmt::format("cannot leave out a '{}'; wanted posture, tendon or specimen", name));
}

nlohmann::json error_json(const Prediction& prediction) {
  return {{"experiment", prediction.experiment},
          {"rms_error_N", prediction.error.rms},
          {"relative_error", prediction.error.relative},
          {"relative_error_flexion_plane", prediction.error.relative_flexion},
          {"start_has_seen_specimen", prediction.calibrated_on_specimen}};
}

/// Says behind an error that it is of no stranger.
const char* mark(const Prediction& prediction) {
  return prediction.calibrated_on_specimen ? " (the subject has seen this specimen)" : "";
}

nlohmann::json summary(const Fit& fit, const std::vector<CrossValidation>& validations) {
  nlohmann::json out{{"status", convergence_word(fit.solution)},
                     {"message", fit.solution.message},
                     {"cost", fit.solution.cost},
                     {"evaluations", fit.solution.evaluations},
                     {"seconds", fit.solution.seconds},
                     {"free_coordinates", fit.problem.size()},
                     {"effective_parameters", fit.covariance.effective_parameters},
                     {"warnings", fit.problem.warnings()}};
  for (std::size_t e = 0; e < fit.problem.experiments().size(); ++e)
    out["in_sample"].push_back(
        error_json(predict_fitted(fit.problem, fit.solution.z, static_cast<int>(e))));
  for (const NullDirection& null : fit.covariance.null_directions)
    out["not_identifiable"].push_back(null.text);
  for (const CrossValidation& validation : validations)
    for (const Prediction& prediction : validation.experiments) {
      out["left_out"].push_back(error_json(prediction));
      out["left_out"].back()["what"] = name_of(validation.what);
      out["left_out"].back()["folds_done"] = validation.folds_done;
      out["left_out"].back()["folds"] = validation.folds.size();
    }
  return out;
}

/// The coordinates that the data moved or pinned down most.
void print_learnt(const Fit& fit, std::size_t count) {
  const std::vector<int> order = sorted_by_sd(fit.covariance);
  fmt::print("\nlearnt most (estimate and sd in units of the prior sd):\n");
  for (std::size_t k = 0; k < std::min(count, order.size()); ++k) {
    const CoordinateEstimate& learnt = fit.covariance.learnt[static_cast<std::size_t>(order[k])];
    fmt::print("  {:<34} {:+6.2f} +- {:.2f}{}\n", learnt.name, learnt.z, learnt.sd,
               learnt.at_bound ? ", at its bound" : "");
  }
}

void print_nulls(const Fit& fit, std::size_t count) {
  const auto& null_directions = fit.covariance.null_directions;
  if (null_directions.empty()) return;
  fmt::print("\n{} of {} directions are known from the prior alone:\n", null_directions.size(),
             fit.problem.size());
  for (std::size_t i = 0; i < std::min(count, null_directions.size()); ++i)
    fmt::print("  {}\n", null_directions[i].text);
  if (null_directions.size() > count)
    fmt::print("  ... all are in the result file (--json lists them)\n");
}

void print_summary(const Fit& fit, const std::vector<CrossValidation>& validations,
                   const std::string& output) {
  fmt::print("{}: {} after {} evaluations, {:.2f} s; {} coordinates, {:.1f} learnt\n",
             name_of(fit.method), convergence_word(fit.solution), fit.solution.evaluations,
             fit.solution.seconds, fit.problem.size(), fit.covariance.effective_parameters);
  for (std::size_t e = 0; e < fit.problem.experiments().size(); ++e) {
    const Prediction p = predict_fitted(fit.problem, fit.solution.z, static_cast<int>(e));
    fmt::print("  {:<20} in sample: RMS error {:.3f} N, relative {:.3f}\n", p.experiment,
               p.error.rms, p.error.relative);
  }
  for (const CrossValidation& validation : validations) {
    for (const Prediction& p : validation.experiments)
      if (!p.trials.empty())
        fmt::print("  {:<20} {}: RMS error {:.3f} N, relative {:.3f}{}\n", p.experiment,
                   name_of(validation.what), p.error.rms, p.error.relative, mark(p));
    if (validation.stopped)
      fmt::print("  {}: stopped after {} of {} folds; the errors are of those alone\n",
                 name_of(validation.what), validation.folds_done, validation.folds.size());
  }
  if (fit.solution.status == Status::kSolved) print_learnt(fit, 8);
  print_nulls(fit, 4);
  fmt::print("\nwrote {}\n", output);
}

void run_fit(const FitArguments& options) {
  if (options.method == "mcmc") {
    require(options.leave_out.empty(),
            "--cross-validate is for fits; a posterior's file says how well it would predict each "
            "trial unseen (`thenar posterior summary`)");
    fit_posterior(inputs_of(options), options.chains, options.seed, options.output, options.json);
    return;
  }
  SolveOptions solve_options;
  solve_options.method = least_squares_method(options.method);
  solve_options.seed = options.seed;
  solve_options.max_evaluations = options.max_evaluations;
  solve_options.progress = terminal_progress();
  std::vector<LeaveOut> left_out;
  for (const std::string& name : options.leave_out) left_out.push_back(leave_out(name));

  require_result_path(options.output);
  const Fit fit = run_fit(inputs_of(options), solve_options);
  for (const std::string& warning : fit.problem.warnings())
    fmt::print(stderr, "thenar: warning: {}\n", warning);
  write_fit(fit, options.output);
  std::vector<CrossValidation> validations;
  for (const LeaveOut what : left_out)
    if (!interrupted()) validations.push_back(cross_validate(fit.problem, what, solve_options));
  if (options.json)
    fmt::print("{}\n", json_text(summary(fit, validations)));
  else
    print_summary(fit, validations, options.output);
  require(!fit.solution.failed, "the fit failed: {}; the file holds the best point found",
          fit.solution.message);
  if (interrupted()) throw Stopped("stopped; the file holds the best point so far");
}

}  // namespace

void add_fit(CLI::App& app) {
  auto options = std::make_shared<FitArguments>();  // lives as long as the callback
  CLI::App* command = app.add_subcommand("fit", "Fit a digit to measured fingertip forces");
  command->add_option("experiments", options->experiments, "Experiment files")->required();
  command->add_option("--subject", options->subject, "Subject file to start from")->required();
  command->add_option("-o,--output", options->output, "Result file: .h5, of mcmc .nc")->required();
  command->add_option("--method", options->method,
                      "ceres|nlopt|nlopt-global|ipopt, or mcmc: draws from the posterior");
  command->add_option("--settings", options->settings,
                      "Which parameters move (default: built in, see `thenar explain`)");
  command->add_option("--free", options->free, "Also free the parameters matching these globs");
  command->add_option("--cross-validate", options->leave_out,
                      "Also leave out one posture|tendon|specimen at a time");
  command->add_option("--seed", options->seed, "Of the global search, or of the chains");
  command->add_option("--max-evaluations", options->max_evaluations, "0: the method's own limit")
      ->check(CLI::NonNegativeNumber);
  command->add_flag("--json", options->json, "Print JSON");
  add_chain_options(*command, options->chains);
  command->callback([options] { run_fit(*options); });
}

}  // namespace thenar
