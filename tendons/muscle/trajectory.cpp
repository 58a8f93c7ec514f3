#include "tendons/muscle/trajectory.h"

#include "base/numbers.h"

namespace thenar {

Eigen::VectorXd energy_drift(const Trajectory& trajectory) {
  if (trajectory.energy.size() == 0) return {};
  return trajectory.energy.array() - trajectory.energy[0] -
         (trajectory.work - trajectory.dissipated).array();
}

double released_energy(const Trajectory& trajectory) {
  double sum = 0;
  for (const MotionSnap& snap : trajectory.snaps) sum += snap.released;
  return sum;
}

double energy_error(const Trajectory& trajectory) {
  return trajectory.energy.size() > 0 ? max_or_nan(energy_drift(trajectory).cwiseAbs()) : 0;
}

}  // namespace thenar
