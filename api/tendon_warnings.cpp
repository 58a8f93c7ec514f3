#include "api/tendon_warnings.h"

#include <algorithm>

#include <fmt/format.h>

#include "api/named/digit_result.h"
#include "tendons/forces/posture_sensitivity.h"
#include "tendons/net/band_course.h"

namespace thenar {
namespace {

/// Terminal per central slip that publications give of an extensor's pull: fractions of 0.4945 to
/// the central slip [Synek2019], and measured forces [Lee2008]. They are a factor of 1.66 apart, by
/// which either may be off.
constexpr double kMinRatio = (1 - 0.4945) / 0.4945, kMaxRatio = 1.7 * 1.7 / kMinRatio;

/// Returns a warning if the ratio of slip tensions is outside the published range; otherwise empty.
std::string slip_doubt(const LoadedDigit& loaded, const DigitPoint& point) {
  // A ratio of slack slips means nothing.
  const SlipTension& slips = point.pull.slips;
  if (loaded.net() == nullptr || !is_trusted(point.pull.status) ||
      slips.central + slips.terminal < kTautTension)
    return "";
  if (slips.terminal >= kMinRatio * slips.central && slips.terminal <= kMaxRatio * slips.central)
    return "";
  // Skip rounding errors of slack tendons.
  const auto taut = [](double tension) { return tension > kTautTension ? tension : 0; };
  const double terminal = taut(slips.terminal), central = taut(slips.central);
  return fmt::format(
      "terminal slip {0:.4g} N, central slip {1:.4g} N{2}; published ratios of terminal to central "
      "tension are {3:.3g} to 1.7",
      terminal, central, central > 0 ? fmt::format(" (ratio {:.3g})", terminal / central) : "",
      kMinRatio);
}

}  // namespace

std::string place_of(const LoadedDigit& loaded, const DigitPoint& point) {
  return varied_angles(loaded.bones().names.coordinates, loaded.grid, point.q);
}

std::string tip_note(const TipForce& tip) {
  constexpr double kTorqueRounding = 1e-9;  // Rounding of a joint torque [N m]
  // Fewer independent rows than a point contact has directions: a singular posture.
  if (tip.rank < std::min<Eigen::Index>(tip.possible, tip.tau_residual.size()))
    return tip.tau_residual.cwiseAbs().maxCoeff() < kTorqueRounding
               ? "singular posture: along some direction a force of the tip needs no joint torque; "
                 "the smallest force in balance is given"
               : "singular posture: no force of the tip balances all joint torques; given is the "
                 "smallest of the forces that leave the least torque unbalanced";
  if (tip.singular())
    return "too few joints: along some direction a force of the tip needs no joint torque; the "
           "smallest force in balance is given";
  if (tip.condition < kNearlyStraight) return "";
  return fmt::format(
      "nearly singular posture (condition {:.3g}): the force changes much within a degree",
      tip.condition);
}

std::vector<std::string> tendon_warnings(const LoadedDigit& loaded, const DigitPoint& point) {
  std::vector<std::string> warnings;
  const TendonTorque& pull = point.pull;
  if (point.snapped)
    warnings.push_back(
        "the hood snaps to another equilibrium on the way here from the straight finger");
  if (!pull.warning.empty() && is_trusted(pull.status)) warnings.push_back(pull.warning);
  const std::string doubt = slip_doubt(loaded, point);
  if (!doubt.empty()) warnings.push_back(doubt);
  return warnings;
}

std::vector<std::string> tendon_warnings(const LoadedDigit& loaded,
                                         const std::vector<DigitPoint>& points) {
  std::vector<std::string> warnings;
  // Singular postures: how many, and the first.
  const auto doubtful = [](const DigitPoint& point) { return !tip_note(point.tip).empty(); };
  const auto first = std::find_if(points.begin(), points.end(), doubtful);
  if (first != points.end())
    warnings.push_back(fmt::format("the force of the tip at {} of {} postures, first at {}: {}",
                                   std::count_if(first, points.end(), doubtful), points.size(),
                                   place_of(loaded, *first), tip_note(first->tip)));
  // Shares of the slips, likewise.
  const auto odd = [&](const DigitPoint& point) { return !slip_doubt(loaded, point).empty(); };
  const auto first_odd = std::find_if(points.begin(), points.end(), odd);
  if (first_odd != points.end())
    warnings.push_back(fmt::format("at {} of {} postures, first at {}: {}",
                                   std::count_if(first_odd, points.end(), odd), points.size(),
                                   place_of(loaded, *first_odd), slip_doubt(loaded, *first_odd)));
  // Snaps and doubts, posture by posture.
  for (std::size_t i = 0; i < points.size(); ++i) {
    const DigitPoint& point = points[i];
    // Each row comes from the straight finger; once snapped, it stays so.
    const bool before = i % loaded.grid.row > 0 && points[i - 1].snapped;
    if (point.snapped && !before)
      warnings.push_back(fmt::format("the hood snaps to another equilibrium on the way to {}",
                                     place_of(loaded, point)));
    if (!point.pull.warning.empty())
      warnings.push_back(fmt::format("at {}: {}", place_of(loaded, point), point.pull.warning));
  }
  return warnings;
}

}  // namespace thenar
