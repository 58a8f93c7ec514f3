#pragma once

/// Bodies whose displacements are held component by component, brought to rest.

#include <vector>

#include <Eigen/SparseCholesky>

#include "pads/tissue_body.h"

namespace thenar {

/// Components of displacements that are held, by places among a body's unknowns.
using HeldComponents = std::vector<bool>;

/// Newton's method of the mixed problem in the components that are not held, from `x`, with forces
/// `load` on the body.
/// @return iterations; -1: it failed
inline int bring_to_rest(const TissueBody& body, const HeldComponents& held,
                         const Eigen::VectorXd& load, Eigen::VectorXd& x) {
  std::vector<int> place(held.size(), -1);
  int count = 0;
  for (std::size_t i = 0; i < held.size(); ++i)
    if (!held[i]) place[i] = count++;
  const SymmetricPattern& pattern = body.pattern();
  TissueResponse at;
  TissuePressure pressure;
  for (int k = 0; k < 25; ++k) {
    const Eigen::Matrix3Xd u = body.node_displacements(x, {});
    body.evaluate(u, 0, {}, pressure, ElementRequest::kStiffness, at);
    if (at.inverted) return -1;
    // Rows and columns that may move.
    std::vector<Eigen::Triplet<double>> entries;
    double stiffest = 0;
    for (int j = 0; j < pattern.size; ++j)
      for (int e = pattern.starts[static_cast<std::size_t>(j)];
           e < pattern.starts[static_cast<std::size_t>(j) + 1]; ++e) {
        const double value = at.tangent[static_cast<std::size_t>(e)];
        const int row = place[static_cast<std::size_t>(pattern.rows[static_cast<std::size_t>(e)])],
                  column = place[static_cast<std::size_t>(j)];
        stiffest = std::max(stiffest, value);
        if (row < 0 || column < 0) continue;
        entries.emplace_back(std::max(row, column), std::min(row, column), value);
      }
    Eigen::VectorXd missing(count);
    for (std::size_t i = 0; i < held.size(); ++i)
      if (place[i] >= 0)
        missing[place[i]] =
            load[static_cast<Eigen::Index>(i)] - at.force[static_cast<Eigen::Index>(i)];
    // Rounding of forces grows with the stiffness.
    if (missing.lpNorm<Eigen::Infinity>() < 1e-13 * stiffest) return k;
    Eigen::SparseMatrix<double> K(count, count);
    K.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(K);
    if (factor.info() != Eigen::Success) return -1;
    const Eigen::VectorXd step = factor.solve(missing);
    Eigen::VectorXd dx = Eigen::VectorXd::Zero(x.size());
    for (std::size_t i = 0; i < held.size(); ++i)
      if (place[i] >= 0) dx[static_cast<Eigen::Index>(i)] = step[place[i]];
    pressure = body.predict_pressure(u, body.node_displacements(dx, {}));
    x += dx;
  }
  return -1;
}

}  // namespace thenar
