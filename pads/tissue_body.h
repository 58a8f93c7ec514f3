#pragma once

/// A body of soft tissue on a hexahedral mesh: its energy, forces and stiffness.

#include <vector>

#include <Eigen/Core>

#include "pads/hex_mesh.h"
#include "pads/tissue_element.h"
#include "solvers/sparse/sparse_cholesky.h"

namespace thenar {

/// State of relaxation of all elements; empty: elastic, or never deformed.
using TissueHistory = std::vector<ElementHistory>;

/// Pressure within elements, coefficients of its modes [Pa] (elements).
using TissuePressure = std::vector<Eigen::Vector4d>;

/// Energy, forces and stiffness of a body at a displacement.
struct TissueResponse {
  bool inverted = false;       // an element is turned inside out: nothing else is written
  double energy = 0;           // incremental potential [J]
  Eigen::VectorXd force;       // its derivative [N] (3 free nodes)
  std::vector<double> values;  // its second derivative, of the pattern's entries [N/m]
};

/// A mesh with tissues and fixed nodes; constant once built. Unknowns are displacements of the free
/// nodes: those that are neither fixed nor hanging.
///
/// Quadratic elements take the mesh's cells eight by eight: each parent of active cells is one
/// element on the 27 nodes of its children.
class TissueBody {
 public:
  /// @param tissues  of the regions
  /// @param fixed    whether a node stays where it is (nodes of the mesh)
  /// @throws InputError if a region has no tissue, an element folds, no node is free, or, for
  /// quadratic elements, a cell's parent is not wholly active or a node hangs.
  TissueBody(const HexMesh& mesh, HexElement kind, std::vector<Tissue> tissues,
             const std::vector<bool>& fixed);

  [[nodiscard]] int unknowns() const { return 3 * static_cast<int>(free_nodes_.size()); }
  /// Nodes of the mesh that are free, in the order of the unknowns.
  [[nodiscard]] const std::vector<int>& free_nodes() const { return free_nodes_; }
  /// Nodes of the mesh that its elements have.
  [[nodiscard]] const std::vector<int>& nodes() const { return nodes_; }
  /// Reference position of a node [m] (3).
  [[nodiscard]] const Eigen::Vector3d& place(int node) const {
    return places_[static_cast<std::size_t>(node)];
  }
  [[nodiscard]] bool hangs(int node) const {
    return !node_masters_[static_cast<std::size_t>(node)].empty();
  }
  /// Place of a node among the free ones; -1: fixed, hanging or not in use.
  [[nodiscard]] int free_place(int node) const {
    return free_place_[static_cast<std::size_t>(node)];
  }
  [[nodiscard]] std::size_t elements() const { return elements_.size(); }
  [[nodiscard]] const SymmetricPattern& pattern() const { return pattern_; }
  /// Returns the position among the values of entry (r, c), r >= c, of the diagonal block (3, 3) of
  /// a free node.
  [[nodiscard]] std::size_t diagonal_entry(int free, int r, int c) const;
  /// Adds a block to the values: rows of free node `row`, columns of `column`, which share an
  /// element; of a symmetric matrix, so each pair once. @param block  (3, 3)
  void add_block(std::vector<double>& values, int row, int column,
                 const Eigen::Matrix3d& block) const;
  [[nodiscard]] bool is_quadratic() const { return kind_ == HexElement::kQuadratic; }
  [[nodiscard]] bool relaxes() const;
  /// Largest shear modulus of its tissues [Pa].
  [[nodiscard]] double largest_modulus() const;

  /// Largest force that a strain of 1 of volume makes on an element [N]: bulk modulus times the
  /// square of its size.
  [[nodiscard]] double largest_pressure_force() const;

  /// Displacements of all nodes from those of the free ones; fixed nodes have `at_fixed`.
  /// @param x  (3 free nodes) [m];  @param at_fixed  (3, nodes) or empty: none
  [[nodiscard]] Eigen::Matrix3Xd spread(const Eigen::VectorXd& x,
                                        const Eigen::Matrix3Xd& at_fixed) const;

  /// Returns whether a place lies in an element.
  /// @param u  displacements of all nodes [m] (3, nodes)
  [[nodiscard]] bool contains(const Eigen::Vector3d& place, const Eigen::Matrix3Xd& u) const;

  /// @param u        displacements of all nodes [m] (3, nodes)
  /// @param h        step since `history` [s]; meaningless for elastic bodies
  /// @param tangent_pressure  as of element_response() (elements); empty: that at u
  void respond(const Eigen::Matrix3Xd& u, double h, const TissueHistory& history,
               const TissuePressure& tangent_pressure, ElementAsk ask, TissueResponse& out) const;

  /// linear_pressure() of all elements.
  [[nodiscard]] TissuePressure pressure_after(const Eigen::Matrix3Xd& u,
                                              const Eigen::Matrix3Xd& du) const;

  /// History at the end of a step that ended at u.
  [[nodiscard]] TissueHistory advance(const Eigen::Matrix3Xd& u, double h,
                                      const TissueHistory& history) const;

  /// Reaction of all nodes, fixed ones included: derivative of the energy by the displacement of
  /// each, hanging nodes handed to their masters [N] (3, nodes).
  /// @throws InputError if an element is turned inside out.
  [[nodiscard]] Eigen::Matrix3Xd reactions(const Eigen::Matrix3Xd& u, double h,
                                           const TissueHistory& history) const;

  /// Energy of the error of each element [J] (elements: active cells in order, or their parents):
  /// that of the difference between its isochoric stress and a smooth one, the mean around each
  /// node, regions apart, by the shear modulus of its tangent as it is stretched. Their sum over
  /// the energy estimates the relative error of a force that holds a displacement, as both are
  /// quadratic in the displacement. Source: [ZienkiewiczZhu1987].
  [[nodiscard]] Eigen::VectorXd error_energies(const Eigen::Matrix3Xd& u) const;

 private:
  /// Share of a block of an element's stiffness that goes to a block of the tangent.
  struct BlockShare {
    int a, b;       // nodes of the element, a <= b
    int node;       // free node whose columns the block is in
    int place;      // of its rows in this column, 0: the diagonal
    double weight;  // of the element's block [1]
    bool turned;    // it is transposed
    bool mirrored;  // its transpose adds as well: two nodes of the element have one master
  };
  struct Element {
    std::vector<int> nodes;
    int region = 0;
    ElementShape shape;
    std::vector<std::vector<NodeWeight>> masters;  // of each node, in free places; empty: fixed
    std::vector<BlockShare> shares;                // of its stiffness
  };
  void list_elements(const HexMesh& mesh);
  void build_pattern();
  void list_shares(Element& element) const;
  [[nodiscard]] const ElementHistory& history_of(std::size_t element,
                                                 const TissueHistory& history) const;
  void add_element(const Element& element, const ElementResponse& response, ElementAsk ask,
                   TissueResponse& out) const;
  [[nodiscard]] Eigen::Matrix3Xd displacements_of(const Element& element,
                                                  const Eigen::Matrix3Xd& u) const;
  [[nodiscard]] std::vector<MemoryStep> steps_of(double h) const;
  [[nodiscard]] std::size_t block_entry(int column, int place, int r, int c) const;

  HexElement kind_;
  std::vector<Tissue> tissues_;
  std::vector<ElementHistory> fresh_;  // of elements never deformed (tissues)
  std::vector<Element> elements_;
  std::vector<Eigen::Vector3d> places_;
  std::vector<int> nodes_, free_nodes_, free_place_;
  std::vector<std::vector<NodeWeight>> node_masters_;  // of the mesh's nodes, by nodes
  std::vector<std::vector<int>> columns_;              // free nodes at or below each in its column
  SymmetricPattern pattern_;
};

/// Mean of F over the Gauss points of a cell.
/// @param places, u  of all nodes: at rest, and their displacements [m] (3, nodes of the mesh)
[[nodiscard]] Eigen::Matrix3d mean_deformation(const HexCell& cell, const Eigen::Matrix3Xd& places,
                                               const Eigen::Matrix3Xd& u);

}  // namespace thenar
