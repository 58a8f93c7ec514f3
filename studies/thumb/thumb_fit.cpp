#include "studies/thumb/thumb_fit.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "base/lists.h"
#include "posterior/run/predict_draws.h"
#include "studies/thumb/drawn_models.h"
#include "studies/thumb/thumb_truth.h"

namespace thenar::internal {
namespace {

constexpr double kTiltSd = 15, kShiftSd = 5;  // of data/fits/five_axis_*.toml [deg], [mm]

/// Arms of tendons at the joints that they cross.
const std::vector<std::string> kArms{"arm/FPL/*",       "arm/EPL/*",           "arm/EPB/CMC1_*",
                                     "arm/EPB/MCP1_*",  "arm/APB/CMC1_*",      "arm/APB/MCP1_*",
                                     "arm/FPB/CMC1_*",  "arm/FPB/MCP1_*",      "arm/OPP/CMC1_*",
                                     "arm/ADPt/CMC1_*", "arm/ADPt/MCP1_*",     "arm/ADPo/CMC1_*",
                                     "arm/ADPo/MCP1_*", "arm/1stDI_MC1/CMC1_*"};

/// Angles between the posterior mean of the pulls' forces and those measured, and how far that mean
/// is from the true forces.
void score_pulls(const ThumbData& data, ThumbFit& out) {
  // Posterior mean of the forces, and its distance from the truth.
  const PredictedDraws predicted = predict_draws(out.run, data.pulls, 0, 500);
  const Prediction mean = summarise(predicted);
  const Eigen::Matrix3Xd truth = true_forces(data.truth, data.pulls);
  double off = 0;
  for (std::size_t i = 0; i < mean.trials.size(); ++i)
    off += (mean.trials[i].predicted - truth.col(static_cast<Eigen::Index>(i))).squaredNorm();
  // Angles between the mean and the measured forces.
  const DirectionErrors errors = direction_errors(mean);
  out.direction = errors.mean;
  out.direction_sd = errors.sd;
  out.relative_error = std::sqrt(off / truth.squaredNorm());
}

/// Tasks by digits at some of the draws; the misfits of each task are averaged over draws.
void score_tasks(const ThumbData& data, int draws, ThumbFit& out) {
  // Some of the draws.
  const HandPosterior& posterior = *out.run.posterior;
  const DrawnModels models(posterior, thinned(pooled(out.run.draws), draws));
  const Eigen::Index count = models.count();

  // Misfits of every task, averaged over the draws.
  std::vector<TaskMisfit> sum(data.tasks.activations.size(), {0, 0, 0});
  double explained = 0;
  TendonDigit drawn = posterior.problem().digit();
  for (Eigen::Index k = 0; k < count; ++k) {
    drawn.model = models.at(k);
    const std::vector<TaskMisfit> misfits = task_misfits(drawn, data.tasks);
    explained += task_scores(misfits).explained / static_cast<double>(count);
    for (std::size_t i = 0; i < sum.size(); ++i) {
      sum[i].direction += misfits[i].direction / static_cast<double>(count);
      sum[i].torque += misfits[i].torque / static_cast<double>(count);
    }
  }
  out.tasks = task_scores(sum);
  out.tasks.explained = explained;
}

/// Index of the type of the thumb at every draw (draws).
Eigen::VectorXi types_at(const ThumbData& data, const HandPosterior& posterior,
                         const Eigen::MatrixXd& x) {
  const std::vector<std::string>& hinges = posterior.problem().digit().names.hinges;
  const DrawnModels models(posterior, x);
  Eigen::VectorXi types(models.count());
  for (Eigen::Index k = 0; k < models.count(); ++k)
    types[k] =
        classify_thumb(data.criteria, thumb_axes(data.criteria, models.at(k), hinges)).index();
  return types;
}

/// Estimates the probability of each type: shares of draws from the prior and from the posterior.
std::vector<TypeProbability> type_probabilities(const ThumbData& data, const PosteriorRun& run) {
  constexpr int kPriorDraws = 4000;
  const HandPosterior& posterior = *run.posterior;
  const Eigen::VectorXi before = types_at(data, posterior, prior_draws(run, kPriorDraws)),
                        after = types_at(data, posterior, pooled(run.draws));
  std::vector<TypeProbability> out;
  // Four types: the order of the axes at the MCP joint, and the way of the common normal.
  for (const bool flexion_distal : {true, false})
    for (const bool toward : {false, true}) {
      const ThumbType type{flexion_distal, toward};
      const Eigen::VectorXd is = (after.array() == type.index()).cast<double>();
      const Estimate share =
          estimate("type", reshape_by_chain(is, run.draws.chains()), run.draws.group);
      const double prior =
          static_cast<double>((before.array() == type.index()).count()) / kPriorDraws;
      // Draws that are all alike have no spread, and no error that could be told from them.
      const bool all_alike = is.minCoeff() == is.maxCoeff();
      out.push_back({type, prior, is.mean(), all_alike ? 0 : share.mcse_mean});
    }
  return out;
}

std::vector<LearntNumber> learnt_numbers(const ThumbData& data, const ThumbFit& fitted) {
  // Parameters of axes and arms; shifts along an axis tell nothing.
  const std::vector<PosteriorQuantity> quantities = posterior_quantities(fitted.run);
  const std::vector<Parameter>& all = fitted.run.posterior->problem().parameters().all;
  std::vector<LearntNumber> learnt;
  for (const PosteriorQuantity& quantity : quantities) {
    const Parameter* parameter = find_named(all, quantity.name);
    if (parameter == nullptr || parameter->name.find("/along") != std::string::npos) continue;
    // Posterior beside prior, and the truth where the model can hold it.
    const Estimate e = estimate(quantity.name, quantity.draws, fitted.run.draws.group);
    LearntNumber number{e.name, quantity.unit, e.mean, e.sd, prior_sd(quantity), e.q05, e.q95, {}};
    if (fitted.settings.skewed) {
      number.truth = true_value(*parameter, data.start, data.truth);
      if (number.truth) *number.truth *= display_scale(*parameter);
    }
    learnt.push_back(std::move(number));
  }
  return learnt;
}

}  // namespace

TendonDigit thumb_of(const SourceText& source) {
  const Subject subject = parse_subject(source.text, source.path);
  return build_tendon_digit(with_passive(subject, PassiveMoments::kOff), "thumb");
}

DirectionErrors direction_errors(const Prediction& prediction) {
  Eigen::ArrayXd angle(static_cast<Eigen::Index>(prediction.trials.size()));
  for (Eigen::Index i = 0; i < angle.size(); ++i)
    angle[i] = direction_error(prediction.trials[static_cast<std::size_t>(i)]);
  const double mean = angle.mean();
  return {mean, std::sqrt((angle - mean).square().sum() /
                          static_cast<double>(std::max<Eigen::Index>(1, angle.size() - 1)))};
}

namespace {

/// The settings with wider priors of axes.
SourceText widened(SourceText file, double width) {
  if (width == 1) return file;
  for (const char* what : {"direction/?", "point/?"}) {
    const bool tilt = what[0] == 'd';
    file.text += fmt::format("\n[[parameter]]\nmatch = \"axis/*/{}\"\nsd_{} = {}\nrange_{} = {}\n",
                             what, tilt ? "deg" : "mm", width * (tilt ? kTiltSd : kShiftSd),
                             tilt ? "deg" : "mm", tilt ? 85.0 : 40 * width);
  }
  file.path += fmt::format(" (axes {} times as wide)", width);
  return file;
}

}  // namespace

FitInputs thumb_fit_inputs(const ThumbStudyInputs& inputs, const ThumbFitSettings& settings,
                           const ThumbData& data) {
  // Pulls, and tasks if they are fitted too.
  Experiment fitted = data.pulls;
  if (settings.with_tasks) {
    fitted.activations = data.tasks.activations;
    if (fitted.postures.size() < data.tasks.postures.size()) fitted.postures = data.tasks.postures;
  }

  // Settings of the model; arms are freed by name.
  FitInputs out{inputs.start,
                widened(settings.skewed ? inputs.skewed : inputs.orthogonal, settings.prior_width),
                {},
                {}};
  out.experiments = {{"made up for the thumb study", experiment_text(fitted)}};
  if (settings.arms == Arms::kFree) out.also_free = kArms;
  return out;
}

PosteriorRun sample_with_retries(const FitInputs& inputs, PosteriorSettings settings, int retries) {
  constexpr std::array<double, 3> kAcceptance{0.9, 0.95, 0.99};
  for (int attempt = 0;; ++attempt) {
    // Shorter steps at each attempt.
    settings.run.sampler.target_acceptance =
        kAcceptance[static_cast<std::size_t>(std::min(attempt, 2))];
    PosteriorRun run = sample_posterior(inputs, settings);
    const bool good = run.convergence.warnings.empty() && run.convergence.divergent == 0;
    if (attempt == retries || !run.draws.complete || good) return run;
    // Chains do not agree: twice as long.
    settings.run.draws *= 2;
    settings.run.sampler.warm_up *= 2;
  }
}

ThumbFit run_thumb_fit(const ThumbStudyInputs& inputs, const ThumbFitSettings& settings,
                       const ThumbData& data, const ThumbStudySettings& study) {
  // Sample; a stopped run is not scored.
  ThumbFit out;
  out.settings = settings;
  const FitInputs fit = thumb_fit_inputs(inputs, settings, data);
  out.run = sample_with_retries(
      fit, chain_settings(settings.skewed ? inputs.skewed : inputs.orthogonal, study),
      study.retries);
  if (!out.run.draws.complete) return out;
  // Scores on pulls, tasks, parameters and left-out trials.
  score_pulls(data, out);
  score_tasks(data, study.scored_draws, out);
  out.learnt = learnt_numbers(data, out);
  out.left_out = leave_one_out(out.run.posterior->pointwise(pooled(out.run.draws)),
                               out.run.draws.chains(), out.run.draws.group);
  // Which of the four types it may be; axes that cross are of none.
  if (settings.skewed) out.types = type_probabilities(data, out.run);
  return out;
}

}  // namespace thenar::internal
