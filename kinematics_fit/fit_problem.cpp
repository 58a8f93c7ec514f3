#include "kinematics_fit/fit_problem.h"

#include <algorithm>
#include <set>

#include <fmt/ranges.h>

#include "base/error.h"
#include "base/lists.h"
#include "data/io/doubled_trials.h"
#include "kinematics_fit/force_jacobian.h"
#include "kinematics_fit/model/experiment_plan.h"
#include "kinematics_fit/model/shared_postures.h"

namespace thenar {
namespace {

/// Returns the names of the specimens of all experiments, each once, in order of appearance.
std::vector<std::string> specimen_names(const std::vector<Experiment>& experiments) {
  std::vector<std::string> names;
  for (const Experiment& experiment : experiments)
    if (!contains(names, experiment.specimen)) names.push_back(experiment.specimen);
  return names;
}

}  // namespace

FitProblem::FitProblem(TendonDigit digit, FitParameters parameters,
                       std::vector<Experiment> experiments, double robust_scale,
                       std::vector<AxisDistance> axis_distances, Scaling scaling)
    : digit_(std::move(digit)),
      experiments_(std::move(experiments)),
      scaling_(scaling),
      coordinates_(share_same_postures(with_fitted_tensions(std::move(parameters), experiments_),
                                       experiments_),
                   specimen_names(experiments_)),
      robust_scale_(robust_scale),
      axis_distances_(std::move(axis_distances)) {
  require(this->parameters().coordinates() > 0, "nothing to fit: every parameter is fixed");
  require(!experiments_.empty(), "nothing to fit to: no experiment");
  // Find the index of each experiment's specimen.
  for (const Experiment& experiment : experiments_)
    specimen_of_.push_back(place_in(specimens(), experiment.specimen));
  // Scale the digits, and compile the forces of each experiment.
  if (scaling_ == Scaling::kOutside) size_specimens();
  for (std::size_t e = 0; e < experiments_.size(); ++e) {
    const TendonDigit& sized = digit_of(specimen_of_[e]);
    plans_.push_back(plan_experiment(sized, this->parameters(), experiments_[e]));
    kernels_.push_back(compile_forces(sized, this->parameters(), plans_[e]));
    add_activations(sized, e);
  }
  find_axes();
}

void FitProblem::add_activations(const TendonDigit& sized, std::size_t e) {
  // Skip the rows of a net, whose forces are not linear in tensions; warnings() reports it.
  const ExperimentPlan bare = without_trials(plans_[e]);
  activations_.push_back(sized.net ? ActivationPlan{bare, 0, {}}
                                   : plan_activations(sized, bare, experiments_[e]));
  const ActivationPlan& rows = activations_.back();
  activation_kernels_.push_back(
      rows.tasks.empty() ? nullptr : compile_forces(sized, parameters(), rows.plan));
}

void FitProblem::size_specimens() {
  for (const std::string& specimen : specimens()) {
    // Share the lengths that any experiment states among all experiments on its specimen.
    const Experiment* stated = nullptr;
    for (const Experiment& experiment : experiments_)
      if (experiment.specimen == specimen && !experiment.outside_length.empty() && !stated)
        stated = &experiment;
    for (Experiment& experiment : experiments_) {
      if (experiment.specimen != specimen || !stated) continue;
      require(
          experiment.outside_length.empty() || experiment.outside_length == stated->outside_length,
          "experiments '{}' and '{}' state different lengths in [outside] of one specimen, {}",
          stated->name, experiment.name, specimen);
      experiment.outside_length = stated->outside_length;
    }
    // Scale the digit by the first experiment, which now has the lengths.
    const auto first = std::find_if(experiments_.begin(), experiments_.end(),
                                    [&](const Experiment& e) { return e.specimen == specimen; });
    digits_.push_back(scale_to_outside(digit_, *first));
  }
}

const TendonDigit& FitProblem::digit_of(int specimen) const {
  if (digits_.empty() || specimen < 0) return digit_;
  return digits_.at(static_cast<std::size_t>(specimen));
}

TendonDigit FitProblem::sized_digit(const Experiment& experiment) const {
  if (scaling_ == Scaling::kSubject) return digit_;
  const int known = place_in(specimens(), experiment.specimen);
  if (known < 0 || !experiment.outside_length.empty()) return scale_to_outside(digit_, experiment);
  return digit_of(known);
}

void FitProblem::find_axes() {
  // Find the hinges of the joints by name.
  const std::vector<std::string>& names = digit_.names.hinges;
  const auto hinge = [&](const std::string& joint) {
    const int found = place_in(names, joint);
    require(found >= 0, "axis distance of joint '{}', which the digit has not; it has {}", joint,
            fmt::join(names, ", "));
    return found;
  };
  for (const AxisDistance& wanted : axis_distances_) {
    require(wanted.lower <= wanted.upper && wanted.upper > 0,
            "axes of '{}' and '{}' cannot be {} .. {} m apart", wanted.joint_a, wanted.joint_b,
            wanted.lower, wanted.upper);
    axis_pairs_.push_back(
        {hinge(wanted.joint_a), hinge(wanted.joint_b), wanted.lower, wanted.upper});
  }
}

std::vector<std::string> FitProblem::warnings() const {
  // Warn of postures, tensions and calibration of every experiment.
  std::vector<std::string> all;
  for (std::size_t e = 0; e < plans_.size(); ++e)
    append_all(all, experiment_warnings(digit_, plans_[e], experiments_[e]));

  // Warn of one name for two postures.
  append_all(all, posture_name_warnings(experiments_));

  // Warn of duplicate rows, which count twice.
  append_all(all, doubled_trial_warnings(experiments_));

  // Warn of data that the fit does not use.
  for (const Experiment& experiment : experiments_)
    if (!experiment.outside_length.empty() && scaling_ == Scaling::kSubject)
      all.push_back(fmt::format(
          "experiment '{}': [outside] is not used, as sizes are those of the subject; the "
          "scaling outside uses it",
          experiment.name));
  for (const Experiment& experiment : experiments_)
    if (digit_.net && !experiment.activations.empty())
      all.push_back(
          fmt::format("experiment '{}': {} activation rows are not fitted, as forces of a net are "
                      "not linear in "
                      "tensions",
                      experiment.name, experiment.activations.size()));

  // Warn of tendons whose geometry is fixed.
  append_all(all, fixed_geometry_warnings(parameters()));
  return all;
}

namespace {

std::set<std::string> postures_of(const std::vector<Trial>& trials) {
  std::set<std::string> names;
  for (const Trial& trial : trials) names.insert(trial.posture);
  return names;
}

}  // namespace

FitProblem subset(const FitProblem& problem,
                  const std::function<bool(const Experiment&, const Trial&)>& keep) {
  std::vector<Experiment> kept;
  for (Experiment experiment : problem.experiments()) {
    // Remove the trials that the caller does not keep, and the activation rows of postures without
    // remaining trials, as they were measured in the same posture.
    std::vector<Trial>& trials = experiment.trials;
    const std::set<std::string> before = postures_of(trials);
    erase_where(trials, [&](const Trial& trial) { return !keep(experiment, trial); });
    const std::set<std::string> after = postures_of(trials);
    std::vector<ActivationRow>& rows = experiment.activations;
    erase_where(rows, [&](const ActivationRow& row) {
      return before.count(row.posture) > after.count(row.posture);
    });
    if (!trials.empty()) kept.push_back(std::move(experiment));
  }
  return {problem.digit(),        problem.parameters(),     std::move(kept),
          problem.robust_scale(), problem.axis_distances(), problem.scaling()};
}

}  // namespace thenar
