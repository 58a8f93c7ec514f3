#pragma once

/// A body of soft tissue on a hexahedral mesh: its energy, forces and stiffness.

#include <vector>

#include <Eigen/Core>

#include "pads/hex_mesh.h"
#include "pads/tissue_element.h"
#include "solvers/sparse/sparse_cholesky.h"

namespace thenar {

/// Relaxation history of all elements; empty: elastic, or never deformed.
using TissueHistory = std::vector<ElementHistory>;

/// Pressure in each element, coefficients of its modes [Pa] (elements).
using TissuePressure = std::vector<Eigen::Vector4d>;

/// Energy, forces and stiffness of a body at given displacements.
struct TissueResponse {
  bool inverted = false;        // an element is inverted: the other members are invalid
  double energy = 0;            // incremental potential [J]
  Eigen::VectorXd force;        // derivative of the energy [N] (3 free nodes)
  std::vector<double> tangent;  // second derivative, entries in the pattern's order [N/m]
};

/// A mesh with tissues and fixed nodes; immutable once built. The unknowns are the displacements of
/// the free nodes: those that are neither fixed nor hanging.
///
/// Quadratic elements take the cells of the mesh in groups of eight: each parent of active cells is
/// one element on the 27 nodes of its children.
class TissueBody {
 public:
  /// @param tissues  tissues of the regions
  /// @param fixed    whether a node is fixed (nodes of the mesh)
  /// @throws InputError if a region has no tissue, an element folds, no node is free, or, for
  /// quadratic elements, a cell's parent is only partly active or a node hangs.
  TissueBody(const HexMesh& mesh, HexElement kind, std::vector<Tissue> tissues,
             const std::vector<bool>& fixed);

  /// Returns the number of unknowns, 3 for each free node.
  [[nodiscard]] int unknowns() const { return 3 * static_cast<int>(free_nodes_.size()); }
  /// Returns the mesh nodes that are free, in the order of the unknowns.
  [[nodiscard]] const std::vector<int>& free_nodes() const { return free_nodes_; }
  /// Returns the mesh nodes that belong to elements.
  [[nodiscard]] const std::vector<int>& nodes() const { return nodes_; }
  /// Returns the reference position of a node [m] (3).
  [[nodiscard]] const Eigen::Vector3d& rest_position(int node) const {
    return rest_positions_[node];
  }
  [[nodiscard]] bool is_hanging(int node) const { return !node_masters_[node].empty(); }
  /// Returns the index of a node among the free ones; -1: fixed, hanging or unused.
  [[nodiscard]] int free_index(int node) const { return free_index_[node]; }
  /// Returns the number of elements.
  [[nodiscard]] std::size_t elements() const { return elements_.size(); }
  [[nodiscard]] const SymmetricPattern& pattern() const { return pattern_; }
  /// Returns the index in a tangent of entry (r, c), r >= c, of a free node's diagonal block (3,
  /// 3).
  [[nodiscard]] std::size_t diagonal_entry(int free, int r, int c) const;
  /// Adds a block to a tangent at the rows of free node `row` and the columns of `column`, which
  /// share an element. The tangent is symmetric: add the block of each pair of nodes once.
  /// @param block  [N/m] (3, 3)
  void add_block(std::vector<double>& tangent, int row, int column,
                 const Eigen::Matrix3d& block) const;
  [[nodiscard]] bool is_quadratic() const { return kind_ == HexElement::kQuadratic; }
  [[nodiscard]] bool relaxes() const;
  /// Returns the largest shear modulus of its tissues [Pa].
  [[nodiscard]] double max_shear_modulus() const;

  /// Returns the largest force on an element under a volumetric strain of 1 [N]: bulk modulus times
  /// the square of the element's size.
  [[nodiscard]] double max_pressure_force() const;

  /// Returns the displacements of all nodes: hanging nodes follow their masters.
  /// @param x  displacements of the free nodes [m] (3 free nodes)
  /// @param at_fixed  displacements of the fixed nodes [m] (3, nodes), or empty: zero
  [[nodiscard]] Eigen::Matrix3Xd node_displacements(const Eigen::VectorXd& x,
                                                    const Eigen::Matrix3Xd& at_fixed) const;

  /// Returns whether a position lies in an element.
  /// @param u  displacements of all nodes [m] (3, nodes)
  [[nodiscard]] bool contains(const Eigen::Vector3d& place, const Eigen::Matrix3Xd& u) const;

  /// Computes the response of the body, up to the requested derivative.
  /// @param u        displacements of all nodes [m] (3, nodes)
  /// @param h        time since `history` [s]; without effect on elastic bodies
  /// @param tangent_pressure  pressure in the tangent, as of element_response() (elements); empty:
  ///                 the pressure at u
  void evaluate(const Eigen::Matrix3Xd& u, double h, const TissueHistory& history,
                const TissuePressure& tangent_pressure, ElementRequest request,
                TissueResponse& out) const;

  /// Returns linear_pressure() of all elements.
  [[nodiscard]] TissuePressure predict_pressure(const Eigen::Matrix3Xd& u,
                                                const Eigen::Matrix3Xd& du) const;

  /// Returns the history at the end of a step of duration h that ends at u.
  [[nodiscard]] TissueHistory advance_history(const Eigen::Matrix3Xd& u, double h,
                                              const TissueHistory& history) const;

  /// Returns the reactions of all nodes, fixed ones included: derivatives of the energy by their
  /// displacements, those of hanging nodes assigned to their masters [N] (3, nodes).
  /// @throws InputError if an element is inverted.
  [[nodiscard]] Eigen::Matrix3Xd reactions(const Eigen::Matrix3Xd& u, double h,
                                           const TissueHistory& history) const;

  /// Estimates the energy of the error in each element [J] (elements: active cells in order, or
  /// their parents). It is the energy of the difference between the element's isochoric stress and
  /// a smooth one, the mean around each node within a region, by the shear modulus of the tangent
  /// at the element's stretch. Their sum over the body's energy estimates the relative error of a
  /// force that holds a displacement, because both are quadratic in the displacement. Source:
  /// [ZienkiewiczZhu1987].
  [[nodiscard]] Eigen::VectorXd error_energies(const Eigen::Matrix3Xd& u) const;

 private:
  /// Contribution of a block of an element's stiffness to a block of the tangent.
  struct BlockShare {
    int a, b;         // nodes of the element, a <= b
    int column;       // free node of the tangent block's columns
    int row_index;    // index of the tangent block's rows in this column, 0: the diagonal
    double weight;    // weight of the element's block [1]
    bool transposed;  // the element's block is transposed
    bool symmetric;   // its transpose adds as well: two nodes of the element share a master
  };
  struct Element {
    std::vector<int> nodes;
    int region = 0;
    ElementShape shape;
    std::vector<std::vector<NodeWeight>> masters;  // free masters of each node; empty: fixed
    std::vector<BlockShare> shares;                // destinations of its stiffness
  };
  void build_elements(const HexMesh& mesh);
  void build_pattern();
  void list_block_shares(Element& element) const;
  [[nodiscard]] const ElementHistory& element_history(std::size_t element,
                                                      const TissueHistory& history) const;
  void add_element(const Element& element, const ElementResponse& response, ElementRequest request,
                   TissueResponse& out) const;
  [[nodiscard]] Eigen::Matrix3Xd element_displacements(const Element& element,
                                                       const Eigen::Matrix3Xd& u) const;
  /// Returns the weights of a time step for each tissue.
  [[nodiscard]] std::vector<MemoryStep> memory_steps(double h) const;
  /// Returns the index in a tangent of entry (r, c) of a block (3, 3).
  [[nodiscard]] std::size_t block_entry(int column, int row_index, int r, int c) const;

  HexElement kind_;
  std::vector<Tissue> tissues_;
  std::vector<ElementHistory> undeformed_history_;  // history of undeformed elements (tissues)
  std::vector<Element> elements_;
  std::vector<Eigen::Vector3d> rest_positions_;
  std::vector<int> nodes_, free_nodes_, free_index_;
  std::vector<std::vector<NodeWeight>> node_masters_;  // masters of the mesh's nodes (nodes)
  std::vector<std::vector<int>> columns_;  // free nodes at or below the diagonal of each column
  SymmetricPattern pattern_;
};

/// Returns the mean of F over the Gauss points of a cell (3, 3).
/// @param places, u  rest positions and displacements of all nodes [m] (3, nodes of the mesh)
[[nodiscard]] Eigen::Matrix3d mean_deformation(const HexCell& cell, const Eigen::Matrix3Xd& places,
                                               const Eigen::Matrix3Xd& u);

}  // namespace thenar
