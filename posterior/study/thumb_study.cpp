#include "posterior/study/thumb_study.h"

#include <algorithm>
#include <cmath>

#include "posterior/study/thumb_fit.h"
#include "posterior/study/thumb_truth.h"

namespace thenar {
namespace {

TendonDigit thumb_of(const SourceText& source) {
  return build_tendon_digit(parse_subject(source.text, source.path), "thumb");
}

Experiment tasks_at(const TendonDigit& truth, double noise, unsigned seed) {
  TaskOptions options;
  options.noise = noise;
  options.seed = seed;
  return perform_tasks(truth, options);
}

Experiment pulls_of(const TendonDigit& truth, const ThumbFitSettings& settings, unsigned seed) {
  PullOptions pulls;
  pulls.noise = settings.noise;
  pulls.postures = settings.postures;
  pulls.seed = seed;
  return pull_muscles(truth, pulls);
}

ThumbReference reference_of(const ThumbStudy& study, const ThumbFitSettings& settings,
                            unsigned seed) {
  const TendonDigit truth = true_thumb(study, settings.skewness);
  ThumbFitSettings two = settings;
  two.postures = 2;
  const Experiment pulls = pulls_of(truth, two, seed);
  const Experiment tasks = tasks_at(truth, settings.noise, seed);
  const Eigen::Matrix3Xd predicted = true_forces(study.start, pulls);
  const auto [direction, sd] = internal::direction_errors(
      compare(pulls, predicted, Eigen::Matrix3Xd::Zero(3, predicted.cols()),
              start_has_seen(study.start, pulls)));
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

TaskScores task_scores(const std::vector<TaskMisfit>& misfits) {
  TaskScores out;
  const auto n = static_cast<double>(misfits.size());
  for (const TaskMisfit& misfit : misfits) {
    out.direction += misfit.direction / n;
    out.torque += misfit.torque / n;
    out.explained += misfit.distance <= kExplained ? 1 / n : 0;
  }
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
  const SourceText& file = study.inputs.skewed;
  const FitParameters parameters =
      choose_parameters(study.start, {}, parse_fit_settings(file.text, file.path));
  std::vector<double> values;
  for (const Parameter& parameter : parameters.all) {
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
  study.inputs = inputs;
  study.start = thumb_of(inputs.start);
  study.truth = in_frame_of(study.start, thumb_of(inputs.truth));
  for (const ThumbFitSettings& one : settings.fits) add_reference(one, settings.seed, study);
  for (std::size_t i = 0; i < settings.fits.size(); ++i) {
    settings.progress(static_cast<double>(i) / static_cast<double>(settings.fits.size()),
                      describe_fit(settings.fits[i]));
    if (settings.progress.stop()) return study;
    const TendonDigit truth = true_thumb(study, settings.fits[i].skewness);
    const internal::ThumbData data{truth, study.start,
                                   pulls_of(truth, settings.fits[i], settings.seed),
                                   tasks_at(truth, settings.fits[i].noise, settings.seed)};
    ThumbFit one = internal::run_thumb_fit(inputs, settings.fits[i], data, settings);
    if (!one.run.draws.complete) return study;
    study.fits.push_back(std::move(one));
  }
  study.complete = true;
  return study;
}

}  // namespace thenar
