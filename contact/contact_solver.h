#pragma once

/// Impulses that answer a contact problem, by several methods behind one call.

#include <array>
#include <memory>
#include <string>

#include <Eigen/Core>

#include "base/enum_names.h"
#include "contact/contact_problem.h"
#include "solvers/status.h"

namespace thenar {

enum class ContactMethod {
  kAutomatic,      // Newton from the warm start; where it does not arrive, sweeps, pivots, interior
                   // points and other starts, most ended by Newton
  kNewton,         // semismooth Newton alone, from the warm start
  kGaussSeidel,    // sweeps with exact answers of each block, from the warm start
  kInteriorPoint,  // interior points, last digits by Newton; has no use for a warm start
  kPyramid         // Lemke's algorithm on friction pyramids; has no use for a warm start
};
inline constexpr std::array kContactMethodNames{
    EnumName{ContactMethod::kAutomatic, "automatic"}, EnumName{ContactMethod::kNewton, "Newton"},
    EnumName{ContactMethod::kGaussSeidel, "Gauss-Seidel"},
    EnumName{ContactMethod::kInteriorPoint, "interior point"},
    EnumName{ContactMethod::kPyramid, "pyramid"}};
[[nodiscard]] inline std::string name_of(ContactMethod method) {
  return name_in(kContactMethodNames, method);
}

struct ContactSolverOptions {
  ContactMethod method = ContactMethod::kAutomatic;
  double tolerance = 1e-11;  // of ContactResidual::natural [1]
  int max_newton_steps = 2000;
  int max_sweeps = 5000;  // of Gauss-Seidel
  int max_interior_steps = 400;
  int pyramid_edges = 8;  // of a pyramid, even and at least 4
};

struct [[nodiscard]] ContactSolution {
  /// kSolved: residual.is_within(tolerance); of pyramids, pyramid_residual is at most that. kLimit:
  /// a limit of the options was reached. kInfeasible: proven by Lemke's ray, of pyramids alone.
  /// kStalled: all else. f is then the best found, and residual says how good.
  Status status = Status::kStalled;
  ContactMethod method = ContactMethod::kAutomatic;  // that found f
  Eigen::VectorXd f;                                 // impulses [N s] or [N m s] (n)
  Eigen::VectorXd u;                                 // W f + b [m/s] or [rad/s] (n)
  ContactResidual residual;                          // of f on the true cones, from W and b
  double pyramid_residual = 0;  // complementarity_residual() of the pyramids [1]
  int newton_steps = 0;         // one linear system each
  int sweeps = 0;               // of Gauss-Seidel
  int interior_steps = 0;       // one linear system each
  int pivots = 0;               // of Lemke's algorithm
};

/// Solves one contact problem after another, and keeps the room that they need: once it has seen a
/// problem as large, it leaves the heap alone (but for pivots and pyramids, and f and u where their
/// number of rows changes). The answer depends on the problem, the warm start and the options
/// alone, bit for bit.
class ContactSolver {
 public:
  ContactSolver();
  ~ContactSolver();
  ContactSolver(ContactSolver&&) noexcept;
  ContactSolver& operator=(ContactSolver&&) noexcept;

  /// A warm start that is an answer is returned as it is, unless a step of Newton halves its
  /// residual (on the way to rounding, which every answer but that of Gauss-Seidel goes). Where
  /// answers are not unique (redundant contacts), the one found depends on the warm start; impulses
  /// that W does not feel stay near it.
  /// @param warm_start  impulses that may be near (n), or none (0): all zero
  /// @returns what stays valid until the next call
  /// @throws InputError as check_contact_problem(), unless warm_start is finite and fits, and
  ///         unless the tolerance is positive and pyramid_edges as they must be
  const ContactSolution& solve(const ContactProblem& problem,
                               const Eigen::Ref<const Eigen::VectorXd>& warm_start,
                               const ContactSolverOptions& options = {});

 private:
  struct Workspace;
  std::unique_ptr<Workspace> work_;
};

}  // namespace thenar
