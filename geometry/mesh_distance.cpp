#include "geometry/mesh_distance.h"

#include <array>
#include <cmath>
#include <deque>
#include <iterator>
#include <mutex>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "base/lists.h"
#include "base/provenance.h"
#include "geometry/cached_mesh.h"
#include "geometry/nearest_grid.h"
#include "geometry/surface_crossings.h"
#include "geometry/triangle_tree.h"
#include "geometry/winding_number.h"

namespace thenar {
namespace {

using Eigen::Vector3d, Eigen::Vector3i;
using internal::Feature, internal::NearestTriangle, internal::TriangleForm, internal::TriangleTree;

/// Outward directions at a triangle's edges and corners.
struct Pseudonormals {
  std::array<Vector3d, 3> edge;
  std::array<Vector3d, 3> corner;
};

double angle_at(const TriangleForm& form, int k) {
  const Vector3d a = form.corner[(k + 1) % 3] - form.corner[k];
  const Vector3d b = form.corner[(k + 2) % 3] - form.corner[k];
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

std::vector<Pseudonormals> pseudonormals(const TriangleMesh& mesh, const TriangleTree& tree) {
  // Compute normals at vertices: those of the faces, weighted with their angles.
  Eigen::Matrix3Xd at_vertex = Eigen::Matrix3Xd::Zero(3, mesh.vertices.cols());
  std::vector<Vector3d> of_triangle(tree.forms().size());
  for (std::size_t i = 0; i < tree.forms().size(); ++i) {
    const TriangleForm& form = tree.forms()[i];
    const Vector3i v = mesh.triangles.col(tree.order()[i]);
    of_triangle[tree.order()[i]] = form.normal;
    for (int k = 0; k < 3; ++k) at_vertex.col(v(k)) += angle_at(form, k) * form.normal;
  }
  // List the places of the mesh's triangles in the tree.
  std::vector<int> place(tree.forms().size());  // of each of the mesh's triangles in the tree
  for (std::size_t i = 0; i < place.size(); ++i) place[tree.order()[i]] = static_cast<int>(i);
  // Compute normals at edges: the sum of both faces.
  std::vector<Pseudonormals> all(tree.forms().size());
  for_each_edge(sides_by_edge(mesh), [&](const MeshSide* first, const MeshSide* last) {
    Vector3d sum = Vector3d::Zero();
    for (const MeshSide* side = first; side != last; ++side) sum += of_triangle[side->triangle];
    for (const MeshSide* side = first; side != last; ++side)
      all[place[side->triangle]].edge[side->side] = sum;
  });
  // Give each corner the normal of its vertex.
  for (std::size_t i = 0; i < all.size(); ++i)
    for (int k = 0; k < 3; ++k)
      all[i].corner[k] = at_vertex.col(mesh.triangles(k, tree.order()[i]));
  return all;
}

constexpr double kOnSurface = 1e-12;  // distance within which a point is on the surface [m]

/// A surface that goes through itself nowhere: the side of its nearest feature decides.
class MeshDistance final : public Shape {
 public:
  MeshDistance(const TriangleMesh& mesh, TriangleTree tree)
      : tree_(std::move(tree)), grid_(tree_), normals_(pseudonormals(mesh, tree_)) {}

  double distance(const Vector3d& p) const override {
    const NearestTriangle near = grid_.nearest(p, tree_);
    const double distance = std::sqrt(near.foot.squared);
    return outward(near).dot(p - near.foot.point) < 0 ? -distance : distance;
  }

  NearestSurface nearest(const Vector3d& p) const override {
    const NearestTriangle near = grid_.nearest(p, tree_);
    const double distance = std::sqrt(near.foot.squared);
    const Vector3d out = outward(near), arm = p - near.foot.point;
    const double sign = out.dot(arm) < 0 ? -1 : 1;
    // On the surface the way to it has no direction left.
    if (near.foot.feature.kind == Feature::kFace || distance < kOnSurface)
      return {sign * distance, out.normalized()};
    return {sign * distance, sign / distance * arm};
  }

  Eigen::AlignedBox3d bounds() const override { return tree_.bounds(); }

 private:
  const Vector3d& outward(const NearestTriangle& near) const {
    const Feature& feature = near.foot.feature;
    if (feature.kind == Feature::kFace) return tree_.forms()[near.triangle].normal;
    const Pseudonormals& normals = normals_[near.triangle];
    return feature.kind == Feature::kEdge ? normals.edge[feature.k] : normals.corner[feature.k];
  }

  TriangleTree tree_;
  internal::NearestGrid grid_;
  std::vector<Pseudonormals> normals_;
};

/// Triangles of a surface without those that have the same on both sides: all inside or all
/// outside. Triangles that meet others are kept, as their parts may differ.
/// @param meeting  crossing_triangles()
TriangleMesh boundary_of(const TriangleMesh& mesh, const TriangleTree& tree,
                         const std::vector<bool>& meeting) {
  const double off = 1e-9 * tree.bounds().diagonal().norm();  // nearer than what meets nothing
  TriangleMesh kept{mesh.vertices, Eigen::Matrix3Xi(3, mesh.triangles.cols())};
  Eigen::Index count = 0;
  for (std::size_t i = 0; i < tree.forms().size(); ++i) {
    const TriangleForm& form = tree.forms()[i];
    const int number = tree.order()[i];
    const Vector3d outside =
        (form.corner[0] + form.corner[1] + form.corner[2]) / 3 + off * form.normal;
    // The winding number falls by one to the outer side.
    if (meeting[number] || internal::winding_number(tree, outside) == 0)
      kept.triangles.col(count++) = mesh.triangles.col(number);
  }
  kept.triangles.conservativeResize(3, count);
  return count == 0 ? mesh : kept;
}

/// A surface that goes through itself: inside is what it winds around more often outwards than
/// inwards. Where it lies twice over the inside, the depth is a lower bound.
class CrossedMeshDistance final : public Shape {
 public:
  CrossedMeshDistance(const TriangleMesh& mesh, TriangleTree whole,
                      const std::vector<bool>& meeting)
      : whole_(std::move(whole)), tree_(boundary_of(mesh, whole_, meeting)), grid_(tree_) {}

  double distance(const Vector3d& p) const override {
    return sign(p) * std::sqrt(grid_.nearest(p, tree_).foot.squared);
  }

  NearestSurface nearest(const Vector3d& p) const override {
    const NearestTriangle near = grid_.nearest(p, tree_);
    const double distance = std::sqrt(near.foot.squared), side = sign(p);
    if (distance < kOnSurface) return {side * distance, tree_.forms()[near.triangle].normal};
    return {side * distance, side / distance * (p - near.foot.point)};
  }

  Eigen::AlignedBox3d bounds() const override { return tree_.bounds(); }

 private:
  double sign(const Vector3d& p) const { return internal::winding_number(whole_, p) > 0 ? -1 : 1; }

  TriangleTree whole_;
  TriangleTree tree_;  // of the boundary
  internal::NearestGrid grid_;
};

std::shared_ptr<const Shape> made(const TriangleMesh& mesh) {
  TriangleTree tree(mesh);
  const std::vector<bool> meeting = internal::crossing_triangles(mesh, tree);
  if (!contains(meeting, true)) return std::make_shared<MeshDistance>(mesh, std::move(tree));
  return std::make_shared<CrossedMeshDistance>(mesh, std::move(tree), meeting);
}

/// Meshes in use, and the last ones that were: a hand is built several times from the same links.
/// Sharing shows in time and memory alone, as distances are constant.
class Recent {
 public:
  std::shared_ptr<const Shape> find(const std::string& content) {
    const std::lock_guard lock(mutex_);
    const auto found = known_.find(content);
    return found == known_.end() ? nullptr : found->second.lock();
  }

  void add(const std::string& content, const std::shared_ptr<const Shape>& shape,
           Eigen::Index triangles) {
    const std::lock_guard lock(mutex_);
    // Forget meshes that are gone.
    for (auto at = known_.begin(); at != known_.end();)
      at = at->second.expired() ? known_.erase(at) : std::next(at);
    known_[content] = shape;
    // Hold on to this one, and let the oldest go.
    held_.emplace_back(shape, triangles);
    triangles_ += triangles;
    while (triangles_ > kMax) {
      triangles_ -= held_.front().second;
      held_.pop_front();
    }
  }

 private:
  // Maximum number of triangles of unused meshes that are kept, 0.1 GB
  static constexpr Eigen::Index kMax = 200'000;

  std::mutex mutex_;
  std::unordered_map<std::string, std::weak_ptr<const Shape>> known_;  // by content
  std::deque<std::pair<std::shared_ptr<const Shape>, Eigen::Index>> held_;
  Eigen::Index triangles_ = 0;
};

}  // namespace

bool goes_through_itself(const Shape& shape) {
  return dynamic_cast<const CrossedMeshDistance*>(&shape) != nullptr;
}

std::shared_ptr<const Shape> build_mesh_distance(const TriangleMesh& mesh) {
  static Recent recent;
  // Return the shape of the same content, if there is one.
  const std::string content = sha256(bytes_of(mesh));
  if (std::shared_ptr<const Shape> shape = recent.find(content)) return shape;
  std::shared_ptr<const Shape> shape = made(mesh);
  recent.add(content, shape, mesh.triangles.cols());
  return shape;
}

}  // namespace thenar
