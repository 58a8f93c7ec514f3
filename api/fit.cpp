#include "api/fit.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "api/named/data_folders.h"
#include "api/named/digits.h"
#include "api/named/files.h"
#include "base/error.h"
#include "base/lists.h"
#include "base/rung_names.h"
#include "base/words.h"
#include "data/io/subject_doubts.h"
#include "kinematics_fit/model/net_trials.h"
#include "kinematics_fit/odd_trials.h"
#include "kinematics_fit/prior_scales.h"
#include "kinematics_fit/specimen_prior.h"
#include "kinematics_fit/undetermined_tilts.h"

namespace thenar {
namespace {

/// A prediction by the subject as it was published; empty of a subject that lacks the digit, a
/// muscle, a joint or the segment of the experiment.
std::optional<Prediction> predicted_as_published(const SourceText& subject,
                                                 const Experiment& experiment) {
  try {
    return predict_as_published(subject, experiment);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

/// Returns predictions of a fit's experiments as published, by the subject that the fit starts from
/// and by all other subjects of the data.
std::vector<BaselinePrediction> published_predictions(const Fit& fit, const std::string& data) {
  std::vector<BaselinePrediction> all;
  // A subject is compared only if it publishes predictions for the trials of the experiment.
  const auto add = [&](const SourceText& subject) {
    const std::string name = parse_subject(subject.text, subject.path).name;
    for (const Experiment& experiment : fit.problem.experiments())
      if (const auto prediction = predicted_as_published(subject, experiment))
        all.push_back({name, "as published", *prediction});
  };
  // Skip the file that the fit started from, whatever its name in the data folders.
  const SourceText& start = fit.inputs.subject;
  add(start);
  for (const std::string& name : names_in(data_folders(data), "subjects")) {
    const SourceText other = subject_source(name, data);
    if (other.text != start.text) add(other);
  }
  return all;
}

/// "experiment 'H01': the fit misses .." of every experiment that chance cannot explain.
std::vector<std::string> misfit_warnings(const FitResult& result) {
  std::vector<std::string> warnings;
  for (std::size_t e = 0; e < result.misfits.size(); ++e)
    if (result.misfits[e].beyond_chance)
      warnings.push_back(fmt::format("experiment '{}': {}",
                                     result.fit.problem.experiments()[e].name,
                                     describe(result.misfits[e])));
  return warnings;
}

/// Returns warnings about specimens whose forces require much more noise than stated.
std::vector<std::string> noise_warnings(const FitResult& result) {
  const FitProblem& problem = result.fit.problem;
  std::vector<std::string> warnings;
  // Wide priors take up any force, so noise is judged by the evidence, not by squares of residuals.
  const std::vector<NoiseEvidence> noise = noise_evidence(problem, result.fit.solution.z);
  for (std::size_t s = 0; s < noise.size(); ++s)
    if (noise[s].understated())
      warnings.push_back(fmt::format(
          "specimen '{}': its forces scatter as if their noise were {:.3g} times the stated one, "
          "whatever priors allow (log evidence {:.1f} beyond that of the stated one): was it "
          "stated too small?",
          problem.specimens()[s], noise[s].factor, noise[s].gain));
  return warnings;
}

/// Trials of every experiment in which a net is not to be trusted.
std::vector<std::string> net_warnings(const Fit& fit) {
  std::vector<std::string> warnings;
  const FitProblem& problem = fit.problem;
  for (std::size_t e = 0; e < problem.plans().size(); ++e) {
    // Evaluate each trial at the posture and parameters of its own specimen.
    const Eigen::VectorXd u = displacements(problem.coordinates(), fit.solution.z,
                                            problem.specimen_of(static_cast<int>(e)));
    for (const std::string& warning :
         net_trial_warnings(problem.digit(), problem.parameters(), problem.plans()[e], u))
      warnings.push_back(
          fmt::format("experiment '{}': {}", problem.experiments()[e].name, warning));
  }
  return warnings;
}

/// Parameters that were moved farther than their priors believe possible, in one sentence.
std::vector<std::string> stray_warnings(const Covariance& covariance) {
  constexpr double kFarMoved = 3;  // prior sds [1]
  // Under the prior a shift beyond 3 sds has a probability of 0.3 %.
  std::vector<const CoordinateEstimate*> far;
  for (const CoordinateEstimate& learnt : covariance.learnt)
    if (std::abs(learnt.z) > kFarMoved) far.push_back(&learnt);
  if (far.empty()) return {};
  // List the largest shift first, as it is most likely the wrong number.
  std::sort(far.begin(), far.end(),
            [](const auto* a, const auto* b) { return std::abs(a->z) > std::abs(b->z); });
  std::vector<std::string> names;
  for (const CoordinateEstimate* each : far)
    names.push_back(fmt::format("{} ({:+.1f})", each->name, each->z));
  return {fmt::format(
      "moved by more than {:.0f} prior sds: {}. Is a sign or a unit of the subject or the "
      "experiment wrong, or the prior too narrow?",
      kFarMoved, some_of(names))};
}

/// Chooses the settings of the inputs, if requested.
struct Preparation {
  FitInputs inputs;
  FitSettings settings;  // before they were chosen; empty where they are not
  std::optional<ChosenSettings> chosen;
};

Preparation prepare(const FitRequest& request, FitInputs inputs, const SolveOptions& options) {
  Preparation out{std::move(inputs), {}, {}};
  if (!request.choose_settings) return out;
  out.settings = parse_fit_settings(out.inputs.settings.text, out.inputs.settings.path);
  out.chosen =
      choose_settings(build_problem(out.inputs), out.settings, out.inputs.also_free, options);
  out.inputs.settings.text = with_choices(out.inputs.settings.text, out.chosen->settings);
  return out;
}

/// Predicts left-out trials, and collects the settings that folds chose.
struct LeftOut {
  std::vector<CrossValidation> validations;
  std::vector<FoldChoice> choices;
};

LeftOut leave_out(const FitRequest& request, const FitProblem& problem, const Preparation& prepared,
                  const SolveOptions& options) {
  LeftOut out;
  for (const LeaveOut what : request.leave_out) {
    // A stop between two validations keeps those that are done.
    if (options.progress.stop()) break;
    // If the fit chose its settings from the data, each fold has to choose them again, or the error
    // is too small.
    if (!request.choose_settings) {
      out.validations.push_back(cross_validate(problem, what, options));
      continue;
    }
    NestedValidation nested =
        validate_choice(problem, prepared.settings, prepared.inputs.also_free, what, options);
    out.validations.push_back(std::move(nested.validation));
    for (FoldChoice& fold : nested.folds) out.choices.push_back(std::move(fold));
  }
  return out;
}

/// Repeats a fit without the net; empty if there is no net or the subject has no fractions.
std::optional<FractionsFit> fit_fractions(const FitRequest& request, const FitInputs& asked,
                                          const SolveOptions& options) {
  if (!asked.net || options.progress.stop()) return {};
  FitInputs inputs = asked;
  inputs.net.reset();
  // Parameters of the net are not there.
  erase_where(inputs.also_free, [](const std::string& glob) { return glob.rfind("net/", 0) == 0; });
  // Compare with fractions of the hood only where the subject states them.
  if (!build_problem(inputs).digit().model.hood) return {};
  const Preparation prepared = prepare(request, std::move(inputs), options);
  FractionsFit out{run_fit(prepared.inputs, options), {}, {}};
  out.in_sample = predict_own(out.fit);
  out.left_out = leave_out(request, out.fit.problem, prepared, options).validations;
  return out;
}

}  // namespace

LeaveOut leave_out_named(const std::string& name) {
  return value_in(kLeaveOutNames, name, "part to leave out");
}

std::string experiment_file(const std::string& name_or_path, const std::string& data,
                            const char* field) {
  return requested_file(field, "experiment", name_or_path, "experiments", data);
}

SourceText fit_settings_source(const std::string& settings, const std::string& digit,
                               const std::string& data) {
  if (settings.empty()) return built_in_settings(digit);
  return read_source(
      named_file("file of fit settings", settings, "fits", ".toml", data_folders(data)));
}

void require_fit_path(const std::optional<Path>& path) {
  require_field(
      "path", !path || *path == Path::kViaPoint,
      "the force model of a fit runs tendons straight between via points, as its kernel does "
      "not wrap: wanted paths 'via', got '{}'",
      path ? name_of(*path) : "");
}

std::vector<std::string> path_cautions(const FitInputs& inputs) {
  const Subject subject = parse_subject(inputs.subject.text, inputs.subject.path);
  if (default_path(subject) != Path::kWrapped) return {};
  return {fmt::format(
      "subject '{}' has tendons that wrap over surfaces or originate from others in other "
      "questions: this fit, and what comes from it, runs them straight between via points",
      subject.name)};
}

FitInputs read_fit_inputs(const FitSources& sources) {
  require_fit_path(sources.path);
  require_field("experiments", !sources.experiments.empty(), "a fit needs at least one experiment");
  FitInputs inputs;
  // Store subject and settings as text, so that the fit can be repeated without the files.
  inputs.subject = subject_source(sources.subject, sources.data);
  for (const std::string& name : sources.experiments)
    inputs.experiments.push_back(read_source(experiment_file(name, sources.data)));
  // Default settings depend on the digit, which the first experiment states.
  const SourceText& first = inputs.experiments.front();
  inputs.settings = fit_settings_source(
      sources.settings, parse_experiment(first.text, first.path).digit, sources.data);
  inputs.also_free = sources.also_free;
  inputs.scaling = sources.scale;
  if (!sources.net.empty())
    inputs.net =
        read_source(named_file("net", sources.net, "nets", ".toml", data_folders(sources.data)));
  return inputs;
}

FitResult fit_digit(const FitRequest& request, const Progress& progress) {
  // Check the path before the work starts.
  if (!request.output.empty()) require_result_path(request.output);
  // Pass on the settings of the optimiser; the rest of the request concerns the inputs.
  SolveOptions options;
  options.method = request.method;
  options.seed = request.seed;
  options.max_evaluations = request.max_evaluations;
  options.progress = progress;
  const FitInputs asked = read_fit_inputs(request.sources);
  const Preparation prepared = prepare(request, asked, options);
  // Run the fit, and compare it with the noise that was stated.
  FitResult result{request, {}, run_fit(prepared.inputs, options), {}, {}};
  result.chosen = prepared.chosen;
  result.fit.run = request.run;
  const Fit& fit = result.fit;
  result.misfits = misfits(fit.problem, fit.solution.z, fit.covariance);
  // Collect doubts about the subject, the data, the noise, the axes and the net, in the order in
  // which an engineer would look for the cause.
  Outcome& outcome = result.outcome;
  outcome.warn(subject_doubts(parse_subject(fit.inputs.subject.text, fit.inputs.subject.path)));
  outcome.warn(fit.problem.warnings());
  outcome.warn(misfit_warnings(result));
  outcome.warn(describe(fit.problem, odd_trials(fit.problem, fit.solution.z, fit.covariance)));
  outcome.warn(noise_warnings(result));
  outcome.warn(describe(find_undetermined_tilts(fit.problem, fit.solution.z, fit.covariance)));
  outcome.warn(net_warnings(fit));
  outcome.warn(stray_warnings(fit.covariance));
  outcome.warn(path_cautions(fit.inputs));
  // Write the fit at once, because cross-validation takes longer.
  if (!request.output.empty()) write_fit(result.fit, request.output);

  // Predict in sample, then by fits without the predicted trials.
  result.in_sample = predict_own(result.fit);
  LeftOut left_out = leave_out(request, result.fit.problem, prepared, options);
  result.left_out = std::move(left_out.validations);
  result.fold_choices = std::move(left_out.choices);
  // Warn of left-out forces that are medians of draws, as angles and axes are hardly known.
  for (const CrossValidation& validation : result.left_out)
    for (const Prediction& prediction : validation.experiments)
      for (const std::string& warning : unsteady_force_warnings(prediction))
        outcome.warnings.push_back(name_of(validation.what) + " left out: " + warning);
  // Compare with published models and with fractions, as the net has to beat both.
  if (!result.left_out.empty()) {
    result.published = published_predictions(result.fit, request.sources.data);
    result.fractions = fit_fractions(request, asked, options);
  }
  outcome.status = progress.stop()            ? Status::kStopped
                   : fit.solution.converged() ? Status::kSolved
                   : fit.solution.failed      ? Status::kStalled
                                              : fit.solution.status;
  return result;
}

std::vector<Prediction> predict_own(const Fit& fit) {
  std::vector<Prediction> predictions;
  for (std::size_t e = 0; e < fit.problem.experiments().size(); ++e) {
    const Experiment& experiment = fit.problem.experiments()[e];
    predictions.push_back(predict_fitted(fit.problem, fit.solution.z, static_cast<int>(e)));
    // Predict once more as for new data: these sds contain the uncertainty of the parameters.
    const Prediction sure =
        predict_experiment(fit.problem, fit.solution.z, fit.covariance.C, experiment,
                           find_specimen(fit.problem, experiment.specimen));
    for (std::size_t i = 0; i < sure.trials.size(); ++i)
      predictions.back().trials[i].sd = sure.trials[i].sd;
    predictions.back().error.covered = sure.error.covered;
  }
  return predictions;
}

TendonDigit fitted_digit(const Fit& fit, int specimen) {
  const TendonDigit& digit = fit.problem.digit_of(specimen);
  const FitParameters& parameters = fit.problem.parameters();
  return specimen_digit(
      digit, specimen_model(
                 digit, parameters,
                 parameter_values<double>(parameters, displacements(fit.problem.coordinates(),
                                                                    fit.solution.z, specimen))));
}

}  // namespace thenar
