#pragma once

/// An experiment prepared for a digit: names become indices, and doubtful conditions are listed.

#include <string>
#include <vector>

#include <Eigen/Core>

#include "data/io/experiment.h"
#include "kinematics_fit/model/fit_parameters.h"
#include "kinematics_fit/model/planned_site.h"
#include "kinematics_fit/model/tip_constraint.h"

namespace thenar {

/// Experiment with all names resolved to indices of one digit; built once, used at every
/// evaluation.
struct ExperimentPlan {
  TipConstraint hold;
  int force_link;    // link whose axes the forces use; -1: the base
  int measured = 3;  // components of a force that are fitted, 2 or 3 [1]
  DecidedForces known =
      DecidedForces::kInSpace;            // forces of the tip that the tendons' torques decide
  Eigen::Matrix3d components;             // experiment components from (proximal, dorsal, radial);
                                          // rows of those not fitted are zero
  std::vector<Eigen::VectorXd> postures;  // [rad] (coordinates)
  std::vector<std::string> posture_names;
  std::vector<int> posture_key;   // column of posture_error of each posture; -1: none
  std::vector<double> condition;  // of each posture's tip_constraint_loads() before the fit [1]
  std::vector<int> posture_of_trial;
  std::vector<Eigen::VectorXd> tension;     // of each trial [N] (muscles)
  std::vector<PlannedSite> sites;           // of load cells that do not hold the tip
  std::vector<int> site_of_trial;           // index in `sites`; -1, or none: the tip's cell
  Eigen::Matrix3Xd force;                   // measured; 0 where not fitted [N] (3, trials)
  Eigen::Matrix3Xd sd;                      // of the noise and of what the model misses; infinite
                                            // where not fitted [N] (3, trials)
  std::vector<Eigen::Matrix3Xd> net_start;  // of each trial: where the nodes of a net come to rest
                                            // at the prior means, by way of the straight finger, on
                                            // their links at the reference posture; empty where
                                            // none is pulled [m] (3, nodes)
};

/// Resolves the names of an experiment.
/// @param parameters  name the postures that may be in error one by one
/// @throws InputError if the experiment names a joint, muscle or segment the digit has not, or a
/// posture in which the held tip is singular: no force there follows from the tendons' torques.
/// The same of the held segment where a trial was measured elsewhere, and InputError if a mount's
/// force is asked for without the paths of the tendons that leave it.
/// Where two components in the plane of flexion are fitted, and all axes are within 15 degrees of
/// that plane's normal, only forces in the plane count.
/// Every search for the rest of a net begins at net_start, so that forces are a function of the
/// parameters and do not depend on what was computed before.
[[nodiscard]] ExperimentPlan plan_experiment(const TendonDigit& digit,
                                             const FitParameters& parameters,
                                             const Experiment& experiment);

/// Returns the site at which trial i was measured: an index in plan.sites, or -1 at the tip.
[[nodiscard]] inline int site_of(const ExperimentPlan& plan, std::size_t trial) {
  return trial < plan.site_of_trial.size() ? plan.site_of_trial[trial] : -1;
}

/// Warnings about an experiment on this digit: angles that look like another unit, postures beyond
/// the joint limits or in which the held tip is nearly singular, tensions far above those that the
/// muscle can make, a pinned tip of more than two joints in one plane, a subject that was
/// calibrated on the specimen, moments that no fit uses.
[[nodiscard]] std::vector<std::string> experiment_warnings(const TendonDigit& digit,
                                                           const ExperimentPlan& plan,
                                                           const Experiment& experiment);

}  // namespace thenar
