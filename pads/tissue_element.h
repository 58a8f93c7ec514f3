#pragma once

/// Hexahedra of soft tissue at finite strain, four ways to keep them from locking or not.

#include <array>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "base/enum_names.h"
#include "pads/tissue.h"

namespace thenar {

/// Elements. All but the first weaken incompressibility, so that nu near 1/2 does not lock them.
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
/// 8 or 27.
[[nodiscard]] int nodes_of(HexElement kind);
/// Gauss points of the isochoric part, 8 or 27.
[[nodiscard]] int points_of(HexElement kind);

/// Shape functions in the reference element, found once.
struct ElementTable;
/// The table of a kind; lives as long as the program.
[[nodiscard]] const ElementTable& element_table(HexElement kind);

/// Quantities of an element that follow from its reference shape. Nodes of Q1 are ordered as
/// HexCell::corners, those of Q2 as the lattice 0..26, first axis fastest.
struct ElementShape {
  std::vector<double> gradient;       // dN/dX [1/m] (nodes, 3, padded points), see element_sums.h
  std::vector<double> volume;         // weights [m^3] (points)
  std::vector<double> mean_gradient;  // F-bar: in the mean, so that a patch passes the test
  Eigen::MatrixXd modes;              // Q2P1: functions of dilatation (points, 4)
  Eigen::MatrixXd modes_inverse;      // inverse of their Gram matrix [1/m^3] (4, 4)
};
/// @param X  reference nodes [m] (3, nodes of the kind)
/// @throws InputError if the map to it folds at a Gauss point.
[[nodiscard]] ElementShape element_shape(HexElement kind, const Eigen::Matrix3Xd& X);

/// F at a Gauss point. @param u  displacements [m] (3, nodes)
[[nodiscard]] Eigen::Matrix3d element_deformation(const ElementShape& shape,
                                                  const Eigen::Matrix3Xd& u, std::size_t point);
/// Value of a node's shape function at a Gauss point [1].
[[nodiscard]] double shape_value(HexElement kind, std::size_t point, std::size_t node);

/// An element's state of relaxation at its Gauss points, second Piola-Kirchhoff stresses [Pa].
struct ElementHistory {
  std::vector<Voigt> elastic;  // Se at the last accepted step (points)
  std::vector<Voigt> terms;    // H_i (terms, points)
};

/// Energy, forces and stiffness of an element; room of one thread, used again.
struct ElementResponse {
  bool inverted = false;       // det F <= 0 at a Gauss point: nothing else is written
  double energy = 0;           // incremental potential [J]
  Eigen::VectorXd force;       // its derivative by displacements [N] (3 nodes)
  Eigen::MatrixXd stiffness;   // its second derivative, upper triangle [N/m] (3 nodes, 3 nodes)
  std::vector<Voigt> elastic;  // Se [Pa] (points), if asked
};

enum class ElementAsk { kEnergy, kForce, kStiffness };

/// One element.
/// @param u        displacements [m] (3, nodes)
/// @param step     weights of relaxation for this step, and `history` of the step before; null:
///                 elastic
/// @param tangent_pressure  what the stiffness takes for the pressure, coefficients of its modes
///                 [Pa]; null: the pressure at u. With that of linear_pressure() Newton's method is
///                 that of the mixed problem, in which pressure is an unknown: a step far from
///                 balance makes no pressures of bulk modulus times its second order
/// Source: [Simo1998] sec. 9.4 and 10.3; spatial forms of [Bonet2008] ch. 9.
void element_response(HexElement kind, const ElementShape& shape, const Tissue& tissue,
                      const Eigen::Matrix3Xd& u, const MemoryStep* step,
                      const ElementHistory* history, const Eigen::Vector4d* tangent_pressure,
                      ElementAsk ask, ElementResponse& out);

/// Pressure after a change du, linearised at u, coefficients of its modes [Pa] (4); those that the
/// kind has not are 0.
[[nodiscard]] Eigen::Vector4d linear_pressure(HexElement kind, const ElementShape& shape,
                                              const Tissue& tissue, const Eigen::Matrix3Xd& u,
                                              const Eigen::Matrix3Xd& du);

}  // namespace thenar
