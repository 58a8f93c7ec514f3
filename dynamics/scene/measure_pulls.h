#pragma once

/// Measures of tendons and muscles in a run of a scene.

#include <string>
#include <vector>

#include "dynamics/stepping/moving_scene.h"
#include "dynamics/stepping/scene_run.h"

namespace thenar {

/// One muscle over the instants of a run.
struct PullMeasure {
  std::string name;            // "human/index/FDP2"
  bool contracts = false;      // excited, rather than given a tension
  Eigen::VectorXd tension;     // [N] (instants)
  Eigen::VectorXd excitation;  // [1] (instants); 0 of muscles that do not contract, likewise:
  Eigen::VectorXd activation;  // [1] (instants)
  Eigen::VectorXd excursion;   // lengthening since the reference posture [m] (instants); 0 where
                               // tension does not depend on it
};

/// All muscles of the pulled digits.
struct RunPulls {
  std::vector<PullMeasure> muscles;
  std::vector<std::string> warnings;  // the first of each digit, with its instant
};

/// Asks the DigitPulls of a scene at every instant of a run.
[[nodiscard]] RunPulls measure_pulls(const MovingScene& scene, const SceneRun& run);

}  // namespace thenar
