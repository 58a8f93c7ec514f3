#pragma once

/// Hexahedral elements of soft tissue at finite strain, one that locks and three that do not.

#include <array>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "base/enum_names.h"
#include "pads/tissue.h"

namespace thenar {

/// Kinds of elements. All but the first relax the incompressibility constraint, so that they do not
/// lock for nu near 1/2.
enum class HexElement {
  kDisplacement,        // Q1: 8 nodes, 8 Gauss points; locks
  kMeanDilatation,      // Q1P0: J is its mean over the element [SimoTaylorPister1985]
  kCentroidDilatation,  // F-bar in a form with an energy: J is that of the mean of F, which on
                        // parallelepipeds is F of the centre [DeSouzaNeto1996]
  kQuadratic            // Q2P1: 27 nodes, 27 Gauss points, J is linear within [SussmanBathe1987]
};
inline constexpr std::array kHexElementNames{
    EnumName{HexElement::kDisplacement, "Q1"}, EnumName{HexElement::kMeanDilatation, "Q1P0"},
    EnumName{HexElement::kCentroidDilatation, "F-bar"}, EnumName{HexElement::kQuadratic, "Q2P1"}};
[[nodiscard]] inline std::string name_of(HexElement kind) {
  return name_in(kHexElementNames, kind);
}
/// Returns the number of nodes, 8 or 27.
[[nodiscard]] int node_count(HexElement kind);
/// Returns the number of Gauss points of the isochoric part, 8 or 27.
[[nodiscard]] int gauss_point_count(HexElement kind);

/// Shape functions in the reference element, computed once.
struct ElementTable;
/// Returns the table of a kind; it lives as long as the program.
[[nodiscard]] const ElementTable& element_table(HexElement kind);

/// Quantities of an element that follow from its reference shape. Nodes of Q1 are ordered as
/// HexCell::corners, those of Q2 as the lattice 0..26, first axis fastest.
struct ElementShape {
  std::vector<double> gradient;       // dN/dX [1/m] (nodes, 3, padded points), see element_sums.h
  std::vector<double> volume;         // integration weights [m^3] (points)
  std::vector<double> mean_gradient;  // F-bar: volume mean of dN/dX, which passes the patch test
                                      // [1/m] (nodes, 3, padded points)
  Eigen::MatrixXd modes;              // Q2P1: dilatation modes at the Gauss points [1] (points, 4)
  Eigen::MatrixXd modes_inverse;      // inverse of their Gram matrix [1/m^3] (4, 4)
};
/// Computes the shape of an element.
/// @param X  reference positions of the nodes [m] (3, nodes of the kind)
/// @throws InputError if the map to it folds at a Gauss point.
[[nodiscard]] ElementShape element_shape(HexElement kind, const Eigen::Matrix3Xd& X);

/// Returns the deformation gradient F at a Gauss point (3, 3).
/// @param u  displacements [m] (3, nodes)
[[nodiscard]] Eigen::Matrix3d element_deformation(const ElementShape& shape,
                                                  const Eigen::Matrix3Xd& u, std::size_t point);
/// Returns the value of a node's shape function at a Gauss point [1].
[[nodiscard]] double shape_value(HexElement kind, std::size_t point, std::size_t node);

/// Relaxation state of an element at its Gauss points, second Piola-Kirchhoff stresses [Pa].
struct ElementHistory {
  std::vector<Voigt> elastic;  // Se at the last accepted step (points)
  std::vector<Voigt> terms;    // H_i (terms, points)
};

/// Energy, forces and stiffness of an element. Reuse one object per thread to avoid allocations.
struct ElementResponse {
  bool inverted = false;       // det F <= 0 at a Gauss point: the other members are invalid
  double energy = 0;           // incremental potential [J]
  Eigen::VectorXd force;       // derivative by displacements [N] (3 nodes)
  Eigen::MatrixXd stiffness;   // second derivative, upper triangle [N/m] (3 nodes, 3 nodes)
  std::vector<Voigt> elastic;  // Se, with forces [Pa] (points)
};

/// Highest derivative of the energy that is computed.
enum class ElementRequest { kEnergy, kForce, kStiffness };

/// Element at displacements u, with its relaxation. All references must outlive the object.
struct DeformedElement {
  HexElement kind;
  const ElementShape& shape;
  const Tissue& tissue;
  const Eigen::Matrix3Xd& u;  // displacements [m] (3, nodes)
  // Weights of relaxation for this step, and relaxation state at the end of the last one. Null
  // only in calls of linear_pressure().
  const MemoryStep* step = nullptr;
  const ElementHistory* history = nullptr;
  // Pressure in the stiffness, coefficients of its modes [Pa] (4); null: the pressure at u. With
  // that of linear_pressure(), Newton's method is that of the mixed problem, in which pressure is
  // an unknown: a step far from equilibrium then avoids pressures of bulk modulus times its
  // second-order volume change.
  const Eigen::Vector4d* tangent_pressure = nullptr;
};

/// Computes the response of one element.
/// Source: [Simo1998] sec. 9.4 and 10.3; spatial forms of [Bonet2008] ch. 9.
/// @param out  replaced; members beyond the request are unspecified
void element_response(const DeformedElement& at, ElementRequest request, ElementResponse& out);

/// Returns the pressure after a displacement increment du, linearized at u: coefficients of its
/// modes, 0 for those that the kind lacks [Pa] (4).
/// @param at  element, whose relaxation and tangent pressure have no effect
/// @param du  [m] (3, nodes)
[[nodiscard]] Eigen::Vector4d linear_pressure(const DeformedElement& at,
                                              const Eigen::Matrix3Xd& du);

}  // namespace thenar
