#include "studies/thumb/thumb_recovery.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/lists.h"
#include "base/special_functions.h"
#include "kinematics_fit/specimen_prior.h"
#include "sampling/diagnostics/order_statistics.h"
#include "studies/thumb/drawn_models.h"
#include "studies/thumb/thumb_fit.h"
#include "studies/thumb/thumb_truth.h"

namespace thenar {
namespace {

/// Pulls of single muscles and tasks with electromyography, read with noise.
internal::ThumbData make_up(const ThumbRecovery& of) {
  // Every muscle in turn, in some postures.
  const ThumbRecoverySettings& settings = of.settings;
  SimulatedPullOptions pulls;
  pulls.postures = settings.postures;
  pulls.noise = settings.noise;
  pulls.seed = settings.seed;
  // People who push in five directions.
  TaskOptions tasks;
  tasks.people = settings.people;
  tasks.noise = settings.noise;
  tasks.seed = settings.seed;
  return {of.truth, of.start, simulate_pulls(of.truth, pulls), simulate_tasks(of.truth, tasks), {}};
}

/// The model whose axes are free and whose arms are known, fitted to both.
ThumbFitSettings free_axes(const ThumbRecoverySettings& settings) {
  ThumbFitSettings fit;
  fit.skewed = true;
  fit.noise = settings.noise;
  fit.postures = settings.postures;
  fit.with_tasks = true;
  return fit;
}

/// Mean, sd and central 95 % interval of draws.
RecoveredValue summary_of(const Eigen::MatrixXd& draws) {
  const Eigen::VectorXd rising = sorted(draws);
  const double mean = rising.mean();
  const double sd =
      std::sqrt((rising.array() - mean).square().sum() / static_cast<double>(rising.size() - 1));
  return {mean, sd, quantile(rising, 0.025), quantile(rising, 0.975)};
}

/// Every tilt and shift that was fitted, by both methods.
std::vector<RecoveredNumber> compare_numbers(const ThumbRecovery& of) {
  const std::vector<Parameter>& all = of.fit->problem.parameters().all;
  const FittedValues fitted = fitted_values(*of.fit, 0);
  std::vector<RecoveredNumber> numbers;
  for (const PosteriorQuantity& quantity : posterior_quantities(of.run)) {
    // The parameter of that name, if the true thumb has a value of it.
    const Parameter* parameter = find_named(all, quantity.name);
    if (parameter == nullptr) continue;
    const std::optional<double> truth = true_value(*parameter, of.start, of.truth);
    if (!truth) continue;
    // Least squares, whose interval is that of its covariance, beside the draws.
    const Eigen::Index at = parameter - all.data();
    const double value = fitted.value[at], sd = fitted.sd[at];
    numbers.push_back(
        {quantity.name,
         quantity.unit,
         *truth * display_scale(*parameter),
         prior_sd(quantity),
         {value, sd, value - kNormal95HalfWidth * sd, value + kNormal95HalfWidth * sd},
         summary_of(quantity.draws)});
  }
  return numbers;
}

double angle_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// Directions of a hinge at all draws (3, count).
Eigen::Matrix3Xd directions_of(const std::vector<TendonModel<double>>& drawn, std::size_t hinge) {
  Eigen::Matrix3Xd d(3, static_cast<Eigen::Index>(drawn.size()));
  for (std::size_t k = 0; k < drawn.size(); ++k)
    d.col(static_cast<Eigen::Index>(k)) = drawn[k].tree[hinge].direction;
  return d;
}

/// Rms of sd / prior sd over the tilts of a joint.
double left_of_tilts(const std::vector<RecoveredNumber>& numbers, const std::string& joint,
                     RecoveredValue RecoveredNumber::*by) {
  double sum = 0;
  int count = 0;
  for (const RecoveredNumber& number : numbers)
    if (number.name.rfind("axis/" + joint + "/direction/", 0) == 0) {
      sum += std::pow((number.*by).sd / number.prior_sd, 2);
      ++count;
    }
  return std::sqrt(sum / count);
}

/// Every axis by both methods.
std::vector<RecoveredAxis> compare_axes(const ThumbRecovery& of) {
  // The digit at the best point, and at the draws.
  const FitProblem& problem = of.fit->problem;
  const TendonModel<double> best =
      specimen_model(
          problem.digit(), problem.parameters(),
          parameter_values<double>(problem.parameters(),
                                   displacements(problem.coordinates(), of.fit->solution.z, 0)))
          .digit;
  const internal::DrawnModels models(*of.run.posterior, pooled(of.run.draws));
  const std::vector<TendonModel<double>> drawn = models.all();

  std::vector<RecoveredAxis> axes;
  for (std::size_t h = 0; h < of.truth.model.tree.size(); ++h) {
    // The mean direction of the draws, and how far they lie about it.
    const Eigen::Matrix3Xd d = directions_of(drawn, h);
    const Eigen::Vector3d mean = d.rowwise().sum().normalized();
    Eigen::VectorXd off(d.cols());
    for (Eigen::Index k = 0; k < d.cols(); ++k) off[k] = angle_between(d.col(k), mean);
    // Angles from the true axis.
    const Eigen::Vector3d truth = of.truth.model.tree[h].direction;
    const std::string& joint = of.truth.names.hinges[h];
    axes.push_back({joint, angle_between(of.start.model.tree[h].direction, truth),
                    angle_between(best.tree[h].direction, truth), angle_between(mean, truth),
                    quantile(sorted(off), 0.95),
                    left_of_tilts(of.numbers, joint, &RecoveredNumber::fit),
                    left_of_tilts(of.numbers, joint, &RecoveredNumber::drawn)});
  }
  return axes;
}

}  // namespace

MethodAgreement compare_methods(const std::vector<RecoveredNumber>& numbers) {
  require(!numbers.empty(), "wanted numbers of two methods to compare, got {}", numbers.size());
  MethodAgreement out;
  out.least_sd_ratio = out.most_sd_ratio = numbers.front().fit.sd / numbers.front().drawn.sd;
  for (const RecoveredNumber& number : numbers) {
    // Differences of the estimates.
    const double off = std::abs(number.fit.value - number.drawn.value) / number.drawn.sd;
    out.rms += off * off / static_cast<double>(numbers.size());
    if (off >= out.worst) out.worst_name = number.name;
    out.worst = std::max(out.worst, off);
    // Ratios of the sds, and intervals that hold the truth.
    const double ratio = number.fit.sd / number.drawn.sd;
    out.least_sd_ratio = std::min(out.least_sd_ratio, ratio);
    out.most_sd_ratio = std::max(out.most_sd_ratio, ratio);
    const auto holds = [&](const RecoveredValue& of) {
      return of.low <= number.truth && number.truth <= of.high;
    };
    out.fit_covered += holds(number.fit) ? 1 : 0;
    out.drawn_covered += holds(number.drawn) ? 1 : 0;
    // Collect the numbers that keep most of their prior's sd.
    const double undecided = kUndecidedShare * number.prior_sd;
    if (number.fit.sd > undecided) out.fit_undecided.push_back(number.name);
    if (number.drawn.sd > undecided) out.drawn_undecided.push_back(number.name);
  }
  out.rms = std::sqrt(out.rms);
  return out;
}

ThumbRecovery recover_thumb(const ThumbStudyInputs& inputs, const ThumbRecoverySettings& settings) {
  // Both thumbs in one frame, and data of the true one.
  ThumbRecovery out;
  out.inputs = inputs;
  out.settings = settings;
  out.start = internal::thumb_of(inputs.start);
  out.truth = in_frame_of(out.start, internal::thumb_of(inputs.truth));
  const internal::ThumbData data = make_up(out);
  out.made_up = data.pulls;
  out.made_up.activations = data.tasks.activations;

  // Least squares with settings of the study.
  const FitInputs fit = internal::thumb_fit_inputs(inputs, free_axes(settings), data);
  settings.progress(0, "a made-up thumb: least squares");
  SolveOptions options;
  options.progress.stop_requested = settings.progress.stop_requested;
  out.fit = run_fit(fit, options);
  if (settings.progress.stop()) return out;

  // Draws from the posterior of the same priors and data.
  settings.progress(0.2, "a made-up thumb: chains");
  out.run = internal::sample_with_retries(fit, internal::chain_settings(inputs.skewed, settings),
                                          settings.retries);
  if (!out.run.draws.complete) return out;

  // Both beside the truth.
  out.numbers = compare_numbers(out);
  out.axes = compare_axes(out);
  out.agreement = compare_methods(out.numbers);
  out.complete = true;
  return out;
}

}  // namespace thenar
