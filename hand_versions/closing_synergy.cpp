#include "hand_versions/closing_synergy.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/error.h"
#include "base/lists.h"
#include "tendons/name_conventions.h"

namespace thenar {
namespace {

/// Returns the bone of the digit next to which a hinge lies, on its proximal side; absent: the
/// hinge of another digit or the wrist.
std::optional<std::size_t> bone_after(const Subject& subject, const DigitAnatomy& digit,
                                      const std::string& joint) {
  const std::string& child = find_named(subject.joints, joint)->child;
  for (std::size_t i = 0; i < digit.bones.size(); ++i) {
    // Walk inwards from each bone, through the links of a universal joint.
    std::string name = digit.bones[i].segment;
    const std::string stop = i == 0 ? digit.root : digit.bones[i - 1].segment;
    while (name != stop) {
      if (name == child) return i;
      const auto found = std::find_if(subject.joints.begin(), subject.joints.end(),
                                      [&](const JointAxis& each) { return each.child == name; });
      if (found == subject.joints.end()) break;
      name = found->parent;
    }
  }
  return std::nullopt;
}

/// Builds the drive of all flexion joints of a digit.
Drive flexion_drive(const DigitAnatomy& digit, const Subject& subject, const Skeleton& skeleton) {
  Drive drive;
  // Set the speed by convention, slower for the thumb.
  drive.name = digit.name;
  drive.coupling = DriveCoupling::kBreakaway;
  const bool thumb = digit.name == "thumb";
  drive.speed = thumb ? 0.25 : 1;
  const double distal = thumb ? 1 : 2.0 / 3;
  // Add all flexion joints of the digit.
  for (int i = 0; i < skeleton.coordinates(); ++i) {
    const std::string& joint = skeleton.coordinate_names[i];
    const auto bone = bone_after(subject, digit, joint);
    if (bone && is_flexion_joint(joint))
      drive.moves.push_back({i, *bone + 1 == digit.bones.size() ? distal : 1});
  }
  return drive;
}

/// Returns the posture with closing joints straight and others in the middle of their ranges.
Eigen::VectorXd neutral_posture(const Skeleton& skeleton, const std::vector<bool>& closes) {
  Eigen::VectorXd q(skeleton.coordinates());
  for (int i = 0; i < skeleton.coordinates(); ++i) {
    const auto& limits = skeleton.limits[i];
    const double middle = (limits.lower + limits.upper) / 2;
    const bool halfway = !closes[i] && std::isfinite(middle);
    q[i] = halfway ? middle : std::min(std::max(limits.lower, 0.0), limits.upper);
  }
  return q;
}

/// Returns the approach of the palm, or of the first bone.
PalmApproach palm_approach(const HandAnatomy& hand) {
  // Approach with the middle of the palm, towards the knuckles, on the palmar side.
  if (hand.palm) {
    Eigen::Vector3d knuckles = Eigen::Vector3d::Zero();
    int fingers = 0;
    for (const DigitAnatomy& digit : hand.digits)
      if (digit.root == hand.palm->segment && digit.name != "thumb") {
        knuckles += digit.bones[0].proximal;
        ++fingers;
      }
    const Eigen::Vector3d middle = 0.3 * hand.palm->wrist + 0.7 * knuckles / fingers;
    return {middle - hand.palm->thickness / 2 * hand.palm->dorsal, -hand.palm->dorsal};
  }
  // Approach with the first bone of the first digit if there is no palm.
  const DigitBone& bone = hand.digits.front().bones.front();
  return {bone.distal - bone.radius * bone.dorsal, -bone.dorsal};
}

/// Replaces the ratios of a drive by those of the flexors' torques; unchanged if there are none.
void follow_tendons(const Eigen::VectorXd& torque, Drive& drive) {
  // Find the largest torque, that of the fastest joint.
  double max_torque = 0;
  for (const DrivenCoordinate& driven : drive.moves)
    max_torque = std::max(max_torque, torque[driven.coordinate]);
  if (max_torque <= 0) return;
  drive.coupling = DriveCoupling::kCompliant;
  // Leave out joints that the flexors extend.
  std::vector<DrivenCoordinate> moves;
  for (const DrivenCoordinate& driven : drive.moves)
    if (torque[driven.coordinate] > 0)
      moves.push_back({driven.coordinate, torque[driven.coordinate] / max_torque});
  drive.moves = moves;
}

}  // namespace

ClosingSynergy motor_synergy(const HandAnatomy& hand, const Subject& subject,
                             const Skeleton& skeleton) {
  // Build one drive for each digit.
  ClosingSynergy use;
  for (const DigitAnatomy& digit : hand.digits) {
    const Drive drive = flexion_drive(digit, subject, skeleton);
    if (!drive.moves.empty()) use.drives.push_back(drive);
  }
  // Add a drive of speed 0 for every other joint.
  std::vector<bool> moved(static_cast<std::size_t>(skeleton.coordinates()), false);
  for (const Drive& drive : use.drives)
    for (const DrivenCoordinate& driven : drive.moves) moved[driven.coordinate] = true;
  for (int i = 0; i < skeleton.coordinates(); ++i)
    if (!moved[i]) {
      Drive still;
      still.name = skeleton.coordinate_names[i];
      still.moves = {{i, 1}};
      use.drives.push_back(still);
    }
  use.approach = palm_approach(hand);
  use.open = neutral_posture(skeleton, moved);
  return use;
}

Eigen::VectorXd max_flexor_tensions(const std::vector<std::string>& actuators,
                                    const Actuation& actuation) {
  require(static_cast<Eigen::Index>(actuators.size()) == actuation.upper.size(),
          "{} names for {} actuators", actuators.size(), actuation.upper.size());
  Eigen::VectorXd t = actuation.upper;
  for (std::size_t i = 0; i < actuators.size(); ++i)
    if (!is_long_flexor(actuators[i])) t[static_cast<Eigen::Index>(i)] = 0;
  return t;
}

Eigen::VectorXd max_flexor_tensions(const Hand& hand) {
  const HandLayout& layout = hand.layout();
  return max_flexor_tensions(layout.actuators,
                             hand.actuation(layout.lower.cwiseMax(0).cwiseMin(layout.upper)));
}

ClosingSynergy tendon_synergy(const HandAnatomy& hand, const Subject& subject,
                              const Skeleton& skeleton, const std::vector<std::string>& actuators,
                              const Actuation& actuation) {
  ClosingSynergy use = motor_synergy(hand, subject, skeleton);
  const Eigen::VectorXd torque = actuation.B * max_flexor_tensions(actuators, actuation);
  for (Drive& drive : use.drives)
    if (drive.speed > 0) follow_tendons(torque, drive);
  return use;
}

}  // namespace thenar
