#pragma once

/// Moment arms of wrapped tendons.

#include <vector>

#include <Eigen/Core>

#include "tendons/wrapping/path_solver.h"

namespace thenar {

/// Computes moment arms by virtual work,  R_j = -dL/dq_j,  flexion positive [m/rad] (paths,
/// coordinates). A touch point counts as fixed to its surface's link: where the path is tangent,
/// sliding it does not change the length. An origin that rides on another tendon adds that tendon's
/// excursion between its insertion and the origin, so a pull there unloads that part of the
/// carrier.
/// @param R  result, all entries overwritten; its shape must be (paths, coordinates)
/// Source: [An1983] for the sign.
void path_arms(const Tree<double>& tree, const TreeState<double>& state, const PathSet& set,
               const std::vector<PathShape>& shapes, Eigen::Ref<Eigen::MatrixXd> R);

/// Overwrites selected rows of R with the moment arms of paths; other rows keep their values.
/// @param rows  row for each path; -1: skip the path (paths)
void path_arms(const Tree<double>& tree, const TreeState<double>& state, const PathSet& set,
               const std::vector<PathShape>& shapes, const std::vector<int>& rows,
               Eigen::Ref<Eigen::MatrixXd> R);

}  // namespace thenar
