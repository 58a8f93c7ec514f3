#include "contact/contact_solver.h"

#include "base/error.h"
#include "base/numbers.h"
#include "base/random_stream.h"
#include "base/stop_scope.h"
#include "contact/contact_newton.h"
#include "contact/friction_pyramids.h"
#include "contact/gauss_seidel.h"
#include "contact/interior_contact.h"
#include "contact/sliding_pivots.h"

namespace thenar {

using Eigen::Index;
using Eigen::Ref;
using Eigen::VectorXd;

namespace {

constexpr double kGoalRatio = 0.5;        // scaled residual goal over the tolerance [1]
constexpr double kRoundingLevel = 1e-8;   // residual below which rounding is considered [1]
constexpr double kPolishGoal = 1e-14;     // residual below which polishing stops [1]
constexpr int kMaxPolishSteps = 2;        // Newton steps that polish a solution, at most
constexpr double kProgressRatio = 0.9;    // residual over the best so far that is progress [1]
constexpr int kMaxIdleSteps = 6;          // steps without progress after which Newton ends
constexpr int kFirstSweeps = 5;           // sweeps of the first round, doubled in each further one
constexpr int kMaxRounds = 2;             // rounds of sweeps and Newton
constexpr int kMaxPivotSteps = 20;        // Newton steps by pivoting
constexpr int kMaxFrozenRuns = 20;        // fixed-point iterations on |ut| of interior points
constexpr int kStepsPerInteriorRun = 40;  // interior-point steps of one such iteration
constexpr double kInteriorGoalRatio = 0.1;  // tolerance of interior points over the goal [1]
constexpr int kMaxRestarts = 20;            // restarts from random impulses
constexpr int kSweepsPerCheck = 5;          // sweeps between two evaluations of the residual
constexpr std::uint64_t kRestartSeed = 1;   // seed of the random impulses

/// Damping of Newton steps: with kYes the proximal term grows while the residual does not decrease.
enum class Damped { kNo, kYes };
constexpr double kMinDamping = 0.3, kMaxDamping = 10;  // proximal term over the residual [1]

}  // namespace

/// Workspace of a solve. The run_*() functions start from f, and return true if they reach the
/// goal.
struct ContactSolver::Workspace {
  internal::ScaledContacts contacts;
  internal::ContactNewton newton;
  internal::GaussSeidel sweeper;
  internal::InteriorContact interior;
  bool sweeper_ready = false, is_warm = false;
  VectorXd f_storage, u_storage, best_f_storage, interior_f_storage;  // scaled, may be longer (n)
  double residual = 0, best = 0, goal = 0;  // residual of f, of the best f, and the goal [1]
  ContactSolverOptions options;
  ContactSolution solution;

  auto f() { return f_storage.head(contacts.rows()); }
  auto u() { return u_storage.head(contacts.rows()); }

  [[nodiscard]] bool polishes() const { return options.method != ContactMethod::kGaussSeidel; }

  void assign(const ContactProblem& problem, const Ref<const VectorXd>& warm_start) {
    // Scale the problem, and grow the vectors if needed.
    contacts.assign(problem);
    newton.assign(contacts);
    sweeper_ready = false;
    const Index n = contacts.rows();
    if (n > f_storage.size())
      for (VectorXd* v : {&f_storage, &u_storage, &best_f_storage, &interior_f_storage})
        v->resize(n);
    // Reset counters and goal; the rest of the tolerance is for rounding when scaling back.
    solution.newton_steps = solution.sweeps = solution.interior_steps = solution.pivots = 0;
    solution.pyramid_residual = 0;
    solution.method = options.method;
    goal = kGoalRatio * options.tolerance;
    best = kInfinity;
    // Ignore a warm start if the scale is 0: then f = 0 is the solution, and any rounding of a warm
    // start would have an infinite residual.
    is_warm = warm_start.size() > 0 && contacts.scale() > 0;
    f().setZero();
    if (is_warm) f() = warm_start.cwiseQuotient(contacts.s());
    set_impulses(f());
  }

  /// Computes the residual of f, and stores f if it is the best so far. @return true at the goal
  bool record_residual() {
    residual = contacts.residual(f(), u());
    if (residual < best) {
      best = residual;
      best_f_storage.head(contacts.rows()) = f();
    }
    // Within the goal, or within the rounding error.
    return residual <= goal ||
           (residual < kRoundingLevel && residual <= kGoalRatio * contacts.rounding(f()));
  }

  /// Sets f and u.
  void set_impulses(const Ref<const VectorXd>& impulses) {
    f() = impulses;
    u().noalias() = contacts.A() * f();
    u() += contacts.b();
  }

  /// Takes Newton steps until they make no progress.
  bool run_newton(Damped damped);

  /// Takes Gauss-Seidel sweeps.
  bool run_sweeps(int sweeps) {
    // Prepare the local problems of the blocks, once for each problem.
    if (!sweeper_ready) sweeper.assign(contacts);
    sweeper_ready = true;
    // Compute u and the residual only after each group of sweeps.
    sweeps = std::min(sweeps, options.max_sweeps - solution.sweeps);
    for (int done = 0; done < sweeps; done += kSweepsPerCheck) {
      const int count = std::min(kSweepsPerCheck, sweeps - done);
      sweeper.sweep(contacts, count, f());
      solution.sweeps += count;
      set_impulses(f());
      if (record_residual()) {
        solution.method = ContactMethod::kGaussSeidel;
        return true;
      }
    }
    return false;
  }

  /// Alternates sweeps from the best f and Newton steps.
  bool run_sweeps_and_newton() {
    for (int k = 0; k < kMaxRounds; ++k) {
      f() = best_f_storage.head(contacts.rows());
      if (run_sweeps(kFirstSweeps << k) || run_newton(Damped::kYes)) return true;
    }
    return false;
  }

  /// Takes Newton steps from the best f, whose loaded contacts are chosen by pivoting.
  bool run_pivots() {
    f() = best_f_storage.head(contacts.rows());
    set_impulses(f());
    for (int k = 0; k < kMaxPivotSteps; ++k) {
      const double before = residual;
      if (!internal::take_pivoting_step(contacts, f(), u(), solution.pivots)) return false;
      set_impulses(f());
      if (record_residual()) {
        solution.method = ContactMethod::kNewton;
        return true;
      }
      // Stop when the residual no longer decreases.
      if (k > 2 && residual > kProgressRatio * before) break;
    }
    return false;
  }

  /// Runs interior points with |ut| as an unknown, then as a fixed point. Each run is followed by
  /// Newton steps, as interior points identify the state of every contact (open, stick, slip).
  bool run_interior() {
    using Coupling = internal::InteriorContact::Coupling;
    auto interior_f = interior_f_storage.head(contacts.rows());
    interior_f.setZero();
    // The first run has |ut| as an unknown; the others freeze it at the impulses of the run before.
    for (int k = 0; k <= kMaxFrozenRuns; ++k) {
      const int max_steps =
          std::min(kStepsPerInteriorRun, options.max_interior_steps - solution.interior_steps);
      if (max_steps <= 0) return false;
      solution.interior_steps += interior.run(contacts, k > 0 ? Coupling::kFrozen : Coupling::kFull,
                                              max_steps, kInteriorGoalRatio * goal, interior_f);
      // Refine the result by Newton steps.
      set_impulses(interior_f);
      if (record_residual() || run_newton(Damped::kYes)) {
        solution.method = ContactMethod::kInteriorPoint;
        return true;
      }
    }
    return false;
  }

  /// Restarts sweeps and Newton from random normal impulses: the iterations may converge to a point
  /// that is not a solution, as there is no merit function with minima at solutions alone.
  bool run_restarts() {
    for (int start = 0; start < kMaxRestarts; ++start) {
      // Random normal impulses up to twice the scale, without friction.
      RandomStream random(kRestartSeed, 0, static_cast<std::uint32_t>(start));
      for (const internal::ScaledBlock& block : contacts.blocks()) {
        f().segment(block.start, block.rows).setZero();
        f()(block.start) = 2 * contacts.scale() * random.uniform();
        if (!block.is_cone())
          f()(block.start) = std::clamp(f()(block.start), block.lower, block.upper);
      }
      // Few sweeps and undamped Newton steps, then more sweeps and damped steps.
      if (run_sweeps(kFirstSweeps) || run_newton(Damped::kNo)) return true;
      if (run_sweeps(2 * kFirstSweeps) || run_newton(Damped::kYes)) return true;
    }
    return false;
  }

  /// Runs the methods of kAutomatic in order of their cost.
  bool run_automatic() {
    // Start from the warm start: Newton, then sweeps with Newton, then pivoting.
    if (run_newton(Damped::kYes) || run_sweeps_and_newton() || run_pivots()) return true;
    // Start from zero, in case the warm start was misleading.
    if (is_warm) {
      f().setZero();
      set_impulses(f());
      if (record_residual() || run_newton(Damped::kYes)) return true;
    }
    // Slower methods that need no warm start.
    if (run_interior() || run_restarts()) return true;
    // Last resort: sweeps from the best f up to max_sweeps.
    f() = best_f_storage.head(contacts.rows());
    for (int sweeps = 4 * kFirstSweeps; solution.sweeps < options.max_sweeps; sweeps *= 2)
      if (run_sweeps(sweeps)) return true;
    return false;
  }

  bool run() {
    switch (options.method) {
      case ContactMethod::kNewton:
        return run_newton(Damped::kYes);
      case ContactMethod::kGaussSeidel:
        return run_sweeps(options.max_sweeps);
      case ContactMethod::kInteriorPoint:
        return run_interior();
      default:
        return run_automatic();
    }
  }

  /// Improves a solution towards rounding by Newton steps that at least halve the residual, because
  /// its errors would accumulate over time steps.
  void polish() {
    for (int k = 0; k < kMaxPolishSteps && best > kPolishGoal; ++k) {
      // Undamped step from the best f.
      const double before = best;
      set_impulses(best_f_storage.head(contacts.rows()));
      ++solution.newton_steps;
      if (!newton.step(contacts, 0, f(), u())) return;
      (void)record_residual();
      if (best > before / 2) return;
    }
  }

  /// Solves the problem with friction pyramids, and stores the solution.
  void run_pyramid(const ContactProblem& problem) {
    // Solve the complementarity problem of the pyramids by Lemke's algorithm.
    const internal::PyramidProblem pyramids =
        internal::friction_pyramids(contacts, options.pyramid_edges);
    ComplementarityOptions pivoting;
    pivoting.tolerance = options.tolerance;
    const ComplementaritySolution found = solve_complementarity(pyramids.lcp, pivoting);
    solution.pivots = found.pivots;
    // Store impulses with residuals on the exact cones, but the status of the pyramids.
    best_f_storage.head(contacts.rows()) =
        pyramids.origin + pyramids.generators * found.z.head(pyramids.generators.cols());
    set_solution(problem);
    solution.status = found.status;
    solution.pyramid_residual = found.residual;
  }

  /// Returns true if the warm start is a solution. It is then returned unchanged, unless polishing
  /// at least halves its residual.
  bool accept_warm_start(const ContactProblem& problem, const Ref<const VectorXd>& warm_start) {
    // Residual of the unscaled warm start, as scaling there and back would change its bits.
    solution.f = warm_start;
    solution.u = problem.b;
    solution.u.noalias() += problem.W * warm_start;
    solution.residual = internal::contact_residual_at(problem, solution.f, solution.u);
    if (!solution.residual.is_within(options.tolerance)) return false;
    solution.status = Status::kSolved;
    // Polish the scaled copy, and use it only if its residual is less than half.
    const double before = best;
    if (polishes()) polish();
    if (best < before / 2) set_solution(problem);
    return true;
  }

  /// Stores the best f in the units of the problem, with residuals and status.
  void set_solution(const ContactProblem& problem) {
    solution.f = best_f_storage.head(contacts.rows()).cwiseProduct(contacts.s());
    solution.u = problem.b;
    solution.u.noalias() += problem.W * solution.f;
    solution.residual = internal::contact_residual_at(problem, solution.f, solution.u);
    // Status by the residual; a failure is kLimit if a counter has reached its limit.
    const bool is_at_limit = solution.newton_steps >= options.max_newton_steps ||
                             solution.sweeps >= options.max_sweeps ||
                             solution.interior_steps >= options.max_interior_steps;
    solution.status = solution.residual.is_within(options.tolerance) ? Status::kSolved
                      : is_at_limit                                  ? Status::kLimit
                                                                     : Status::kStalled;
  }
};

bool ContactSolver::Workspace::run_newton(Damped damped) {
  double min_residual = kInfinity, damping = 0;
  residual = contacts.residual(f(), u());
  for (int idle = 0; idle < kMaxIdleSteps && solution.newton_steps < options.max_newton_steps;) {
    ++solution.newton_steps;
    end_if_stopped();
    // The proximal term decreases with the residual, so that convergence stays quadratic.
    const double before = residual;
    if (!newton.step(contacts, damping * std::min(residual, 1.0), f(), u())) return false;
    if (record_residual()) {
      solution.method = ContactMethod::kNewton;
      return true;
    }
    // Halve the damping after a step that halves the residual, double it after any other.
    if (damped == Damped::kYes)
      damping =
          residual < before / 2 ? damping / 2 : std::clamp(2 * damping, kMinDamping, kMaxDamping);
    // Count the steps without progress.
    idle = residual < kProgressRatio * min_residual ? 0 : idle + 1;
    min_residual = std::min(min_residual, residual);
  }
  return false;
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
  require(options.tolerance > 0, "the tolerance must be positive, got {}", options.tolerance);
  require(options.pyramid_edges >= 4 && options.pyramid_edges % 2 == 0,
          "pyramids have an even number of edges, at least 4, got {}", options.pyramid_edges);
  Workspace& work = *work_;
  work.options = options;
  work.assign(problem, warm_start);
  // Pyramids are an approximation with its own status and residual.
  if (options.method == ContactMethod::kPyramid) {
    work.run_pyramid(problem);
    return work.solution;
  }

  // Return a warm start that is already a solution.
  const bool solved = work.record_residual();
  if (warm_start.size() > 0 && work.accept_warm_start(problem, warm_start)) return work.solution;
  // Otherwise run the method, polish its solution, and evaluate it on the unscaled problem.
  if ((solved || work.run()) && work.polishes()) work.polish();
  work.set_solution(problem);
  return work.solution;
}

}  // namespace thenar
