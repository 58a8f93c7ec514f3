#include "hand/skin/hand_anatomy.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "base/error.h"
#include "base/lists.h"
#include "base/spatial.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

constexpr int kFleshBones = 3;  // number of bones of a digit with flesh of its own

/// Proportions of a digit, by its name.
struct Proportion {
  // Radii over hand length, cylinders of [Mirakhorlo2016] [1].
  std::array<double, kFleshBones> radius;
  double length;  // length of the three bones over hand length [Buchholz1992] [1]
};

const std::map<std::string, Proportion>& proportions() {
  static const std::map<std::string, Proportion> table{
      {"thumb", {{11.52 / 196, 10.00 / 196, 10.00 / 196}, 0.251 + 0.196 + 0.158}},
      {"index", {{9.73 / 196, 9.30 / 196, 9.30 / 196}, 0.245 + 0.143 + 0.097}},
      {"middle", {{9.28 / 196, 8.45 / 196, 8.45 / 196}, 0.266 + 0.170 + 0.108}},
      {"ring", {{8.39 / 196, 7.62 / 196, 7.61 / 196}, 0.244 + 0.165 + 0.107}},
      {"little", {{7.19 / 196, 6.69 / 196, 6.68 / 196}, 0.204 + 0.117 + 0.093}}};
  return table;
}

const Proportion& proportion_of(const std::string& digit) {
  const auto found = proportions().find(digit);
  return found == proportions().end() ? proportions().at("middle") : found->second;
}

constexpr double kBreadthOverLength =
    0.0875 / 0.195;  // hand breadth over length [1] [Buchholz1992]
constexpr double kThicknessOverBreadth =
    24.0 / 68.0;  // palm thickness over breadth [1] [Mirakhorlo2016]

/// Returns the first joint that moves a segment; nullptr if there is none.
const JointAxis* joint_moving(const Subject& subject, const std::string& child) {
  for (const JointAxis& joint : subject.joints)
    if (joint.child == child) return &joint;
  return nullptr;
}

/// Returns whether a segment is a hinge of a universal joint, without flesh.
bool is_link(const Segment& segment) {
  const std::string suffix = "_link", &name = segment.name;
  return segment.proximal == segment.distal ||
         (name.size() > suffix.size() &&
          name.compare(name.size() - suffix.size(), suffix.size(), suffix) == 0);
}

/// Returns the segments of a digit with flesh, from the tip towards the base, which is none of them.
std::vector<const Segment*> flesh_segments(const Subject& subject, const Digit& digit) {
  std::vector<const Segment*> chain;
  // Walk along the chain from the tip; links of universal joints have no flesh.
  std::string name = digit.tip_segment;
  while (chain.size() < kFleshBones) {
    const JointAxis* joint = joint_moving(subject, name);
    require(joint != nullptr, "digit '{}' of '{}' has {} bones to its tip; a skin wants {}",
            digit.name, subject.name, chain.size(), kFleshBones);
    const Segment* segment = find_named(subject.segments, name);
    if (segment != nullptr && !is_link(*segment)) chain.push_back(segment);
    name = joint->parent;
  }
  return chain;
}

/// Returns the first segment with flesh, or the base, inwards of a segment.
std::string root_of(const Subject& subject, std::string name) {
  while (const JointAxis* joint = joint_moving(subject, name)) {
    name = joint->parent;
    const Segment* segment = find_named(subject.segments, name);
    if (segment != nullptr && !is_link(*segment)) break;
  }
  return name;
}

/// Returns all hinges between a bone and the bone before it, from the bone inwards.
std::vector<const JointAxis*> hinges_of(const Subject& subject, std::string name) {
  std::vector<const JointAxis*> hinges;
  while (const JointAxis* joint = joint_moving(subject, name)) {
    for (const JointAxis& each : subject.joints)
      if (each.child == name) hinges.push_back(&each);
    name = joint->parent;
    const Segment* segment = find_named(subject.segments, name);
    if (segment == nullptr || !is_link(*segment)) break;
  }
  return hinges;
}

/// Computes the point of an axis nearest to p.
Vector3d nearest_on_axis(const JointAxis& joint, const Vector3d& p) {
  return joint.point + joint.direction.normalized() * (p - joint.point).dot(joint.direction) /
                           joint.direction.norm();
}

/// Computes a joint's centre, see find_anatomy(). @param across  radial direction
Vector3d joint_center(const Subject& subject, const Segment& bone, double radius,
                      const Vector3d& across) {
  // Find the hinge that flexes most.
  const JointAxis* flexion = nullptr;
  for (const JointAxis* hinge : hinges_of(subject, bone.name)) {
    if (flexion == nullptr ||
        std::abs(hinge->direction.dot(across)) > std::abs(flexion->direction.dot(across)))
      flexion = hinge;
  }
  if (flexion == nullptr) return bone.proximal;
  // Start from the bone's end, or half way to the middle of the joint's head.
  Vector3d from = bone.proximal;
  const std::string root = root_of(subject, bone.name);
  for (const Surface& head : subject.surfaces)
    if (head.segment == root && head.shape == SurfaceShape::kCylinder &&
        (head.center - bone.proximal).norm() < 2 * radius)
      from = (bone.proximal + head.center) / 2;
  // Move towards the axis, by at most 1.5 radii.
  const Vector3d way = nearest_on_axis(*flexion, from) - bone.proximal;
  return bone.proximal + std::min(1.0, 1.5 * radius / std::max(way.norm(), 1e-9)) * way;
}

/// Returns the end of a digit: its tip, or the end of the tip's bone if the bone reaches further,
/// since the tip may be the middle of a pad.
Vector3d end_of(const Digit& digit, const Segment& bone) {
  const double to_tip = digit.proximal.dot(bone.proximal - digit.tip);
  const double to_end = digit.proximal.dot(bone.proximal - bone.distal);
  return to_end > to_tip ? bone.distal : digit.tip;
}

/// Sets the directions across a bone, near the digit's radial one.
void set_directions(const Digit& digit, DigitBone& bone) {
  // Make the radial direction of the digit normal to the bone.
  const Vector3d proximal = (bone.proximal - bone.distal).normalized();
  Vector3d radial = digit.radial - digit.radial.dot(proximal) * proximal;
  if (radial.norm() < 0.1) radial = tangents(proximal).e1;
  bone.radial = radial.normalized();
  // Choose the dorsal direction by the handedness of the digit.
  const double hand = digit.radial.cross(digit.proximal).dot(digit.dorsal) < 0 ? -1 : 1;
  bone.dorsal = hand * bone.radial.cross(proximal);
}

/// Derives the anatomy of a digit; sets `assumed` if a radius is not stated.
DigitAnatomy anatomy_of(const Subject& subject, const Digit& digit, double length, bool& assumed) {
  // Collect the bones from the root to the tip.
  const std::vector<const Segment*> chain = flesh_segments(subject, digit);
  DigitAnatomy anatomy{digit.name, root_of(subject, chain.back()->name), {}};
  for (int i = 0; i < kFleshBones; ++i) {
    const Segment& segment = *chain[kFleshBones - 1 - i];
    assumed = assumed || segment.radius == 0;
    // Take the stated radius, or one in proportion to the hand.
    const double radius =
        segment.radius > 0 ? segment.radius : proportion_of(digit.name).radius[i] * length;
    anatomy.bones.push_back({segment.name,
                             joint_center(subject, segment, radius, digit.radial),
                             end_of(digit, *chain.front()),
                             radius,
                             {},
                             {}});
    if (i > 0) anatomy.bones[i - 1].distal = anatomy.bones[i].proximal;
  }
  // Set directions, which need the bones' final ends.
  for (DigitBone& bone : anatomy.bones) {
    require((bone.distal - bone.proximal).norm() > 1e-3, "segment '{}' of '{}' has no length",
            bone.segment, subject.name);
    set_directions(digit, bone);
  }
  return anatomy;
}

/// Returns the hand length, as stated or from the bones of all digits together [m].
double length_of(const Subject& subject) {
  // Take the stated length, or sum the lengths of all bones.
  const auto stated = subject.lengths.find("hand_length");
  if (stated != subject.lengths.end()) return stated->second;
  double bones = 0, parts = 0;
  for (const Digit& digit : subject.digits) {
    for (const Segment* segment : flesh_segments(subject, digit))
      bones += (segment->distal - segment->proximal).norm();
    parts += proportion_of(digit.name).length;
  }
  return bones / parts;
}

/// Returns the centre of the wrist.
Vector3d wrist_of(const Subject& subject, const Segment& palm) {
  const std::vector<const JointAxis*> hinges = hinges_of(subject, palm.name);
  return hinges.empty() ? palm.proximal : nearest_on_axis(*hinges.back(), palm.proximal);
}

/// Derives the anatomy of the palm, if at least two fingers share a root.
std::optional<PalmAnatomy> palm_of(const Subject& subject, const HandAnatomy& hand) {
  // Collect the knuckles of the fingers that share a root, radial ones first.
  std::vector<const DigitBone*> knuckles;
  std::string root;
  for (const char* name : {"index", "middle", "ring", "little"})
    if (const DigitAnatomy* digit = digit_named(hand, name)) {
      if (!knuckles.empty() && digit->root != root) continue;
      root = digit->root;
      knuckles.push_back(&digit->bones.front());
    }
  const Segment* segment = find_named(subject.segments, root);
  if (knuckles.size() < 2 || segment == nullptr) return std::nullopt;

  // Find the wrist, and the mean of the knuckles.
  PalmAnatomy palm;
  palm.segment = root;
  palm.wrist = wrist_of(subject, *segment);
  Vector3d heads = Vector3d::Zero(), dorsal = Vector3d::Zero();
  for (const DigitBone* bone : knuckles) {
    heads += bone->proximal / static_cast<double>(knuckles.size());
    dorsal += bone->dorsal;
  }
  // Set the axes: distal, radial towards the index finger, dorsal on the side of the bones' one.
  palm.distal = (heads - palm.wrist).normalized();
  const Vector3d across = knuckles.front()->proximal - knuckles.back()->proximal;
  palm.radial = (across - across.dot(palm.distal) * palm.distal).normalized();
  palm.dorsal = palm.distal.cross(palm.radial);
  if (palm.dorsal.dot(dorsal) < 0) palm.dorsal = -palm.dorsal;
  // Take the stated breadth, or one in proportion.
  const auto stated = subject.lengths.find("hand_breadth");
  palm.breadth =
      stated == subject.lengths.end() ? kBreadthOverLength * hand.length : stated->second;
  palm.thickness = kThicknessOverBreadth * palm.breadth;
  return palm;
}

}  // namespace

HandAnatomy find_anatomy(const Subject& subject) {
  require(!subject.digits.empty(), "subject '{}' has no digit to lay skin on", subject.name);
  HandAnatomy hand;
  // Find the length first, since radii depend on it.
  hand.length = length_of(subject);
  bool assumed = false;
  for (const Digit& digit : subject.digits)
    hand.digits.push_back(anatomy_of(subject, digit, hand.length, assumed));
  if (assumed)
    hand.warnings.push_back(
        fmt::format("breadths of digits that '{}' does not state: in proportion to hand length, "
                    "as in Mirakhorlo 2016",
                    subject.name));
  hand.palm = palm_of(subject, hand);
  return hand;
}

const DigitAnatomy* digit_named(const HandAnatomy& hand, const std::string& name) {
  return find_named(hand.digits, name);
}

}  // namespace thenar
