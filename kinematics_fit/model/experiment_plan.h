#pragma once

/// Experiment prepared for a digit: names are resolved to indices, and unusual conditions are
/// listed.

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
  TipConstraint hold;   // constraint of the tip
  int force_link = -1;  // link whose axes the force components refer to; -1: the base
  int measured = 3;     // number of fitted force components, 2 or 3 [1]
  DecidedForces known = DecidedForces::kInSpace;  // tip forces that the joint torques determine
  Eigen::Matrix3d components;  // experiment components from (proximal, dorsal, radial); rows of
                               // those not fitted are zero
  std::vector<Eigen::VectorXd> postures;  // [rad] (coordinates)
  std::vector<std::string> posture_names;
  std::vector<int> posture_key;  // column of posture_error of each posture; -1: none
  std::vector<double>
      condition;  // condition number of each posture's tip_constraint_loads() before the fit [1]
  std::vector<int> posture_of_trial;
  std::vector<Eigen::VectorXd> tension;  // tensions of each trial [N] (muscles)
  std::vector<PlannedSite> sites;        // load cells that do not hold the tip
  std::vector<int> site_of_trial;  // index in `sites` of each trial; -1, or empty: the tip's cell
  Eigen::Matrix3Xd force;          // measured; 0 where not fitted [N] (3, trials)
  Eigen::Matrix3Xd sd;  // sd of noise and model error; infinite where not fitted [N] (3, trials)
  std::vector<Eigen::Matrix3Xd>
      net_start;  // equilibrium positions of a net's nodes in each trial at the prior means,
                  // reached from the straight finger, on their links at the reference posture;
                  // empty if the net is not pulled [m] (3, nodes)
};

/// Resolves the names of an experiment, and computes its constants.
/// @param parameters  parameters with the names of postures that have their own angle errors
/// @throws InputError if the experiment names an unknown joint, muscle or segment, or has a posture
/// in which the constrained tip (or the held segment, if trials were measured there) is singular;
/// or if the force of a mount is needed without the paths of the tendons that leave it.
///
/// If two components in the plane of flexion are fitted, and all axes are within 15 degrees of the
/// normal of that plane, only forces in the plane are used. Every search for the equilibrium of a
/// net starts at net_start, so that forces are a function of the parameters and do not depend on
///         earlier evaluations.
[[nodiscard]] ExperimentPlan plan_experiment(const TendonDigit& digit,
                                             const FitParameters& parameters,
                                             const Experiment& experiment);

/// Returns the index of a muscle of the digit. @throws InputError if the digit has none of this
/// name
[[nodiscard]] int muscle_index(const TendonDigit& digit, const std::string& name);

/// Returns the site at which trial i was measured: an index in plan.sites, or -1 for the tip.
[[nodiscard]] inline int site_of(const ExperimentPlan& plan, std::size_t trial) {
  return trial < plan.site_of_trial.size() ? plan.site_of_trial[trial] : -1;
}

/// Returns warnings about an experiment on this digit: angles that seem to be in another unit,
/// postures beyond the joint limits or with a nearly singular tip, tensions far above the capacity
/// of the muscle, a pinned tip with more than two joints in one plane, a subject that was
/// calibrated on the specimen, moments that no fit uses.
[[nodiscard]] std::vector<std::string> experiment_warnings(const TendonDigit& digit,
                                                           const ExperimentPlan& plan,
                                                           const Experiment& experiment);

}  // namespace thenar
