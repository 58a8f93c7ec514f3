#pragma once

/// Hexahedral meshes that refine cell by cell: each cell in eight, with hanging nodes between.

#include <array>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include <Eigen/Core>

namespace thenar {

/// Map from the coordinates of a chart to space. Cells are refined in coordinates of a chart, so
/// that new nodes lie on curved boundaries.
class HexChart {
 public:
  virtual ~HexChart() = default;
  /// Place of a point of the chart [m] (3).
  [[nodiscard]] virtual Eigen::Vector3d place(const Eigen::Vector3d& c) const = 0;
  /// Middle of an edge, in the chart (3).
  [[nodiscard]] virtual Eigen::Vector3d middle(const Eigen::Vector3d& a,
                                               const Eigen::Vector3d& b) const {
    return 0.5 * (a + b);
  }
  /// Returns the middle of a face in the chart (3). It must lie on a boundary to which middle()
  /// keeps if all corners do.
  /// @param mean  mean of the middles of its edges
  [[nodiscard]] virtual Eigen::Vector3d middle_of_face(
      const std::array<Eigen::Vector3d, 4>& /*corners*/, const Eigen::Vector3d& mean) const {
    return mean;
  }
};

/// One hexahedron. Corner 0..7 is at the bits (1, 2, 4) of its number along (xi, eta, zeta).
struct HexCell {
  std::array<int, 8> corners{};  // nodes
  int region = 0;                // of material; children have their parent's
  int level = 0;
  int parent = -1;       // none: a cell of the coarsest mesh
  int first_child = -1;  // of eight in a row, child 0..7 at the corner of its number; -1: none
};

/// A node as the mean of others.
struct NodeWeight {
  int node;
  double weight;  // [1]
};

/// A mesh of active cells (without children) in which an edge or a face meets at most two on its
/// other side (2:1 balance).
class HexMesh {
 public:
  /// @param chart   shared: meshes of one shape use one chart
  /// @param points  nodes in the chart (3, nodes)
  /// @param cells   corners and regions
  /// @throws InputError if a corner is no node, or a cell is inverted at a corner
  HexMesh(std::shared_ptr<const HexChart> chart, const Eigen::Matrix3Xd& points,
          std::vector<HexCell> cells);

  /// Splits cells in eight, and others as the balance asks. Cells with children are passed over.
  void refine(const std::vector<int>& cells);
  /// Replaces the children of cells by the cells, where all eight are active and the balance allows
  /// it.
  void coarsen(const std::vector<int>& cells);

  [[nodiscard]] const std::vector<HexCell>& cells() const { return cells_; }
  /// Cells without children, in order.
  [[nodiscard]] const std::vector<int>& active() const { return active_; }
  [[nodiscard]] int nodes() const { return static_cast<int>(chart_points_.size()); }
  [[nodiscard]] const HexChart& chart() const { return *chart_; }
  /// Returns whether an active cell has the node.
  [[nodiscard]] bool in_use(int node) const { return in_use_[static_cast<std::size_t>(node)]; }
  /// Reference position [m] (3), that of a hanging node among its masters; and the place in the
  /// chart.
  [[nodiscard]] const Eigen::Vector3d& place(int node) const {
    return places_[static_cast<std::size_t>(node)];
  }
  [[nodiscard]] const Eigen::Vector3d& chart_point(int node) const {
    return chart_points_[static_cast<std::size_t>(node)];
  }
  /// Nodes that a hanging node is the mean of, none of which hangs; empty: it does not hang.
  [[nodiscard]] const std::vector<NodeWeight>& masters(int node) const {
    return masters_[static_cast<std::size_t>(node)];
  }
  /// The masters of a node that hangs, any other node itself.
  [[nodiscard]] std::vector<NodeWeight> support(int node) const;
  /// The node between the corners of an edge or a face when it was made; empty: of the coarsest
  /// mesh. Fields are carried to new nodes by it.
  [[nodiscard]] const std::vector<NodeWeight>& made_from(int node) const {
    return made_from_[static_cast<std::size_t>(node)];
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
  std::map<std::pair<int, int>, int> edges_;  // middles
  std::map<std::array<int, 4>, int> faces_;   // middles
};

/// Reference positions of all nodes, as HexMesh::place() [m] (3, nodes).
[[nodiscard]] Eigen::Matrix3Xd rest_positions(const HexMesh& mesh);

/// Corners of the 12 edges and 6 faces of a cell; those of a face go round as two rows.
[[nodiscard]] const std::array<std::array<int, 2>, 12>& hex_edges();
[[nodiscard]] const std::array<std::array<int, 4>, 6>& hex_faces();

/// A face of an active cell.
struct HexFace {
  int cell;
  std::array<int, 4> nodes;  // as hex_faces(): two rows
};
/// Faces of active cells all of whose nodes are marked, in the order of the cells.
/// @param marked  (nodes)
[[nodiscard]] std::vector<HexFace> marked_faces(const HexMesh& mesh,
                                                const std::vector<bool>& marked);

/// Place 0..26 of the middle of two corners among the 27 nodes of a cell, first axis fastest; of a
/// corner with itself its own place. Also that of corner b of child a.
[[nodiscard]] std::size_t lattice_index(int a, int b);

/// A box cut in equal cells. @param size  [m] (3)  @param cells  along each edge (3)
[[nodiscard]] HexMesh box_mesh(const Eigen::Vector3d& size, const Eigen::Vector3i& cells);

}  // namespace thenar
