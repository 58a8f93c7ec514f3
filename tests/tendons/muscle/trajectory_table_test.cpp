// Tests for tendons/muscle/trajectory_table.cpp.

#include "tendons/muscle/trajectory_table.h"

#include <gtest/gtest.h>

#include "base/units.h"

namespace thenar {
namespace {

/// One joint, one muscle without fibres, two instants.
Trajectory small() {
  Trajectory t;
  t.joints = {"PIP2"};
  t.muscles = {"FDP"};
  t.time = Eigen::Vector2d(0, 0.5);
  t.angle = Eigen::Vector2d(0, 30 * kDegree);
  t.speed = Eigen::Vector2d(0, 90 * kDegree);
  t.excitation = t.activation = Eigen::Vector2d(0, 0.25);
  t.tension = Eigen::Vector2d(0, 12);
  t.excursion = Eigen::Vector2d(0, -0.004);
  t.slips = Eigen::MatrixX4d::Zero(2, 4);
  t.tip = Eigen::MatrixX3d::Constant(2, 3, 0.01);
  t.energy = t.work = t.dissipated = Eigen::Vector2d(0, 1e-3);
  return t;
}

TEST(TrajectoryTable, NamesColumnsWithTheirUnits) {
  const std::vector<std::string> wanted{
      "time_s",          "angle_PIP2_deg",   "speed_PIP2_deg_s", "excitation_FDP", "activation_FDP",
      "tension_FDP_N",   "excursion_FDP_mm", "slip_central_N",   "slip_radial_N",  "slip_ulnar_N",
      "slip_terminal_N", "tip_x_mm",         "tip_y_mm",         "tip_z_mm",       "energy_J",
      "work_J",          "lost_J",           "energy_error_J"};
  EXPECT_EQ(trajectory_table(small()).columns, wanted);
}

TEST(TrajectoryTable, TurnsNumbersToTheirUnits) {
  const TrajectoryTable table = trajectory_table(small());
  Eigen::RowVectorXd row(18);
  row << 0.5, 30, 90, 0.25, 0.25, 12, -4, 0, 0, 0, 0, 10, 10, 10, 1e-3, 1e-3, 1e-3, 1e-3;
  EXPECT_LT((table.values.row(1) - row).cwiseAbs().maxCoeff(), 1e-13);
}

}  // namespace
}  // namespace thenar
