#include "studies/questions/study.h"

#include <algorithm>

#include "api/named/data_folders.h"
#include "base/progress_parts.h"

namespace thenar {
namespace {

ThumbStudySettings settings_of(const ThumbStudyRequest& request, const Progress& progress) {
  ThumbStudySettings settings = request.quick ? quick_thumb_study() : full_thumb_study();
  if (request.draws > 0) settings.draws = settings.warm_up = request.draws;
  settings.seed = request.seed;
  settings.progress = progress;
  return settings;
}

ThumbCalibrationSettings calibration_of(const ThumbStudyRequest& request,
                                        const Progress& progress) {
  ThumbCalibrationSettings settings;
  settings.simulations = request.simulations;
  settings.seed = request.seed;
  settings.progress = progress;
  return settings;
}

}  // namespace

ThumbStudyResult compute_thumb_study(const ThumbStudyRequest& request, const Progress& progress) {
  const ThumbStudyInputs inputs = thumb_study_inputs(data_with("fits", request.data));
  ThumbStudyResult result{
      study_thumb(inputs, settings_of(request, progress)), {}, request.seed, {}};
  if (request.simulations > 0 && !progress.stop())
    result.calibration = calibrate_thumb(inputs, calibration_of(request, progress));
  if (!result.study.complete || progress.stop()) result.outcome.status = Status::kStopped;
  return result;
}

ThumbTypesResult compute_thumb_types(const ThumbTypesRequest& request, const Progress& progress) {
  ThumbTypesSettings settings;
  settings.draws = request.draws;
  settings.seed = request.seed;
  settings.progress = progress;
  return {study_thumb_types(thumb_types_inputs(data_with("studies", request.data)), settings),
          request.seed};
}

ThumbRecoveryResult compute_thumb_recovery(const ThumbRecoveryRequest& request,
                                           const Progress& progress) {
  // Times of the two parts, which share the progress [s]
  constexpr double kRecoveryTime = 9, kLessonsTime = 11;
  ProgressParts parts(progress, kRecoveryTime + kLessonsTime);
  const std::string data = data_with("fits", request.data);
  ThumbRecoverySettings recovery;
  if (request.draws > 0) recovery.draws = recovery.warm_up = request.draws;
  recovery.seed = request.seed;
  recovery.progress = parts.next(kRecoveryTime);
  ThumbRecoveryResult result;
  result.recovery = recover_thumb(thumb_study_inputs(data), recovery);
  if (!result.recovery.complete) result.outcome.status = Status::kStopped;
  if (result.outcome.stopped()) return result;

  // Draws of its prior and posterior, weighed by what was measured.
  MeasuredLessonsSettings lessons;
  if (request.weighed > 0) lessons.prior_draws = request.weighed;
  lessons.progress = parts.next(kLessonsTime);
  result.lessons = reweight_by_measurements(measured_thumb_inputs(data), result.recovery.run,
                                            result.recovery.truth, lessons);
  if (!result.lessons.complete) result.outcome.status = Status::kStopped;
  return result;
}

std::size_t unconverged_fits(const ThumbStudy& study) {
  return static_cast<std::size_t>(std::count_if(
      study.fits.begin(), study.fits.end(), [](const ThumbFit& fit) { return !fit.converged(); }));
}

}  // namespace thenar
