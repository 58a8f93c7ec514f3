#include "dynamics/contact/contact_solver.h"

#include <array>

#include "base/error.h"
#include "dynamics/contact/contact_newton.h"
#include "dynamics/contact/gauss_seidel.h"

namespace thenar {

using Eigen::Index;
using Eigen::Ref;
using Eigen::VectorXd;

namespace {

constexpr double kMargin = 0.5;     // of the tolerance: what scaling back may cost
constexpr double kProgress = 0.9;   // of the best residual: a fall that counts
constexpr int kPatience = 6;        // steps of Newton without such a fall
constexpr int kFirstSweeps = 5;     // before Newton's second try; each try has twice as many
constexpr int kSweepsPerCheck = 5;  // of the residual

}  // namespace

std::string name_of(ContactMethod method) {
  constexpr std::array kNames{"automatic", "Newton", "Gauss-Seidel"};
  return kNames[static_cast<std::size_t>(method)];
}

struct ContactSolver::Workspace {
  internal::ScaledContacts contacts;
  internal::ContactNewton newton;
  internal::GaussSeidel sweeper;
  bool sweeper_ready = false;
  VectorXd f_room, u_room, best_room;  // scaled
  double residual = 0, best = 0, goal = 0;
  ContactSolution solution;

  auto f() { return f_room.head(contacts.rows()); }
  auto u() { return u_room.head(contacts.rows()); }

  void assign(const ContactProblem& problem, const Ref<const VectorXd>& warm_start);
  bool measure();
  bool run_newton(int max_steps);
  bool run_sweeps(int sweeps);
  void run_automatic(const ContactSolverOptions& options);
  void finish(const ContactProblem& problem, double tolerance);
};

void ContactSolver::Workspace::assign(const ContactProblem& problem,
                                      const Ref<const VectorXd>& warm_start) {
  contacts.assign(problem);
  newton.assign(contacts);
  sweeper_ready = false;
  const Index n = contacts.rows();
  if (n > f_room.size())
    for (VectorXd* v : {&f_room, &u_room, &best_room}) v->resize(n);
  solution.newton_steps = solution.sweeps = 0;
  f().setZero();
  if (warm_start.size() > 0) f() = warm_start.cwiseQuotient(contacts.s());
  best = std::numeric_limits<double>::infinity();
  u().noalias() = contacts.A() * f();
  u() += contacts.b();
}

/// Measures f and keeps it if it is the best; true at the goal.
bool ContactSolver::Workspace::measure() {
  residual = contacts.residual(f(), u());
  if (residual < best) {
    best = residual;
    best_room.head(contacts.rows()) = f();
  }
  return residual <= goal;
}

/// Steps until the goal, or none counts any more; true at the goal.
bool ContactSolver::Workspace::run_newton(int max_steps) {
  double least = std::numeric_limits<double>::infinity();
  int idle = 0;
  while (solution.newton_steps < max_steps && idle < kPatience) {
    ++solution.newton_steps;
    if (!newton.step(contacts, f(), u())) return false;
    if (measure()) {
      solution.method = ContactMethod::kNewton;
      return true;
    }
    idle = residual < kProgress * least ? 0 : idle + 1;
    least = std::min(least, residual);
  }
  return false;
}

bool ContactSolver::Workspace::run_sweeps(int sweeps) {
  if (!sweeper_ready) sweeper.assign(contacts);
  sweeper_ready = true;
  for (int done = 0; done < sweeps; done += kSweepsPerCheck) {
    const int count = std::min(kSweepsPerCheck, sweeps - done);
    sweeper.sweep(contacts, count, f());
    solution.sweeps += count;
    u().noalias() = contacts.A() * f();
    u() += contacts.b();
    if (measure()) {
      solution.method = ContactMethod::kGaussSeidel;
      return true;
    }
  }
  return false;
}

void ContactSolver::Workspace::run_automatic(const ContactSolverOptions& options) {
  if (run_newton(options.max_newton_steps)) return;
  for (int sweeps = kFirstSweeps; solution.sweeps < options.max_sweeps; sweeps *= 2) {
    // From the best point found, some sweeps, and Newton again.
    f() = best_room.head(contacts.rows());
    if (run_sweeps(std::min(sweeps, options.max_sweeps - solution.sweeps))) return;
    if (run_newton(options.max_newton_steps)) return;
  }
}

void ContactSolver::Workspace::finish(const ContactProblem& problem, double tolerance) {
  solution.f = best_room.head(contacts.rows()).cwiseProduct(contacts.s());
  solution.u = problem.b;
  solution.u.noalias() += problem.W * solution.f;
  solution.residual = internal::contact_residual_at(problem, solution.f, solution.u);
  solution.status = solution.residual.natural <= tolerance ? Status::kSolved : Status::kStalled;
}

ContactSolver::ContactSolver() : work_(std::make_unique<Workspace>()) {}
ContactSolver::~ContactSolver() = default;
ContactSolver::ContactSolver(ContactSolver&&) noexcept = default;
ContactSolver& ContactSolver::operator=(ContactSolver&&) noexcept = default;

const ContactSolution& ContactSolver::solve(const ContactProblem& problem,
                                            const Ref<const VectorXd>& warm_start,
                                            const ContactSolverOptions& options) {
  check_contact_problem(problem);
  require(warm_start.size() == 0 || warm_start.size() == problem.b.size(),
          "b has {} rows, the warm start {}", problem.b.size(), warm_start.size());
  require(warm_start.allFinite(), "a warm start must be finite");

  // The warm start itself may be the answer.
  Workspace& work = *work_;
  work.assign(problem, warm_start);
  work.goal = kMargin * options.tolerance;
  work.solution.method = options.method;
  if (warm_start.size() > 0) {
    work.solution.f = warm_start;
    work.solution.u = problem.b;
    work.solution.u.noalias() += problem.W * warm_start;
    work.solution.residual =
        internal::contact_residual_at(problem, work.solution.f, work.solution.u);
    work.solution.status = Status::kSolved;
    if (work.solution.residual.natural <= options.tolerance) return work.solution;
  }

  // The method.
  if (!work.measure()) {
    if (options.method == ContactMethod::kNewton)
      (void)work.run_newton(options.max_newton_steps);
    else if (options.method == ContactMethod::kGaussSeidel)
      (void)work.run_sweeps(options.max_sweeps);
    else
      work.run_automatic(options);
  }
  work.finish(problem, options.tolerance);
  const bool spent = work.solution.newton_steps >= options.max_newton_steps ||
                     work.solution.sweeps >= options.max_sweeps;
  if (work.solution.status != Status::kSolved && spent) work.solution.status = Status::kLimit;
  return work.solution;
}

}  // namespace thenar
