#include "kinematics_fit/model/net_trials.h"

#include <algorithm>
#include <memory>

#include <fmt/format.h>

#include "tendons/linear_tendons.h"
#include "tendons/net/net_continuation.h"
#include "tendons/net/net_statics.h"

namespace thenar {
namespace {

using Eigen::Matrix3Xd;
using Eigen::VectorXd;

/// Returns the stated tensions times the gains [N] (muscles).
VectorXd arriving_tensions(const SpecimenModel<double>& model, const ExperimentPlan& plan,
                           std::size_t i) {
  return model.gain.cwiseProduct(plan.tension[i]);
}

/// Moves nodes with their links, from link coordinates to space [m] (3, nodes).
Matrix3Xd from_link_frames(const Net& net, const TreeState<double>& state, const Matrix3Xd& at) {
  Matrix3Xd x(3, at.cols());
  for (Eigen::Index i = 0; i < x.cols(); ++i)
    x.col(i) = moved(state, net.nodes[i].link, Eigen::Vector3d(at.col(i)));
  return x;
}

/// Returns the places of nodes in coordinates of their links [m] (3, nodes): the inverse of
/// from_link_frames().
Matrix3Xd to_link_frames(const Net& net, const TreeState<double>& state, const Matrix3Xd& x) {
  Matrix3Xd at(3, x.cols());
  for (Eigen::Index i = 0; i < x.cols(); ++i) {
    const int link = net.nodes[i].link;
    at.col(i) = link < 0 ? Eigen::Vector3d(x.col(i)) : state[link].X.inverse() * x.col(i);
  }
  return at;
}

/// Builds the tendons of a specimen. @param angles  posture at which muscles divide among their
/// pulls [rad] (coordinates)
NetTendons tendons_of(const TendonDigit& digit, const SpecimenModel<double>& model,
                      const VectorXd& angles) {
  TendonDigit own = digit;
  own.model = model.digit;
  return {straight_tendons(std::move(own)),
          built_net(*model.net, mcp_angle<double>(model.digit, angles))};
}

}  // namespace

NetTrials net_trials(const SpecimenModel<double>& model, const ExperimentPlan& plan) {
  // Set up one solver for all trials.
  const BuiltNet built = built_net(*model.net);
  NetSolver solver(built.net);
  NetTrials out{built.net, {}};
  out.trials.resize(plan.tension.size());
  for (std::size_t i = 0; i < plan.tension.size(); ++i) {
    if (!pulls_net(*model.net->built, plan.tension[i])) continue;
    // Solve from the initial point of the plan; if that fails, from scratch.
    NetTrial trial;
    const PosedSpecimen<double> at =
        pose_specimen(model, plan, static_cast<std::size_t>(plan.posture_of_trial[i]));
    trial.state = at.state;
    trial.drive.tension = net_pulls(*model.net, mcp_angle<double>(model.digit, at.angles),
                                    arriving_tensions(model, plan, i));
    const Matrix3Xd start = from_link_frames(out.net, trial.state, plan.net_start[i]);
    trial.rest = solver.solve(trial.state, trial.drive, &start);
    if (is_unbalanced(trial.rest)) {
      NetEquilibrium cold = solver.solve(trial.state, trial.drive);
      if (!is_unbalanced(cold)) trial.rest = std::move(cold);
    }
    // Map the bands' tensions to torques.
    trial.tau =
        net_torque(out.net, model.digit.tree, trial.state, trial.rest, model.digit.coordinates);
    out.trials[i] = std::move(trial);
  }
  return out;
}

std::vector<Matrix3Xd> net_starts(const TendonDigit& digit, const FitParameters& parameters,
                                  const ExperimentPlan& plan) {
  // Build the specimen at the prior means.
  const VectorXd u = VectorXd::Zero(parameters.coordinates());
  const SpecimenModel<double> model =
      specimen_model(digit, parameters, parameter_values<double>(parameters, u));
  // Allow long steps: they only select the equilibrium, which every later solve refines.
  NetContinuationOptions long_steps;
  long_steps.stray = 1e-3;
  long_steps.min_turn = 0.05;
  long_steps.max_solves = 100;
  // Follow the net of each trial from the straight finger.
  std::vector<Matrix3Xd> starts(plan.tension.size());
  for (std::size_t i = 0; i < starts.size(); ++i) {
    if (!pulls_net(*digit.net, plan.tension[i])) continue;
    const PosedSpecimen<double> at =
        pose_specimen(model, plan, static_cast<std::size_t>(plan.posture_of_trial[i]));
    const NetTendons tendons = tendons_of(digit, model, at.angles);
    const NetContinuation walk =
        follow_from_straight(tendons, at.angles, arriving_tensions(model, plan, i), long_steps);
    starts[i] = to_link_frames(tendons.net().net, at.state, walk.rest.x);
  }
  return starts;
}

TendonDigit specimen_digit(const TendonDigit& digit, const SpecimenModel<double>& model) {
  TendonDigit own = digit;
  own.model = model.digit;
  if (model.net) own.net = std::make_shared<const BuiltNet>(built_net(*model.net));
  return own;
}

std::vector<std::string> net_trial_warnings(const TendonDigit& digit,
                                            const FitParameters& parameters,
                                            const ExperimentPlan& plan, const VectorXd& u) {
  if (!digit.net) return {};
  // Largest relative difference of torques of equal equilibria; loose knots may differ in place [1]
  constexpr double kTorqueTolerance = 0.01;
  const SpecimenModel<double> model =
      specimen_model(digit, parameters, parameter_values<double>(parameters, u));
  const NetTrials found = net_trials(model, plan);
  std::vector<std::string> warnings;
  for (std::size_t i = 0; i < found.trials.size(); ++i) {
    if (!found.trials[i]) continue;
    const NetTrial& trial = *found.trials[i];
    // Check that the net is at rest, and that continuation from the straight finger agrees.
    std::string why = net_warning(found.net, trial.state, trial.rest);
    const auto posture = static_cast<std::size_t>(plan.posture_of_trial[i]);
    const VectorXd angles = pose_specimen(model, plan, posture).angles;
    const NetEquilibrium other = follow_from_straight(tendons_of(digit, model, angles), angles,
                                                      arriving_tensions(model, plan, i))
                                     .rest;
    const VectorXd tau =
        net_torque(found.net, model.digit.tree, trial.state, other, model.digit.coordinates);
    const double off = (tau - trial.tau).norm() / std::max(tau.norm(), trial.tau.norm());
    if (why.empty() && off > kTorqueTolerance)
      why = fmt::format(
          "the net comes to another rest by way of the straight finger, {:.0f} % off in torque",
          100 * off);
    if (!why.empty())
      warnings.push_back(
          fmt::format("trial {} in posture '{}': {}", i + 1, plan.posture_names[posture], why));
  }
  return warnings;
}

}  // namespace thenar
