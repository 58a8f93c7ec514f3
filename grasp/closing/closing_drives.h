#pragma once

/// Which coordinates still move while a hand closes, and what stopped the others.

#include <string>
#include <vector>

#include <Eigen/Core>

#include "hand/hand.h"

namespace thenar {

/// Why a coordinate does not move (any more).
enum class StoppedBy { kNothing, kLimit, kContact, kCoupling, kNoDrive };

/// "free", "limit", "contact", "coupling", "no drive".
[[nodiscard]] std::string name_of(StoppedBy stop);

/// Drives that run at their speeds until their coordinates are stopped. A layout without drives
/// moves every coordinate by itself, upwards at speed 1.
class ClosingDrives {
 public:
  explicit ClosingDrives(const HandLayout& layout);

  /// Of every coordinate; 0 where it is stopped [rad/s] or [m/s] (coordinates)
  [[nodiscard]] const Eigen::VectorXd& rates() const { return rates_; }
  [[nodiscard]] const std::vector<StoppedBy>& stopped() const { return stopped_; }
  [[nodiscard]] bool moving() const { return !rates_.isZero(0); }

  /// Which coordinates a drive may still move. (coordinates)
  [[nodiscard]] Eigen::Array<bool, Eigen::Dynamic, 1> free() const;

  /// Takes other rates for the coordinates that are free. (coordinates)
  void follow(const Eigen::VectorXd& rates);

  /// Stops a coordinate, and those that its drive's coupling stops with it.
  void stop(int coordinate, StoppedBy why);

 private:
  void halt(int coordinate, StoppedBy why);

  std::vector<Drive> drives_;
  Eigen::VectorXd rates_;
  std::vector<StoppedBy> stopped_;
};

/// How long joints take at constant rates until the last of those that move is at its limit [s].
/// @param q      start [rad] or [m] (coordinates)
/// @param rates  [rad/s] or [m/s] (coordinates)
[[nodiscard]] double time_to_limits(const HandLayout& layout, const Eigen::VectorXd& q,
                                    const Eigen::VectorXd& rates);

/// Where closing begins: the hand's own HandLayout::open; where it states none, coordinates that
/// drives move at the limit they come from, the others at zero or the limit next to it.
/// (coordinates)
[[nodiscard]] Eigen::VectorXd open_posture(const HandLayout& layout);

}  // namespace thenar
