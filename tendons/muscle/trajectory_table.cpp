#include "tendons/muscle/trajectory_table.h"

#include <fmt/format.h>

#include "base/units.h"

namespace thenar {
namespace {

/// Appends one column for each name.
void add(TrajectoryTable& table, const std::string& before, const std::vector<std::string>& names,
         const std::string& after, const Eigen::MatrixXd& values) {
  if (values.size() == 0) return;
  const Eigen::Index columns = table.values.cols();
  table.values.conservativeResize(values.rows(), columns + values.cols());
  table.values.rightCols(values.cols()) = values;
  for (const std::string& name : names)
    table.columns.push_back(fmt::format("{}{}{}", before, name, after));
}

}  // namespace

TrajectoryTable trajectory_table(const Trajectory& t) {
  TrajectoryTable table;
  add(table, "time_s", {""}, "", t.time);
  add(table, "angle_", t.joints, "_deg", t.angle / kDegree);
  add(table, "speed_", t.joints, "_deg_s", t.speed / kDegree);
  add(table, "excitation_", t.muscles, "", t.excitation);
  add(table, "activation_", t.muscles, "", t.activation);
  add(table, "tension_", t.muscles, "_N", t.tension);
  add(table, "excursion_", t.muscles, "_mm", t.excursion / kMm);
  add(table, "fibre_", t.muscles, "", t.fibre);
  add(table, "slip_", {"central", "radial", "ulnar", "terminal"}, "_N", t.slips);
  add(table, "tip_", {"x", "y", "z"}, "_mm", t.tip / kMm);
  add(table, "energy_J", {""}, "", t.energy);
  add(table, "work_J", {""}, "", t.work);
  add(table, "lost_J", {""}, "", t.dissipated);
  add(table, "energy_error_J", {""}, "", energy_drift(t));
  return table;
}

}  // namespace thenar
