#pragma once

/// Rows of contacts, joint limits and dry frictions in the contact problem of a step.

#include <vector>

#include <Eigen/Core>

#include "contact/contact_problem.h"
#include "contact/contact_solver.h"
#include "dynamics/mechanism/composite_body.h"
#include "dynamics/stepping/scene_state.h"

namespace thenar {

/// Builder of a step's contact problem from a list of contacts. A "row" is one scalar constraint; a
/// contact has one to four.
class ContactRows {
 public:
  /// @param scene, model  must outlive the object
  ContactRows(const MovingScene& scene, const TreeModel& model) : scene_(scene), model_(model) {}

  /// Assembles the blocks, the Jacobian J and W = J A^-1 J' of a list of contacts.
  /// @param h     step length, which bounds the impulse of dry friction [s]
  /// @param mass  factorised A
  void assemble(const std::vector<ActiveContact>& list, double h, const TreeMotion<double>& links,
                const MassMatrix<double>& mass);

  /// Multiplies the normal velocities of closing contacts by 1 + restitution, and clears impulses.
  void apply_restitution(std::vector<ActiveContact>& list);

  /// Adds the gap and mean-of-both-ends terms of a midpoint step to b, and stores their velocities
  /// in the list: see ContactStep::take_midpoint_step().
  /// @param v  velocity at the start of the step (v);  @param h  [s];  @param recovery  [m/s]
  void add_midpoint_terms(const Eigen::VectorXd& v, double h, double recovery,
                          std::vector<ActiveContact>& list);

  /// Returns the impulses of a list as initial guess of the solver [N s], [N m s] (rows).
  [[nodiscard]] const Eigen::VectorXd& warm_start(const std::vector<ActiveContact>& list);

  /// Stores impulses, velocities and modes of a solution in the list.
  ///
  /// Modes follow the motion, not the force: which of several redundant contacts have no force is
  /// arbitrary.
  void store_solution(const ContactSolution& answer, std::vector<ActiveContact>& list) const;

  ContactProblem problem;
  Eigen::MatrixXd Jt;  // transposed Jacobian J' (v, rows)

 private:
  /// Calls a function with each contact, its block and the index of its first row.
  template <class List, class Call>
  void for_each_row(List& list, const Call& call) const {
    int at = 0;
    for (std::size_t k = 0; k < list.size(); ++k) {
      call(list[k], problem.blocks[k], at);
      at += row_count(problem.blocks[k].law);
    }
  }
  [[nodiscard]] ContactBlock make_block(const ActiveContact& contact, double h) const;
  void fill_jacobian(const ActiveContact& contact, ConstraintLaw law, int at,
                     const TreeMotion<double>& links);

  const MovingScene& scene_;
  const TreeModel& model_;
  Eigen::MatrixXd Y_;           // D^-1/2 L'^-1 J', so that W = Y' Y (v, rows)
  Eigen::VectorXd warm_start_;  // initial guess of the impulses (rows)
};

}  // namespace thenar
