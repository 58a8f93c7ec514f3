#include "grasp/closing/closing_drives.h"

#include <algorithm>

#include "base/error.h"

namespace thenar {
namespace {

/// Returns the drives of a layout; in a layout without drives, one for each coordinate.
std::vector<Drive> drives_of(const HandLayout& layout) {
  if (!layout.drives.empty()) return layout.drives;
  std::vector<Drive> drives;
  for (std::size_t i = 0; i < layout.coordinates.size(); ++i)
    drives.push_back(
        {layout.coordinates[i], DriveCoupling::kRigid, {{static_cast<int>(i), 1}}, /*speed=*/1, 0});
  return drives;
}

}  // namespace

ClosingDrives::ClosingDrives(const HandLayout& layout)
    : drives_(drives_of(layout)),
      rates_(Eigen::VectorXd::Zero(layout.lower.size())),
      stopped_(layout.coordinates.size(), StoppedBy::kNoDrive) {
  for (const Drive& drive : drives_)
    // Only coordinates with a rate count as free.
    for (const DrivenCoordinate& driven : drive.moves) {
      const double rate = drive.speed * driven.ratio;
      rates_[driven.coordinate] = rate;
      if (rate != 0) stopped_[driven.coordinate] = StoppedBy::kNothing;
    }
}

Eigen::Array<bool, Eigen::Dynamic, 1> ClosingDrives::free_coordinates() const {
  Eigen::Array<bool, Eigen::Dynamic, 1> free(rates_.size());
  for (Eigen::Index j = 0; j < free.size(); ++j) free[j] = stopped_[j] == StoppedBy::kNothing;
  return free;
}

void ClosingDrives::set_rates(const Eigen::VectorXd& rates) {
  require(rates.size() == rates_.size() && rates.allFinite(),
          "closing wants {} finite rates, got {}", rates_.size(), rates.size());
  rates_ = free_coordinates().select(rates.array(), 0.0).matrix();
}

void ClosingDrives::stop_one(int coordinate, StoppedBy why) {
  if (stopped_[coordinate] != StoppedBy::kNothing) return;
  stopped_[coordinate] = why;
  rates_[coordinate] = 0;
}

void ClosingDrives::stop(int coordinate, StoppedBy why) {
  stop_one(coordinate, why);
  for (const Drive& drive : drives_) {
    // A compliant coupling stops nothing else.
    if (drive.coupling == DriveCoupling::kCompliant) continue;
    const auto at =
        std::find_if(drive.moves.begin(), drive.moves.end(),
                     [&](const DrivenCoordinate& d) { return d.coordinate == coordinate; });
    if (at == drive.moves.end()) continue;
    // Gears stop all coordinates, a clutch only the inner ones, so that outer ones continue.
    const auto end = drive.coupling == DriveCoupling::kRigid ? drive.moves.end() : at;
    for (auto d = drive.moves.begin(); d != end; ++d) stop_one(d->coordinate, StoppedBy::kCoupling);
  }
}

double time_to_limits(const HandLayout& layout, const Eigen::VectorXd& q,
                      const Eigen::VectorXd& rates) {
  double time = 0;
  // The slowest coordinate determines the time.
  for (Eigen::Index j = 0; j < q.size(); ++j) {
    const double limit = rates[j] > 0 ? layout.upper[j] : layout.lower[j];
    if (rates[j] != 0) time = std::max(time, (limit - q[j]) / rates[j]);
  }
  return time;
}

Eigen::VectorXd open_posture(const HandLayout& layout) {
  // Stated open posture, or the limit from which each drive starts.
  if (layout.open.size() > 0) return layout.open;
  const Eigen::VectorXd rates = ClosingDrives(layout).rates();
  Eigen::VectorXd q = layout.lower.cwiseMax(0).cwiseMin(layout.upper);
  for (Eigen::Index j = 0; j < q.size(); ++j)
    if (rates[j] != 0) q[j] = rates[j] > 0 ? layout.lower[j] : layout.upper[j];
  return q;
}

}  // namespace thenar
