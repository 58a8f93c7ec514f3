#pragma once

/// Grasp matrix and its algebraic measures, which are independent of friction.

#include <vector>

#include <Eigen/Core>

#include "grasp/contact/contact.h"

namespace thenar {

/// Computes the grasp matrix: wrenches of unit force components of each contact, along its normal;
/// with friction along both tangents; with torsion about the normal. Force [N], then torque / scale
/// [N].
/// @returns (6, k)
/// @throws InputError as wrench_set()
[[nodiscard]] Eigen::Matrix<double, 6, Eigen::Dynamic> grasp_matrix(
    const std::vector<Contact>& contacts, const Eigen::Vector3d& centre, double torque_scale);

/// Measures of a grasp matrix G. Rows that are zero in a planar problem are left out.
struct GraspMatrixMeasures {
  int rank = 0;                   // number of singular values above 1e-12 of the largest
  double min_singular_value = 0;  // distance from losing rank; 0 below full rank [1]
  double isotropy = 0;  // smallest over largest singular value; 1: equal in all directions [1]
  double volume = 0;    // sqrt(det G G'), product of singular values: volume of the ellipsoid of
                        // wrenches of forces |f| = 1, over that of the unit ball [1]
  int internal_forces = 0;  // dimension of the null space of G: internal forces
};

/// Computes the measures of a grasp matrix. @param G  (3 or 6, k), finite
/// @throws InputError if an entry is not finite
/// Source: [RoaSuarez2015] for the measures of the algebraic properties of G; [Murray1994] for
///         internal forces.
[[nodiscard]] GraspMatrixMeasures grasp_matrix_measures(const Eigen::MatrixXd& G);

}  // namespace thenar
