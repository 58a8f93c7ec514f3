#include "hand/skin/human_surfaces.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/error.h"
#include "base/lists.h"
#include "base/parallel_for.h"
#include "geometry/cached_mesh.h"
#include "geometry/capsule_fit.h"
#include "geometry/mesh_from_distance.h"
#include "geometry/triangle_mesh.h"
#include "hand/skin/hand_anatomy.h"
#include "hand/skin/skin_body.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

/// Plane at which a body is cut; the part on the side of `outward` is removed.
struct FlatCut {
  Vector3d point, outward;  // [m], unit (3)
};

/// Implicit body as a Shape for mesh_from_distance().
class SoftShape final : public Shape {
 public:
  explicit SoftShape(const ImplicitBody& body, const std::optional<FlatCut>& cut = {})
      : body_(body), bounds_(implicit_bounds(body)), cut_(cut) {}

  [[nodiscard]] double distance(const Vector3d& p) const override {
    const double height = implicit_height(body_, p);
    return cut_ ? std::max(height, cut_->outward.dot(p - cut_->point)) : height;
  }
  [[nodiscard]] NearestSurface nearest(const Vector3d& p) const override {
    // Compute the gradient by central differences.
    const double h = 1e-6;  // step of the differences [m]
    Vector3d slope;
    for (int i = 0; i < 3; ++i)
      slope[i] = distance(p + h * Vector3d::Unit(i)) - distance(p - h * Vector3d::Unit(i));
    return {distance(p), slope.normalized()};
  }
  [[nodiscard]] Eigen::AlignedBox3d bounds() const override { return bounds_; }

 private:
  const ImplicitBody& body_;
  Eigen::AlignedBox3d bounds_;
  std::optional<FlatCut> cut_;
};

/// Throws if an edge does not belong to two triangles that run along it in opposite senses.
void require_closed(const TriangleMesh& mesh, const std::string& segment) {
  // Count edges that do not occur equally often in both senses.
  int open = 0, from = 0;
  for_each_edge(sides_by_edge(mesh), [&](const MeshSide* first, const MeshSide* last) {
    const auto up = std::count_if(first, last, [](const MeshSide& side) { return side.upwards; });
    if (2 * up == last - first) return;
    if (open++ == 0) from = first->low;
  });
  if (open == 0) return;
  const Vector3d p = mesh.vertices.col(from);
  throw InputError(fmt::format(
      "skin of segment '{}' leaks: {} edges have no triangle on one side, the first at {:.4f} "
      "{:.4f} {:.4f} m",
      segment, open, p.x(), p.y(), p.z()));
}

/// Fits the tapered capsule nearest to a skin, which remains its picture.
Solid capsule_of(TriangleMesh mesh) {
  Solid solid = build_solid({fit_tapered_capsule(mesh).shape});
  solid.visual = std::move(mesh);
  return solid;
}

/// Builds a solid from a watertight mesh.
Solid solid_of(TriangleMesh mesh, const std::string& segment) {
  require_closed(mesh, segment);
  ShapeSpec shape;
  shape.kind = ShapeKind::kMesh;
  shape.mesh = std::move(mesh);
  try {
    return build_solid({shape});
  } catch (const InputError& error) {
    throw InputError(fmt::format("skin of segment '{}': {}", segment, error.what()));
  }
}

/// Serialises everything that a body's skin depends on, as a cache key.
std::string bytes_of(const ImplicitBody& body) {
  std::string bytes;
  for (const Lump& lump : body) {
    for (const Vector3d& p : lump.core) append_bytes(bytes, p.data(), 3);
    append_bytes(bytes, lump.radius.data(), lump.radius.size());
    append_bytes(bytes, lump.flat.data(), 3);
    append_bytes(bytes, &lump.aspect, 1);
    append_bytes(bytes, &lump.blend, 1);
    bytes += lump.sheet ? 't' : 'c';
  }
  return bytes;
}

/// Meshes a body, with a flat cut if given. @throws InputError below 100 triangles
TriangleMesh mesh_of(const ImplicitBody& body, const std::optional<FlatCut>& cut, int triangles) {
  require(triangles >= 100, "a link's skin wants at least 100 triangles, got {}", triangles);
  std::string key = fmt::format("{}\n", triangles) + bytes_of(body);
  if (cut) {
    append_bytes(key, cut->point.data(), 3);
    append_bytes(key, cut->outward.data(), 3);
  }
  return cached_mesh("skin mesh 1", key, [&] {
    const SoftShape shape(body, cut);
    // Estimate the cell size from the area of an ellipsoid in the box, at two triangles per cell.
    const Vector3d size = shape.bounds().sizes();
    const double area = (size.x() * size.y() + size.y() * size.z() + size.z() * size.x()) * 1.2;
    double cell = std::sqrt(2 * area / triangles);
    // Enlarge the cells until there are few enough triangles.
    for (;;) {
      TriangleMesh mesh = mesh_from_distance(shape, cell);
      if (mesh.triangles.cols() <= triangles) return mesh;
      cell *= 1.02 * std::sqrt(static_cast<double>(mesh.triangles.cols()) / triangles);
    }
  });
}

/// Meshes the picture of a palm, extended by a wrist of about two thirds of its breadth, which is
/// cut flat a third of that behind the wrist's centre. These ratios are assumptions, chosen by eye.
/// The picture takes no part in contact.
TriangleMesh palm_picture(const PalmAnatomy& palm, ImplicitBody body, int triangles) {
  const double breadth = 0.66 * palm.breadth, depth = 0.68 * breadth, reach = 0.34 * palm.breadth;
  Lump wrist;
  wrist.radius = {std::sqrt(breadth * depth) / 2, std::sqrt(breadth * depth) / 2};
  const Vector3d end = palm.wrist - reach * palm.distal;
  wrist.core = {palm.wrist + 0.1 * palm.breadth * palm.distal, end, end};
  wrist.flat = palm.dorsal;
  wrist.aspect = breadth / depth;
  wrist.blend = palm.thickness / 2;
  body.push_back(wrist);
  return mesh_of(body, FlatCut{end, -palm.distal}, triangles);
}

/// Returns the digit of a segment; empty: none.
std::string digit_of(const HandAnatomy& hand, const std::string& segment) {
  for (const DigitAnatomy& digit : hand.digits)
    for (const DigitBone& bone : digit.bones)
      if (bone.segment == segment) return digit.name;
  return "";
}

/// Surface of a segment at the reference posture.
struct Skin {
  std::string digit, segment;
  ImplicitBody body;
  TriangleMesh mesh, picture;
};

/// Builds the skins of all segments that have links, except the user's own.
std::vector<Skin> skins_of(const HandAnatomy& hand, const Skeleton& skeleton,
                           const SkinOptions& options) {
  // Collect segments without a mesh of their own.
  std::vector<Skin> skins;
  for (const auto& [segment, body] : skin_bodies(hand))
    if (skeleton.link_of_segment.count(segment) > 0 && options.own.count(segment) == 0)
      skins.push_back({digit_of(hand, segment), segment, body, {}, {}});
  std::mutex progress_lock;
  double done = 0;
  // Mesh them in parallel, as each takes seconds.
  parallel_for(skins.size(), [&](std::size_t i) {
    Skin& skin = skins[i];
    {
      const std::lock_guard lock(progress_lock);
      options.progress(done++ / static_cast<double>(skins.size()), "skin of " + skin.segment);
    }
    const int share =
        skin.digit.empty()
            ? 2
            : 1;  // twice the triangles for the palm, with ten times the area of a phalanx
    if (options.drawn > 0)
      skin.picture = skin.digit.empty() && hand.palm
                         ? palm_picture(*hand.palm, skin.body, share * options.drawn)
                         : skin_mesh(skin.body, share * options.drawn);
    skin.mesh = skin_mesh(skin.body, share * options.triangles);
  });
  return skins;
}

}  // namespace

TriangleMesh skin_mesh(const ImplicitBody& body, int triangles) {
  return mesh_of(body, {}, triangles);
}

std::vector<LinkSurface> human_surfaces(const Subject& subject, const Skeleton& skeleton,
                                        const SkinOptions& options) {
  const HandAnatomy hand = find_anatomy(subject);
  // Make generated skins, then add the user's own.
  std::vector<Skin> skins = skins_of(hand, skeleton, options);
  for (const auto& [segment, mesh] : options.own) {
    require(find_named(subject.segments, segment) != nullptr,
            "a mesh for segment '{}', which '{}' does not have", segment, subject.name);
    skins.push_back({digit_of(hand, segment), segment, {}, mesh, {}});
  }
  std::vector<LinkSurface> surfaces;
  for (Skin& skin : skins) {
    // Skip segments that the skeleton does not keep.
    const auto link = skeleton.link_of_segment.find(skin.segment);
    if (link == skeleton.link_of_segment.end()) continue;
    const Pose<double>& at = skeleton.segment_at.at(skin.segment);
    // Transform the meshes to the hand's frame.
    for (TriangleMesh* each : {&skin.mesh, &skin.picture})
      each->vertices = ((at.R * each->vertices).colwise() + at.p).eval();
    Solid solid = options.capsules && !skin.digit.empty()
                      ? capsule_of(std::move(skin.mesh))
                      : solid_of(std::move(skin.mesh), skin.segment);
    if (!skin.picture.empty()) solid.visual = std::move(skin.picture);
    surfaces.push_back({link->second, skin.segment, skin.digit, options.material,
                        std::make_shared<const Solid>(std::move(solid))});
  }
  return surfaces;
}

SkinError capsule_error(const std::vector<LinkSurface>& surfaces) {
  SkinError error;
  double squares = 0;
  Eigen::Index corners = 0;
  for (const LinkSurface& surface : surfaces) {
    const Solid& solid = *surface.solid;
    if (solid.parts.size() != 1 || solid.parts[0].spec.kind != ShapeKind::kTaperedCapsule) continue;
    corners += solid.visual.vertices.cols();
    for (const auto& p : solid.visual.vertices.colwise()) {
      const double apart = std::abs(solid.shape->distance(p));
      squares += apart * apart;
      if (apart > error.largest) error.largest = apart, error.worst = surface.name;
    }
  }
  if (corners > 0) error.rms = std::sqrt(squares / static_cast<double>(corners));
  return error;
}

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

/// Builds shaft, base and condyles, or the tuft of a last bone.
std::vector<ShapeSpec> bone_shapes(const DigitBone& bone, bool last) {
  // Place the ends of the shaft within the flesh.
  const double r = bone.radius, thin = 0.4 * r;
  const Vector3d along = (bone.distal - bone.proximal).normalized();
  const Vector3d base = bone.proximal + 0.45 * r * along;
  const Vector3d head = bone.distal - (last ? 0.9 : 0.1) * r * along;
  const Vector3d middle = (base + head) / 2;
  // End a fingertip in a tuft, other bones in two condyles.
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

/// Builds metacarpals II to V, from the carpus to the knuckles.
std::vector<ShapeSpec> palm_shapes(const HandAnatomy& hand) {
  const PalmAnatomy& palm = *hand.palm;
  std::vector<ShapeSpec> shapes;
  for (const DigitAnatomy& digit : hand.digits) {
    if (digit.root != palm.segment || digit.name == "thumb") continue;
    // Build a shaft from the carpus to the knuckle.
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

/// Adds a surface in the hand's frame at the skeleton's reference posture.
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
