#pragma once

/// Predicts measured fingertip forces by every model of the extensor hood, without any fit.

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
  Prediction prediction;                     // all trials
  std::map<std::string, ForceError> muscle;  // by the muscle that pulls, where one pulls alone
  ForceError hood_muscles;                   // of trials whose muscles all pull on the hood
  double relative_to_finest = 0;     // RMS distance of its forces from those of the last rung,
                                     // per RMS force of that [1]
  double seconds = 0;                // for one posture and load, a net started where it rests [s]
  std::vector<std::string> warning;  // trial and reason, where the result of a net is unreliable
};

/// All rungs on one experiment.
struct HoodComparison {
  std::string subject, experiment;
  std::vector<std::string> hood_muscles;  // muscles of HoodRung::hood_muscles
  std::vector<HoodRung> rungs;            // from the simplest to the finest
};

/// Predicts every trial on every rung: separate tendons, fixed fractions if the subject has a hood
/// rule, each net with straight runs from knot to knot, then each net over its surfaces; of these
/// the last is called the finest. Whole tendons run straight, and again wrapped where the subject
/// has surfaces. Nets are brought to each posture from the straight
/// finger under the load. The hold carries forces and the flexion moment, as in [Synek2019].
/// @throws InputError if the experiment does not fit the digit.
[[nodiscard]] HoodComparison compare_hoods(const Subject& subject, const Experiment& experiment,
                                           const std::vector<NetDescription>& nets);

/// Forces of a held tip in every trial of an experiment.
struct TrialForces {
  Eigen::Matrix3Xd force;            // in the experiment's components [N] (3, trials)
  std::vector<std::string> warning;  // why the trial is unreliable; empty if it is not (trials)
  double seconds;                    // for one trial, median [s]
};

/// @throws InputError if the experiment does not fit the digit.
[[nodiscard]] TrialForces trial_forces(const DigitTendons& tendons, const Experiment& experiment);

}  // namespace thenar
