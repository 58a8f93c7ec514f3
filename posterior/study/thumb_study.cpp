#include "posterior/study/thumb_study.h"

#include <algorithm>
#include <cmath>

#include "posterior/study/thumb_case.h"
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

internal::ThumbData data_of(const ThumbStudy& study, const ThumbCaseSettings& settings,
                            unsigned seed) {
  PullOptions pulls;
  pulls.noise = settings.noise;
  pulls.postures = settings.postures;
  pulls.seed = seed;
  Experiment pulled = pull_muscles(study.truth, pulls);
  Experiment tasks = tasks_at(study.truth, settings.noise, seed);
  // Tasks that are fitted with pulls share their postures.
  if (settings.with_tasks) pulled.postures = tasks.postures;
  return {study.truth, study.start, std::move(pulled), std::move(tasks)};
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

ThumbStudy study_thumb(const ThumbStudyInputs& inputs, const ThumbStudySettings& settings) {
  ThumbStudy study;
  study.inputs = inputs;
  study.start = thumb_of(inputs.start);
  study.truth = in_frame_of(study.start, thumb_of(inputs.truth));
  for (const ThumbCaseSettings& one : settings.cases)
    if (std::find(study.task_noise.begin(), study.task_noise.end(), one.noise) ==
        study.task_noise.end()) {
      study.task_noise.push_back(one.noise);
      study.by_truth.push_back(
          task_scores(task_misfits(study.truth, tasks_at(study.truth, one.noise, settings.seed))));
    }
  for (std::size_t i = 0; i < settings.cases.size(); ++i) {
    settings.progress(static_cast<double>(i) / static_cast<double>(settings.cases.size()),
                      describe_case(settings.cases[i]));
    if (settings.progress.stop()) return study;
    ThumbCase one = internal::run_thumb_case(
        inputs, settings.cases[i], data_of(study, settings.cases[i], settings.seed), settings);
    if (!one.run.draws.complete) return study;
    study.cases.push_back(std::move(one));
  }
  study.complete = true;
  return study;
}

}  // namespace thenar
