#pragma once

/// Experiments made up for a thumb: one muscle after the other, and tasks with electromyography.

#include <string>
#include <vector>

#include "data/io/experiment.h"
#include "tendons/tendon_model.h"

namespace thenar {

/// Key pinch, opposition pinch, wide grasp and hook, in this order: joint angles of a five-axis
/// thumb within its ranges. They are judgements: key pinch with the thumb adducted and its IP joint
/// bent, opposition abducted and less bent, the other two to either side of them.
[[nodiscard]] std::vector<PostureRecord> thumb_postures();

struct SimulatedPullOptions {
  int postures = 2;       // the first of thumb_postures() [1]
  double tension = 10;    // of one muscle after the other [N]
  double noise = 0.1;     // sd of every component, as a part of the true force's size [1]
  double floor = 0.01;    // and at least about this: sds add in squares [N]
  bool add_noise = true;  // false: forces as they are, with sds as if there were noise
  unsigned seed = 1;
};

/// Pulls every muscle of the digit in turn, tip pinned, and reads the force with its sds, which are
/// known as if from repeated readings: sd^2 = floor^2 + (noise |f|)^2, f the true force.
[[nodiscard]] Experiment simulate_pulls(const TendonDigit& truth,
                                        const SimulatedPullOptions& options);

/// The true forces of its trials [N] (3, trials).
[[nodiscard]] Eigen::Matrix3Xd true_forces(const TendonDigit& truth, const Experiment& experiment);

/// The experiment as a file that read_experiment() reads, numbers to the last bit. Components are
/// those of the digit, every row has its own sd.
/// @throws InputError if a row has none, or the components are others.
[[nodiscard]] std::string experiment_text(const Experiment& experiment);

}  // namespace thenar
