#include "geometry/mesh_from_distance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>
#include <vector>

#include "base/error.h"

namespace thenar {
namespace {

using Eigen::Vector3d, Eigen::Vector3i;

// Corner c of a cell stands at (c & 1, c >> 1 & 1, c >> 2 & 1). Edge 4 a + i of it runs along axis
// a from corner low_corner(e).
int low_corner(int edge) {
  const int axis = edge / 4, u = (axis + 1) % 3, v = (axis + 2) % 3;
  return (edge & 1) << u | (edge >> 1 & 1) << v;
}
int high_corner(int edge) { return low_corner(edge) | 1 << edge / 4; }
int edge_between(int a, int b) {
  for (int edge = 0;; ++edge)
    if ((low_corner(edge) | high_corner(edge) << 3) == (std::min(a, b) | std::max(a, b) << 3))
      return edge;
}

/// Visits the nodes from `low` up to, but not including, `high`, along x first.
template <typename Visit>
void for_each_node(const Vector3i& low, const Vector3i& high, int step, const Visit& visit) {
  Vector3i node;
  for (node.z() = low.z(); node.z() < high.z(); node.z() += step)
    for (node.y() = low.y(); node.y() < high.y(); node.y() += step)
      for (node.x() = low.x(); node.x() < high.x(); node.x() += step) visit(node);
}

/// Patches of the surface in a cell, by the set of its corners that are inside (bits).
struct Passage {
  int patches = 0;
  std::array<int, 12> patch_of_edge;  // -1: both ends on one side
};

/// Edges that the surface crosses in a cell with these corners inside (bits), in groups. Crossed
/// edges of a face belong to one group; of four, those around an inner corner.
class EdgeGroups {
 public:
  explicit EdgeGroups(int inside) : inside_(inside) {
    // Give each crossed edge a group of its own.
    for (int edge = 0; edge < 12; ++edge)
      group_[edge] = is_in(low_corner(edge)) != is_in(high_corner(edge)) ? edge : -1;
    for (int axis = 0; axis < 3; ++axis)
      for (int side = 0; side < 2; ++side) {
        const int u = 1 << (axis + 1) % 3, v = 1 << (axis + 2) % 3, base = side << axis;
        join_across({base, base | u, base | u | v, base | v});
      }
  }

  /// -1: the edge is not crossed.
  [[nodiscard]] int of(int edge) const { return group_[edge]; }

 private:
  [[nodiscard]] bool is_in(int corner) const { return (inside_ >> corner & 1) != 0; }

  void join(int a, int b) {
    const int from = group_[a], to = group_[b];
    for (int& g : group_) g = g == from ? to : g;
  }

  /// Joins the crossed edges of a face. @param ring  its corners, one after the other
  void join_across(const std::array<int, 4>& ring) {
    std::vector<int> crossed;
    for (int k = 0; k < 4; ++k)
      if (is_in(ring[k]) != is_in(ring[(k + 1) % 4]))
        crossed.push_back(edge_between(ring[k], ring[(k + 1) % 4]));
    if (crossed.size() == 2) join(crossed[0], crossed[1]);
    if (crossed.size() != 4) return;
    for (int k = 0; k < 4; ++k)
      if (is_in(ring[k]))
        join(edge_between(ring[k], ring[(k + 1) % 4]), edge_between(ring[k], ring[(k + 3) % 4]));
  }

  int inside_;
  std::array<int, 12> group_;
};

Passage passage_of(int inside) {
  const EdgeGroups groups(inside);
  // Number the groups.
  Passage passage;
  std::array<int, 12> number;
  number.fill(-1);
  passage.patch_of_edge.fill(-1);
  for (int edge = 0; edge < 12; ++edge) {
    if (groups.of(edge) < 0) continue;
    int& n = number[groups.of(edge)];
    if (n < 0) n = passage.patches++;
    passage.patch_of_edge[edge] = n;
  }
  return passage;
}

const std::array<Passage, 256>& passages() {
  static const std::array<Passage, 256> all = [] {
    std::array<Passage, 256> made;
    for (int inside = 0; inside < 256; ++inside) made[inside] = passage_of(inside);
    return made;
  }();
  return all;
}

/// Distances at the nodes of a cubic grid whose two outermost layers lie outside.
class Grid {
 public:
  Grid(const Shape& solid, double cell) : cell_(cell) {
    // Lay out nodes from beyond one corner of the box to beyond the other.
    require(cell > 0 && std::isfinite(cell), "a cell must be positive and finite, got {} m", cell);
    const Eigen::AlignedBox3d box = solid.bounds();
    origin_ = box.min().array() - 1.5 * cell;
    const Eigen::Array3d nodes = (box.sizes().array() / cell).ceil() + 4;
    require(nodes.prod() < 1e8, "cells of {} m are too small for a solid of {} m: {} nodes", cell,
            box.sizes().maxCoeff(), nodes.prod());
    size_ = nodes.cast<int>();
    value_.resize(nodes.prod());
    // Compute the distances block by block.
    for_each_node(Vector3i::Zero(), size_, kBlockCubes,
                  [&](const Vector3i& low) { fill_block(solid, low); });
  }
  [[nodiscard]] const Vector3i& size() const { return size_; }
  [[nodiscard]] Vector3d at(const Vector3i& node) const {
    return origin_ + cell_ * node.cast<double>();
  }
  [[nodiscard]] int index(const Vector3i& node) const {
    return node.x() + size_.x() * (node.y() + size_.y() * node.z());
  }
  [[nodiscard]] double value(const Vector3i& node) const { return value_[index(node)]; }
  [[nodiscard]] bool inside(const Vector3i& node) const { return value(node) < 0; }

 private:
  static constexpr int kBlockCubes = 6;  // Cubes along one edge of a block

  /// Far from the surface the middle of a block speaks for all of it.
  void fill_block(const Shape& solid, const Vector3i& low) {
    // Compute the middle of the block, and a bound of its nodes' distance from it.
    const Vector3i high = (low.array() + kBlockCubes).min(size_.array());
    const double reach = cell_ * std::sqrt(3.0) / 2 * (kBlockCubes - 1) + 2 * solid.accuracy();
    const double middle =
        solid.distance(at(low) + Vector3d::Constant(cell_ / 2 * (kBlockCubes - 1)));
    const bool far = std::abs(middle) > reach;
    // Evaluate nodes near the surface one by one; the border counts as outside.
    for_each_node(low, high, 1, [&](const Vector3i& node) {
      double& value = value_[index(node)];
      value = far ? middle : solid.distance(at(node));
      const bool border = (node.array() < 2).any() || (node.array() > size_.array() - 3).any();
      if (border) value = std::max(value, 1e-12 * cell_);
    });
  }

  double cell_;
  Vector3d origin_;
  Vector3i size_;
  std::vector<double> value_;
};

class Mesher {
 public:
  Mesher(const Shape& solid, double cell) : solid_(solid), cell_(cell), grid_(solid, cell) {}

  TriangleMesh run() {
    // Place vertices, then add a face for every crossed edge of the grid.
    place_patches();
    for_each(Vector3i(1, 1, 1), [&](const Vector3i& node) {
      for (int axis = 0; axis < 3; ++axis)
        if (grid_.inside(node) != grid_.inside(node + Vector3i::Unit(axis))) add_face(node, axis);
    });
    return {as_columns(vertices_), as_columns(triangles_)};
  }

 private:
  /// Nodes from `first` that have a neighbour in every direction.
  template <typename Visit>
  void for_each(const Vector3i& first, const Visit& visit) const {
    for_each_node(first, grid_.size() - Vector3i::Ones(), 1, visit);
  }

  static Vector3i corner(int c) { return {c & 1, c >> 1 & 1, c >> 2 & 1}; }

  [[nodiscard]] int inside_corners(const Vector3i& cell) const {
    int bits = 0;
    for (int c = 0; c < 8; ++c) bits |= (grid_.inside(cell + corner(c)) ? 1 : 0) << c;
    return bits;
  }

  /// Returns the point where the surface crosses an edge of the grid, as if the distance were
  /// linear.
  [[nodiscard]] Vector3d crossing(const Vector3i& a, const Vector3i& b) const {
    const double share = grid_.value(a) / (grid_.value(a) - grid_.value(b));
    return grid_.at(a) + share * (grid_.at(b) - grid_.at(a));
  }

  int add_vertex(Vector3d p) {
    // Move it onto the surface, unless that leads too far.
    const Vector3d start = p;
    for (int i = 0; i < 8; ++i) {
      const NearestSurface near = solid_.nearest(p);
      if (!(std::abs(near.distance) > 1e-9 * cell_)) break;
      p -= near.distance * near.normal;
    }
    vertices_.push_back((p - start).norm() < cell_ ? p : start);
    return static_cast<int>(vertices_.size()) - 1;
  }

  void place_patches() {
    first_patch_.assign(static_cast<std::size_t>(grid_.index(grid_.size())), -1);
    // Place one vertex for each patch of each cell: the mean of its crossings.
    for_each(Vector3i::Zero(), [&](const Vector3i& cell) {
      const int inside = inside_corners(cell);
      const Passage& passage = passages()[inside];
      if (passage.patches == 0) return;
      first_patch_[grid_.index(cell)] = static_cast<int>(vertices_.size());
      for (int patch = 0; patch < passage.patches; ++patch) {
        Vector3d sum = Vector3d::Zero();
        int crossed = 0;
        for (int edge = 0; edge < 12; ++edge) {
          if (passage.patch_of_edge[edge] != patch) continue;
          sum += crossing(cell + corner(low_corner(edge)), cell + corner(high_corner(edge)));
          ++crossed;
        }
        add_vertex(sum / crossed);
      }
    });
  }

  /// The vertex of the patch that crosses an edge of a cell.
  [[nodiscard]] int patch(const Vector3i& cell, const Vector3i& node, int axis) const {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const int edge = 4 * axis + (node(u) - cell(u)) + 2 * (node(v) - cell(v));
    return first_patch_[grid_.index(cell)] + passages()[inside_corners(cell)].patch_of_edge[edge];
  }

  /// Quadrilateral of the four cells around the edge from `node` along `axis`.
  void add_face(const Vector3i& node, int axis) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    // Collect the ring of patches around the edge, with the middles of saddle faces between them.
    const Vector3i du = Vector3i::Unit(u), dv = Vector3i::Unit(v);
    // List cells counterclockwise seen from the high end, and the in-plane way to the face after
    // each.
    const std::array<Vector3i, 4> cells{node, node - du, node - du - dv, node - dv};
    const std::array<Vector3i, 4> ways{dv, Vector3i(-du), Vector3i(-dv), du};
    ring_.clear();
    int first = -1;  // where the fan begins: no diagonal may run between cells that share a face
    for (int k = 0; k < 4; ++k) {
      ring_.push_back(patch(cells[k], node, axis));
      const int middle = middle_of_saddle(node, axis, ways[k]);
      if (middle < 0) continue;
      first = static_cast<int>(ring_.size());
      ring_.push_back(middle);
    }
    // Without a saddle, take the shorter diagonal.
    const auto length = [&](int a, int b) {
      return (vertices_[ring_[a]] - vertices_[ring_[b]]).norm();
    };
    if (first < 0) first = length(1, 3) < length(0, 2) ? 1 : 0;
    // Add a fan, facing outwards.
    std::rotate(ring_.begin(), ring_.begin() + first, ring_.end());
    if (!grid_.inside(node)) std::reverse(ring_.begin() + 1, ring_.end());
    for (std::size_t k = 1; k + 1 < ring_.size(); ++k)
      triangles_.emplace_back(ring_[0], ring_[k], ring_[k + 1]);
  }

  /// Two strips of surface pass through a face whose corners alternate: each gets a vertex of its
  /// own there, lest their edges coincide. -1: no such face.
  int middle_of_saddle(const Vector3i& node, int axis, const Vector3i& way) {
    const Vector3i other = node + Vector3i::Unit(axis);
    // Consider only faces whose corners alternate.
    const bool in = grid_.inside(node);
    if (grid_.inside(node + way) == in || grid_.inside(other + way) != in) return -1;
    const Vector3i& inner = in ? node : other;
    const Vector3i along = in ? other : node;
    // Add one vertex for each inner corner of such a face.
    const Vector3i low = node.cwiseMin(node + way);
    const auto key = std::make_tuple(grid_.index(low), 3 - axis - axis_of(way), grid_.index(inner));
    const auto found = saddles_.find(key);
    if (found != saddles_.end()) return found->second;
    return saddles_[key] = add_vertex((crossing(inner, along) + crossing(inner, inner + way)) / 2);
  }
  static int axis_of(const Vector3i& way) {
    Eigen::Index axis;
    way.cwiseAbs().maxCoeff(&axis);
    return static_cast<int>(axis);
  }

  const Shape& solid_;
  double cell_;
  Grid grid_;
  std::vector<int> first_patch_;                      // by cell, vertex; -1: none
  std::map<std::tuple<int, int, int>, int> saddles_;  // face, its normal's axis, inner node
  std::vector<Vector3d> vertices_;
  std::vector<Vector3i> triangles_;
  std::vector<int> ring_;  // vertices around the edge at hand
};

}  // namespace

TriangleMesh mesh_from_distance(const Shape& solid, double cell) {
  return Mesher(solid, cell).run();
}

}  // namespace thenar
