#include "hand/skin/skin_landmarks.h"

#include <cmath>
#include <map>

#include "base/error.h"
#include "base/lists.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

/// Finder of landmarks where rays leave the skin.
class LandmarkFinder {
 public:
  LandmarkFinder(const HandAnatomy& hand, const Skeleton& skeleton)
      : bodies_(skin_bodies(hand)), skeleton_(skeleton) {}

  /// Returns the landmark where the ray from a point within a segment leaves its skin.
  [[nodiscard]] SkinLandmark mark(const std::string& digit, const std::string& segment,
                                  const Vector3d& from, const Vector3d& direction) const {
    // Bisect along the ray.
    const ImplicitBody& body = bodies_.at(segment);
    double inside = 0, outside = implicit_bounds(body).diagonal().norm();
    while (outside - inside > 1e-9) {
      const double middle = (inside + outside) / 2;
      (implicit_height(body, from + middle * direction) < 0 ? inside : outside) = middle;
    }
    // Convert to the hand's frame at the skeleton's posture.
    const Vector3d p = from + inside * direction;
    const Pose<double>& at = skeleton_.segment_at.at(segment);
    return {digit, segment, skeleton_.link_of_segment.at(segment), at * p,
            at.R * slope(body, p).normalized()};
  }

  /// Returns whether a segment is kept and has skin.
  [[nodiscard]] bool keeps(const std::string& segment) const {
    return skeleton_.link_of_segment.count(segment) > 0 && bodies_.count(segment) > 0;
  }

  /// Returns the rotation of a segment by frozen joints.
  [[nodiscard]] const Eigen::Matrix3d& turn(const std::string& segment) const {
    return skeleton_.segment_at.at(segment).R;
  }

 private:
  /// Computes the unnormalised gradient of the height by central differences.
  static Vector3d slope(const ImplicitBody& body, const Vector3d& p) {
    const double h = 1e-6;  // step of the differences [m]
    Vector3d slope;
    for (int i = 0; i < 3; ++i)
      slope[i] = implicit_height(body, p + h * Vector3d::Unit(i)) -
                 implicit_height(body, p - h * Vector3d::Unit(i));
    return slope;
  }

  std::map<std::string, ImplicitBody> bodies_;
  const Skeleton& skeleton_;
};

/// Returns the point of a bone at a fraction of its length.
Vector3d along(const DigitBone& bone, double part) {
  return bone.proximal + part * (bone.distal - bone.proximal);
}

/// Returns the direction of a bone towards distal.
Vector3d direction(const DigitBone& bone) { return (bone.distal - bone.proximal).normalized(); }

/// Returns a point of the axis well within a fingertip, from which rays start.
Vector3d within_tip(const DigitBone& bone) { return along(bone, 0.6); }

/// Adds targets 1 and 2.
void add_index_sides(const LandmarkFinder& marker, const HandAnatomy& hand,
                     std::vector<OppositionTarget>& targets) {
  const DigitAnatomy* index = digit_named(hand, "index");
  if (index == nullptr || !marker.keeps(index->bones[0].segment)) return;
  const char* names[] = {"radial side of the index finger's proximal phalanx",
                         "radial side of the index finger's middle phalanx"};
  for (int i = 0; i < 2; ++i) {
    const DigitBone& bone = index->bones[i];
    targets.push_back(
        {i + 1, names[i], marker.mark("index", bone.segment, along(bone, 0.5), bone.radial)});
  }
}

/// Adds targets 3 to 6.
void add_tips(const LandmarkFinder& marker, const HandAnatomy& hand,
              std::vector<OppositionTarget>& targets) {
  int score = 3;
  for (const char* name : {"index", "middle", "ring", "little"}) {
    const DigitAnatomy* digit = digit_named(hand, name);
    if (digit != nullptr && marker.keeps(digit->bones.back().segment)) {
      const DigitBone& bone = digit->bones.back();
      // Mark the end of the pad, half way between palmar and distal.
      const Vector3d ahead = (direction(bone) - bone.dorsal).normalized();
      targets.push_back({score, std::string("tip of the ") + name + " finger",
                         marker.mark(name, bone.segment, within_tip(bone), ahead)});
    }
    ++score;
  }
}

/// Adds targets 7 to 10.
void add_little_creases(const LandmarkFinder& marker, const HandAnatomy& hand,
                        std::vector<OppositionTarget>& targets) {
  const DigitAnatomy* little = digit_named(hand, "little");
  if (little == nullptr || !marker.keeps(little->bones[0].segment)) return;
  const char* names[] = {"little finger's DIP crease", "little finger's PIP crease",
                         "little finger's root crease"};
  for (int i = 0; i < 3; ++i) {
    // Mark the creases over DIP and PIP at the joints, that of the root a third along the phalanx.
    const DigitBone& bone = little->bones[2 - i];
    const Vector3d from = i < 2 ? bone.proximal : along(bone, 0.34);
    targets.push_back({7 + i, names[i], marker.mark("little", bone.segment, from, -bone.dorsal)});
  }
  if (!hand.palm || !marker.keeps(hand.palm->segment)) return;
  const PalmAnatomy& palm = *hand.palm;
  const Vector3d knuckle = little->bones[0].proximal;
  const Vector3d from = knuckle - 0.15 * (knuckle - palm.wrist).dot(palm.distal) * palm.distal;
  targets.push_back(
      {10, "distal crease of the palm", marker.mark("", palm.segment, from, -palm.dorsal)});
}

}  // namespace

std::vector<SkinPatch> skin_patches(const HandAnatomy& hand, const Skeleton& skeleton) {
  const LandmarkFinder marker(hand, skeleton);
  std::vector<SkinPatch> patches;
  // Add pad and nail of each distal phalanx.
  for (const DigitAnatomy& digit : hand.digits) {
    const DigitBone& bone = digit.bones.back();
    if (!marker.keeps(bone.segment)) continue;
    const double length = (bone.distal - bone.proximal).norm();
    const Vector3d ahead = marker.turn(bone.segment) * direction(bone);
    patches.push_back({PatchKind::kPad,
                       marker.mark(digit.name, bone.segment, along(bone, 0.6), -bone.dorsal), ahead,
                       length / 3, 0.8 * bone.radius});
    patches.push_back({PatchKind::kNail,
                       marker.mark(digit.name, bone.segment, along(bone, 0.7), bone.dorsal), ahead,
                       length / 4, 0.6 * bone.radius});
  }
  return patches;
}

bool on_patch(const SkinPatch& patch, const Vector3d& p) {
  // Compute coordinates on the patch over its half axes.
  const Vector3d from = p - patch.middle.p;
  const Vector3d across = patch.middle.outward.cross(patch.along);
  const double u = from.dot(patch.along) / patch.half_length;
  const double v = from.dot(across) / patch.half_breadth;
  return u * u + v * v <= 1 && std::abs(from.dot(patch.middle.outward)) <= patch.half_breadth;
}

const SkinLandmark& pad_of(const std::vector<SkinPatch>& patches, const std::string& digit) {
  for (const SkinPatch& patch : patches)
    if (patch.kind == PatchKind::kPad && patch.middle.digit == digit) return patch.middle;
  throw InputError(fmt::format("no pad on digit '{}'", digit));
}

Vector3d pad_normal(const Subject& subject, const Skeleton& skeleton, const std::string& digit) {
  const std::vector<SkinPatch> patches = skin_patches(find_anatomy(subject), skeleton);
  const SkinLandmark& pad = pad_of(patches, digit);
  const Segment* segment = find_named(subject.segments, pad.segment);
  const Vector3d bone =
      skeleton.segment_at.at(pad.segment).R * (segment->distal - segment->proximal).normalized();
  return (pad.outward - pad.outward.dot(bone) * bone).normalized();
}

std::vector<OppositionTarget> kapandji_targets(const HandAnatomy& hand, const Skeleton& skeleton) {
  const LandmarkFinder marker(hand, skeleton);
  std::vector<OppositionTarget> targets;
  add_index_sides(marker, hand, targets);
  add_tips(marker, hand, targets);
  add_little_creases(marker, hand, targets);
  return targets;
}

}  // namespace thenar
