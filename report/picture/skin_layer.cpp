#include "report/picture/skin_layer.h"

#include <optional>

#include "base/error.h"
#include "hand/skin/human_surfaces.h"
#include "hand/skin/skin_body.h"
#include "report/picture/color_ramp.h"

namespace thenar {
namespace {

constexpr const char* kFleshColor = "#dfab8f";
constexpr const char* kNailTint = "#f0d3c6";
constexpr double kSeenThrough = 0.32;  // opacity [1]
constexpr int kSkinTriangles = 1200;   // largest number of triangles of a segment [1]

/// The anatomy of a subject; none if it has too few bones.
std::optional<HandAnatomy> anatomy_of(const Subject& subject) {
  try {
    return find_anatomy(subject);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

}  // namespace

std::vector<MeshColor> nail_colors(const TriangleMesh& mesh, const std::vector<SkinPatch>& patches,
                                   const std::string& digit, int link) {
  const MeshColor skin = color_of_hex(kFleshColor), nail = color_of_hex(kNailTint);
  std::vector<MeshColor> colors;
  for (const SkinPatch& patch : patches) {
    if (patch.kind != PatchKind::kNail || patch.middle.digit != digit || patch.middle.link != link)
      continue;
    for (const auto& p : mesh.vertices.colwise())
      colors.push_back(on_patch(patch, p) ? nail : skin);
    return colors;
  }
  return colors;
}

Json skin_layer(const SkinnedDigit& digit, MeshTable& meshes) {
  // Skin needs the anatomy of the hand, and is drawn of this digit alone.
  std::optional<HandAnatomy> anatomy = anatomy_of(digit.subject);
  if (!anatomy) return nullptr;
  anatomy->palm.reset();  // its web would not be attached to anything
  const Skeleton& skeleton = digit.tendons.skeleton;
  const DigitAnatomy* own = digit_named(*anatomy, skeleton.tips.front().digit);
  if (own == nullptr) return nullptr;
  const std::vector<SkinPatch> patches = skin_patches(*anatomy, skeleton);
  const std::map<std::string, ImplicitBody> bodies = skin_bodies(*anatomy);
  Json items = Json::array();
  for (const DigitBone& bone : own->bones) {
    const auto link = skeleton.link_of_segment.find(bone.segment);
    const auto body = bodies.find(bone.segment);
    if (link == skeleton.link_of_segment.end() || body == bodies.end()) continue;
    // At the reference posture, then where its link is.
    TriangleMesh mesh = skin_mesh(body->second, kSkinTriangles);
    const Pose<double>& at = skeleton.segment_at.at(bone.segment);
    mesh.vertices = ((at.R * mesh.vertices).colwise() + at.p).eval();
    const MeshLook look{-1, nail_colors(mesh, patches, own->name, link->second)};
    const Pose<double> X = link->second < 0 ? Pose<double>{} : nth(digit.at, link->second).X;
    items.push_back(with(mesh_item(meshes.add(mesh, look), X), {{"opacity", kSeenThrough}}));
  }
  if (items.empty()) return nullptr;
  return layer("skin", kFleshColor, std::move(items));
}

void add_skin(const SkinnedDigit& digit, MeshTable& meshes, Json& layers) {
  Json skin = skin_layer(digit, meshes);
  if (!skin.is_null()) layers.push_back(std::move(skin));
}

}  // namespace thenar
