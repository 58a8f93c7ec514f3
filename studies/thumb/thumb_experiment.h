#pragma once

/// Simulated experiments of a thumb: single muscles pulled in turn, tip pinned.

#include <string>
#include <vector>

#include "data/io/experiment.h"
#include "tendons/tendon_model.h"

namespace thenar {

/// Returns the postures of a five-axis thumb within its ranges: key pinch, opposition pinch, wide
/// grasp and hook, in this order. The joint angles are judgements: key pinch with the thumb
/// adducted and its IP joint bent, opposition abducted and less bent, the other two to either side
/// of these.
[[nodiscard]] std::vector<PostureRecord> thumb_postures();

/// Protocol and noise of simulated pulls.
struct SimulatedPullOptions {
  int postures = 2;       // number of leading thumb_postures() [1]
  double tension = 10;    // tension of one muscle after the other [N]
  double noise = 0.1;     // sd of every component over the magnitude of the true force [1]
  double floor = 0.01;    // floor of the sd, added in quadrature [N]
  bool add_noise = true;  // false: exact forces, with the same sds
  unsigned seed = 1;
};

/// Simulates pulls of every muscle of the digit in turn, tip pinned, with measured forces. Their
/// sds are known, as if from repeated readings: sd^2 = floor^2 + (noise |f|)^2, f the true force.
[[nodiscard]] Experiment simulate_pulls(const TendonDigit& truth,
                                        const SimulatedPullOptions& options);

/// Returns the true forces of the trials of an experiment [N] (3, trials).
[[nodiscard]] Eigen::Matrix3Xd true_forces(const TendonDigit& truth, const Experiment& experiment);

/// Returns the text of the experiment as read_experiment() reads it, numbers to the last bit.
/// @throws InputError if a row has no sd, or the components are not those of the digit.
[[nodiscard]] std::string experiment_text(const Experiment& experiment);

}  // namespace thenar
