#pragma once

/// Prediction of measured fingertip forces by every model of the extensor hood, without any fit.

#include <map>
#include <string>
#include <vector>

#include "data/io/net_description.h"
#include "kinematics_fit/prediction.h"
#include "tendons/digit_tendons.h"

namespace thenar {

/// Predictions of one experiment by one model of tendon paths and hood (a rung of the ladder).
struct HoodRung {
  std::string name;  // "fixed fractions", "net winslow"
  Path path;
  Hood hood;
  Prediction prediction;  // predictions of all trials
  std::map<std::string, ForceError>
      muscle;                        // errors by muscle, for trials in which one muscle pulls alone
  ForceError hood_muscles;           // error over trials whose muscles all pull on the hood
  double relative_to_finest = 0;     // RMS distance of its forces from those of the last rung, over
                                     // the RMS force of that rung [1]
  double seconds = 0;                // time for one posture and load; nets start at rest [s]
  std::vector<std::string> warning;  // trial and reason if the result of a net is unreliable
};

/// Predictions of one experiment by all rungs.
struct HoodComparison {
  std::string subject, experiment;
  std::vector<std::string> hood_muscles;  // muscles of HoodRung::hood_muscles
  std::vector<HoodRung> rungs;            // predictions, from the simplest hood to the finest
};

/// Predicts every trial on every rung: separate tendons, fixed fractions if the subject has a hood
/// rule, each net with straight segments between knots, then each net over its surfaces; the last
/// of these is called the finest. Whole tendons run straight, and again wrapped if the subject has
/// surfaces. Nets are moved to each posture from the straight finger under the load. The tip
/// constraint carries forces and the flexion moment, as in [Synek2019].
/// @throws InputError if the experiment does not fit the digit.
[[nodiscard]] HoodComparison compare_hoods(const Subject& subject, const Experiment& experiment,
                                           const std::vector<NetDescription>& nets);

/// Forces of a constrained tip in every trial of an experiment.
struct TrialForces {
  Eigen::Matrix3Xd force;  // force in the experiment's components [N] (3, trials)
  std::vector<std::string>
      warning;         // reason why the trial is unreliable; empty if reliable (trials)
  double seconds = 0;  // median time for one trial [s]
};

/// Computes the forces of every trial. @throws InputError if the experiment does not fit the digit.
[[nodiscard]] TrialForces trial_forces(const DigitTendons& tendons, const Experiment& experiment);

}  // namespace thenar
