#pragma once

/// Mechanisms of human hands: bones on hinges, their skin, and the tendons of every digit.

#include <memory>
#include <string>
#include <vector>

#include "dynamics/mechanism/mechanism.h"
#include "hand_versions/human_hand.h"

namespace thenar {

class DigitTendons;

/// Description of a human hand to build.
struct HumanModel {
  Subject subject;                                  // measured person
  HumanVersion version = HumanVersion::kTendonNet;  // version of the hand model
  HumanHandOptions options{};                       // options of build_human_hand()
};

/// Tendons of one digit of a hand.
struct HumanDigit {
  std::string name;                             // name of the digit
  std::shared_ptr<const DigitTendons> tendons;  // model of its tendons
  std::vector<int> coordinates;   // indices of its coordinates in the hand, in the digit's order
  std::vector<double> max_force;  // F0 of its muscles; assumed values cause a warning [N] (muscles)
};

/// Mechanism of a human hand, with what scenes need beyond it.
struct HumanMechanism {
  Mechanism mechanism;   // bodies and joints; the base is the first body, welded to the world
  Skeleton skeleton;     // skeleton with the mechanism's coordinates, in the same order
  Subject subject;       // subject with all masses, and the axes of the version
  Eigen::VectorXd open;  // posture in which closing begins [rad] (coordinates)
  ContactModel contact = ContactModel::kHardPoint;  // contact model of the finger pads
  std::vector<HumanDigit> digits;                   // empty: the subject has no muscles
  std::vector<std::string> warnings;                // assumptions that were made
};

/// Builds the mechanism of a hand, see build_human_hand(): the digits on a welded wrist, without
/// the forearm.
///
/// All body frames coincide with the hand's frame at the reference posture. A body is named after
/// its skin ("DP2"), or after its segment if it has no skin; a second skin on a link is a body that
/// is welded to it. Segments without a stated mass get the mass of their skin. Joints have the
/// subject's springs and dampers, or the damper of JointResistance. They have no limits; add
/// JointStops to the scene. The largest effort of a coordinate is that of the version's motor in
/// its stronger direction. Tendons are floating nets in the fourth version, linear in the others.
/// @throws InputError as build_human_hand(), or if a link has mass but no moments of inertia.
[[nodiscard]] HumanMechanism human_mechanism(const HumanModel& model);

}  // namespace thenar
