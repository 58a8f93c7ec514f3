#include "kinematics_fit/trivial_prediction.h"

#include <algorithm>
#include <cmath>

#include "base/lists.h"
#include "kinematics_fit/force_jacobian.h"
#include "kinematics_fit/model/shared_postures.h"

namespace thenar {
namespace {

/// Returns the tensions of the muscles that pull [N].
std::map<std::string, double> pulls_of(const Trial& trial) {
  std::map<std::string, double> pulls;
  for (const auto& [muscle, tension] : trial.tension)
    if (tension > 0) pulls[muscle] = tension;
  return pulls;
}

double total(const std::map<std::string, double>& pulls) {
  double sum = 0;
  for (const auto& [muscle, tension] : pulls) sum += tension;
  return sum;
}

/// Returns whether the same muscles pull in the same proportion.
bool same_loads(const std::map<std::string, double>& a, const std::map<std::string, double>& b) {
  // Largest relative difference of a muscle's share in equal loads [1]
  constexpr double kEqualShareTolerance = 0.1;
  if (a.size() != b.size() || a.empty()) return false;
  const double total_a = total(a), total_b = total(b);
  return std::equal(a.begin(), a.end(), b.begin(), [&](const auto& one, const auto& other) {
    const double share = one.second / total_a;
    return one.first == other.first &&
           std::abs(other.second / total_b - share) <= kEqualShareTolerance * share;
  });
}

/// Sum and number of forces per tension, in axes of the digit.
struct MeanForce {
  Eigen::Vector3d sum{0, 0, 0};  // [1] (3)
  int count = 0;                 // [1]

  void add(const Eigen::Vector3d& force) {
    sum += force;
    ++count;
  }
};

/// Returns the sum of the predictions for each load on its own; empty if one of them is missing, or
/// if there is only one load.
template <typename Alone>
std::optional<Eigen::Vector3d> sum_of_loads(const Trial& trial, const Alone& alone) {
  const std::map<std::string, double> pulls = pulls_of(trial);
  if (pulls.size() < 2) return std::nullopt;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const auto& pull : pulls) {
    Trial single = trial;
    single.tension = {pull};
    const std::optional<Eigen::Vector3d> force = alone(single);
    if (!force) return std::nullopt;
    sum += *force;
  }
  return sum;
}

/// Means of forces under the same loads, by posture and specimen.
struct MeansOfLoads {
  MeanForce in_posture;      // same posture, all specimens
  MeanForce own_in_posture;  // same posture, same specimen
  MeanForce own;             // any posture, same specimen
  MeanForce all;             // any posture, all specimens
};

MeansOfLoads means_of(const Experiment& experiment, const Trial& trial,
                      const std::vector<Experiment>& seen) {
  const std::map<std::string, double> pulls = pulls_of(trial);
  const PostureRecord* posture = find_posture(experiment, trial.posture);
  MeansOfLoads means;
  for (const Experiment& other : seen) {
    if (other.components < experiment.components || other.digit != experiment.digit) continue;
    // Add the trials of equal loads, per tension and in axes of the digit.
    for (const Trial& row : other.trials) {
      const std::map<std::string, double> others = pulls_of(row);
      if (!same_loads(pulls, others) || !(row.site == trial.site)) continue;
      const Eigen::Vector3d force =
          other.axes_of_digit.cast<double>().transpose() * row.force / total(others);
      const bool here = same_posture(posture, find_posture(other, row.posture));
      const bool self = other.specimen == experiment.specimen;
      if (here) means.in_posture.add(force);
      if (here && self) means.own_in_posture.add(force);
      if (self) means.own.add(force);
      means.all.add(force);
    }
  }
  return means;
}

/// Returns a mean in the axes of the experiment, under the loads of the trial; empty if it has no
/// trial.
std::optional<Eigen::Vector3d> under_load(const MeanForce& mean, const Experiment& experiment,
                                          const Trial& trial) {
  if (mean.count == 0) return std::nullopt;
  return experiment.axes_of_digit.cast<double>() * mean.sum * (total(pulls_of(trial)) / mean.count);
}

}  // namespace

std::optional<Eigen::Vector3d> trivial_force(const Experiment& experiment, const Trial& trial,
                                             const std::vector<Experiment>& seen) {
  // Return the closest mean available, else the sum of single loads.
  const MeansOfLoads means = means_of(experiment, trial, seen);
  for (const MeanForce& mean : {means.in_posture, means.own, means.all})
    if (const auto force = under_load(mean, experiment, trial)) return force;
  return sum_of_loads(trial,
                      [&](const Trial& single) { return trivial_force(experiment, single, seen); });
}

std::optional<Eigen::Vector3d> superposed_force(const Experiment& experiment, const Trial& trial,
                                                const std::vector<Experiment>& seen) {
  return sum_of_loads(trial, [&](const Trial& single) {
    return under_load(means_of(experiment, single, seen).own_in_posture, experiment, single);
  });
}

std::optional<BesideTrivial> beside_trivial(const Prediction& prediction) {
  std::vector<PredictedTrial> model, trivial;
  bool measured = false;
  for (const PredictedTrial& trial : prediction.trials) {
    if (!trial.trivial) continue;
    measured = measured || trial.measured.squaredNorm() > 0;
    model.push_back(trial);
    trivial.push_back(trial);
    trivial.back().predicted = *trial.trivial;
    trivial.back().sd.setZero();
  }
  if (!measured) return std::nullopt;
  return BesideTrivial{force_error(model), force_error(trivial)};
}

std::vector<ErrorsOfLoad> errors_by_load(const Prediction& prediction) {
  std::vector<ErrorsOfLoad> out;
  for (const PredictedTrial& trial : prediction.trials) {
    if (!trial.trivial) continue;
    // Find the sums of this load, or begin them with its first trial.
    auto load = std::find_if(out.begin(), out.end(),
                             [&](const ErrorsOfLoad& one) { return one.loads == trial.loads; });
    const Eigen::Vector3d zero = Eigen::Vector3d::Zero();
    if (load == out.end()) load = out.insert(load, {trial.loads, 0, zero, zero, zero});
    ++load->trials;
    load->measured += trial.measured.cwiseAbs2();
    load->model += (trial.predicted - trial.measured).cwiseAbs2();
    load->trivial += (*trial.trivial - trial.measured).cwiseAbs2();
  }
  // Convert sums of squares to RMS values.
  for (ErrorsOfLoad& one : out)
    for (Eigen::Vector3d* sum : {&one.measured, &one.model, &one.trivial})
      *sum = (*sum / one.trials).cwiseSqrt();
  return out;
}

Prediction predict_as_published(const SourceText& subject, const Experiment& experiment) {
  const TendonDigit digit =
      build_tendon_digit(parse_subject(subject.text, subject.path), experiment.digit);
  const FitParameters fixed = choose_parameters(digit, {}, {});
  const Eigen::Matrix3Xd force = force_values(
      digit, fixed, plan_experiment(digit, fixed, experiment), Eigen::VectorXd::Zero(0));
  return compare_forces(experiment, force, Eigen::Matrix3Xd::Zero(3, force.cols()),
                        calibrated_on_specimen(digit, experiment));
}

Prediction mean_of_other_postures(const Experiment& experiment) {
  Prediction out{experiment.name, {}, {}};
  for (const Trial& trial : experiment.trials) {
    Experiment others = experiment;
    erase_where(others.trials, [&](const Trial& other) { return other.posture == trial.posture; });
    if (const auto force = trivial_force(experiment, trial, {others}))
      out.trials.push_back({trial.posture, describe_loads(trial), trial.force, *force,
                            Eigen::Vector3d::Zero(), experiment.components});
  }
  if (!out.trials.empty()) out.error = force_error(out.trials);
  return out;
}

}  // namespace thenar
