#include "grasp/quality/hold_force.h"

#include "base/error.h"

namespace thenar {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Adds t with  f_n <= t  for every contact, and aims at the least t.
void bound_by_largest(ConeProgram& program, const ForceSet& forces) {
  const Index n = program.c.size(), rows = program.G.rows();
  program.c = VectorXd::Unit(n + 1, n);
  program.A.conservativeResize(program.A.rows(), n + 1);
  program.A.col(n).setZero();
  program.G.conservativeResize(rows + forces.contacts, n + 1);
  program.G.col(n).setZero();
  program.G.bottomRows(forces.contacts).setZero();
  program.h.conservativeResize(rows + forces.contacts);
  program.h.tail(forces.contacts).setZero();
  Index column = 0;
  for (Index i = 0; i < forces.contacts; ++i) {
    program.G(rows + i, column) = 1;
    program.G(rows + i, n) = -1;
    program.cones.push_back(1);
    column += forces.cones[static_cast<std::size_t>(i)];
  }
  for (const int contact : forces.borne) program.G(rows + contact, column++) = 1;
}

}  // namespace

HoldForce smallest_hold(const ForceSet& forces, const Wrench& load, Squeeze squeeze) {
  require(load.allFinite(), "the load must be finite");
  ConeProgram program{forces.normals.transpose(), {}, {}, forces.G, forces.h, forces.cones};
  program.A.resize(forces.A.rows() + 6, forces.wrench.cols());
  program.A << forces.A, forces.wrench;
  program.b.resize(forces.b.size() + 6);
  program.b << forces.b, -load;
  if (squeeze == Squeeze::kLargest) bound_by_largest(program, forces);
  const ConeResult solution = solve(program);
  const VectorXd y = solution.x.head(forces.wrench.cols());
  return {solution.status, solution.objective, contact_forces(forces, y), forces.wrench * y + load,
          solution.residual};
}

}  // namespace thenar
