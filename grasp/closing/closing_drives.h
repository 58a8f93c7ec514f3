#pragma once

/// Drive state while a hand closes: rates of the coordinates, and what stopped them.

#include <array>
#include <functional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "base/enum_names.h"
#include "hand/hand.h"

namespace thenar {

/// Function that computes the rates of all coordinates at a posture [rad/s] or [m/s].
/// @param q  (coordinates);  @param free  whether a drive may still move each (coordinates)
using ClosingRates = std::function<Eigen::VectorXd(
    const Eigen::VectorXd& q, const Eigen::Array<bool, Eigen::Dynamic, 1>& free)>;

/// Reason why a coordinate does not move.
enum class StoppedBy { kNothing, kLimit, kContact, kCoupling, kNoDrive };
inline constexpr std::array kStoppedByNames{
    EnumName{StoppedBy::kNothing, "free"}, EnumName{StoppedBy::kLimit, "limit"},
    EnumName{StoppedBy::kContact, "contact"}, EnumName{StoppedBy::kCoupling, "coupling"},
    EnumName{StoppedBy::kNoDrive, "no drive"}};
[[nodiscard]] inline std::string name_of(StoppedBy stop) { return name_in(kStoppedByNames, stop); }

/// Drives that run at their speeds until their coordinates are stopped. In a layout without drives
/// every coordinate has a drive of its own, at speed 1.
class ClosingDrives {
 public:
  explicit ClosingDrives(const HandLayout& layout);

  /// Returns the rate of every coordinate; 0 if it is stopped [rad/s] or [m/s] (coordinates)
  [[nodiscard]] const Eigen::VectorXd& rates() const { return rates_; }
  [[nodiscard]] const std::vector<StoppedBy>& stopped() const { return stopped_; }
  [[nodiscard]] bool is_moving() const { return !rates_.isZero(0); }

  /// Returns for each coordinate whether a drive may still move it (coordinates).
  [[nodiscard]] Eigen::Array<bool, Eigen::Dynamic, 1> free_coordinates() const;

  /// Replaces the rates of coordinates that are not stopped [rad/s] or [m/s] (coordinates)
  void set_rates(const Eigen::VectorXd& rates);

  /// Stops a coordinate, and those that its drive's coupling stops with it.
  void stop(int coordinate, StoppedBy why);

 private:
  void stop_one(int coordinate, StoppedBy why);

  std::vector<Drive> drives_;
  Eigen::VectorXd rates_;
  std::vector<StoppedBy> stopped_;
};

/// Returns the time at constant rates until the last moving joint is at its limit [s].
/// @param q      start [rad] or [m] (coordinates)
/// @param rates  [rad/s] or [m/s] (coordinates)
[[nodiscard]] double time_to_limits(const HandLayout& layout, const Eigen::VectorXd& q,
                                    const Eigen::VectorXd& rates);

/// Returns the posture at which closing begins [rad], of sliding joints [m] (coordinates):
/// HandLayout::open if the hand states it. Otherwise driven coordinates are at the limit from which
/// their drive starts, all others at zero or the limit nearest to it.
[[nodiscard]] Eigen::VectorXd open_posture(const HandLayout& layout);

}  // namespace thenar
