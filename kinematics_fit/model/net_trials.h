#pragma once

/// Equilibria of a specimen's net in the trials of an experiment.

#include <optional>
#include <string>
#include <vector>

#include "kinematics_fit/model/predict_forces.h"
#include "tendons/net/net_tendons.h"

namespace thenar {

/// Equilibrium of the net in one trial.
struct NetTrial {
  TreeState<double> state;  // pose of the links
  NetDrive drive;
  NetEquilibrium rest;
  Eigen::VectorXd tau;  // torque of the net about the joints [N m] (coordinates)
};

/// Net of a specimen, and its equilibrium in every trial in which muscles pull it.
struct NetTrials {
  Net net;
  std::vector<std::optional<NetTrial>> trials;  // empty where no muscle pulls the net
};

/// Finds the equilibrium of the net in every trial, starting from plan.net_start; if that fails,
/// from the positions of the nodes on their links.
[[nodiscard]] NetTrials net_trials(const SpecimenModel<double>& model, const ExperimentPlan& plan);

/// Computes ExperimentPlan::net_start.
[[nodiscard]] std::vector<Eigen::Matrix3Xd> net_starts(const TendonDigit& digit,
                                                       const FitParameters& parameters,
                                                       const ExperimentPlan& plan);

/// Returns the digit with a specimen's numbers; muscles of its net divide their tension among their
/// pulls as at kHoodAngle.
[[nodiscard]] TendonDigit specimen_digit(const TendonDigit& digit,
                                         const SpecimenModel<double>& model);

/// Returns the trials in which the net is unreliable, with the reason: it is not in equilibrium
/// (net_warning()), or reaches an equilibrium with another torque by way of the straight finger.
[[nodiscard]] std::vector<std::string> net_trial_warnings(const TendonDigit& digit,
                                                          const FitParameters& parameters,
                                                          const ExperimentPlan& plan,
                                                          const Eigen::VectorXd& u);

}  // namespace thenar
