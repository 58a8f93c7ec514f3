#pragma once

/// Trials of an experiment as inputs for inferring the bands of an extensor net.

#include <vector>

#include "data/io/experiment.h"
#include "kinematics_fit/model/predict_forces.h"
#include "tendons/net/net_tendons.h"
#include "tendons/topology/candidate_net.h"

namespace thenar {

/// Computes the map from joint torques to the force of the constrained tip on the load cell, in the
/// experiment's components [1/m] (3, coordinates). If the constraint carries more loads than there
/// are joints, the loads of minimum norm are used.
[[nodiscard]] Eigen::MatrixXd cell_map(const TendonModel<double>& model, const ExperimentPlan& plan,
                                       const Eigen::VectorXd& q);

/// Returns a candidate net with every passive band of the digit's net.
[[nodiscard]] CandidateNet candidate_of(const NetTendons& tendons);

/// Returns the trials in which a muscle pulls the net, with the measured forces of the constrained
/// tip in the experiment's components. Other trials do not depend on the net and are left out.
/// @throws InputError if the experiment does not fit the digit.
[[nodiscard]] std::vector<TendonRecord> net_records(const NetTendons& tendons,
                                                    const Experiment& experiment);

/// Returns tests that are possible on the same rig: every posture of the experiment with the
/// maximum load of each muscle of the net, alone, in pairs and all together.
[[nodiscard]] std::vector<TendonTest> possible_tests(const NetTendons& tendons,
                                                     const Experiment& experiment);

/// Returns the possible tests as trials without a reading, for any model of the net.
/// @param digit  digit with a net
[[nodiscard]] std::vector<Trial> possible_trials(const TendonDigit& digit,
                                                 const Experiment& experiment);

/// Returns posture and tensions of a trial [N]: "MinorFlex EDC=3.28 RI=5.32", muscles in the
/// digit's order.
[[nodiscard]] std::string trial_name(const TendonDigit& digit, const Trial& trial);

}  // namespace thenar
