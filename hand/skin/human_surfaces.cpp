#include "hand/skin/human_surfaces.h"

#include <cmath>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "base/error.h"
#include "base/shapes/mesh_from_distance.h"
#include "hand/skin/hand_anatomy.h"
#include "hand/skin/skin_body.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

/// A soft body as far as mesh_from_distance() asks.
class SoftShape final : public Shape {
 public:
  explicit SoftShape(const SoftBody& body) : body_(body), bounds_(soft_bounds(body)) {}

  [[nodiscard]] double distance(const Vector3d& p) const override { return soft_height(body_, p); }
  [[nodiscard]] NearestSurface nearest(const Vector3d& p) const override {
    const double h = 1e-6;  // [m]
    Vector3d slope;
    for (int i = 0; i < 3; ++i)
      slope[i] = distance(p + h * Vector3d::Unit(i)) - distance(p - h * Vector3d::Unit(i));
    return {distance(p), slope.normalized()};
  }
  [[nodiscard]] Eigen::AlignedBox3d bounds() const override { return bounds_; }

 private:
  const SoftBody& body_;
  Eigen::AlignedBox3d bounds_;
};

const Segment& segment_named(const Subject& subject, const std::string& name) {
  for (const Segment& segment : subject.segments)
    if (segment.name == name) return segment;
  throw InputError(
      fmt::format("a mesh for segment '{}', which '{}' does not have", name, subject.name));
}

/// Throws if an edge does not belong to two triangles that walk it in opposite ways.
void require_closed(const TriangleMesh& mesh, const std::string& segment) {
  std::map<std::pair<int, int>, int> edges;
  for (const Eigen::Vector3i& corner : mesh.triangles.colwise())
    for (int i = 0; i < 3; ++i) ++edges[{corner[i], corner[(i + 1) % 3]}];
  int open = 0, from = 0;
  for (const auto& [edge, count] : edges) {
    const auto back = edges.find({edge.second, edge.first});
    if (back != edges.end() && back->second == count) continue;
    if (open++ == 0) from = edge.first;
  }
  if (open == 0) return;
  const Vector3d p = mesh.vertices.col(from);
  throw InputError(fmt::format(
      "skin of segment '{}' leaks: {} edges have no triangle on one side, the first at {:.4f} "
      "{:.4f} {:.4f} m",
      segment, open, p.x(), p.y(), p.z()));
}

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

/// Lays surfaces on the links of a skeleton.
class SkinMaker {
 public:
  SkinMaker(const Skeleton& skeleton, const SkinOptions& options)
      : skeleton_(skeleton), options_(options) {}

  void add(const std::string& digit, const std::string& segment, const SoftBody& body) {
    if (options_.own.count(segment) > 0) return;
    const int share = digit.empty() ? 2 : 1;  // the palm has ten times the area of a phalanx
    TriangleMesh picture;
    if (options_.drawn > 0) picture = skin_mesh(body, share * options_.drawn);
    add(digit, segment, skin_mesh(body, share * options_.triangles), std::move(picture));
  }

  /// @param picture  empty: the mesh itself
  void add(const std::string& digit, const std::string& segment, TriangleMesh mesh,
           TriangleMesh picture = {}) {
    const auto link = skeleton_.link_of_segment.find(segment);
    if (link == skeleton_.link_of_segment.end()) return;
    const Pose<double>& at = skeleton_.segment_at.at(segment);
    for (TriangleMesh* each : {&mesh, &picture})
      each->vertices = ((at.R * each->vertices).colwise() + at.p).eval();
    Solid solid = solid_of(std::move(mesh), segment);
    if (!picture.empty()) solid.picture = std::move(picture);
    surfaces_.push_back({link->second, segment, digit, options_.material,
                         std::make_shared<const Solid>(std::move(solid))});
  }

  std::vector<LinkSurface> take() { return std::move(surfaces_); }

 private:
  const Skeleton& skeleton_;
  const SkinOptions& options_;
  std::vector<LinkSurface> surfaces_;
};

std::string digit_of(const HandAnatomy& hand, const std::string& segment) {
  for (const DigitAnatomy& digit : hand.digits)
    for (const DigitBone& bone : digit.bones)
      if (bone.segment == segment) return digit.name;
  return "";
}

}  // namespace

TriangleMesh skin_mesh(const SoftBody& body, int triangles) {
  require(triangles >= 100, "a link's skin wants at least 100 triangles, got {}", triangles);
  const SoftShape shape(body);
  // A body of this box has about the area of an ellipsoid in it; two triangles a cell.
  const Vector3d size = shape.bounds().sizes();
  const double area = (size.x() * size.y() + size.y() * size.z() + size.z() * size.x()) * 1.2;
  double cell = std::sqrt(2 * area / triangles);
  for (;;) {
    TriangleMesh mesh = mesh_from_distance(shape, cell);
    if (mesh.triangles.cols() <= triangles) return mesh;
    cell *= 1.02 * std::sqrt(static_cast<double>(mesh.triangles.cols()) / triangles);
  }
}

std::vector<LinkSurface> human_surfaces(const Subject& subject, const Skeleton& skeleton,
                                        const SkinOptions& options) {
  const HandAnatomy hand = find_anatomy(subject);
  SkinMaker maker(skeleton, options);
  const std::map<std::string, SoftBody> bodies = skin_bodies(hand);
  double done = 0;
  for (const auto& [segment, body] : bodies) {
    options.progress(done++ / static_cast<double>(bodies.size()), "skin of " + segment);
    if (skeleton.link_of_segment.count(segment) > 0)
      maker.add(digit_of(hand, segment), segment, body);
  }
  for (const auto& [segment, mesh] : options.own)
    maker.add(digit_of(hand, segment), segment_named(subject, segment).name, mesh);
  return maker.take();
}

}  // namespace thenar
