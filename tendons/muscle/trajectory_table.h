#pragma once

/// Trajectories as tables, for files.

#include "tendons/muscle/trajectory.h"

namespace thenar {

/// Table with one row per instant; column names contain units.
struct TrajectoryTable {
  std::vector<std::string> columns;
  Eigen::MatrixXd values;  // (instants, columns)
};

/// Builds the table of a trajectory: time_s; angle_J_deg and speed_J_deg_s of every joint J;
/// excitation_M, activation_M, tension_M_N, excursion_M_mm and, with fibres, fibre_M of every
/// muscle M; slip_.._N; tip_x_mm ..; energy_J, work_J, lost_J.
[[nodiscard]] TrajectoryTable trajectory_table(const Trajectory& trajectory);

}  // namespace thenar
