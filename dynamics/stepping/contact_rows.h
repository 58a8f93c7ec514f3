#pragma once

/// Rows of contacts, joint limits and dry frictions in the contact problem of a step.

#include <vector>

#include <Eigen/Core>

#include "contact/contact_problem.h"
#include "contact/contact_solver.h"
#include "dynamics/mechanism/composite_body.h"
#include "dynamics/stepping/scene_state.h"

namespace thenar {

class ContactRows {
 public:
  /// @param scene, model  outlive it
  ContactRows(const MovingScene& scene, const TreeModel& model) : scene_(scene), model_(model) {}

  /// Sets blocks, J and W = J' A^-1 J of a list of contacts.
  /// @param h     of the step, for dry friction [s]
  /// @param mass  factor of A
  void set(const std::vector<ActiveContact>& list, double h, const TreeMotion<double>& links,
           const MassMatrix<double>& mass);

  /// Multiplies speeds with which contacts close by 1 + restitution, and forgets their impulses.
  void bounce(std::vector<ActiveContact>& list);

  /// Adds what contacts ask of the speeds after a midpoint step beyond their laws: gaps, and the
  /// mean of both ends where they went on (ContactStep::time_step()).
  /// @param v  at its beginning (v);  @param recovery  [m/s]
  void add_speeds_before(const Eigen::VectorXd& v, double h, double recovery,
                         std::vector<ActiveContact>& list);

  /// Impulses of a list, for a warm start (rows).
  [[nodiscard]] const Eigen::VectorXd& warm_start(const std::vector<ActiveContact>& list);

  /// Writes impulses, velocities and modes of an answer into the list.
  ///
  /// Modes are those of the motion: of redundant contacts some may have no force, and which ones is
  /// chance.
  void read(const ContactSolution& answer, std::vector<ActiveContact>& list) const;

  ContactProblem problem;
  Eigen::MatrixXd J;  // rows as columns (v, rows)

 private:
  /// Calls with each contact, its block and its first row.
  template <class List, class Call>
  void for_each_row(List& list, const Call& call) const {
    int at = 0;
    for (std::size_t k = 0; k < list.size(); ++k) {
      call(list[k], problem.blocks[k], at);
      at += rows_of(problem.blocks[k].law);
    }
  }
  [[nodiscard]] ContactBlock block_of(const ActiveContact& contact, double h) const;
  void fill(const ActiveContact& contact, ConstraintLaw law, int at,
            const TreeMotion<double>& links);
  void add_speeds(const Eigen::VectorXd& v, double h, double recovery, int at, int rows,
                  ActiveContact& contact);

  const MovingScene& scene_;
  const TreeModel& model_;
  Eigen::MatrixXd Y_;      // half of the factor's answer to J (v, rows)
  Eigen::VectorXd start_;  // (rows)
};

}  // namespace thenar
