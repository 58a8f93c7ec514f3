#pragma once

/// Trials of an experiment as inputs of the inference of an extensor net's bands.

#include <vector>

#include "data/io/experiment.h"
#include "kinematics_fit/model/predict_forces.h"
#include "tendons/net/net_tendons.h"
#include "tendons/topology/candidate_net.h"

namespace thenar {

/// Force of the held tip on the load cell per joint torque, in the experiment's components [1/m]
/// (3, coordinates). Where the hold takes more loads than there are joints, the loads of least
/// norm.
[[nodiscard]] Eigen::MatrixXd cell_map(const TendonModel<double>& model, const ExperimentPlan& plan,
                                       const Eigen::VectorXd& q);

/// Every passive band of the digit's net as a candidate.
[[nodiscard]] CandidateNet candidate_of(const NetTendons& tendons);

/// Trials in which a muscle pulls the net, with the measured forces of the held tip in the
/// experiment's components. Other trials do not depend on the net and are left out.
/// @throws InputError if the experiment does not fit the digit.
[[nodiscard]] std::vector<TendonRecord> net_records(const NetTendons& tendons,
                                                    const Experiment& experiment);

/// Tests that are possible on the same rig: every posture of the experiment with the largest load
/// of each muscle of the net, alone, in pairs and all together.
[[nodiscard]] std::vector<TendonTest> possible_tests(const NetTendons& tendons,
                                                     const Experiment& experiment);

/// Returns the possible tests as trials without a reading, for any model of the net.
/// @param digit  with a net
[[nodiscard]] std::vector<Trial> possible_trials(const TendonDigit& digit,
                                                 const Experiment& experiment);

/// Posture and tensions of a trial [N]: "MinorFlex EDC=3.28 RI=5.32", muscles in the digit's order.
[[nodiscard]] std::string trial_name(const TendonDigit& digit, const Trial& trial);

}  // namespace thenar
