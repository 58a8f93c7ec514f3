#include "grasp/limits/grasp_force.h"

#include <map>
#include <vector>

#include "base/error.h"

namespace thenar {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Rows of the force limits of contacts; points of one patch share a row.
struct PatchRows {
  std::vector<Index> of_contact;
  Index count = 0;
};

PatchRows patch_rows(const ForceSet& forces) {
  PatchRows rows;
  std::map<int, Index> of_patch;
  for (const int patch : forces.patch) {
    const bool is_new = patch < 0 || of_patch.try_emplace(patch, rows.count).second;
    rows.of_contact.push_back(is_new ? rows.count++ : of_patch.at(patch));
  }
  return rows;
}

/// Adds a variable t with  sum of f_n <= t  for every patch, and minimises t.
void minimise_max_force(ConeProgram& program, const ForceSet& forces) {
  // Add a column for t, with the objective t alone.
  const PatchRows patches = patch_rows(forces);
  const Index n = program.c.size();
  internal::append_variable(program);
  program.c = VectorXd::Unit(n + 1, n);
  // Rows of patches:  sum of f_n - t <= 0.
  MatrixXd rows = MatrixXd::Zero(patches.count, n + 1);
  rows.col(n).setConstant(-1);
  // Active and passive normal forces of a contact count in the row of its patch.
  Index column = 0;
  for (std::size_t i = 0; i < patches.of_contact.size(); ++i) {
    rows(patches.of_contact[i], column) = 1;
    column += forces.cones[i];
  }
  for (const int contact : forces.passive_contacts) rows(patches.of_contact[contact], column++) = 1;
  internal::append_limits(program, rows, VectorXd::Zero(patches.count));
}

}  // namespace

GraspForce minimum_grasp_force(const ForceSet& forces, const ScaledWrench& whole_load,
                               GraspForceObjective objective) {
  require(whole_load.is_finite(), "the load must be finite");
  const WrenchCoordinates load = resistible_part(forces, whole_load).vector();
  // Variables and cones of the force set, and six rows for the equilibrium of the object.
  ConeProgram program{forces.normals.transpose(), {}, {}, forces.G, forces.h, forces.cones};
  program.A.resize(forces.A.rows() + 6, forces.wrench.cols());
  program.A << forces.A, forces.wrench;
  program.b.resize(forces.b.size() + 6);
  program.b << forces.b, -load;
  if (objective == GraspForceObjective::kLargest) minimise_max_force(program, forces);
  const ConeResult solution = solve(program);
  const VectorXd y = solution.x.head(forces.wrench.cols());
  return {solution.status, solution.objective, contact_forces(forces, y),
          ScaledWrench::from_coordinates(forces.wrench * y + load), solution.residual};
}

}  // namespace thenar
