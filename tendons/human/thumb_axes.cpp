#include "tendons/human/thumb_axes.h"

#include <string>

#include "base/error.h"
#include "hand/skin/hand_anatomy.h"
#include "tendons/name_kinds.h"

namespace thenar {
namespace {

/// The bone that a joint moves, straight or through links of a universal joint; nullptr if it is
/// none of the thumb's.
const DigitBone* bone_moved(const Subject& subject, const DigitAnatomy& thumb, std::string child) {
  for (std::size_t step = 0; step <= subject.joints.size(); ++step) {
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
  const HandAnatomy hand = find_anatomy(subject);
  const DigitAnatomy* thumb = digit_named(hand, "thumb");
  require(thumb != nullptr, "subject '{}' has no thumb", subject.name);
  for (JointAxis& joint : subject.joints) {
    // A wrist that carries nothing but a thumb is no joint of the thumb.
    if (joint.child == thumb->root) continue;
    const DigitBone* bone = bone_moved(subject, *thumb, joint.child);
    if (bone == nullptr) continue;
    const Eigen::Vector3d axis = axis_of(joint, *bone);
    joint.direction = joint.direction.dot(axis) < 0 ? Eigen::Vector3d(-axis) : axis;
    joint.point = bone->proximal;
    joint.direction_sd = joint.point_sd = 0;
  }
  return subject;
}

}  // namespace thenar
