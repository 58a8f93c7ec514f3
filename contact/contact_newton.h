#pragma once

/// Semismooth Newton steps for a contact problem.

#include <vector>

#include <Eigen/Core>

#include "contact/in_place_lu.h"
#include "contact/scaled_contacts.h"

namespace thenar::internal {

/// Semismooth Newton method on  fn = (fn - un)+,  ft = P_{mu (fn - un)}(ft - ut)
/// [AlartCurnier1991], which has the same solutions as De Saxce's form. Each step determines the
/// state of every contact from p = f - u,
///   open   p_n <= 0             f = 0
///   stick  |p_t| <= mu p_n      u = 0
///   slip   otherwise            un = 0,  ft = -mu fn d,  ut = s d,  d = -p_t / |p_t|,
/// and solves the linearized equations. A slipping contact stays on its cone: its unknowns are fn
/// and a rotation of d, two instead of three (soft finger: three instead of four), and its impulse
/// is on the cone to rounding. A proximal term of 1e-10 of the diagonal, with iterative refinement,
/// allows W to be singular. Convergence is quadratic near a solution, and not guaranteed far from
/// one.
class ContactNewton {
 public:
  /// Allocates the workspace for a problem of this size.
  void assign(const ScaledContacts& contacts);

  /// Makes one step from f and u to a new f and  u = A f + b.
  /// @param proximal  term added to the diagonal of A, which is 1; it is at least 1e-10 [1]
  /// @returns false, with f unchanged, if the linear system has no solution
  [[nodiscard]] bool step(const ScaledContacts& contacts, double proximal,
                          Eigen::Ref<Eigen::VectorXd> f, Eigen::Ref<Eigen::VectorXd> u);

 private:
  /// Scalar unknown y, with the direction of its impulse and its equation.
  struct Unknown {
    int start = 0, rows = 1;                             // first row and number of rows of f
    Eigen::Vector4d impulse = Eigen::Vector4d::Zero();   // df / dy (rows)
    Eigen::Vector4d velocity = Eigen::Vector4d::Zero();  // weights of u in its equation (rows)
    double diagonal = 0;                                 // term added to the diagonal [1]
  };
  /// Contact that slips, with its unknowns.
  struct SlippingContact {
    int start = 0, rows = 3;      // first row and number of rows
    int first = 0;                // index of its first unknown
    double mu = 0, rotation = 0;  // friction, and rotation of d per unit of a tangential unknown
    Eigen::Vector3d d = Eigen::Vector3d::Zero();  // direction of the slip, unit
    Eigen::Matrix<double, 3, 2> P = Eigen::Matrix<double, 3, 2>::Zero();  // perpendicular to d
  };

  void classify_blocks(const ScaledContacts& contacts, Eigen::Ref<Eigen::VectorXd> f,
                       const Eigen::Ref<const Eigen::VectorXd>& u);
  void classify_cone(const ScaledBlock& block, Eigen::Ref<Eigen::VectorXd> f,
                     const Eigen::Ref<const Eigen::VectorXd>& u);
  void add_zero_velocity_row(int row);
  void add_slip_unknowns(SlippingContact* contact, double fn,
                         const Eigen::Ref<const Eigen::VectorXd>& u);
  void assemble(const ScaledContacts& contacts, const Eigen::Ref<const Eigen::VectorXd>& u);
  [[nodiscard]] bool solve_linear(double proximal);
  void update_impulses(Eigen::Ref<Eigen::VectorXd> f) const;

  std::vector<Unknown> unknowns_;
  std::vector<SlippingContact> slips_;
  // Workspace, of which the first entries are used
  Eigen::MatrixXd R_, factor_;                               // (rows, rows)
  Eigen::VectorXd column_, rhs_, y_, remainder_, f_before_;  // (rows)
  InPlaceLu lu_;
};

}  // namespace thenar::internal
