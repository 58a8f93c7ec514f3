#include "studies/thumb/thumb_study.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include <fmt/format.h>

#include "data/io/toml_node.h"
#include "studies/thumb/thumb_fit.h"
#include "studies/thumb/thumb_truth.h"

namespace thenar {
namespace {

constexpr bool kBothModels[] = {false, true};

/// Both models at some noises, 2 postures.
void add_noises(Arms arms, std::initializer_list<double> noises, double skewness,
                std::vector<ThumbFitSettings>& fits) {
  for (const double noise : noises)
    for (const bool skewed : kBothModels) fits.push_back({skewed, arms, noise, 2, skewness, false});
}

/// 1, 3 and 4 postures at 10 %; 2 are among the noises.
void add_postures(bool skewed, Arms arms, std::vector<ThumbFitSettings>& fits) {
  for (const int postures : {1, 3, 4}) fits.push_back({skewed, arms, 0.1, postures, 1, false});
}

Experiment tasks_at(const TendonDigit& truth, double noise, unsigned seed) {
  TaskOptions options;
  options.noise = noise;
  options.seed = seed;
  return simulate_tasks(truth, options);
}

Experiment pulls_of(const TendonDigit& truth, const ThumbFitSettings& settings, unsigned seed) {
  SimulatedPullOptions pulls;
  pulls.noise = settings.noise;
  pulls.postures = settings.postures;
  pulls.seed = seed;
  return simulate_pulls(truth, pulls);
}

ThumbReference reference_of(const ThumbStudy& study, const ThumbFitSettings& settings,
                            unsigned seed) {
  // Pulls and tasks of the true thumb.
  const TendonDigit truth = true_thumb(study, settings.skewness);
  ThumbFitSettings two = settings;
  two.postures = 2;
  const Experiment pulls = pulls_of(truth, two, seed);
  const Experiment tasks = tasks_at(truth, settings.noise, seed);
  // Forces by the thumb at the start, which was not fitted.
  const Eigen::Matrix3Xd predicted = true_forces(study.start, pulls);
  const auto [direction, sd] = internal::direction_errors(
      compare_forces(pulls, predicted, Eigen::Matrix3Xd::Zero(3, predicted.cols()),
                     calibrated_on_specimen(study.start, pulls)));
  return {settings.noise,
          settings.skewness,
          direction,
          sd,
          task_scores(task_misfits(study.start, tasks)),
          task_scores(task_misfits(truth, tasks))};
}

void add_reference(const ThumbFitSettings& settings, unsigned seed, ThumbStudy& study) {
  for (const ThumbReference& known : study.references)
    if (known.noise == settings.noise && known.skewness == settings.skewness) return;
  study.references.push_back(reference_of(study, settings, seed));
}

}  // namespace

ThumbStudyInputs thumb_study_inputs(const std::string& data) {
  const auto read = [&](const char* file) {
    const std::string path = data + "/" + file;
    return SourceText{path, read_text_file(path)};
  };
  return {read("subjects/arms_five_axis_thumb.toml"),
          read("subjects/mechanical_five_axis_thumb.toml"), read("fits/five_axis_orthogonal.toml"),
          read("fits/five_axis_skewed.toml"), read("studies/thumb_axes_variability.toml")};
}

ThumbStudySettings full_thumb_study() {
  // Noises, and twice the published skewness.
  ThumbStudySettings settings;
  add_noises(Arms::kFixed, {0.01, 0.05, 0.1, 0.2}, 1, settings.fits);
  add_noises(Arms::kFixed, {0.05, 0.1, 0.2}, 2, settings.fits);
  // Postures, and tasks beside the pulls.
  for (const bool skewed : kBothModels) {
    add_postures(skewed, Arms::kFixed, settings.fits);
    settings.fits.push_back({skewed, Arms::kFixed, 0.1, 2, 1, true});
  }
  // Arms learnt too.
  add_noises(Arms::kFree, {0.05, 0.1, 0.2}, 1, settings.fits);
  // Where anatomy hardly helps, there may be several modes.
  for (const int postures : {1, 2, 4})
    for (const bool skewed : kBothModels)
      settings.fits.push_back({skewed, Arms::kFixed, 0.05, postures, 1, false, 3});
  return settings;
}

ThumbStudySettings quick_thumb_study() {
  // Noises and postures, arms fixed.
  ThumbStudySettings settings;
  add_noises(Arms::kFixed, {0.05, 0.1, 0.2}, 1, settings.fits);
  add_postures(true, Arms::kFixed, settings.fits);
  // Short chains, few searches.
  settings.draws = 500;
  settings.warm_up = 500;
  settings.mode_starts = 8;
  settings.retries = 1;
  return settings;
}

bool is_compared(const ThumbFitSettings& s) {
  return s.arms == Arms::kFixed && s.noise == 0.1 && s.postures == 2 && s.skewness == 1 &&
         !s.with_tasks && s.prior_width == 1;
}

std::string describe_fit(const ThumbFitSettings& settings) {
  return fmt::format(
      "{}, arms {}, {:.0f} % noise, {} {}{}{}{}", settings.skewed ? "skewed" : "orthogonal",
      settings.arms == Arms::kFixed ? "known" : "free", 100 * settings.noise, settings.postures,
      settings.postures == 1 ? "posture" : "postures",
      settings.skewness == 1 ? "" : fmt::format(", {} x skew", settings.skewness),
      settings.with_tasks ? ", with tasks" : "",
      settings.prior_width == 1 ? "" : fmt::format(", {} x prior", settings.prior_width));
}

TaskScores task_scores(const std::vector<TaskMisfit>& misfits) {
  TaskScores out;
  // Means, and the share of tasks that are explained.
  const auto n = static_cast<double>(misfits.size());
  for (const TaskMisfit& misfit : misfits) {
    out.direction += misfit.direction / n;
    out.torque += misfit.torque / n;
    out.explained += misfit.distance <= kChiSquare3At95 ? 1 / n : 0;
  }
  // Sds over tasks.
  for (const TaskMisfit& misfit : misfits) {
    out.direction_sd += std::pow(misfit.direction - out.direction, 2) / std::max(1.0, n - 1);
    out.torque_sd += std::pow(misfit.torque - out.torque, 2) / std::max(1.0, n - 1);
  }
  out.direction_sd = std::sqrt(out.direction_sd);
  out.torque_sd = std::sqrt(out.torque_sd);
  return out;
}

TendonDigit true_thumb(const ThumbStudy& study, double skewness) {
  if (skewness == 1) return study.truth;
  // Parameters that turn the start into the truth.
  const SourceText& file = study.inputs.skewed;
  const FitParameters parameters =
      choose_parameters(study.start, {}, parse_fit_settings(file.text, file.path));
  std::vector<double> values;
  for (const Parameter& parameter : parameters.all) {
    // Axes are skewed as much more as is wanted; arms stay.
    const bool axis = parameter.name.rfind("axis/", 0) == 0;
    const std::optional<double> value = true_value(parameter, study.start, study.truth);
    values.push_back(axis && value ? skewness * *value : value.value_or(parameter.mean));
  }
  TendonDigit out = study.truth;
  out.model = specimen_model(study.start, parameters, values).digit;
  return out;
}

ThumbStudy study_thumb(const ThumbStudyInputs& inputs, const ThumbStudySettings& settings) {
  ThumbStudy study;
  // Both thumbs in one frame, and those that no fit improves.
  study.inputs = inputs;
  study.start = internal::thumb_of(inputs.start);
  study.truth = in_frame_of(study.start, internal::thumb_of(inputs.truth));
  study.criteria = mean_thumb(parse_variability(inputs.criteria.text, inputs.criteria.path),
                              parse_subject(inputs.start.text, inputs.start.path));
  for (const ThumbFitSettings& one : settings.fits) add_reference(one, settings.seed, study);
  for (std::size_t i = 0; i < settings.fits.size(); ++i) {
    // Fit by fit, until somebody stops it.
    settings.progress(static_cast<double>(i) / static_cast<double>(settings.fits.size()),
                      describe_fit(settings.fits[i]));
    if (settings.progress.stop()) return study;
    // Its data: pulls and tasks of its true thumb.
    const TendonDigit truth = true_thumb(study, settings.fits[i].skewness);
    const internal::ThumbData data{
        truth, study.start, pulls_of(truth, settings.fits[i], settings.seed),
        tasks_at(truth, settings.fits[i].noise, settings.seed), study.criteria};
    ThumbFit one = internal::run_thumb_fit(inputs, settings.fits[i], data, settings);
    if (!one.run.draws.complete) return study;
    study.fits.push_back(std::move(one));
  }
  study.complete = true;
  return study;
}

}  // namespace thenar
