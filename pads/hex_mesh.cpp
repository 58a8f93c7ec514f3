#include "pads/hex_mesh.h"

#include <algorithm>

#include <Eigen/Geometry>

#include "base/error.h"
#include "base/lists.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

std::array<int, 4> sorted(std::array<int, 4> a) {
  std::sort(a.begin(), a.end());
  return a;
}

}  // namespace

const std::array<std::array<int, 2>, 12>& hex_edges() {
  static const std::array<std::array<int, 2>, 12> edges = [] {
    std::array<std::array<int, 2>, 12> out{};
    // Join corners whose numbers differ in one bit.
    std::size_t k = 0;
    for (const int axis : {1, 2, 4})
      for (int corner = 0; corner < 8; ++corner)
        if ((corner & axis) == 0) out[k++] = {corner, corner | axis};
    return out;
  }();
  return edges;
}

const std::array<std::array<int, 4>, 6>& hex_faces() {
  static const std::array<std::array<int, 4>, 6> faces = [] {
    std::array<std::array<int, 4>, 6> out{};
    // Collect corners with the same bit of `normal`, in the order 0, u, v, u + v.
    const std::array<std::array<int, 3>, 3> axes{{{1, 2, 4}, {2, 4, 1}, {4, 1, 2}}};
    std::size_t k = 0;
    for (const auto& [normal, u, v] : axes)
      for (const int side : {0, normal}) out[k++] = {side, side | u, side | v, side | u | v};
    return out;
  }();
  return faces;
}

Eigen::Matrix3Xd rest_positions(const HexMesh& mesh) {
  Eigen::Matrix3Xd places(3, mesh.nodes());
  for (int node = 0; node < mesh.nodes(); ++node) places.col(node) = mesh.place(node);
  return places;
}

std::vector<HexFace> marked_faces(const HexMesh& mesh, const std::vector<bool>& marked) {
  std::vector<HexFace> out;
  for (const int index : mesh.active()) {
    const auto& corners = mesh.cells()[index].corners;
    for (const std::array<int, 4>& face : hex_faces()) {
      HexFace found{index, {}};
      for (std::size_t i = 0; i < 4; ++i) found.nodes[i] = corners[face[i]];
      if (all_of(found.nodes, [&](int node) { return marked[node]; })) out.push_back(found);
    }
  }
  return out;
}

std::size_t lattice_index(int a, int b) {
  // Add the bits of both corners to 0, 1 or 2 along each axis.
  int place = 0, step = 1;
  for (const int axis : {1, 2, 4}) {
    place += step * (((a & axis) != 0 ? 1 : 0) + ((b & axis) != 0 ? 1 : 0));
    step *= 3;
  }
  return static_cast<std::size_t>(place);
}

HexMesh::HexMesh(std::shared_ptr<const HexChart> chart, const Eigen::Matrix3Xd& points,
                 std::vector<HexCell> cells)
    : chart_(std::move(chart)), cells_(std::move(cells)) {
  for (Eigen::Index i = 0; i < points.cols(); ++i) add_node(points.col(i), {});
  for (std::size_t c = 0; c < cells_.size(); ++c) {
    const HexCell& cell = cells_[c];
    for (const int node : cell.corners)
      require(node >= 0 && node < nodes(), "cell {} has no node {}", c, node);
    // Check that the three edges at each corner are right-handed.
    for (int corner = 0; corner < 8; ++corner) {
      const auto along = [&](int axis) -> Vector3d {
        const auto there = static_cast<std::size_t>(corner ^ axis);
        const Vector3d way = place(cell.corners[there]) - place(cell.corners[corner]);
        return (corner & axis) != 0 ? Vector3d(-way) : way;
      };
      require(along(1).cross(along(2)).dot(along(4)) > 0, "cell {} is inverted at corner {}", c,
              corner);
    }
  }
  list_active();
}

int HexMesh::add_node(const Vector3d& c, std::vector<NodeWeight> from) {
  chart_points_.push_back(c);
  on_chart_.push_back(chart_->place(c));
  places_.push_back(on_chart_.back());
  made_from_.push_back(std::move(from));
  return nodes() - 1;
}

int HexMesh::middle_of_edge(int a, int b) {
  const auto [at, is_new] = edges_.try_emplace(std::minmax(a, b), nodes());
  if (is_new) add_node(chart_->middle(chart_point(a), chart_point(b)), {{a, 0.5}, {b, 0.5}});
  return at->second;
}

int HexMesh::middle_of_face(const std::array<int, 4>& corners) {
  const auto at = faces_.find(sorted(corners));
  if (at != faces_.end()) return at->second;
  // Average the middles of its four edges.
  Vector3d sum(0, 0, 0);
  for (const auto& [i, j] : {std::pair(0, 1), std::pair(0, 2), std::pair(1, 3), std::pair(2, 3)})
    sum += chart_point(middle_of_edge(corners[i], corners[j]));
  std::vector<NodeWeight> from;
  for (const int corner : corners) from.push_back({corner, 0.25});
  const int node =
      add_node(chart_->middle_of_face({chart_point(corners[0]), chart_point(corners[1]),
                                       chart_point(corners[2]), chart_point(corners[3])},
                                      sum / 4),
               std::move(from));
  faces_.emplace(sorted(corners), node);
  return node;
}

void HexMesh::split(int index) {
  if (cells_[index].first_child >= 0) return;
  const HexCell cell = cells_[index];
  // Collect the 27 nodes: corners, middles of edges and faces.
  std::array<int, 27> lattice{};
  const auto node_of = [&](int corner) { return cell.corners[corner]; };
  for (int c = 0; c < 8; ++c) lattice[lattice_index(c, c)] = node_of(c);
  for (const auto& [a, b] : hex_edges())
    lattice[lattice_index(a, b)] = middle_of_edge(node_of(a), node_of(b));
  Vector3d sum(0, 0, 0);
  for (const std::array<int, 4>& face : hex_faces()) {
    const int middle =
        middle_of_face({node_of(face[0]), node_of(face[1]), node_of(face[2]), node_of(face[3])});
    lattice[lattice_index(face[0], face[3])] = middle;
    sum += chart_point(middle);
  }
  // Add the middle of the cell, the mean of the middles of its faces.
  std::vector<NodeWeight> from;
  for (const int corner : cell.corners) from.push_back({corner, 0.125});
  lattice[lattice_index(0, 7)] = add_node(sum / 6, std::move(from));
  // Add eight children.
  cells_[index].first_child = static_cast<int>(cells_.size());
  for (int child = 0; child < 8; ++child) {
    HexCell part;
    part.region = cell.region;
    part.level = cell.level + 1;
    part.parent = index;
    for (int c = 0; c < 8; ++c) part.corners[c] = lattice[lattice_index(child, c)];
    cells_.push_back(part);
  }
}

int HexMesh::edge_node_in_use(int a, int b) const {
  const auto at = edges_.find(std::minmax(a, b));
  return at != edges_.end() && in_use(at->second) ? at->second : -1;
}

bool HexMesh::must_split(const HexCell& cell) const {
  const auto node_of = [&](int corner) { return cell.corners[corner]; };
  // Look for a half of an edge that is split again: the neighbour is two levels finer.
  for (const auto& [a, b] : hex_edges()) {
    const int middle = edge_node_in_use(node_of(a), node_of(b));
    if (middle < 0) continue;
    if (edge_node_in_use(node_of(a), middle) >= 0 || edge_node_in_use(middle, node_of(b)) >= 0)
      return true;
  }
  // Look for a split line between the middles of an edge and of a face.
  for (const std::array<int, 4>& face : hex_faces()) {
    const std::array<int, 4> corners{node_of(face[0]), node_of(face[1]), node_of(face[2]),
                                     node_of(face[3])};
    const auto at = faces_.find(sorted(corners));
    if (at == faces_.end() || !in_use(at->second)) continue;
    for (const auto& [i, j] :
         {std::pair(0, 1), std::pair(0, 2), std::pair(1, 3), std::pair(2, 3)}) {
      const int middle = edge_node_in_use(corners[i], corners[j]);
      if (middle >= 0 && edge_node_in_use(middle, at->second) >= 0) return true;
    }
  }
  return false;
}

std::vector<NodeWeight> HexMesh::support(int node) const {
  return masters(node).empty() ? std::vector<NodeWeight>{{node, 1}} : masters(node);
}

void HexMesh::refine(const std::vector<int>& cells) {
  for (const int cell : cells) split(cell);
  // Split further cells until neighbours differ by one level at most.
  for (bool any = true; any;) {
    any = false;
    list_active();
    const std::vector<int> now = active_;
    for (const int cell : now)
      if (must_split(cells_[cell])) {
        split(cell);
        any = true;
      }
  }
}

void HexMesh::list_active() {
  // Descend from the coarsest cells.
  active_.clear();
  std::vector<int> open;
  for (std::size_t c = 0; c < cells_.size(); ++c)
    if (cells_[c].parent < 0) open.push_back(static_cast<int>(c));
  while (!open.empty()) {
    const int cell = open.back();
    open.pop_back();
    const int child = cells_[cell].first_child;
    if (child < 0)
      active_.push_back(cell);
    else
      for (int k = 0; k < 8; ++k) open.push_back(child + k);
  }
  std::sort(active_.begin(), active_.end());
  // Mark the nodes of active cells as used.
  in_use_.assign(chart_points_.size(), false);
  for (const int cell : active_)
    for (const int node : cells_[cell].corners) in_use_[node] = true;
  find_hanging();
}

void HexMesh::find_hanging() {
  masters_.assign(chart_points_.size(), {});
  // Find used middles of the edges and faces of active cells, which hang.
  for (const int index : active_) {
    const HexCell& cell = cells_[index];
    const auto node_of = [&](int corner) { return cell.corners[corner]; };
    for (const auto& [a, b] : hex_edges()) {
      const int middle = edge_node_in_use(node_of(a), node_of(b));
      if (middle >= 0) masters_[middle] = {{node_of(a), 0.5}, {node_of(b), 0.5}};
    }
    for (const std::array<int, 4>& face : hex_faces()) {
      const std::array<int, 4> corners{node_of(face[0]), node_of(face[1]), node_of(face[2]),
                                       node_of(face[3])};
      const auto at = faces_.find(sorted(corners));
      if (at == faces_.end() || !in_use(at->second)) continue;
      std::vector<NodeWeight>& from = masters_[at->second];
      from.clear();
      for (const int corner : corners) from.push_back({corner, 0.25});
    }
  }
  // Replace masters that hang themselves by their own masters, which are coarser.
  for (std::vector<NodeWeight>& from : masters_)
    for (std::size_t k = 0; k < from.size();) {
      const NodeWeight at = from[k];
      const std::vector<NodeWeight>& theirs = masters_[at.node];
      if (theirs.empty()) {
        ++k;
        continue;
      }
      from.erase(from.begin() + static_cast<std::ptrdiff_t>(k));
      for (const NodeWeight& each : std::vector<NodeWeight>(theirs)) {
        const auto is_same = [&](const NodeWeight& other) { return other.node == each.node; };
        if (NodeWeight* same = find_where(from, is_same))
          same->weight += at.weight * each.weight;
        else
          from.push_back({each.node, at.weight * each.weight});
      }
      k = 0;
    }
  // Place hanging nodes at the mean of their masters; otherwise a rigid rotation would cause
  // strain.
  places_ = on_chart_;
  for (std::size_t node = 0; node < places_.size(); ++node) {
    if (masters_[node].empty()) continue;
    places_[node].setZero();
    for (const NodeWeight& each : masters_[node])
      places_[node] += each.weight * on_chart_[each.node];
  }
}

HexMesh box_mesh(const Vector3d& size, const Eigen::Vector3i& cells) {
  class Straight final : public HexChart {
   public:
    [[nodiscard]] Vector3d place(const Vector3d& c) const override { return c; }
  };
  // Create the lattice of points, first axis fastest.
  const Eigen::Vector3i points = cells.array() + 1;
  Eigen::Matrix3Xd at(3, points.prod());
  const auto node = [&](int i, int j, int k) { return (k * points[1] + j) * points[0] + i; };
  for (int k = 0; k < points[2]; ++k)
    for (int j = 0; j < points[1]; ++j)
      for (int i = 0; i < points[0]; ++i)
        at.col(node(i, j, k)) =
            Vector3d(i, j, k).cwiseQuotient(cells.cast<double>()).cwiseProduct(size);
  // Create the cells; the bits of a corner are its steps along the axes.
  std::vector<HexCell> list;
  for (int k = 0; k < cells[2]; ++k)
    for (int j = 0; j < cells[1]; ++j)
      for (int i = 0; i < cells[0]; ++i) {
        HexCell cell;
        for (int c = 0; c < 8; ++c)
          cell.corners[c] = node(i + (c & 1), j + ((c >> 1) & 1), k + ((c >> 2) & 1));
        list.push_back(cell);
      }
  return {std::make_shared<Straight>(), at, std::move(list)};
}

}  // namespace thenar
