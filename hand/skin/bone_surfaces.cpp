#include <map>

#include "hand/skin/hand_anatomy.h"
#include "hand/skin/human_surfaces.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

ShapeSpec ball(const Vector3d& center, double radius) {
  ShapeSpec shape;
  shape.kind = ShapeKind::kSphere;
  shape.size = {radius, 0, 0};
  shape.X_BS.p = center;
  return shape;
}

ShapeSpec shaft(const Vector3d& a, const Vector3d& b, double ra, double rb) {
  ShapeSpec shape;
  shape.kind = ShapeKind::kTaperedCapsule;
  shape.size = {ra, rb, (b - a).norm()};
  const Vector3d along = (b - a).normalized();
  const Tangents across = tangents(along);
  shape.X_BS.R << across.e1, across.e2, along;
  shape.X_BS.p = (a + b) / 2;
  return shape;
}

/// Shaft, base and condyles between two joints; `end` before the second in parts of the radius.
std::vector<ShapeSpec> bone_shapes(const DigitBone& bone, bool last) {
  const double r = bone.radius, thin = 0.4 * r;
  const Vector3d along = (bone.distal - bone.proximal).normalized();
  const Vector3d base = bone.proximal + 0.45 * r * along;
  const Vector3d head = bone.distal - (last ? 0.9 : 0.1) * r * along;
  const Vector3d middle = (base + head) / 2;
  std::vector<ShapeSpec> shapes{shaft(base, middle, 0.58 * r, thin)};
  if (last) {
    shapes.push_back(shaft(middle, head, thin, 0.35 * r));
  } else {
    shapes.push_back(shaft(middle, head, thin, 0.45 * r));
    for (const double side : {-1.0, 1.0})
      shapes.push_back(ball(head + side * 0.22 * r * bone.radial, 0.42 * r));
  }
  return shapes;
}

/// Metacarpals II to V, from the carpus to the knuckles.
std::vector<ShapeSpec> palm_shapes(const HandAnatomy& hand) {
  const PalmAnatomy& palm = *hand.palm;
  std::vector<ShapeSpec> shapes;
  for (const DigitAnatomy& digit : hand.digits) {
    if (digit.root != palm.segment || digit.name == "thumb") continue;
    const DigitBone& bone = digit.bones.front();
    const Vector3d way = bone.proximal - palm.wrist;
    const Vector3d foot = palm.wrist + 0.25 * way.dot(palm.distal) * palm.distal +
                          0.6 * way.dot(palm.radial) * palm.radial;
    const Vector3d middle = (foot + bone.proximal) / 2;
    shapes.push_back(shaft(foot, middle, 0.6 * bone.radius, 0.42 * bone.radius));
    shapes.push_back(shaft(middle, bone.proximal, 0.42 * bone.radius, 0.7 * bone.radius));
  }
  return shapes;
}

/// The hand's frame at the skeleton's reference posture.
void add_surface(const Skeleton& skeleton, const std::string& digit, const std::string& segment,
                 std::vector<ShapeSpec> shapes, std::vector<LinkSurface>& surfaces) {
  const auto link = skeleton.link_of_segment.find(segment);
  if (link == skeleton.link_of_segment.end() || shapes.empty()) return;
  const Pose<double>& at = skeleton.segment_at.at(segment);
  for (ShapeSpec& shape : shapes) shape.X_BS = at * shape.X_BS;
  surfaces.push_back(
      {link->second, segment, digit, "bone", std::make_shared<const Solid>(build_solid(shapes))});
}

}  // namespace

std::vector<LinkSurface> bone_surfaces(const Subject& subject, const Skeleton& skeleton) {
  const HandAnatomy hand = find_anatomy(subject);
  std::vector<LinkSurface> surfaces;
  if (hand.palm) add_surface(skeleton, "", hand.palm->segment, palm_shapes(hand), surfaces);
  for (const DigitAnatomy& digit : hand.digits)
    for (const DigitBone& bone : digit.bones)
      add_surface(skeleton, digit.name, bone.segment,
                  bone_shapes(bone, bone.segment == digit.bones.back().segment), surfaces);
  return surfaces;
}

}  // namespace thenar
