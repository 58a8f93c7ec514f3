#include "grasp/robot/digit_motion.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/lists.h"
#include "base/numbers.h"
#include "grasp/robot/posed_surfaces.h"

namespace thenar {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kMinFingerCosine = 0.7;    // minimum cosine between tip motions of fingers [1]
constexpr double kNoTipMotion = 1e-9;       // motion of a tip up to which it counts as none [m]
constexpr std::size_t kMinPalmFingers = 3;  // number of fingers approached along the palm's normal
constexpr std::size_t kMaxOpposingMotors = 3;  // number of turning motors that are tried
constexpr double kMinOppositionRange = 0.6;    // range from which a turning motor can oppose [rad]
constexpr double kMinOppositionRatio = 1.4;    // ratio of that range to the ranges of others [1]
constexpr double kMaxBackwardBend = 0.6;       // backward bend of fingers that open [rad]
constexpr double kMinPalmNormalCosine = 0.9925;  // cosine of the palm's normal to a flat face [1]

/// Returns the number of positions at which each of several turning motors is tried.
int position_count(std::size_t motors) { return motors <= 1 ? 9 : motors == 2 ? 5 : 3; }

}  // namespace

DigitMotion::DigitMotion(const BallGrasp& grip, ClosingSource closing)
    : digits_(grip), closing_(closing) {
  // Stated speeds define how the hand closes; otherwise several directions are tried.
  if (closing == ClosingSource::kStated) {
    SenseOption stated;
    for (const Drive& drive : digits_.drives()) stated.speed.push_back(drive.speed);
    options_ = {stated};
  } else {
    options_ = closing_options(grip.hand().layout(), digits_.rest(), digits_.groups(),
                               [this](const std::vector<double>& senses) {
                                 return digits_.tip_separation(digits_.posture_at(senses, 0.5));
                               });
  }
}

std::vector<Drive> DigitMotion::drives(std::size_t option) const {
  std::vector<Drive> drives = digits_.drives();
  for (std::size_t d = 0; d < drives.size(); ++d) drives[d].speed = options_[option].speed[d];
  return drives;
}

/// Returns the direction in which a tip moves as its digit begins to curl; zero: it does not. (3)
Vector3d DigitMotion::curl_motion(const HandDigit& digit, std::size_t option) const {
  Vector3d sum = Vector3d::Zero();
  for (const int d : digit.curls) {
    const double speed = options_[option].speed[d];
    const int sense = speed > 0 ? 1 : speed < 0 ? -1 : 0;
    sum += sense * digits_.tip_translation(d, digit);
  }
  return sum.norm() > kNoTipMotion ? Vector3d(sum.normalized()) : Vector3d::Zero();
}

/// Returns the maximum range of the motors that turn this digit alone [rad].
double DigitMotion::turn_range(const HandDigit& digit) const {
  double largest = 0;
  for (const int d : digit.turns)
    if (!digits_.spreads(d, digit)) largest = std::max(largest, digits_.range(d));
  return largest;
}

/// Finds the largest group of digits whose tips move in the same direction, without digits that
/// turn far.
/// @param motions  curl_motion() of each digit;  @param turns  turn_range() of each digit [rad]
std::vector<std::size_t> DigitMotion::find_fingers(const std::vector<Vector3d>& motions,
                                                   const std::vector<double>& turns) const {
  // A digit that turns much farther than the median is opposed, whatever its rest position.
  const std::size_t count = digits_.digits().size();
  std::vector<double> sorted = turns;
  std::sort(sorted.begin(), sorted.end());
  std::vector<bool> turned(count, false);
  for (std::size_t i = 0; i < count; ++i)
    turned[i] = count > 2 && turns[i] > kMinOppositionRange &&
                turns[i] > kMinOppositionRatio * sorted[(count - 1) / 2];
  // The largest of the groups around each digit.
  std::vector<std::size_t> fingers;
  for (std::size_t i = 0; i < count; ++i) {
    std::vector<std::size_t> alike;
    for (std::size_t j = 0; j < count; ++j)
      if (!turned[i] && !turned[j] && motions[i].dot(motions[j]) > kMinFingerCosine)
        alike.push_back(j);
    if (alike.size() > fingers.size()) fingers = alike;
  }
  return fingers;
}

DigitRoles DigitMotion::roles(std::size_t option) const {
  DigitRoles roles;
  const std::size_t count = digits_.digits().size();
  roles.opposed.assign(count, false);
  // Fingers move in the same direction, and do not turn far.
  const std::vector<double> turns =
      transformed(digits_.digits(), [&](const auto& digit) { return turn_range(digit); });
  const std::vector<Vector3d> motions =
      transformed(digits_.digits(), [&](const auto& digit) { return curl_motion(digit, option); });
  std::vector<std::size_t> fingers = find_fingers(motions, turns);
  if (fingers.size() < 2) {
    // A thumb and one finger: the digit that turns farther is opposed.
    for (std::size_t i = 0; i < count && count == 2; ++i)
      roles.opposed[i] =
          turns[i] > kMinOppositionRange && turns[i] > kMinOppositionRatio * turns[1 - i];
    if (count != 2 || roles.opposed[0] == roles.opposed[1]) return roles;
    fingers = {roles.opposed[0] ? 1U : 0U};
  } else {
    roles.opposed.assign(count, true);
    for (const std::size_t i : fingers) roles.opposed[i] = false;
  }
  // Mean motion, direction, root and length of the fingers.
  Vector3d normal = Vector3d::Zero(), along = Vector3d::Zero();
  for (const std::size_t i : fingers) {
    normal += motions[i];
    along += digits_.digits()[i].tip - digits_.digits()[i].root;
    roles.root += digits_.digits()[i].root / static_cast<double>(fingers.size());
    roles.length += (digits_.digits()[i].tip - digits_.digits()[i].root).norm() /
                    static_cast<double>(fingers.size());
  }
  // The normal is aligned with a flat face of the palm, if there is one.
  const std::vector<Pose<double>> links = digits_.grip().hand().pose(digits_.rest());
  roles.normal = normal.normalized();
  roles.normal = snap_to_axis(
      facing_direction(faces_of(digits_.grip(), palm_surfaces(digits_.grip()), links), roles.normal,
                       kMinPalmNormalCosine, {})
          .value_or(roles.normal));
  along -= along.dot(roles.normal) * roles.normal;
  // A palm needs fingers and an opposed digit.
  roles.palm = fingers.size() < count && along.norm() > kNoTipMotion;
  if (roles.palm) roles.along = along.normalized();
  roles.row = fingers.size() >= kMinPalmFingers;
  return roles;
}

/// Returns the posture in which closing drives are at the limit from which they start.
/// (coordinates)
/// @param others    posture of the other drives (coordinates)
/// @param farthest  maximum opening from rest of rotating drives [rad]
VectorXd DigitMotion::posture_at_opening(std::size_t option, const VectorXd& others,
                                         double farthest) const {
  VectorXd open = others;
  for (std::size_t d = 0; d < digits_.drives().size(); ++d) {
    const double back = digits_.rotates_digits(d) ? farthest : kInfinity;
    for (const DrivenCoordinate& driven : digits_.drives()[d].moves) {
      const double rate = options_[option].speed[d] * driven.ratio;
      if (rate == 0) continue;
      // Open to the limit, but not farther than allowed.
      const Eigen::Index c = driven.coordinate;
      const double lower = layout().lower[c], upper = layout().upper[c];
      open[c] = rate > 0 ? lower : upper;
      if (std::min(std::abs(lower - digits_.rest()[c]), std::abs(upper - digits_.rest()[c])) > back)
        open[c] = digits_.rest()[c] - std::copysign(back, rate);
    }
  }
  return open;
}

/// Returns whether every digit has at most one drive that curls it, like a jaw.
bool DigitMotion::are_jaws() const {
  return all_of(digits_.digits(), [](const HandDigit& each) { return each.curls.size() <= 1; });
}

/// Returns the motors with the largest ranges that turn opposed digits, at most kMaxOpposingMotors.
std::vector<std::size_t> DigitMotion::opposing_motors(const DigitRoles& roles) const {
  std::vector<std::size_t> motors;
  for (std::size_t i = 0; i < digits_.digits().size(); ++i)
    for (const int d : digits_.digits()[i].turns)
      if (roles.opposed[i] && !digits_.spreads(d, digits_.digits()[i]) &&
          !contains(motors, static_cast<std::size_t>(d)))
        motors.push_back(d);
  std::stable_sort(motors.begin(), motors.end(), [&](std::size_t a, std::size_t b) {
    return digits_.range(a) > digits_.range(b);
  });
  if (motors.size() > kMaxOpposingMotors) motors.resize(kMaxOpposingMotors);
  return motors;
}

/// Returns postures with a motor at several positions, from one end of its range to the other.
std::vector<VectorXd> DigitMotion::motor_positions(const VectorXd& before, std::size_t motor,
                                                   int positions) const {
  std::vector<VectorXd> postures(static_cast<std::size_t>(positions), before);
  for (int i = 0; i < positions; ++i)
    for (const DrivenCoordinate& driven : digits_.drives()[motor].moves) {
      const Eigen::Index c = driven.coordinate;
      const double share = static_cast<double>(i) / (positions - 1);
      postures[i][c] = layout().lower[c] + (driven.ratio < 0 ? 1 - share : share) *
                                               (layout().upper[c] - layout().lower[c]);
    }
  return postures;
}

std::vector<VectorXd> DigitMotion::opening_postures(std::size_t option,
                                                    const DigitRoles& roles) const {
  // A stated closing starts at its stated posture; jaws open as far as possible.
  const VectorXd& stated = layout().open;
  if (closing_ == ClosingSource::kStated)
    return {posture_at_opening(option, stated.size() > 0 ? stated : digits_.rest(), kInfinity)};
  if (!roles.palm && are_jaws()) return {posture_at_opening(option, digits_.rest(), kInfinity)};
  // Fingers that also bend backwards must not open so far that they are behind the palm.
  const VectorXd open = posture_at_opening(option, digits_.rest(), kMaxBackwardBend);
  std::vector<VectorXd> postures{open};
  // Digits that curl towards each other may start with outer joints open.
  if (!roles.palm)
    for (const VectorXd& inner : {open, digits_.rest()})
      postures.push_back(with_outer_joints_open(option, inner));
  // Motors that oppose digits are tried at several positions, in all combinations.
  const std::vector<std::size_t> motors = opposing_motors(roles);
  for (const std::size_t motor : motors) {
    std::vector<VectorXd> next = postures;  // with the motor at rest
    for (const VectorXd& before : postures)
      append_all(next, motor_positions(before, motor, position_count(motors.size())));
    postures = std::move(next);
  }
  return postures;
}

/// Returns the posture with outer joints as far open as possible. Otherwise the ends of digits that
/// curl towards each other meet before their middle links hold anything.
VectorXd DigitMotion::with_outer_joints_open(std::size_t option, VectorXd open) const {
  for (const HandDigit& digit : digits_.digits())
    for (std::size_t i = 1; i < digit.curls.size(); ++i) {
      const auto d = static_cast<std::size_t>(digit.curls[i]);
      for (const DrivenCoordinate& driven : digits_.drives()[d].moves) {
        const double rate = options_[option].speed[d] * driven.ratio;
        if (rate != 0)
          open[driven.coordinate] = (rate > 0 ? layout().lower : layout().upper)[driven.coordinate];
      }
    }
  return open;
}

/// Returns the posture with the coordinates of closing drives in the middle of their ranges, the
/// others at rest.
VectorXd DigitMotion::half_closed_posture(std::size_t option) const {
  VectorXd q = digits_.rest();
  for (std::size_t d = 0; d < digits_.drives().size(); ++d)
    for (const DrivenCoordinate& driven : digits_.drives()[d].moves)
      if (options_[option].speed[d] != 0)
        q[driven.coordinate] =
            (layout().lower[driven.coordinate] + layout().upper[driven.coordinate]) / 2;
  return q;
}

/// Returns the posture with the coordinates of closing drives at the limit to which they close, the
/// others at rest.
VectorXd DigitMotion::closed_posture(std::size_t option) const {
  VectorXd q = digits_.rest();
  for (std::size_t d = 0; d < digits_.drives().size(); ++d)
    for (const DrivenCoordinate& driven : digits_.drives()[d].moves)
      if (const double rate = options_[option].speed[d] * driven.ratio; rate != 0)
        q[driven.coordinate] = (rate > 0 ? layout().upper : layout().lower)[driven.coordinate];
  return q;
}

}  // namespace thenar
