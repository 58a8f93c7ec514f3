#pragma once

/// Human hand in four versions, each with one more feature than the one before.

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/enum_names.h"
#include "base/fidelity.h"
#include "data/io/subject.h"
#include "hand/hand.h"
#include "hand/skin/human_surfaces.h"
#include "hand/skin/skin_landmarks.h"

namespace thenar {

/// Version of the human hand. Source of the four steps: [Miller2005], in the order in which they
/// are compared here.
enum class HumanVersion {
  kOrthogonalThumb,  // rigid, thumb axes crossing at right angles, hard points
  kSkewedThumb,      // rigid, thumb axes as measured, hard points
  kSoftPads,         // skewed thumb, and pads that resist twisting
  kTendonNet  // soft pads, and tendons in place of motors, the extensors through a floating net
};
inline constexpr std::array kHumanVersionNames{
    EnumName{HumanVersion::kOrthogonalThumb, "orthogonal"},
    EnumName{HumanVersion::kSkewedThumb, "skewed"}, EnumName{HumanVersion::kSoftPads, "soft"},
    EnumName{HumanVersion::kTendonNet, "tendons"}};

/// Contact surfaces of the hand.
enum class Cover {
  kSkin,
  kBones,  // bare bones, as of a specimen without flesh
  kNone    // no surfaces, for studies of joints and tendons alone
};

/// Options of build_human_hand().
struct HumanHandOptions {
  Cover cover = Cover::kSkin;
  SkinOptions skin;
  /// Path model of tendons; absent: default_path(). Subjects with arms alone use these.
  std::optional<Path> path;
  std::map<std::string, double> frozen;  // joint -> the angle it is frozen at [rad]; the wrist: 0
  PassiveMoments passive =
      PassiveMoments::kOn;  // whether the subject's passive moments are included
};

/// Human hand with the data for comparisons.
struct HumanHand {
  std::unique_ptr<Hand> hand;
  Skeleton skeleton;        // skeleton of the hand
  ContactModel contact;     // hard points, or soft fingers from kSoftPads on
  Path path = Path::kNone;  // path model of the tendons that move it, or give its motors' limits
  std::vector<SkinPatch> patches;         // pads and nails
  std::vector<OppositionTarget> targets;  // landmarks of Kapandji's score
  std::vector<std::string> warnings;      // assumptions, omissions and simplified models
};

/// Builds a version of a subject's hand: its digits on a welded wrist, without the forearm.
///
/// Motors of the first three have the joint_torque_limits() of the fourth at the reference posture.
/// Where the subject has none for a joint, that of default_human() is used, times the cube of the
/// ratio of hand lengths (forces grow as sections, arms as lengths), with a warning. The third and
/// fourth have fingertips of material "fingertip" where their skin is "skin": pads with a law of
/// their own (built_in_materials()). The fourth has the net "extensor_hood" on every finger that
/// can carry it, and separate tendons elsewhere, with a warning; it needs tendons at every digit.
/// @throws InputError naming what the subject lacks.
[[nodiscard]] HumanHand build_human_hand(const Subject& subject, HumanVersion version,
                                         const HumanHandOptions& options = {});

/// Returns whether a word names a version, by its name or its old one.
[[nodiscard]] bool is_human_version(const std::string& name);

/// Returns the version of that name, or of its old one, "tier1" .. "tier4".
/// @throws InputError listing the names.
[[nodiscard]] HumanVersion human_version(const std::string& name);

/// Returns the default subject `human_hand`: the hand of [Mirakhorlo2016] with a calibrated thumb.
[[nodiscard]] const Subject& default_human();

// Human hand with a simpler thumb.

/// Returns the subject with thumb axes as in machines: each through the joint's centre (see
/// find_anatomy()), flexion about the radial direction square to the bone, abduction about the
/// dorsal one, so that the two of a joint cross at a right angle. Senses of rotation, ranges, bones
/// and tendon points are unchanged.
///
/// Hinges whose name ends in "_AA" abduct, all others flex; "_PS" (pronation) turns about the bone.
/// This is the thumb of the first hand of [Miller2005]; the skewed one is that of its third.
/// @throws InputError if there is no digit "thumb".
[[nodiscard]] Subject orthogonal_thumb(Subject subject);

}  // namespace thenar
