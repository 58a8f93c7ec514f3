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

/// Names of the postures of all experiments, each once.
std::vector<std::string> posture_names(const std::vector<Experiment>& experiments) {
  std::vector<std::string> names;
  for (const Experiment& experiment : experiments)
    for (const PostureRecord& posture : experiment.postures)
      if (!contains(names, posture.name)) names.push_back(posture.name);
  return names;
}

/// The digit with its tendons; a net takes the place of the hood. Load cells are zeroed under the
/// digit at rest, so that measured forces are those of tendons, without passive moments.
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
  // Shares of a muscle among its pulls may depend on the knuckle, as those of a hood do.
  digit.model.knuckle = build_tendon_digit(subject, name).model.knuckle;
  return digit;
}

/// Inputs whose settings have the factors of the problem's prior scales in force.
FitInputs with_factors_of(FitInputs inputs, const FitProblem& problem) {
  std::vector<double> factors;
  for (const ScaledPriors& scale : problem.parameters().scales) factors.push_back(scale.factor);
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
  // Experiments: of one digit, each once.
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

  // Another posture of the same name, in another experiment on the same specimen, gets a name of
  // its own.
  for (std::size_t e = 0; e < experiments.size(); ++e) {
    std::vector<Experiment> before;
    for (std::size_t other = 0; other < e; ++other)
      if (experiments[other].specimen == experiments[e].specimen)
        before.push_back(experiments[other]);
    experiments[e] = with_own_postures(std::move(experiments[e]), before);
  }

  // The digit, and which of its parameters are free.
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
  // Values, and the variance that the covariance of z gives to every coordinate.
  const FitParameters& parameters = fit.problem.parameters();
  const std::vector<double> values = parameter_values<double>(
      parameters, displacements(fit.problem.coordinates(), fit.solution.z, specimen));
  const Eigen::MatrixXd J =
      displacement_jacobian(fit.problem.coordinates(), fit.solution.z, specimen);
  Eigen::VectorXd variance =
      (J * fit.covariance.C.block_entries(specimen)).cwiseProduct(J).rowwise().sum();
  // What one specimen alone cannot say of the population stays as wide as the prior has it.
  const Eigen::VectorXd unseen = unseen_variance(fit.problem.coordinates());
  if (specimen < 0)
    for (int c = 0; c < parameters.coordinates(); ++c) {
      const Parameter& p = parameters.all[parameters.leader[c]];
      variance[c] += unseen[c] - p.between_sd * p.between_sd;
    }

  // Parameters tied to a coordinate share its sd, by their ratio.
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

// The result file of a fit: everything needed to run it again, and everything it found.
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

/// Writes the data that the fit has seen: its own experiments, and the experiments to which its
/// start was fitted.
void add_seen(const FitProblem& problem, ResultFile& file) {
  // The experiments of this fit.
  std::vector<std::string> experiments, specimens, sources;
  for (const Experiment& experiment : problem.experiments()) {
    experiments.push_back(experiment.name);
    specimens.push_back(experiment.specimen);
  }
  // Those of earlier fits that the subject comes from.
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
    inputs.scaling = scaling_named(file.text("inputs/scale"));
  for (int e = 0; file.texts.count(fmt::format("inputs/experiment{}/text", e)) > 0; ++e)
    inputs.experiments.push_back(get(fmt::format("inputs/experiment{}", e)));
  return inputs;
}

/// Values and sds of every parameter, of the population and of each specimen.
void add_parameters(const Fit& fit, ResultFile& file) {
  // Names and units, once for all groups.
  std::vector<std::string> names, units;
  for (const Parameter& parameter : fit.problem.parameters().all) {
    names.push_back(parameter.name);
    units.push_back(display_unit(parameter));
  }
  file.add("parameters/name", names);
  file.add("parameters/unit", units);

  // Values and sds: the population, then each specimen.
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
    // Forces as matrices, trials as rows.
    const Prediction prediction = predict_fitted(fit.problem, fit.solution.z, static_cast<int>(e));
    if (prediction.trials.empty()) continue;  // rows of activations alone
    const std::string group = "predictions/" + prediction.experiment;
    const auto trials = static_cast<Eigen::Index>(prediction.trials.size());
    Eigen::MatrixXd measured(trials, 3), predicted(trials, 3);
    std::vector<std::string> postures, loads;
    for (Eigen::Index i = 0; i < trials; ++i) {
      postures.push_back(prediction.trials[i].posture);
      loads.push_back(prediction.trials[i].loads);
      measured.row(i) = prediction.trials[i].measured;
      predicted.row(i) = prediction.trials[i].predicted;
    }

    // One group for each experiment.
    file.add(group + "/posture", postures);
    file.add(group + "/loads", loads);
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

/// The record of the run; empty where the file has none.
RunRecord run_of(const ResultFile& file) {
  std::map<std::string, std::string> texts;
  for (const char* const name : {"command", "folder", "date", "commit", "request"})
    texts[name] = file.text_or_none(fmt::format("provenance/{}", name));
  return record_of_texts(texts);
}

/// A solution that ended as the word of convergence_word() says; all else is empty.
Solution ended_as(const std::string& word) {
  Solution solution;
  solution.failed = word == "failed";
  for (const Status status :
       {Status::kStalled, Status::kSolved, Status::kLimit, Status::kStopped}) {
    solution.status = status;
    if (convergence_word(solution) == word) return solution;
  }
  throw InputError(fmt::format("no solver status '{}'", word));
}

/// @throws InputError for what is missing or does not fit together.
Fit fit_of(const ResultFile& file) {
  // The problem is built anew from the inputs; the estimate must belong to it.
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
  Solution solution = ended_as(file.text("fit/status"));
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

/// Covariance of the entries of z that move a specimen, and which these are: the population's, then
/// its own. What two specimens have in common is in the population's.
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
  // Inputs first: the file can be run again.
  ResultFile file;
  file.add("format", kFormat);
  add_inputs(fit.inputs, file);

  // Estimate, and how the solver ended.
  file.add("fit/z", fit.solution.z, "1", {"coordinate"});
  file.add("fit/name", fit.problem.coordinates().names());
  add_covariance(fit, file);
  file.add("fit/cost", fit.solution.cost, "1");
  file.add("fit/status", convergence_word(fit.solution));
  file.add("fit/message", fit.solution.message);
  file.add("fit/evaluations", fit.solution.evaluations, "1");
  file.add("fit/seconds", fit.solution.seconds, "s");

  // Directions that the data leave open.
  std::vector<std::string> null_directions;
  for (const NullDirection& null : fit.covariance.null_directions)
    null_directions.push_back(null.text);
  file.add("fit/not_identifiable", null_directions);

  // Parameters, predictions and provenance in words and units that people read.
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
