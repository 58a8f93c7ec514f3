#pragma once

/// Hexahedral meshes with local refinement: a cell splits into eight, with hanging nodes.

#include <array>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include <Eigen/Core>

namespace thenar {

/// Map from the coordinates of a chart to space. Cells are refined in the chart, so that new nodes
/// lie on curved boundaries.
class HexChart {
 public:
  virtual ~HexChart() = default;
  /// Returns the position of a point of the chart [m] (3).
  [[nodiscard]] virtual Eigen::Vector3d place(const Eigen::Vector3d& c) const = 0;
  /// Returns the middle of an edge in the chart (3).
  [[nodiscard]] virtual Eigen::Vector3d middle(const Eigen::Vector3d& a,
                                               const Eigen::Vector3d& b) const {
    return 0.5 * (a + b);
  }
  /// Returns the middle of a face in the chart (3). It must lie on a boundary if all corners do, as
  /// that of middle().
  /// @param mean  mean of the middles of its edges (3)
  [[nodiscard]] virtual Eigen::Vector3d middle_of_face(
      const std::array<Eigen::Vector3d, 4>& /*corners*/, const Eigen::Vector3d& mean) const {
    return mean;
  }
};

/// Hexahedral cell. Bits 1, 2 and 4 of a corner's number 0..7 are its coordinates xi, eta and zeta.
struct HexCell {
  std::array<int, 8> corners{};  // nodes
  int region = 0;                // material region; children have that of their parent
  int level = 0;                 // number of refinements
  int parent = -1;               // parent cell, -1: a cell of the coarsest mesh
  int first_child = -1;          // first of eight consecutive children, child 0..7 at the corner of
                                 // its number; -1: none
};

/// Weight of a node in a weighted mean of nodes.
struct NodeWeight {
  int node = 0;
  double weight = 0;  // [1]
};

/// Mesh of active cells (without children) with 2:1 balance: an edge or a face meets at most two
/// along each direction on its other side.
class HexMesh {
 public:
  /// @param chart   chart, which meshes of one shape share
  /// @param points  nodes in the chart (3, nodes)
  /// @param cells   cells with corners and regions
  /// @throws InputError if a corner is no node, or a cell is inverted at a corner
  HexMesh(std::shared_ptr<const HexChart> chart, const Eigen::Matrix3Xd& points,
          std::vector<HexCell> cells);

  /// Splits cells into eight, and further cells to keep the balance. Skips cells with children.
  void refine(const std::vector<int>& cells);

  [[nodiscard]] const std::vector<HexCell>& cells() const { return cells_; }
  /// Returns the cells without children, in increasing order.
  [[nodiscard]] const std::vector<int>& active() const { return active_; }
  [[nodiscard]] int nodes() const { return static_cast<int>(chart_points_.size()); }
  [[nodiscard]] const HexChart& chart() const { return *chart_; }
  /// Returns whether the node is a corner of an active cell.
  [[nodiscard]] bool in_use(int node) const { return in_use_[node]; }
  /// Returns the reference position of a node [m] (3), for a hanging node the mean of its masters.
  [[nodiscard]] const Eigen::Vector3d& place(int node) const { return places_[node]; }
  /// Returns the position of a node in the chart (3).
  [[nodiscard]] const Eigen::Vector3d& chart_point(int node) const { return chart_points_[node]; }
  /// Returns the non-hanging masters whose mean defines a hanging node; empty: the node does not
  /// hang.
  [[nodiscard]] const std::vector<NodeWeight>& masters(int node) const { return masters_[node]; }
  /// Returns the masters of a hanging node, or any other node itself with weight 1.
  [[nodiscard]] std::vector<NodeWeight> support(int node) const;
  /// Returns the nodes of the edge, face or cell in whose middle a node was created, with which
  /// fields are transferred to it; empty: a node of the coarsest mesh.
  [[nodiscard]] const std::vector<NodeWeight>& made_from(int node) const {
    return made_from_[node];
  }

 private:
  int add_node(const Eigen::Vector3d& c, std::vector<NodeWeight> from);
  int middle_of_edge(int a, int b);
  int middle_of_face(const std::array<int, 4>& corners);
  void split(int cell);
  [[nodiscard]] int edge_node_in_use(int a, int b) const;
  [[nodiscard]] bool must_split(const HexCell& cell) const;
  void list_active();
  void find_hanging();

  std::shared_ptr<const HexChart> chart_;
  std::vector<Eigen::Vector3d> chart_points_, on_chart_, places_;
  std::vector<std::vector<NodeWeight>> made_from_, masters_;
  std::vector<bool> in_use_;
  std::vector<HexCell> cells_;
  std::vector<int> active_;
  std::map<std::pair<int, int>, int> edges_;  // middle nodes of edges
  std::map<std::array<int, 4>, int> faces_;   // middle nodes of faces, by sorted corners
};

/// Returns the reference positions of all nodes, HexMesh::place() [m] (3, nodes).
[[nodiscard]] Eigen::Matrix3Xd rest_positions(const HexMesh& mesh);

/// Returns the corners of the 12 edges of a cell.
[[nodiscard]] const std::array<std::array<int, 2>, 12>& hex_edges();
/// Returns the corners of the 6 faces of a cell, each in two rows.
[[nodiscard]] const std::array<std::array<int, 4>, 6>& hex_faces();

/// Face of an active cell.
struct HexFace {
  int cell = 0;
  std::array<int, 4> nodes;  // corners in two rows, as of hex_faces()
};
/// Returns the faces of active cells all of whose nodes are marked, in the order of the cells.
/// @param marked  (nodes)
[[nodiscard]] std::vector<HexFace> marked_faces(const HexMesh& mesh,
                                                const std::vector<bool>& marked);

/// Returns the index 0..26, first axis fastest, of the middle between corners a and b among the 27
/// nodes of a cell; a = b: the corner itself. It is also the index of corner b of child a.
[[nodiscard]] std::size_t lattice_index(int a, int b);

/// Builds a box of equal cells.
/// @param size  edge lengths [m] (3);  @param cells  number along each edge (3)
[[nodiscard]] HexMesh box_mesh(const Eigen::Vector3d& size, const Eigen::Vector3i& cells);

}  // namespace thenar
