#include "hand_versions/human_hand.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "base/error.h"
#include "base/lists.h"
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

/// Returns the text of a built-in file.
std::string built_in(const std::string& file) {
  return std::string(internal::human_files().at(file));
}

/// Returns the description of the net of fingers.
const NetDescription& finger_net() {
  static const NetDescription net = parse_net(built_in("extensor_hood.toml"), "extensor_hood.toml");
  return net;
}

/// Returns the frozen joints: the requested ones, and the wrist at its reference or nearest limit.
std::map<std::string, double> frozen_joints(const Subject& subject,
                                            const std::map<std::string, double>& asked) {
  // Freeze the joints that digits share as well.
  std::map<std::string, double> frozen = asked;
  for (const std::string& name : shared_joints(subject))
    for (const JointAxis& joint : subject.joints)
      if (joint.name == name) frozen.emplace(name, std::clamp(0.0, joint.lower, joint.upper));
  return frozen;
}

bool has_tendons(const Subject& subject) { return !subject.muscles.empty(); }

/// Returns the path model that the subject's strands allow: strands with arms instead of points
/// have no path.
Path path_of(const Subject& subject, const std::optional<Path>& asked) {
  const bool arms =
      all_of(subject.strands, [](const Strand& strand) { return strand.path.empty(); });
  return arms ? Path::kConstant : asked.value_or(default_path(subject));
}

/// Builds the options of one digit's tendons.
TendonOptions tendon_options(const Subject& subject, const std::string& digit,
                             const std::map<std::string, double>& frozen,
                             const std::optional<Path>& path) {
  TendonOptions options;
  // Select the frozen joints that this subject has.
  options.path = path_of(subject, path);
  for (const auto& [joint, angle] : frozen)
    if (find_named(subject.joints, joint) != nullptr) options.frozen[joint] = angle;
  // Use its hood, if the subject states one.
  const bool hood = find_named(subject.digits, digit)->hood.has_value();
  options.hood = hood ? Hood::kFractions : Hood::kSeparate;
  return options;
}

/// Builds a digit with a net, or without one and a warning where that fails.
std::unique_ptr<DigitTendons> net_or_linear_tendons(const Subject& subject,
                                                    const std::string& digit,
                                                    const TendonOptions& options,
                                                    std::vector<std::string>& warnings) {
  // Try a net on fingers; use linear tendons for the thumb and where that fails.
  TendonOptions floating = options;
  floating.hood = Hood::kFloatingNet;
  if (digit != "thumb") try {
      return build_digit_tendons(subject, digit, floating, &finger_net());
    } catch (const InputError& error) {
      warnings.push_back(fmt::format("{}: no net, {}", digit, error.what()));
    }
  return build_digit_tendons(subject, digit, options);
}

/// Model of the extensors.
enum class Extensors { kLinear, kNet };

/// Builds the tendons of all digits.
HandTendons hand_tendons(const Subject& subject, Extensors extensors,
                         const std::map<std::string, double>& frozen,
                         const std::optional<Path>& path, std::vector<std::string>& warnings) {
  HandTendons tendons;
  std::vector<std::string> muscles;
  // Build the tendons of each digit, and collect all muscles once.
  for (const Digit& digit : subject.digits) {
    const TendonOptions options = tendon_options(subject, digit.name, frozen, path);
    tendons.digits.push_back(extensors == Extensors::kNet
                                 ? net_or_linear_tendons(subject, digit.name, options, warnings)
                                 : build_digit_tendons(subject, digit.name, options));
    append_new(muscles, tendons.digits.back()->digit().names.muscles);
  }
  // Set the largest tensions, and warn of assumptions.
  MuscleForces forces = muscle_forces(subject, muscles);
  tendons.max_force = std::move(forces.max_force);
  for (const std::string& assumed : forces.assumed)
    warnings.push_back("largest tension assumed, " + assumed);
  return tendons;
}

/// Computes the smallest and largest torque of joints by their names.
std::map<std::string, std::pair<double, double>> named_strength(const Skeleton& skeleton,
                                                                HandTendons tendons) {
  // Compute the limits at the reference posture.
  const TendonHand hand(skeleton, std::move(tendons));
  const TorqueLimits limits =
      joint_torque_limits(hand, Eigen::VectorXd::Zero(skeleton.coordinates()));
  std::map<std::string, std::pair<double, double>> strength;
  // Leave out joints that no muscle moves.
  for (int i = 0; i < skeleton.coordinates(); ++i)
    if (limits.upper[i] > limits.lower[i])
      strength[skeleton.coordinate_names[i]] = {limits.lower[i], limits.upper[i]};
  return strength;
}

/// Returns the strength of the joints of default_human() for a path model.
const std::map<std::string, std::pair<double, double>>& default_strength(
    const std::optional<Path>& path) {
  const auto on = [](const std::optional<Path>& rung) {
    const Subject& human = default_human();
    const auto frozen = frozen_joints(human, {});
    std::vector<std::string> ignored_warnings;
    return named_strength(build_skeleton(human, {{}, frozen}),
                          hand_tendons(human, Extensors::kNet, frozen, rung, ignored_warnings));
  };
  // Use wrapped paths in place of fitted ones, which are close to them and expensive to build.
  if (path == Path::kViaPoint) {
    static const auto straight = on(Path::kViaPoint);
    return straight;
  }
  static const auto wrapped = on({});
  return wrapped;
}

/// Computes the torque limits of motors from tendons.
TorqueLimits motor_limits(const Subject& subject, const HandAnatomy& anatomy,
                          const Skeleton& skeleton, const std::map<std::string, double>& frozen,
                          const std::optional<Path>& path, std::vector<std::string>& warnings) {
  // Compute limits from the subject's own tendons.
  std::map<std::string, std::pair<double, double>> own;
  if (has_tendons(subject)) try {
      own =
          named_strength(skeleton, hand_tendons(subject, Extensors::kNet, frozen, path, warnings));
    } catch (const InputError& error) {
      warnings.push_back(fmt::format("tendons of '{}' left out: {}", subject.name, error.what()));
    }
  // Scale the default strength by the cube of the size.
  const double scale = std::pow(anatomy.length / find_anatomy(default_human()).length, 3);
  TorqueLimits limits{Eigen::VectorXd(skeleton.coordinates()),
                      Eigen::VectorXd(skeleton.coordinates())};
  std::string borrowed;
  // Use the scaled default strength for joints without a limit of their own.
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

/// Builds the surfaces of the chosen cover.
std::vector<LinkSurface> cover_surfaces(const Subject& subject, const Skeleton& skeleton,
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

/// Changes the material of fingertips from skin to pads; other materials stay.
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

/// Returns the version by its name or its old one; empty if there is none.
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
  // Derive the anatomy from the measured joints, independent of changes of the thumb's axes.
  const HandAnatomy anatomy = find_anatomy(subject);
  // Build skeleton, contact model, patches and targets.
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
  std::vector<LinkSurface> surfaces = cover_surfaces(subject, skeleton, options);
  if (version >= HumanVersion::kSoftPads) put_pads(anatomy, surfaces);
  // Build tendons digit by digit for the fourth version, with nets where possible.
  if (version == HumanVersion::kTendonNet) {
    require(has_tendons(variant), "subject '{}' has no tendons for the fourth version",
            variant.name);
    HandTendons tendons =
        hand_tendons(variant, Extensors::kNet, frozen, options.path, human.warnings);
    for (std::size_t i = 0; i < variant.digits.size(); ++i)
      require(!tendons.digits[i]->digit().names.muscles.empty(),
              "no muscle of '{}' moves its {}; the fourth version wants tendons at every digit",
              variant.name, variant.digits[i].name);
    // Derive the closing synergy from linear tendons.
    std::vector<std::string> ignored_warnings;
    const TendonHand straight(skeleton, hand_tendons(variant, Extensors::kLinear, frozen,
                                                     options.path, ignored_warnings));
    ClosingSynergy use =
        tendon_synergy(anatomy, variant, skeleton, straight.layout().actuators,
                       straight.actuation(Eigen::VectorXd::Zero(skeleton.coordinates())));
    human.hand = std::make_unique<TendonHand>(skeleton, std::move(tendons), std::move(surfaces),
                                              std::move(use));
    return human;
  }
  // Build motors with limits from tendons for other versions.
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

/// Returns the bone of the thumb that a joint moves, directly or through links of a universal
/// joint; nullptr if there is none.
const DigitBone* bone_moved(const Subject& subject, const DigitAnatomy& thumb, std::string child) {
  for (std::size_t step = 0; step <= subject.joints.size(); ++step) {
    // Walk outwards from the joint, up to a bone of the thumb.
    for (const DigitBone& bone : thumb.bones)
      if (bone.segment == child) return &bone;
    const JointAxis* next = nullptr;
    for (const JointAxis& joint : subject.joints)
      if (joint.parent == child) {
        if (next != nullptr && next->child != joint.child)
          return nullptr;  // the chain forks at the palm
        next = &joint;
      }
    if (next == nullptr) return nullptr;
    child = next->child;
  }
  return nullptr;
}

/// Returns the orthogonal axis of a joint of the thumb.
Eigen::Vector3d axis_of(const JointAxis& joint, const DigitBone& bone) {
  if (ends_with(joint.name, "_AA")) return bone.dorsal;
  if (ends_with(joint.name, "_PS")) return (bone.distal - bone.proximal).normalized();
  return bone.radial;
}

}  // namespace

Subject orthogonal_thumb(Subject subject) {
  // Find the thumb of the subject.
  const HandAnatomy hand = find_anatomy(subject);
  const DigitAnatomy* thumb = digit_named(hand, "thumb");
  require(thumb != nullptr, "subject '{}' has no thumb", subject.name);
  for (JointAxis& joint : subject.joints) {
    // Skip a wrist that carries only a thumb.
    if (joint.child == thumb->root) continue;
    const DigitBone* bone = bone_moved(subject, *thumb, joint.child);
    if (bone == nullptr) continue;
    // Set the orthogonal axis through the joint's centre, with the sense of the old one.
    const Eigen::Vector3d axis = axis_of(joint, *bone);
    joint.direction = joint.direction.dot(axis) < 0 ? Eigen::Vector3d(-axis) : axis;
    joint.point = bone->proximal;
    joint.direction_sd = joint.point_sd = 0;
  }
  return subject;
}

}  // namespace thenar
