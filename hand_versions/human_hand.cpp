#include "hand_versions/human_hand.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "base/error.h"
#include "data/io/net_description.h"
#include "hand/skin/hand_anatomy.h"
#include "hand_versions/closing_synergy.h"
#include "hand_versions/human_tendons.h"
#include "hand_versions/muscle_forces.h"
#include "hand_versions/tendon_hand.h"
#include "tendons/name_conventions.h"
#include "tendons/net/build_tendons.h"

namespace thenar {
namespace internal {
const std::map<std::string, std::string_view>& human_files();
}  // namespace internal

namespace {

std::string built_in(const std::string& file) {
  return std::string(internal::human_files().at(file));
}

const NetDescription& finger_net() {
  static const NetDescription net = parse_net(built_in("extensor_hood.toml"), "extensor_hood.toml");
  return net;
}

/// The wrist at its reference, or as near as its limits allow; and what was asked for.
std::map<std::string, double> frozen_joints(const Subject& subject,
                                            const std::map<std::string, double>& asked) {
  // Joints that digits share are frozen as well.
  std::map<std::string, double> frozen = asked;
  for (const std::string& name : shared_joints(subject))
    for (const JointAxis& joint : subject.joints)
      if (joint.name == name) frozen.emplace(name, std::clamp(0.0, joint.lower, joint.upper));
  return frozen;
}

bool has_tendons(const Subject& subject) { return !subject.muscles.empty(); }

/// Path rung that the subject's strands can stand on: those that state arms instead of points have
/// no path.
Path path_of(const Subject& subject, const std::optional<Path>& asked) {
  const bool arms = std::all_of(subject.strands.begin(), subject.strands.end(),
                                [](const Strand& strand) { return strand.path.empty(); });
  return arms ? Path::kConstant : asked.value_or(default_path(subject));
}

TendonOptions tendon_options(const Subject& subject, const std::string& digit,
                             const std::map<std::string, double>& frozen,
                             const std::optional<Path>& path) {
  TendonOptions options;
  // Frozen joints that this subject has.
  options.path = path_of(subject, path);
  for (const auto& [joint, angle] : frozen)
    for (const JointAxis& each : subject.joints)
      if (each.name == joint) options.frozen[joint] = angle;
  // Its hood, if the subject states one.
  for (const Digit& each : subject.digits)
    if (each.name == digit) options.hood = each.hood ? Hood::kFractions : Hood::kSeparate;
  return options;
}

std::unique_ptr<DigitTendons> net_or_less(const Subject& subject, const std::string& digit,
                                          const TendonOptions& options,
                                          std::vector<std::string>& warnings) {
  // The thumb has no net; a finger that cannot carry one keeps linear tendons.
  TendonOptions floating = options;
  floating.hood = Hood::kFloatingNet;
  if (digit != "thumb") try {
      return build_digit_tendons(subject, digit, floating, &finger_net());
    } catch (const InputError& error) {
      warnings.push_back(fmt::format("{}: no net, {}", digit, error.what()));
    }
  return build_digit_tendons(subject, digit, options);
}

enum class Extensors { kLinear, kNet };

HandTendons hand_tendons(const Subject& subject, Extensors extensors,
                         const std::map<std::string, double>& frozen,
                         const std::optional<Path>& path, std::vector<std::string>& warnings) {
  HandTendons tendons;
  std::vector<std::string> muscles;
  // Tendons of each digit, and all muscles once.
  for (const Digit& digit : subject.digits) {
    const TendonOptions options = tendon_options(subject, digit.name, frozen, path);
    tendons.digits.push_back(extensors == Extensors::kNet
                                 ? net_or_less(subject, digit.name, options, warnings)
                                 : build_digit_tendons(subject, digit.name, options));
    for (const std::string& name : tendons.digits.back()->digit().names.muscles)
      if (std::count(muscles.begin(), muscles.end(), name) == 0) muscles.push_back(name);
  }
  // Largest tensions, with the assumptions that they rest on.
  MuscleForces forces = muscle_forces(subject, muscles);
  tendons.max_force = std::move(forces.max_force);
  for (const std::string& assumed : forces.assumed)
    warnings.push_back("largest tension assumed, " + assumed);
  return tendons;
}

/// Strength of joints by their names.
std::map<std::string, std::pair<double, double>> named_strength(const Skeleton& skeleton,
                                                                HandTendons tendons) {
  // Limits at the reference posture.
  const TendonHand hand(skeleton, std::move(tendons));
  const TorqueLimits limits =
      joint_torque_limits(hand, Eigen::VectorXd::Zero(skeleton.coordinates()));
  std::map<std::string, std::pair<double, double>> strength;
  // Joints that no muscle moves are left out.
  for (int i = 0; i < skeleton.coordinates(); ++i)
    if (limits.upper[i] > limits.lower[i])
      strength[skeleton.coordinate_names[i]] = {limits.lower[i], limits.upper[i]};
  return strength;
}

/// Strength of the joints of default_human() on a rung of paths.
const std::map<std::string, std::pair<double, double>>& default_strength(
    const std::optional<Path>& path) {
  const auto on = [](const std::optional<Path>& rung) {
    const Subject& human = default_human();
    const auto frozen = frozen_joints(human, {});
    std::vector<std::string> unheard;
    return named_strength(build_skeleton(human, {{}, frozen}),
                          hand_tendons(human, Extensors::kNet, frozen, rung, unheard));
  };
  // Fitted paths are near wrapped ones, and dear to build.
  if (path == Path::kViaPoint) {
    static const auto straight = on(Path::kViaPoint);
    return straight;
  }
  static const auto wrapped = on({});
  return wrapped;
}

TorqueLimits motor_limits(const Subject& subject, const HandAnatomy& anatomy,
                          const Skeleton& skeleton, const std::map<std::string, double>& frozen,
                          const std::optional<Path>& path, std::vector<std::string>& warnings) {
  // Limits from the subject's own tendons.
  std::map<std::string, std::pair<double, double>> own;
  if (has_tendons(subject)) try {
      own =
          named_strength(skeleton, hand_tendons(subject, Extensors::kNet, frozen, path, warnings));
    } catch (const InputError& error) {
      warnings.push_back(fmt::format("tendons of '{}' left out: {}", subject.name, error.what()));
    }
  // Strength of joints grows with the cube of the size.
  const double scale = std::pow(anatomy.length / find_anatomy(default_human()).length, 3);
  TorqueLimits limits{Eigen::VectorXd(skeleton.coordinates()),
                      Eigen::VectorXd(skeleton.coordinates())};
  std::string borrowed;
  // Joints without an own limit borrow that of the default hand.
  for (int i = 0; i < skeleton.coordinates(); ++i) {
    const std::string& joint = skeleton.coordinate_names[i];
    auto found = own.find(joint);
    double by = 1;
    if (found == own.end()) {
      const auto other = default_strength(path).find(joint);
      require(other != default_strength(path).end(),
              "nothing tells how strong joint '{}' of '{}' is", joint, subject.name);
      found = own.emplace(joint, other->second).first;
      by = scale;
      borrowed += (borrowed.empty() ? "" : ", ") + joint;
    }
    limits.lower[i] = by * found->second.first;
    limits.upper[i] = by * found->second.second;
  }
  if (!borrowed.empty())
    warnings.push_back(fmt::format("strength of {} is that of '{}' times {:.2f}", borrowed,
                                   default_human().name, scale));
  return limits;
}

std::vector<LinkSurface> covered(const Subject& subject, const Skeleton& skeleton,
                                 const HumanHandOptions& options) {
  switch (options.cover) {
    case Cover::kSkin:
      return human_surfaces(subject, skeleton, options.skin);
    case Cover::kBones:
      return bone_surfaces(subject, skeleton);
    case Cover::kNone:
      break;
  }
  return {};
}

/// Fingertips of skin are pads of pulp. Other materials stay.
void put_pads(const HandAnatomy& anatomy, std::vector<LinkSurface>& surfaces) {
  for (LinkSurface& surface : surfaces)
    for (const DigitAnatomy& digit : anatomy.digits)
      if (surface.material == "skin" && surface.name == digit.bones.back().segment)
        surface.material = "fingertip";
}

constexpr std::array kOldVersionNames{EnumName{HumanVersion::kOrthogonalThumb, "tier1"},
                                      EnumName{HumanVersion::kSkewedThumb, "tier2"},
                                      EnumName{HumanVersion::kSoftPads, "tier3"},
                                      EnumName{HumanVersion::kTendonNet, "tier4"}};

/// The version by its name or its old one; empty: it is none.
std::optional<HumanVersion> find_version(const std::string& name) {
  for (const auto& table : {kHumanVersionNames, kOldVersionNames})
    for (const auto& [version, word] : table)
      if (name == word) return version;
  return {};
}

}  // namespace

HumanHand build_human_hand(const Subject& measured, HumanVersion version,
                           const HumanHandOptions& options) {
  const Subject subject = with_passive(measured, options.passive);
  const Subject variant =
      version == HumanVersion::kOrthogonalThumb ? orthogonal_thumb(subject) : subject;
  // Skin lies around the joints as measured, whatever becomes of the thumb's axes.
  const HandAnatomy anatomy = find_anatomy(subject);
  // Bones, contact model, patches and targets.
  const auto frozen = frozen_joints(variant, options.frozen);
  const Skeleton skeleton = build_skeleton(variant, {{}, frozen});
  HumanHand human;
  human.contact =
      version < HumanVersion::kSoftPads ? ContactModel::kHardPoint : ContactModel::kSoftFinger;
  human.patches = skin_patches(anatomy, skeleton);
  human.targets = kapandji_targets(anatomy, skeleton);
  human.skeleton = skeleton;
  human.path = has_tendons(variant) ? path_of(variant, options.path)
                                    : path_of(default_human(), options.path);
  human.warnings = anatomy.warnings;
  std::vector<LinkSurface> surfaces = covered(subject, skeleton, options);
  if (version >= HumanVersion::kSoftPads) put_pads(anatomy, surfaces);
  // Tendons: digit by digit, through nets where they can be carried.
  if (version == HumanVersion::kTendonNet) {
    require(has_tendons(variant), "subject '{}' has no tendons for the fourth version",
            variant.name);
    HandTendons tendons =
        hand_tendons(variant, Extensors::kNet, frozen, options.path, human.warnings);
    for (std::size_t i = 0; i < variant.digits.size(); ++i)
      require(!tendons.digits[i]->digit().names.muscles.empty(),
              "no muscle of '{}' moves its {}; the fourth version wants tendons at every digit",
              variant.name, variant.digits[i].name);
    // The closing synergy follows from linear tendons.
    std::vector<std::string> unheard;
    const TendonHand straight(
        skeleton, hand_tendons(variant, Extensors::kLinear, frozen, options.path, unheard));
    ClosingSynergy use =
        tendon_synergy(anatomy, variant, skeleton, straight.layout().actuators,
                       straight.actuation(Eigen::VectorXd::Zero(skeleton.coordinates())));
    human.hand = std::make_unique<TendonHand>(skeleton, std::move(tendons), std::move(surfaces),
                                              std::move(use));
    return human;
  }
  // Motors: limits from tendons.
  TorqueLimits limits =
      motor_limits(variant, anatomy, skeleton, frozen, options.path, human.warnings);
  human.hand = std::make_unique<SkeletonHand>(skeleton, std::move(limits), std::move(surfaces),
                                              motor_synergy(anatomy, variant, skeleton));
  return human;
}

HumanTendons human_tendons(const Subject& subject, Hood extensors,
                           const HumanHandOptions& options) {
  HumanTendons out;
  const Extensors kind = extensors == Hood::kFloatingNet ? Extensors::kNet : Extensors::kLinear;
  out.hand = hand_tendons(subject, kind, frozen_joints(subject, options.frozen), options.path,
                          out.warnings);
  return out;
}

bool is_human_version(const std::string& name) { return find_version(name).has_value(); }

HumanVersion human_version(const std::string& name) {
  const std::optional<HumanVersion> found = find_version(name);
  return found ? *found : value_in(kHumanVersionNames, name, "version of the human hand");
}

const Subject& default_human() {
  static const Subject human = parse_subject(built_in("human_hand.toml"), "human_hand.toml");
  return human;
}

namespace {

/// The bone that a joint moves, straight or through links of a universal joint; nullptr if it is
/// none of the thumb's.
const DigitBone* bone_moved(const Subject& subject, const DigitAnatomy& thumb, std::string child) {
  for (std::size_t step = 0; step <= subject.joints.size(); ++step) {
    // Down the chain from the joint, until a bone of the thumb.
    for (const DigitBone& bone : thumb.bones)
      if (bone.segment == child) return &bone;
    const JointAxis* next = nullptr;
    for (const JointAxis& joint : subject.joints)
      if (joint.parent == child) {
        if (next != nullptr && next->child != joint.child) return nullptr;  // the palm: it forks
        next = &joint;
      }
    if (next == nullptr) return nullptr;
    child = next->child;
  }
  return nullptr;
}

Eigen::Vector3d axis_of(const JointAxis& joint, const DigitBone& bone) {
  if (ends_with(joint.name, "_AA")) return bone.dorsal;
  if (ends_with(joint.name, "_PS")) return (bone.distal - bone.proximal).normalized();
  return bone.radial;
}

}  // namespace

Subject orthogonal_thumb(Subject subject) {
  // The thumb of the subject.
  const HandAnatomy hand = find_anatomy(subject);
  const DigitAnatomy* thumb = digit_named(hand, "thumb");
  require(thumb != nullptr, "subject '{}' has no thumb", subject.name);
  for (JointAxis& joint : subject.joints) {
    // A wrist that carries nothing but a thumb is no joint of the thumb.
    if (joint.child == thumb->root) continue;
    const DigitBone* bone = bone_moved(subject, *thumb, joint.child);
    if (bone == nullptr) continue;
    // Orthogonal axis through the joint's centre, with the sense of the old one.
    const Eigen::Vector3d axis = axis_of(joint, *bone);
    joint.direction = joint.direction.dot(axis) < 0 ? Eigen::Vector3d(-axis) : axis;
    joint.point = bone->proximal;
    joint.direction_sd = joint.point_sd = 0;
  }
  return subject;
}

}  // namespace thenar
