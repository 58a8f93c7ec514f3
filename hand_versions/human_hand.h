#pragma once

/// The human hand in four versions, each richer by one thing.

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

/// The version. Source of the four steps: [Miller2005], in the order in which they are compared
/// here.
enum class HumanVersion {
  kOrthogonalThumb,  // rigid, thumb axes crossing at right angles, hard points
  kSkewedThumb,      // rigid, thumb axes as measured, hard points
  kSoftPads,         // and pads that resist twisting
  kTendonNet         // and tendons in place of motors, the extensors through a floating net
};
inline constexpr std::array kHumanVersionNames{
    EnumName{HumanVersion::kOrthogonalThumb, "orthogonal"},
    EnumName{HumanVersion::kSkewedThumb, "skewed"}, EnumName{HumanVersion::kSoftPads, "soft"},
    EnumName{HumanVersion::kTendonNet, "tendons"}};

/// Surfaces with which the hand touches.
enum class Cover {
  kSkin,
  kBones,  // as a specimen without flesh
  kNone    // nothing: for questions of joints and tendons alone
};

/// Options of build_human_hand().
struct HumanHandOptions {
  Cover cover = Cover::kSkin;
  SkinOptions skin;
  std::optional<Path> path;  // of tendons; absent: default_path(). Subjects with arms alone have
                             // these
  std::map<std::string, double> frozen;  // joint -> the angle it is frozen at [rad]; the wrist: 0
  PassiveMoments passive = PassiveMoments::kOn;  // whether those of the subject are counted
};

/// A hand with all that comparisons need.
struct HumanHand {
  std::unique_ptr<Hand> hand;
  Skeleton skeleton;                      // its bones
  ContactModel contact;                   // hard points, or soft fingers from kSoftPads on
  Path path = Path::kNone;                // of the tendons that move it, or give its motors' limits
  std::vector<SkinPatch> patches;         // pads and nails
  std::vector<OppositionTarget> targets;  // of Kapandji's score
  std::vector<std::string> warnings;      // what was assumed, left out or put on a lower rung
};

/// Builds a version of a subject's hand: its digits on a welded wrist, the forearm left out.
///
/// Motors of the first three have the joint_torque_limits() of the fourth at the reference posture.
/// Where the subject has none for a joint, that of default_human() serves, times the cube of the
/// ratio of hand lengths (forces grow as sections, arms as lengths), and a warning says so. The
/// third and fourth have fingertips of material "fingertip" where their skin is "skin": pads with a
/// law of their own (built_in_materials()). The fourth lays the net "extensor_hood" on every finger
/// that can carry it, and takes separate tendons elsewhere, with a warning; it wants tendons at
/// every digit.
/// @throws InputError naming what the subject lacks.
[[nodiscard]] HumanHand build_human_hand(const Subject& subject, HumanVersion version,
                                         const HumanHandOptions& options = {});

/// Returns whether a word names a version, by its name or its old one.
[[nodiscard]] bool is_human_version(const std::string& name);

/// The version of that name, or of its old one, "tier1" .. "tier4".
/// @throws InputError listing the names.
[[nodiscard]] HumanVersion human_version(const std::string& name);

/// The human of comparisons, `human_hand`: the hand of [Mirakhorlo2016] with a calibrated thumb.
[[nodiscard]] const Subject& default_human();

// The same hand with a simpler thumb.

/// The subject with the axes of its thumb as machines have them: each through the joint's centre
/// (see find_anatomy()), flexion about the radial direction square to the bone, abduction about
/// the dorsal one, so that the two of a joint cross at a right angle. Senses of turning, ranges,
/// bones and tendon points stay.
///
/// Hinges whose name ends in "_AA" abduct, all others flex; "_PS" (pronation) turns about the bone.
/// This is the thumb of the founding paper's first hand, the skewed one of its third [Miller2005].
/// @throws InputError if there is no digit "thumb".
[[nodiscard]] Subject orthogonal_thumb(Subject subject);

}  // namespace thenar
