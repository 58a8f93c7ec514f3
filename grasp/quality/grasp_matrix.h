#pragma once

/// What the grasp matrix by itself says of contacts, whatever their friction.

#include <vector>

#include <Eigen/Core>

#include "grasp/contact/contact.h"

namespace thenar {

/// Wrenches of unit force components: of each contact along its normal; with friction along both of
/// its tangents; with torsion about its normal. Force [N], then torque / scale [N].
/// @returns (6, k)
/// @throws InputError as wrench_set()
[[nodiscard]] Eigen::Matrix<double, 6, Eigen::Dynamic> grasp_matrix(
    const std::vector<Contact>& contacts, const Eigen::Vector3d& centre, double torque_scale);

/// Measures of a grasp matrix G; rows without any entry in a plane's problem are left out.
struct GraspMatrixMeasures {
  int rank;             // singular values above 1e-12 of the largest
  double least;         // smallest singular value, 0 below full rank: how near G is to losing one
  double isotropy;      // smallest by largest singular value, 1: alike in all directions
  double volume;        // sqrt(det G G'), product of singular values: of the ellipsoid of wrenches
                        // that forces of |f| = 1 make, over that of the unit ball
  int internal_forces;  // dimension of { f : G f = 0 }: forces that only squeeze
};

/// @param G  (3 or 6, k), finite
/// @throws InputError if an entry is not finite
/// Source: [RoaSuarez2015] for the measures, those of algebraic properties of G; [Murray1994] for
/// internal forces.
[[nodiscard]] GraspMatrixMeasures grasp_matrix_measures(const Eigen::MatrixXd& G);

}  // namespace thenar
