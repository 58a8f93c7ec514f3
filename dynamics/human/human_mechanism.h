#pragma once

/// Human hands as mechanisms: bones on hinges, in their skin, with the tendons of every digit.

#include <memory>
#include <string>
#include <vector>

#include "dynamics/mechanism/mechanism.h"
#include "hand_versions/human_hand.h"

namespace thenar {

class DigitTendons;

/// Model of a human hand: its subject, version and options.
struct HumanModel {
  Subject subject;
  HumanVersion version = HumanVersion::kTendonNet;
  HumanHandOptions options{};
};

/// Tendons of one digit of a hand.
struct HumanDigit {
  std::string name;
  std::shared_ptr<const DigitTendons> tendons;
  std::vector<int> coordinates;   // of the hand, in the digit's order
  std::vector<double> max_force;  // F0 of its muscles; assumed ones are warned of [N] (muscles)
};

/// A hand ready for scenes.
struct HumanMechanism {
  Mechanism mechanism;   // the base first, welded to the world
  Skeleton skeleton;     // its coordinates are those of the mechanism, in the same order
  Subject subject;       // with all masses, and the axes of the version
  Eigen::VectorXd open;  // posture in which closing begins (coordinates) [rad]
  ContactModel contact = ContactModel::kHardPoint;  // of its pads
  std::vector<HumanDigit> digits;                   // none: the subject has no muscles
  std::vector<std::string> warnings;
};

/// Builds a hand as build_human_hand() does: its digits on a welded wrist, the forearm left out.
///
/// Frames of all bodies are the hand's at the reference posture. A body is called after its skin
/// ("DP2"), or after its segment where it has none; a second skin on the same link is welded to it.
/// Segments without mass weigh their skin. Joints have the subject's springs and dampers, or the
/// damper of JointResistance; they are not limited here: that is what JointStops does. A drive's
/// largest effort is that of the version's motors, in the stronger of both senses.
/// Tendons are floating nets in the fourth version, and linear in the first three.
/// @throws InputError as build_human_hand(), or if a link has mass but no moments of inertia.
[[nodiscard]] HumanMechanism human_mechanism(const HumanModel& model);

}  // namespace thenar
