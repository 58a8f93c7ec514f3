#pragma once

/// Impulses that answer a contact problem, by several methods behind one call.

#include <memory>
#include <string>

#include <Eigen/Core>

#include "dynamics/contact/contact_problem.h"
#include "solvers/status.h"

namespace thenar {

enum class ContactMethod {
  kAutomatic,    // Newton from the warm start; sweeps and interior points where it does not arrive
  kNewton,       // semismooth Newton alone, from the warm start
  kGaussSeidel,  // block sweeps with exact answers of each block
};

/// "automatic", "Newton" or "Gauss-Seidel".
[[nodiscard]] std::string name_of(ContactMethod method);

struct ContactSolverOptions {
  ContactMethod method = ContactMethod::kAutomatic;
  double tolerance = 1e-12;    // of ContactResidual::natural [1]
  int max_newton_steps = 200;  // in all
  int max_sweeps = 5000;       // of Gauss-Seidel, in all
};

struct [[nodiscard]] ContactSolution {
  /// kSolved: residual.natural is at most the tolerance. kLimit, kStalled: f is the best found.
  Status status = Status::kStalled;
  ContactMethod method = ContactMethod::kAutomatic;  // that found f
  Eigen::VectorXd f;                                 // impulses [N s] or [N m s] (n)
  Eigen::VectorXd u;                                 // W f + b [m/s] or [rad/s] (n)
  ContactResidual residual;                          // of f, from W and b
  int newton_steps = 0;                              // one linear system each
  int sweeps = 0;                                    // of Gauss-Seidel
};

/// Solves one contact problem after another, and keeps the room that they need: once it has seen a
/// problem as large, it leaves the heap alone, but for f and u where their number of rows changes.
/// The answer depends on the problem, the warm start and the options alone, bit for bit.
class ContactSolver {
 public:
  ContactSolver();
  ~ContactSolver();
  ContactSolver(ContactSolver&&) noexcept;
  ContactSolver& operator=(ContactSolver&&) noexcept;

  /// Where the warm start is an answer, it is returned as it is. Where answers are not unique
  /// (redundant contacts), the one found depends on the warm start and stays near it.
  /// @param warm_start  impulses that may be near (n), or none (0): all zero
  /// @returns what stays valid until the next call
  /// @throws InputError as check_contact_problem(), and unless warm_start is finite and fits
  const ContactSolution& solve(const ContactProblem& problem,
                               const Eigen::Ref<const Eigen::VectorXd>& warm_start,
                               const ContactSolverOptions& options = {});

 private:
  struct Workspace;
  std::unique_ptr<Workspace> work_;
};

}  // namespace thenar
