#include "grasp/quality/force_rows.h"

namespace thenar::internal {

using Eigen::Index;

void add_rows(ForceSet& forces, const Eigen::MatrixXd& rows, const Eigen::VectorXd& most) {
  const Index old = forces.G.rows();
  forces.G.conservativeResize(old + rows.rows(), forces.G.cols());
  forces.G.bottomRows(rows.rows()) = rows;
  forces.h.conservativeResize(old + rows.rows());
  forces.h.tail(rows.rows()) = most;
  forces.cones.insert(forces.cones.end(), static_cast<std::size_t>(rows.rows()), 1);
}

void widen(ForceSet& forces, Index by) {
  const Index n = forces.wrench.cols();
  forces.wrench.conservativeResize(6, n + by);
  forces.wrench.rightCols(by).setZero();
  forces.A.conservativeResize(forces.A.rows(), n + by);
  forces.A.rightCols(by).setZero();
  forces.G.conservativeResize(forces.G.rows(), n + by);
  forces.G.rightCols(by).setZero();
  forces.normals.conservativeResize(n + by);
  forces.normals.tail(by).setZero();
}

}  // namespace thenar::internal
