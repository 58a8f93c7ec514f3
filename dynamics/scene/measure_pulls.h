#pragma once

/// Measures of tendons and muscles in a run of a scene.

#include <string>
#include <vector>

#include "dynamics/stepping/moving_scene.h"
#include "dynamics/stepping/scene_run.h"

namespace thenar {

/// History of one muscle over the instants of a run.
struct PullMeasure {
  std::string name;            // name of the muscle, "human/index/FDP2"
  bool contracts = false;      // true: the muscle contracts; false: its tension is given
  Eigen::VectorXd tension;     // tension [N] (instants)
  Eigen::VectorXd excitation;  // excitation [1] (instants); 0 unless it contracts
  Eigen::VectorXd activation;  // activation [1] (instants); 0 unless it contracts
  Eigen::VectorXd excursion;   // lengthening since the reference posture [m] (instants); 0 where
                               // tension does not depend on it
};

/// Histories of all muscles of the pulled digits.
struct RunPulls {
  std::vector<PullMeasure> muscles;
  std::vector<std::string> warnings;  // first warning of each digit, with its time
};

/// Evaluates the DigitPulls of a scene at every instant of a run.
[[nodiscard]] RunPulls measure_pulls(const MovingScene& scene, const SceneRun& run);

}  // namespace thenar
