#pragma once

/// Newton's steps on the active rows of a contact problem.

#include <vector>

#include <Eigen/Core>

#include "contact/in_place_lu.h"
#include "contact/scaled_contacts.h"

namespace thenar::internal {

/// A semismooth Newton method on  fn = (fn - un)+,  ft = P_{mu (fn - un)}(ft - ut)
/// [AlartCurnier1991], which has the answers of De Saxce's form. Each step reads from p = f - u
/// what every block does,
///   open   p_n <= 0             f = 0
///   stick  |p_t| <= mu p_n      u = 0
///   slip   otherwise            un = 0,  ft = -mu fn d,  ut = s d,  d = -p_t / |p_t|,
/// and solves these equations linearised. A slipping contact moves on its cone: its unknowns are fn
/// and a turn of d, so two rows (soft finger: three) are left of three (four), and its impulse is
/// on the cone to rounding. Steps are proximal by 1e-10 of the diagonal and refined, so W may be
/// singular. Quadratic near an answer; nothing is promised far from one.
class ContactNewton {
 public:
  /// Allocates memory for a problem of this size.
  void assign(const ScaledContacts& contacts);

  /// One step from f, u to a new f and  u = A f + b.
  /// @param proximal  what is added to the diagonal of A, which is 1; at least 1e-10 is [1]
  /// @returns false, with f unspoilt, where the linear system has no answer
  [[nodiscard]] bool step(const ScaledContacts& contacts, double proximal,
                          Eigen::Ref<Eigen::VectorXd> f, Eigen::Ref<Eigen::VectorXd> u);

 private:
  /// A scalar unknown: what it adds to f, and which velocity it makes zero.
  struct Unknown {
    int start = 0, rows = 1;                             // of its block's part that it touches
    Eigen::Vector4d impulse = Eigen::Vector4d::Zero();   // df / dy (rows)
    Eigen::Vector4d velocity = Eigen::Vector4d::Zero();  // weights of u in its equation (rows)
    double own = 0;                                      // added to the diagonal
  };
  struct Slipping {
    int start = 0, rows = 3, first = 0;  // first of its unknowns
    double mu = 0, turn = 0;             // turn of d per unit of a tangential unknown
    Eigen::Vector3d d = Eigen::Vector3d::Zero();
    Eigen::Matrix<double, 3, 2> P = Eigen::Matrix<double, 3, 2>::Zero();  // perpendicular to d
  };

  void read_states(const ScaledContacts& contacts, Eigen::Ref<Eigen::VectorXd> f,
                   const Eigen::Ref<const Eigen::VectorXd>& u);
  void read_cone(const ScaledBlock& block, Eigen::Ref<Eigen::VectorXd> f,
                 const Eigen::Ref<const Eigen::VectorXd>& u);
  void add_row(int row);
  void add_slipping(Slipping* contact, double fn, const Eigen::Ref<const Eigen::VectorXd>& u);
  void assemble(const ScaledContacts& contacts, const Eigen::Ref<const Eigen::VectorXd>& u);
  [[nodiscard]] bool solve_linear(double proximal);
  void apply(Eigen::Ref<Eigen::VectorXd> f) const;

  std::vector<Unknown> unknowns_;
  std::vector<Slipping> slipping_;
  Eigen::MatrixXd R_, factor_;                          // (room, room)
  Eigen::VectorXd column_, rhs_, y_, rest_, f_before_;  // (room)
  InPlaceLu lu_;
};

}  // namespace thenar::internal
