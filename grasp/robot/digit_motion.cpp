#include "grasp/robot/digit_motion.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/numbers.h"
#include "grasp/robot/posed_surfaces.h"

namespace thenar {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kSameWay = 0.7;  // smallest cosine between tip directions of similar fingers [1]
constexpr double kNoWay = 1e-9;   // motion of a tip that counts as none [m]
constexpr std::size_t kPalmFingers = 3;   // fingers that make a palm, approached along its normal
constexpr double kOppositionRange = 0.6;  // range from which a turning motor may oppose [rad]
constexpr double kFartherRatio = 1.4;     // smallest ratio to the ranges of the others [1]
constexpr double kMostBackBend = 0.6;     // farthest that fingers bend backwards to open [rad]
constexpr double kNearNormal = 0.9925;    // least cosine to a flat face of the palm's normal [1]

/// Number of positions at which each of so many turning motors is tried.
int places(std::size_t motors) { return motors <= 1 ? 9 : motors == 2 ? 5 : 3; }

}  // namespace

DigitMotion::DigitMotion(const BallGrasp& grip, bool closing) : digits_(grip) {
  // Stated speeds tell how the hand closes; otherwise both senses are tried.
  if (closing) {
    SenseOption stated;
    for (const Drive& drive : digits_.drives()) stated.speed.push_back(drive.speed);
    options_ = {stated};
  } else {
    options_ = closing_options(grip.hand().layout(), digits_.rest(), digits_.groups(),
                               [this](const std::vector<double>& senses) {
                                 return digits_.apart(digits_.moved(senses, 0.5));
                               });
  }
}

std::vector<Drive> DigitMotion::drives(std::size_t option) const {
  std::vector<Drive> drives = digits_.drives();
  for (std::size_t d = 0; d < drives.size(); ++d) drives[d].speed = options_[option].speed[d];
  return drives;
}

/// Direction in which a tip moves as its digit begins to curl; zero: it does not. (3)
Vector3d DigitMotion::curl_way(const HandDigit& digit, std::size_t option) const {
  Vector3d sum = Vector3d::Zero();
  for (const int d : digit.curls) {
    const double speed = options_[option].speed[static_cast<std::size_t>(d)];
    sum += (speed > 0 ? 1 : speed < 0 ? -1 : 0) * digits_.way(static_cast<std::size_t>(d), digit);
  }
  return sum.norm() > kNoWay ? Vector3d(sum.normalized()) : Vector3d::Zero();
}

/// The largest range of a motor that turns this digit alone [rad].
double DigitMotion::turn_range(const HandDigit& digit) const {
  double largest = 0;
  for (const int d : digit.turns)
    if (!digits_.spreads(static_cast<std::size_t>(d), digit))
      largest = std::max(largest, digits_.range(static_cast<std::size_t>(d)));
  return largest;
}

/// The largest group of digits whose tips move the same way, without digits that turn far.
/// @param ways   curl_way() of each digit      @param turns  turn_range() of each digit [rad]
std::vector<std::size_t> DigitMotion::find_fingers(const std::vector<Vector3d>& ways,
                                                   const std::vector<double>& turns) const {
  // A digit that turns much farther than the median is opposed, wherever it stands now.
  const std::size_t count = digits_.all().size();
  std::vector<double> sorted = turns;
  std::sort(sorted.begin(), sorted.end());
  std::vector<bool> turned(count, false);
  for (std::size_t i = 0; i < count; ++i)
    turned[i] = count > 2 && turns[i] > kOppositionRange &&
                turns[i] > kFartherRatio * sorted[(count - 1) / 2];
  // Groups around each digit.
  std::vector<std::size_t> fingers;
  for (std::size_t i = 0; i < count; ++i) {
    std::vector<std::size_t> alike;
    for (std::size_t j = 0; j < count; ++j)
      if (!turned[i] && !turned[j] && ways[i].dot(ways[j]) > kSameWay) alike.push_back(j);
    if (alike.size() > fingers.size()) fingers = alike;
  }
  return fingers;
}

DigitRoles DigitMotion::roles(std::size_t option) const {
  DigitRoles roles;
  const std::size_t count = digits_.all().size();
  roles.opposed.assign(count, false);
  // Fingers move the same way, and do not turn far.
  std::vector<double> turns;
  for (const HandDigit& digit : digits_.all()) turns.push_back(turn_range(digit));
  std::vector<Vector3d> ways;
  for (const HandDigit& digit : digits_.all()) ways.push_back(curl_way(digit, option));
  std::vector<std::size_t> fingers = find_fingers(ways, turns);
  if (fingers.size() < 2) {
    // A thumb and one finger: the digit that turns farther is opposed.
    for (std::size_t i = 0; i < count && count == 2; ++i)
      roles.opposed[i] = turns[i] > kOppositionRange && turns[i] > kFartherRatio * turns[1 - i];
    if (count != 2 || roles.opposed[0] == roles.opposed[1]) return roles;
    fingers = {roles.opposed[0] ? 1U : 0U};
  } else {
    roles.opposed.assign(count, true);
    for (const std::size_t i : fingers) roles.opposed[i] = false;
  }
  // Normal, direction and mean root of the fingers.
  Vector3d normal = Vector3d::Zero(), along = Vector3d::Zero();
  for (const std::size_t i : fingers) {
    normal += ways[i];
    along += digits_.all()[i].tip - digits_.all()[i].root;
    roles.root += digits_.all()[i].root / static_cast<double>(fingers.size());
    roles.length +=
        (digits_.all()[i].tip - digits_.all()[i].root).norm() / static_cast<double>(fingers.size());
  }
  const std::vector<Pose<double>> links = digits_.grip().hand().pose(digits_.rest());
  roles.normal = normal.normalized();
  roles.normal = without_rounding(
      facing_direction(faces_of(digits_.grip(), palm_surfaces(digits_.grip()), links), roles.normal,
                       kNearNormal, {})
          .value_or(roles.normal));
  along -= along.dot(roles.normal) * roles.normal;
  // A palm needs fingers and an opposed digit.
  roles.palm = fingers.size() < count && along.norm() > kNoWay;
  if (roles.palm) roles.along = along.normalized();
  roles.row = fingers.size() >= kPalmFingers;
  return roles;
}

/// The posture in which drives that close start at the limit from which they come. (coordinates)
/// @param others    posture of the other drives (coordinates)
/// @param farthest  that drives which turn open from rest, where their range goes farther [rad]
VectorXd DigitMotion::open_at(std::size_t option, const VectorXd& others, double farthest) const {
  const HandLayout& layout = digits_.grip().hand().layout();
  VectorXd open = others;
  for (std::size_t d = 0; d < digits_.drives().size(); ++d) {
    const double back = digits_.turns(d) ? farthest : kInfinity;
    for (const DrivenCoordinate& driven : digits_.drives()[d].moves) {
      const double rate = options_[option].speed[d] * driven.ratio;
      if (rate == 0) continue;
      const Eigen::Index c = driven.coordinate;
      const double lower = layout.lower[c], upper = layout.upper[c];
      open[c] = rate > 0 ? lower : upper;
      if (std::min(std::abs(lower - digits_.rest()[c]), std::abs(upper - digits_.rest()[c])) > back)
        open[c] = digits_.rest()[c] - std::copysign(back, rate);
    }
  }
  return open;
}

/// Returns whether every digit has one drive that curls it, as jaws have.
bool DigitMotion::are_jaws() const {
  return std::all_of(digits_.all().begin(), digits_.all().end(),
                     [](const HandDigit& digit) { return digit.curls.size() <= 1; });
}

/// Returns up to three motors with the largest ranges that turn opposed digits.
std::vector<std::size_t> DigitMotion::opposing_motors(const DigitRoles& roles) const {
  std::vector<std::size_t> motors;
  for (std::size_t i = 0; i < digits_.all().size(); ++i)
    for (const int d : digits_.all()[i].turns)
      if (roles.opposed[i] && !digits_.spreads(static_cast<std::size_t>(d), digits_.all()[i]) &&
          std::find(motors.begin(), motors.end(), static_cast<std::size_t>(d)) == motors.end())
        motors.push_back(static_cast<std::size_t>(d));
  std::stable_sort(motors.begin(), motors.end(), [&](std::size_t a, std::size_t b) {
    return digits_.range(a) > digits_.range(b);
  });
  if (motors.size() > 3) motors.resize(3);
  return motors;
}

/// The posture with a motor at so many positions, from one end of its range to the other.
std::vector<VectorXd> DigitMotion::motor_positions(const VectorXd& before, std::size_t motor,
                                                   int positions) const {
  const HandLayout& layout = digits_.grip().hand().layout();
  std::vector<VectorXd> postures(static_cast<std::size_t>(positions), before);
  for (int i = 0; i < positions; ++i)
    for (const DrivenCoordinate& driven : digits_.drives()[motor].moves) {
      const Eigen::Index c = driven.coordinate;
      const double share = static_cast<double>(i) / (positions - 1);
      postures[static_cast<std::size_t>(i)][c] =
          layout.lower[c] +
          (driven.ratio < 0 ? 1 - share : share) * (layout.upper[c] - layout.lower[c]);
    }
  return postures;
}

std::vector<VectorXd> DigitMotion::openings(std::size_t option, const DigitRoles& roles,
                                            bool only_one) const {
  // A stated closing opens as stated; jaws open as far as they go.
  const VectorXd& stated = digits_.grip().hand().layout().open;
  if (only_one) return {open_at(option, stated.size() > 0 ? stated : digits_.rest(), kInfinity)};
  if (!roles.palm && are_jaws()) return {open_at(option, digits_.rest(), kInfinity)};
  // Fingers that also bend backwards do not open so far that they lie behind the palm.
  const VectorXd open = open_at(option, digits_.rest(), kMostBackBend);
  std::vector<VectorXd> openings{open};
  // Digits that curl at each other may start with outer joints open.
  if (!roles.palm)
    for (const VectorXd& inner : {open, digits_.rest()})
      openings.push_back(outer_open(option, inner));
  // Each motor that opposes digits at several positions, in all combinations.
  const std::vector<std::size_t> motors = opposing_motors(roles);
  for (const std::size_t motor : motors) {
    std::vector<VectorXd> next = openings;  // where it is at rest
    for (const VectorXd& before : openings) {
      const std::vector<VectorXd> all = motor_positions(before, motor, places(motors.size()));
      next.insert(next.end(), all.begin(), all.end());
    }
    openings = std::move(next);
  }
  return openings;
}

/// The posture with outer joints as far open as they go. Otherwise the ends of digits that curl at
/// each other meet before their middles hold anything.
VectorXd DigitMotion::outer_open(std::size_t option, VectorXd open) const {
  const HandLayout& layout = digits_.grip().hand().layout();
  for (const HandDigit& digit : digits_.all())
    for (std::size_t i = 1; i < digit.curls.size(); ++i) {
      const auto d = static_cast<std::size_t>(digit.curls[i]);
      for (const DrivenCoordinate& driven : digits_.drives()[d].moves) {
        const double rate = options_[option].speed[d] * driven.ratio;
        if (rate != 0)
          open[driven.coordinate] = (rate > 0 ? layout.lower : layout.upper)[driven.coordinate];
      }
    }
  return open;
}

/// Every coordinate that closing drives move at the middle of its range, the others at rest.
VectorXd DigitMotion::half_closed(std::size_t option) const {
  const HandLayout& layout = digits_.grip().hand().layout();
  VectorXd q = digits_.rest();
  for (std::size_t d = 0; d < digits_.drives().size(); ++d)
    for (const DrivenCoordinate& driven : digits_.drives()[d].moves)
      if (options_[option].speed[d] != 0)
        q[driven.coordinate] =
            (layout.lower[driven.coordinate] + layout.upper[driven.coordinate]) / 2;
  return q;
}

/// Every coordinate that closing drives move at the limit to which they close, the others at rest.
VectorXd DigitMotion::closed(std::size_t option) const {
  const HandLayout& layout = digits_.grip().hand().layout();
  VectorXd q = digits_.rest();
  for (std::size_t d = 0; d < digits_.drives().size(); ++d)
    for (const DrivenCoordinate& driven : digits_.drives()[d].moves)
      if (const double rate = options_[option].speed[d] * driven.ratio; rate != 0)
        q[driven.coordinate] = (rate > 0 ? layout.upper : layout.lower)[driven.coordinate];
  return q;
}

}  // namespace thenar
