#pragma once

/// Solver of contact problems, with several methods behind one interface.

#include <array>
#include <memory>
#include <string>

#include <Eigen/Core>

#include "base/enum_names.h"
#include "contact/contact_problem.h"
#include "solvers/status.h"

namespace thenar {

/// Method of a contact solver.
enum class ContactMethod {
  kAutomatic,      // Newton from the warm start; if it fails, Gauss-Seidel sweeps, pivoting,
                   // interior points and random starts, mostly followed by Newton
  kNewton,         // semismooth Newton alone, from the warm start
  kGaussSeidel,    // block Gauss-Seidel with exact local solutions, from the warm start
  kInteriorPoint,  // interior points, polished by Newton; ignores the warm start
  kPyramid         // Lemke's algorithm on friction pyramids; ignores the warm start
};
inline constexpr std::array kContactMethodNames{
    EnumName{ContactMethod::kAutomatic, "automatic"}, EnumName{ContactMethod::kNewton, "Newton"},
    EnumName{ContactMethod::kGaussSeidel, "Gauss-Seidel"},
    EnumName{ContactMethod::kInteriorPoint, "interior point"},
    EnumName{ContactMethod::kPyramid, "pyramid"}};
[[nodiscard]] inline std::string name_of(ContactMethod method) {
  return name_in(kContactMethodNames, method);
}

/// Options of a contact solver.
struct ContactSolverOptions {
  ContactMethod method = ContactMethod::kAutomatic;
  double tolerance = 1e-11;      // largest ContactResidual::natural of a solution [1]
  int max_newton_steps = 2000;   // largest number of Newton steps
  int max_sweeps = 5000;         // largest number of Gauss-Seidel sweeps
  int max_interior_steps = 400;  // largest number of interior-point steps
  int pyramid_edges = 8;         // number of edges of a friction pyramid, even and at least 4
};

/// Solution of a contact problem.
struct [[nodiscard]] ContactSolution {
  /// kSolved: residual.is_within(tolerance); for pyramids, pyramid_residual <= tolerance. kLimit:
  /// a limit of the options was reached. kInfeasible: proven by a ray of Lemke's algorithm, for
  /// pyramids alone. kStalled: any other failure. After a failure f is the best iterate found.
  Status status = Status::kStalled;
  ContactMethod method = ContactMethod::kAutomatic;  // method that found f
  Eigen::VectorXd f;                                 // impulses [N s] or [N m s] (n)
  Eigen::VectorXd u;                                 // velocities W f + b [m/s] or [rad/s] (n)
  ContactResidual residual;                          // residuals of f on the exact cones
  double pyramid_residual = 0;  // complementarity_residual() of the pyramids [1]
  int newton_steps = 0;         // Newton steps, one linear system each
  int sweeps = 0;               // Gauss-Seidel sweeps
  int interior_steps = 0;       // interior-point steps, one linear system each
  int pivots = 0;               // pivots of Lemke's algorithm
};

/// Solver of a sequence of contact problems with a reusable workspace: memory is allocated only for
/// a problem that is larger than all before (except in pivoting and pyramids, and for f and u when
/// their size changes). The solution depends on the problem, the warm start and the options alone,
/// and is deterministic to the bit.
class ContactSolver {
 public:
  ContactSolver();
  ~ContactSolver();
  ContactSolver(ContactSolver&&) noexcept;
  ContactSolver& operator=(ContactSolver&&) noexcept;

  /// Solves a contact problem.
  ///
  /// All methods but Gauss-Seidel polish a solution by Newton steps down to rounding. A warm start
  /// that already is a solution is returned unchanged, unless polishing at least halves its
  /// residual. If solutions are not unique (redundant contacts), the result depends on the warm
  /// start, and stays near it in the null space of W.
  /// @param warm_start  initial impulses (n), or empty (0) for zero
  /// @returns reference that is valid until the next call
  /// @throws InputError as check_contact_problem(), or if warm_start is not finite or has the wrong
  ///         size, the tolerance is not positive, or pyramid_edges is odd or below 4
  const ContactSolution& solve(const ContactProblem& problem,
                               const Eigen::Ref<const Eigen::VectorXd>& warm_start,
                               const ContactSolverOptions& options = {});

 private:
  struct Workspace;
  std::unique_ptr<Workspace> work_;
};

}  // namespace thenar
