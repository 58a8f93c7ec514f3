#include "kinematics_fit/fit.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <string_view>

#include "base/error.h"
#include "base/lists.h"
#include "data/io/net_description.h"
#include "data/io/result_layout.h"
#include "kinematics_fit/axis_pivots.h"
#include "kinematics_fit/fit_residuals.h"
#include "kinematics_fit/model/shared_postures.h"
#include "kinematics_fit/prediction.h"
#include "kinematics_fit/prior_scales.h"
#include "kinematics_fit/specimen_prior.h"
#include "tendons/net/build_net.h"

namespace thenar {
namespace internal {
const std::map<std::string, std::string_view>& fit_settings();  // data/fits, by file name
}

namespace {

/// Returns the names of the postures of all experiments, each once.
std::vector<std::string> posture_names(const std::vector<Experiment>& experiments) {
  std::vector<std::string> names;
  for (const Experiment& experiment : experiments)
    for (const PostureRecord& posture : experiment.postures)
      if (!contains(names, posture.name)) names.push_back(posture.name);
  return names;
}

/// Builds the digit with its tendons; a net replaces the hood. Passive moments are off: load cells
/// are zeroed with the digit at rest, so that measured forces are those of tendons.
TendonDigit build_digit(const FitInputs& inputs, const std::string& name) {
  const Subject subject = with_points_at_tendons(
      with_passive(parse_subject(inputs.subject.text, inputs.subject.path), PassiveMoments::kOff),
      name);
  if (!inputs.net) return build_tendon_digit(subject, name);
  TendonOptions separate;
  separate.hood = Hood::kSeparate;
  TendonDigit digit = build_tendon_digit(subject, name, separate);
  digit.net = std::make_shared<const BuiltNet>(
      build_net(subject, digit, parse_net(inputs.net->text, inputs.net->path)));
  digit.fidelity.hood = Hood::kFloatingNet;
  // Keep the knuckle: a muscle's split among its pulls may depend on its angle, as in a hood.
  digit.model.knuckle = build_tendon_digit(subject, name).model.knuckle;
  return digit;
}

/// Returns the inputs with the problem's prior scale factors written into their settings.
FitInputs with_factors_of(FitInputs inputs, const FitProblem& problem) {
  const std::vector<double> factors =
      transformed(problem.parameters().scales, &ScaledPriors::factor);
  if (factors.empty()) return inputs;
  const FitSettings settings = parse_fit_settings(inputs.settings.text, inputs.settings.path);
  inputs.settings.text = with_scale_factors(inputs.settings.text, settings, factors);
  return inputs;
}

}  // namespace

SourceText built_in_settings(const std::string& digit) {
  const std::string name = digit == "thumb" ? "thumb.toml" : "finger.toml";
  return {"built-in " + name, std::string(internal::fit_settings().at(name))};
}

std::vector<SourceText> sources_of(const FitInputs& inputs) {
  std::vector<SourceText> sources{inputs.subject, inputs.settings};
  if (inputs.net) sources.push_back(*inputs.net);
  append_all(sources, inputs.experiments);
  return sources;
}

FitProblem build_problem(const FitInputs& inputs) {
  // Parse the experiments, and check that they are of one digit and given only once.
  require(!inputs.experiments.empty(), "a fit needs at least one experiment");
  std::vector<Experiment> experiments;
  for (const SourceText& source : inputs.experiments)
    experiments.push_back(parse_experiment(source.text, source.path));
  for (const Experiment& experiment : experiments)
    require(experiment.digit == experiments.front().digit,
            "experiments are of different digits: '{}' of the {}, '{}' of the {}",
            experiments.front().name, experiments.front().digit, experiment.name, experiment.digit);

  for (std::size_t e = 0; e < experiments.size(); ++e)
    for (std::size_t other = 0; other < e; ++other)
      require(experiments[e].name != experiments[other].name,
              "experiment '{}' is given twice: it would count twice", experiments[e].name);

  // Rename a posture that differs from one of the same name in another experiment on the specimen.
  for (std::size_t e = 0; e < experiments.size(); ++e) {
    std::vector<Experiment> before;
    for (std::size_t other = 0; other < e; ++other)
      if (experiments[other].specimen == experiments[e].specimen)
        before.push_back(experiments[other]);
    experiments[e] = with_own_postures(std::move(experiments[e]), before);
  }

  // Build the digit, and choose which of its parameters are free.
  TendonDigit digit = build_digit(inputs, experiments.front().digit);
  const FitSettings settings = parse_fit_settings(inputs.settings.text, inputs.settings.path);
  FitParameters parameters =
      choose_parameters(digit, posture_names(experiments), settings, inputs.also_free);
  return {std::move(digit),      std::move(parameters),   std::move(experiments),
          settings.robust_scale, settings.axis_distances, inputs.scaling};
}

Fit run_fit(const FitInputs& inputs, const SolveOptions& options) {
  ScaledFit scaled = fit_with_scales(build_problem(inputs), options);
  Covariance covariance = posterior_covariance(scaled.problem, scaled.solution.z);
  return {with_factors_of(inputs, scaled.problem),
          std::move(scaled.problem),
          options.method,
          options.seed,
          std::move(scaled.solution),
          std::move(covariance)};
}

FitInputs with_inferred_scales(const FitInputs& inputs, const SolveOptions& options) {
  const FitProblem problem = build_problem(inputs);
  if (problem.parameters().scales.empty()) return inputs;
  return with_factors_of(inputs, fit_with_scales(problem, options).problem);
}

FittedValues fitted_values(const Fit& fit, int specimen) {
  // Compute the values, and the variance of every coordinate from the covariance of z.
  const FitParameters& parameters = fit.problem.parameters();
  const std::vector<double> values = parameter_values<double>(
      parameters, displacements(fit.problem.coordinates(), fit.solution.z, specimen));
  const Eigen::MatrixXd J =
      displacement_jacobian(fit.problem.coordinates(), fit.solution.z, specimen);
  Eigen::VectorXd variance =
      (J * fit.covariance.C.block_entries(specimen)).cwiseProduct(J).rowwise().sum();
  // Widen the population's variance by the share that a single specimen leaves unknown.
  const Eigen::VectorXd unseen = unseen_variance(fit.problem.coordinates());
  if (specimen < 0)
    for (int c = 0; c < parameters.coordinates(); ++c) {
      const Parameter& p = parameters.all[parameters.leader[c]];
      variance[c] += unseen[c] - p.between_sd * p.between_sd;
    }

  // Scale to display units; parameters tied to a coordinate share its sd, by their ratio.
  FittedValues out{Eigen::VectorXd::Zero(static_cast<Eigen::Index>(values.size())),
                   Eigen::VectorXd::Zero(static_cast<Eigen::Index>(values.size()))};
  for (Eigen::Index p = 0; p < out.value.size(); ++p) {
    const auto at = static_cast<std::size_t>(p);
    const double scale = display_scale(parameters.all[at]);
    out.value[p] = values[at] * scale;
    if (parameters.coordinate[at] >= 0)
      out.sd[p] = std::abs(parameters.ratio[at]) *
                  std::sqrt(std::max(0.0, variance[parameters.coordinate[at]])) * scale;
  }
  return out;
}

// Reading and writing of result files: everything needed to rerun a fit, and everything it found.
namespace {

constexpr const char* kFormat = "thenar fit 1";

void add_inputs(const FitInputs& inputs, ResultFile& file) {
  const auto add = [&](const std::string& key, const SourceText& source) {
    file.add(key + "/path", source.path);
    file.add(key + "/text", source.text);
    file.add("provenance/sha256/" + key, sha256(source.text));
  };
  add("inputs/subject", inputs.subject);
  add("inputs/settings", inputs.settings);
  if (inputs.net) add("inputs/net", *inputs.net);
  for (std::size_t e = 0; e < inputs.experiments.size(); ++e)
    add(fmt::format("inputs/experiment{}", e), inputs.experiments[e]);
  file.add("inputs/also_free", inputs.also_free);
  if (inputs.scaling == Scaling::kOutside) file.add("inputs/scale", "outside");
}

/// Writes the data to which the model was fitted: the experiments of this fit, and those to which
/// its initial subject was fitted.
void add_seen(const FitProblem& problem, ResultFile& file) {
  // List the experiments of this fit.
  std::vector<std::string> experiments, specimens, sources;
  for (const Experiment& experiment : problem.experiments()) {
    experiments.push_back(experiment.name);
    specimens.push_back(experiment.specimen);
  }
  // Add those of earlier fits that the subject comes from.
  for (const CalibratedOn& on : problem.digit().calibrated_on) {
    if (!on.source.empty()) {
      sources.push_back(on.source);
      continue;
    }
    if (contains(experiments, on.experiment)) continue;
    experiments.push_back(on.experiment);
    specimens.push_back(on.specimen);
  }
  file.add("fit/calibrated_on/experiment", experiments);
  file.add("fit/calibrated_on/specimen", specimens);
  if (!sources.empty()) file.add("fit/calibrated_on/source", sources);
}

FitInputs inputs_of(const ResultFile& file) {
  const auto get = [&](const std::string& key) {
    return SourceText{file.text(key + "/path"), file.text(key + "/text")};
  };
  FitInputs inputs{
      get("inputs/subject"), get("inputs/settings"), {}, file.list("inputs/also_free")};
  if (file.texts.count("inputs/net/text") > 0) inputs.net = get("inputs/net");
  if (file.texts.count("inputs/scale") > 0)
    inputs.scaling = value_in(kScalingNames, file.text("inputs/scale"), "scaling");
  for (int e = 0; file.texts.count(fmt::format("inputs/experiment{}/text", e)) > 0; ++e)
    inputs.experiments.push_back(get(fmt::format("inputs/experiment{}", e)));
  return inputs;
}

/// Writes values and sds of every parameter, of the population and of each specimen.
void add_parameters(const Fit& fit, ResultFile& file) {
  // Write names and units, once for all groups.
  const std::vector<Parameter>& all = fit.problem.parameters().all;
  file.add("parameters/name", names_of(all));
  file.add("parameters/unit", transformed(all, display_unit));

  // Write values and sds of the population, then of each specimen.
  const auto add = [&](const std::string& group, int specimen) {
    const FittedValues fitted = fitted_values(fit, specimen);
    file.add(group + "/value", fitted.value, "see parameters/unit", {"parameter"});
    file.add(group + "/sd", fitted.sd, "see parameters/unit", {"parameter"});
  };
  add("parameters/population", kPopulation);
  for (std::size_t s = 0; s < fit.problem.specimens().size(); ++s)
    add("parameters/specimens/" + fit.problem.specimens()[s], static_cast<int>(s));
}

void add_predictions(const Fit& fit, ResultFile& file) {
  for (std::size_t e = 0; e < fit.problem.experiments().size(); ++e) {
    // Arrange forces as matrices, with a row for each trial.
    const Prediction prediction = predict_fitted(fit.problem, fit.solution.z, static_cast<int>(e));
    if (prediction.trials.empty()) continue;  // rows of activations alone
    const std::string group = "predictions/" + prediction.experiment;
    const auto trials = static_cast<Eigen::Index>(prediction.trials.size());
    Eigen::MatrixXd measured(trials, 3), predicted(trials, 3);
    for (Eigen::Index i = 0; i < trials; ++i) {
      measured.row(i) = prediction.trials[i].measured;
      predicted.row(i) = prediction.trials[i].predicted;
    }

    // Write one group for each experiment.
    file.add(group + "/posture", transformed(prediction.trials, &PredictedTrial::posture));
    file.add(group + "/loads", transformed(prediction.trials, &PredictedTrial::loads));
    file.add(group + "/measured", measured, "N", {"trial", "component"});
    file.add(group + "/predicted", predicted, "N", {"trial", "component"});
    file.add(group + "/relative_error", prediction.error.relative, "1");
    file.add(group + "/start_has_seen_specimen", prediction.calibrated_on_specimen ? 1 : 0, "1");
  }
}

void add_provenance(const Fit& fit, ResultFile& file) {
  for (const auto& [name, version] : versions()) file.add("provenance/versions/" + name, version);
  file.add("provenance/fidelity", describe(fit.problem.digit().fidelity));
  file.add("provenance/method", name_of(fit.method));
  file.add("provenance/seed", fit.seed, "1");
  for (const auto& [name, text] : texts_of(fit.run)) file.add("provenance/" + name, text);
}

/// Returns the record of the run; its texts are empty where the file has none.
RunRecord run_of(const ResultFile& file) {
  std::map<std::string, std::string> texts;
  for (const char* const name : {"command", "folder", "date", "commit", "request"})
    texts[name] = file.text_or_none(fmt::format("provenance/{}", name));
  return record_of_texts(texts);
}

/// Returns a solution whose status convergence_word() describes as `word`; all else is empty.
Solution solution_with_status(const std::string& word) {
  Solution solution;
  solution.failed = word == "failed";
  for (const Status status :
       {Status::kStalled, Status::kSolved, Status::kLimit, Status::kStopped}) {
    solution.status = status;
    if (convergence_word(solution) == word) return solution;
  }
  throw InputError(fmt::format("no solver status '{}'", word));
}

/// Reads a fit. @throws InputError for what is missing or inconsistent.
Fit fit_of(const ResultFile& file) {
  // Rebuild the problem from the inputs, and check that the estimate belongs to it.
  const FitInputs inputs = inputs_of(file);
  FitProblem problem = build_problem(inputs);
  const Eigen::VectorXd z = vector_in(file, "fit/z");
  require(z.size() == problem.size(), "the fit has {} coordinates, its inputs give {}", z.size(),
          problem.size());
  const std::vector<std::string>& names = file.list("fit/name");
  const std::vector<std::string> wanted = problem.coordinates().names();
  for (std::size_t i = 0; i < wanted.size(); ++i)
    require(i < names.size() && names[i] == wanted[i],
            "coordinate {} of the fit is '{}', its inputs give '{}'", i,
            i < names.size() ? names[i] : "", wanted[i]);
  // Restore the solution, and recompute its covariance.
  Solution solution = solution_with_status(file.text("fit/status"));
  solution.z = z;
  solution.cost = file.number("fit/cost");
  solution.message = file.text("fit/message");
  solution.evaluations = static_cast<int>(file.number("fit/evaluations"));
  solution.seconds = file.number("fit/seconds");
  Covariance covariance = posterior_covariance(problem, z);
  return {inputs,
          std::move(problem),
          least_squares_method(file.text("provenance/method")),
          static_cast<unsigned>(file.number("provenance/seed")),
          std::move(solution),
          std::move(covariance),
          run_of(file)};
}

/// Writes the covariance of the entries of z that move each specimen, and their indices: those of
/// the population, then its own. Covariances between two specimens follow from the population's
/// entries.
void add_covariance(const Fit& fit, ResultFile& file) {
  const auto specimens = fit.problem.specimens().size();
  std::vector<double> values, entries;
  for (int specimen = 0; specimen < static_cast<int>(specimens); ++specimen) {
    const Eigen::MatrixXd C = fit.covariance.C.block_entries(specimen);
    values.insert(values.end(), C.data(), C.data() + C.size());  // symmetric
    const std::vector<int> on = fit.problem.coordinates().entries_of_specimen(specimen);
    append_all(entries, on);
  }
  const std::size_t count = entries.size() / specimens;
  file.arrays["fit/covariance"] = {
      std::move(values), {specimens, count, count}, "1", {"specimen", "entry", "entry_"}};
  file.arrays["fit/entry_of_z"] = {
      std::move(entries), {specimens, count}, "1", {"specimen", "entry"}};
}

}  // namespace

void write_fit(const Fit& fit, const std::string& path) {
  // Write the inputs first: the file can be run again.
  ResultFile file;
  file.add("format", kFormat);
  add_inputs(fit.inputs, file);

  // Write the estimate and the solver's status.
  file.add("fit/z", fit.solution.z, "1", {"coordinate"});
  file.add("fit/name", fit.problem.coordinates().names());
  add_covariance(fit, file);
  file.add("fit/cost", fit.solution.cost, "1");
  file.add("fit/status", convergence_word(fit.solution));
  file.add("fit/message", fit.solution.message);
  file.add("fit/evaluations", fit.solution.evaluations, "1");
  file.add("fit/seconds", fit.solution.seconds, "s");

  // Write the directions that the data leave undetermined.
  file.add("fit/not_identifiable",
           transformed(fit.covariance.null_directions, &NullDirection::text));

  // Write parameters, predictions and provenance in names and units for readers.
  add_seen(fit.problem, file);
  add_parameters(fit, file);
  add_predictions(fit, file);
  add_provenance(fit, file);
  write_result(file, path);
}

Fit read_fit(const std::string& path) {
  const ResultFile file = read_result(path);
  if (file.text_or_none("format") != kFormat)
    throw DataError(path, 1, fmt::format("wanted a '{}' file", kFormat));
  try {
    return fit_of(file);
  } catch (const InputError& e) {
    throw DataError(path, 1, e.what());
  }
}

}  // namespace thenar
