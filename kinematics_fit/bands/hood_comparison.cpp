#include "kinematics_fit/bands/hood_comparison.h"

#include <algorithm>
#include <chrono>
#include <set>

#include "base/error.h"
#include "base/lists.h"
#include "kinematics_fit/bands/net_records.h"
#include "kinematics_fit/model/fit_parameters.h"
#include "kinematics_fit/model/predict_forces.h"
#include "tendons/linear_tendons.h"
#include "tendons/net/build_tendons.h"
#include "tendons/net/posture_sweep.h"

namespace thenar {
namespace {

using Eigen::VectorXd;

double upper_median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

/// Returns the errors of the trials that a predicate picks; empty if it picks none.
template <typename Pick>
ForceError error_of(const Prediction& prediction, const Experiment& experiment, Pick pick) {
  std::vector<PredictedTrial> picked;
  for (std::size_t i = 0; i < prediction.trials.size(); ++i)
    if (pick(experiment.trials[i])) picked.push_back(prediction.trials[i]);
  return picked.empty() ? ForceError{} : force_error(picked);
}

std::vector<std::string> loaded(const Trial& trial) {
  std::vector<std::string> muscles;
  for (const auto& [muscle, tension] : trial.tension)
    if (tension > 0) muscles.push_back(muscle);
  return muscles;
}

/// Returns the muscles of the hood: those of the subject's rule, and those that pull a net.
std::vector<std::string> find_hood_muscles(const Subject& subject, const Experiment& experiment,
                                           const std::vector<NetDescription>& nets) {
  // Collect the muscles of the subject's hood rule.
  std::set<std::string> known;
  for (const Digit& digit : subject.digits)
    if (digit.name == experiment.digit && digit.hood)
      for (const HoodBranch& branch : digit.hood->branches) known.insert(branch.muscle);
  // Add the muscles that pull a net.
  for (const NetDescription& net : nets)
    for (const NetMusclePlan& role : net.muscles)
      known.insert(role.names.begin(), role.names.end());
  // Keep those that some trial loads.
  std::set<std::string> pulling;
  for (const Trial& trial : experiment.trials)
    for (const std::string& muscle : loaded(trial))
      if (known.count(muscle) > 0) pulling.insert(muscle);
  return {pulling.begin(), pulling.end()};
}

HoodRung predict_rung(const DigitTendons& tendons, const std::string& name,
                      const Experiment& experiment, const std::vector<std::string>& of_hood) {
  // Predict all trials with these tendons.
  const TrialForces forces = trial_forces(tendons, experiment);
  HoodRung rung{
      name,
      tendons.digit().fidelity.path,
      tendons.digit().fidelity.hood,
      compare_forces(experiment, forces.force, Eigen::Matrix3Xd::Zero(3, forces.force.cols()),
                     calibrated_on_specimen(tendons.digit(), experiment)),
      {},
      {},
      0,
      forces.seconds,
      {}};

  // Compute errors of trials that load only hood muscles, and of those that load a single muscle.
  const auto in_hood = [&](const Trial& trial) {
    const std::vector<std::string> muscles = loaded(trial);
    return all_of(muscles, [&](const std::string& muscle) { return contains(of_hood, muscle); });
  };
  rung.hood_muscles = error_of(rung.prediction, experiment, in_hood);
  for (const Trial& trial : experiment.trials)
    if (const auto alone = loaded(trial); alone.size() == 1)
      rung.muscle[alone.front()] =
          error_of(rung.prediction, experiment, [&](const Trial& t) { return loaded(t) == alone; });

  // List trials with warnings.
  for (std::size_t i = 0; i < forces.warning.size(); ++i)
    if (!forces.warning[i].empty())
      rung.warning.push_back(fmt::format("{}, {}: {}", rung.prediction.trials[i].posture,
                                         rung.prediction.trials[i].loads, forces.warning[i]));
  return rung;
}

/// Returns the norm of the difference of predicted forces over that of `to` [1].
double distance(const Prediction& from, const Prediction& to) {
  double off = 0, size = 0;
  for (std::size_t i = 0; i < from.trials.size(); ++i) {
    off += (from.trials[i].predicted - to.trials[i].predicted).squaredNorm();
    size += to.trials[i].predicted.squaredNorm();
  }
  return size > 0 ? std::sqrt(off / size) : 0;
}

}  // namespace

TrialForces trial_forces(const DigitTendons& tendons, const Experiment& experiment) {
  // Plan the experiment on the digit as published, without free parameters.
  const TendonDigit& digit = tendons.digit();
  const FitParameters fixed = choose_parameters(digit, {}, {});
  const ExperimentPlan plan = plan_experiment(digit, fixed, experiment);
  TrialForces out;
  out.force.resize(3, plan.force.cols());
  std::vector<double> seconds;
  for (Eigen::Index i = 0; i < plan.force.cols(); ++i) {
    // Move nets from the straight finger to the posture; time only the equilibrium there.
    const VectorXd& q = plan.postures[plan.posture_of_trial[i]];
    const VectorXd& t = plan.tension[i];
    const Eigen::Matrix3Xd start = start_from_straight(tendons, q, t);
    const auto began = std::chrono::steady_clock::now();
    const TendonTorque pull = tendons.evaluate(q, t, start);
    out.force.col(i) = cell_map(digit.model, plan, q) * pull.tau;
    seconds.push_back(
        std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count());
    out.warning.push_back(pull.warning);
  }
  out.seconds = upper_median(std::move(seconds));
  return out;
}

HoodComparison compare_hoods(const Subject& subject, const Experiment& experiment,
                             const std::vector<NetDescription>& nets) {
  // Find the muscles of the hood, and whether the subject has a rule for it.
  HoodComparison out{
      subject.name, experiment.name, find_hood_muscles(subject, experiment, nets), {}};
  bool has_rule = false;
  for (const Digit& digit : subject.digits)
    has_rule = has_rule || (digit.name == experiment.digit && digit.hood);
  // Choose the paths of whole tendons: straight, and wrapped where the subject has surfaces.
  std::vector<std::pair<Path, std::string>> paths{{Path::kViaPoint, ""}};
  if (!subject.surfaces.empty()) paths.emplace_back(Path::kWrapped, ", wrapped");

  // Add a rung with each kind of path.
  const auto add = [&](const std::string& name, Hood hood, const NetDescription* net = nullptr,
                       NetPaths paths_of_net = NetPaths::kWrapped) {
    for (const auto& [path, suffix] : paths) {
      TendonOptions options;
      options.path = path;
      options.hood = hood;
      NetBuildOptions laid;
      laid.paths = paths_of_net;
      const auto tendons = build_digit_tendons(subject, experiment.digit, options, net, laid);
      out.rungs.push_back(predict_rung(*tendons, name + suffix, experiment, out.hood_muscles));
    }
  };

  // Add rungs from the coarsest hood to the finest, then the distance of each to the last.
  add("separate tendons", Hood::kSeparate);
  if (has_rule) add("fixed fractions", Hood::kFractions);
  for (const NetDescription& net : nets)
    add("net " + net.name + ", straight runs", Hood::kFloatingNet, &net, NetPaths::kStraightLines);
  for (const NetDescription& net : nets) add("net " + net.name, Hood::kFloatingNet, &net);
  for (HoodRung& rung : out.rungs)
    rung.relative_to_finest = distance(rung.prediction, out.rungs.back().prediction);
  return out;
}

}  // namespace thenar
