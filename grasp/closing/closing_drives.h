#pragma once

/// State of closing: rates of the coordinates, and what stopped them.

#include <array>
#include <functional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "base/enum_names.h"
#include "hand/hand.h"

namespace thenar {

/// Rates of all coordinates at a posture [rad/s] or [m/s], updated while the hand closes.
/// @param q  (coordinates);  @param free  which a drive may still move (coordinates)
using ClosingRates = std::function<Eigen::VectorXd(
    const Eigen::VectorXd& q, const Eigen::Array<bool, Eigen::Dynamic, 1>& free)>;

/// Reason why a coordinate does not move (any more).
enum class StoppedBy { kNothing, kLimit, kContact, kCoupling, kNoDrive };
inline constexpr std::array kStoppedByNames{
    EnumName{StoppedBy::kNothing, "free"}, EnumName{StoppedBy::kLimit, "limit"},
    EnumName{StoppedBy::kContact, "contact"}, EnumName{StoppedBy::kCoupling, "coupling"},
    EnumName{StoppedBy::kNoDrive, "no drive"}};
[[nodiscard]] inline std::string name_of(StoppedBy stop) { return name_in(kStoppedByNames, stop); }

/// Drives that run at their speeds until their coordinates are stopped. In a layout without drives
/// every coordinate moves upwards by itself at speed 1.
class ClosingDrives {
 public:
  explicit ClosingDrives(const HandLayout& layout);

  /// Rate of every coordinate; 0 if it is stopped [rad/s] or [m/s] (coordinates)
  [[nodiscard]] const Eigen::VectorXd& rates() const { return rates_; }
  [[nodiscard]] const std::vector<StoppedBy>& stopped() const { return stopped_; }
  [[nodiscard]] bool moving() const { return !rates_.isZero(0); }

  /// Returns for each coordinate whether a drive may still move it. (coordinates)
  [[nodiscard]] Eigen::Array<bool, Eigen::Dynamic, 1> free() const;

  /// Replaces the rates of free coordinates [rad/s] or [m/s] (coordinates)
  void follow(const Eigen::VectorXd& rates);

  /// Stops a coordinate, and those that the coupling of its drive stops with it.
  void stop(int coordinate, StoppedBy why);

 private:
  void halt(int coordinate, StoppedBy why);

  std::vector<Drive> drives_;
  Eigen::VectorXd rates_;
  std::vector<StoppedBy> stopped_;
};

/// Time at constant rates until the last moving joint is at its limit [s].
/// @param q      start [rad] or [m] (coordinates)
/// @param rates  [rad/s] or [m/s] (coordinates)
[[nodiscard]] double time_to_limits(const HandLayout& layout, const Eigen::VectorXd& q,
                                    const Eigen::VectorXd& rates);

/// Posture at which closing begins: HandLayout::open if the hand states it. Otherwise coordinates
/// that drives move start at the limit from which they come, the others at zero or the nearest
/// limit. [rad], of sliding joints [m] (coordinates)
[[nodiscard]] Eigen::VectorXd open_posture(const HandLayout& layout);

}  // namespace thenar
