#include "kinematics_fit/model/activation_plan.h"

#include <cmath>

#include "base/error.h"
#include "base/lists.h"

namespace thenar {
namespace {

/// Adds unit pulls to an experiment's plan.
class TaskPlanner {
 public:
  TaskPlanner(const TendonDigit& digit, const Experiment& experiment, ActivationPlan& out)
      : digit_(digit), experiment_(experiment), out_(out) {}

  [[nodiscard]] ActivationTask plan(const ActivationRow& row) {
    ActivationTask task{{}, row.force, force_sd(experiment_, row)};
    // Find the posture by name.
    const int posture = place_in(out_.plan.posture_names, row.posture);
    require(posture >= 0, "activation row names posture '{}', which is not defined", row.posture);
    for (const auto& [name, activation] : row.activation) {
      // Skip a muscle that is known to be inactive.
      const double sd = row.sd.at(name);
      if (activation == 0 && sd == 0) continue;
      const int muscle = muscle_index(digit_, name);
      const double max_tension = digit_.max_tension[muscle];
      require(std::isfinite(max_tension),
              "experiment '{}' states the activation of '{}', whose max_force the subject does not "
              "say",
              experiment_.name, name);
      // Add the expected tension, and its variance.
      task.pulls.push_back(
          {column(posture, muscle), max_tension * activation, std::pow(max_tension * sd, 2)});
    }
    return task;
  }

 private:
  /// Returns the column of a unit pull, which is added when it is first needed.
  int column(int posture, int muscle) {
    // Return the column if it exists.
    ExperimentPlan& plan = out_.plan;
    const Eigen::VectorXd unit = Eigen::VectorXd::Unit(digit_.max_tension.size(), muscle);
    for (int i = out_.trials; i < static_cast<int>(plan.tension.size()); ++i)
      if (plan.posture_of_trial[i] == posture && plan.tension[i] == unit) return i;
    // Add a column to the plan, without a measured force.
    plan.posture_of_trial.push_back(posture);
    plan.tension.push_back(unit);
    const auto columns = static_cast<Eigen::Index>(plan.tension.size());
    plan.force.conservativeResize(3, columns);
    plan.sd.conservativeResize(3, columns);
    plan.force.col(columns - 1).setZero();
    plan.sd.col(columns - 1).setOnes();
    return static_cast<int>(columns) - 1;
  }

  const TendonDigit& digit_;
  const Experiment& experiment_;
  ActivationPlan& out_;
};

}  // namespace

ActivationPlan plan_activations(const TendonDigit& digit, const ExperimentPlan& plan,
                                const Experiment& experiment) {
  ActivationPlan out{plan, static_cast<int>(plan.force.cols()), {}};
  TaskPlanner planner(digit, experiment, out);
  for (const ActivationRow& row : experiment.activations) out.tasks.push_back(planner.plan(row));
  return out;
}

ExperimentPlan without_trials(ExperimentPlan plan) {
  plan.posture_of_trial.clear();
  plan.tension.clear();
  plan.sites.clear();
  plan.site_of_trial.clear();
  plan.net_start.clear();
  plan.force.resize(3, 0);
  plan.sd.resize(3, 0);
  return plan;
}

}  // namespace thenar
