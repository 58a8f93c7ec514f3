#pragma once

/// Equilibria of a specimen's net in the trials of an experiment.

#include <optional>
#include <string>
#include <vector>

#include "kinematics_fit/model/predict_forces.h"
#include "tendons/net/net_tendons.h"

namespace thenar {

/// The net at rest in one trial.
struct NetTrial {
  TreeState<double> state;  // links
  NetDrive drive;
  NetEquilibrium rest;
  Eigen::VectorXd tau;  // of the net about the joints [N m] (coordinates)
};

/// A specimen's net, and its rest in every trial in which muscles pull it.
struct NetTrials {
  Net net;
  std::vector<std::optional<NetTrial>> trials;
};

/// Rest of the net in every trial, found from plan.net_start; where that ends without balance, from
/// where the links carry the nodes.
[[nodiscard]] NetTrials net_trials(const SpecimenModel<double>& model, const ExperimentPlan& plan);

/// ExperimentPlan::net_start.
[[nodiscard]] std::vector<Eigen::Matrix3Xd> net_starts(const TendonDigit& digit,
                                                       const FitParameters& parameters,
                                                       const ExperimentPlan& plan);

/// The digit with a specimen's numbers; muscles of its net share among their pulls as at
/// kHoodAngle.
[[nodiscard]] TendonDigit specimen_digit(const TendonDigit& digit,
                                         const SpecimenModel<double>& model);

/// Trials in which the net is not to be trusted, with the reason: it is not at rest
/// (net_warning()), or comes to rest with another torque by way of the straight finger.
[[nodiscard]] std::vector<std::string> net_trial_warnings(const TendonDigit& digit,
                                                          const FitParameters& parameters,
                                                          const ExperimentPlan& plan,
                                                          const Eigen::VectorXd& u);

}  // namespace thenar
