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

constexpr double kToleranceShare = 0.5;  // Share of the tolerance that scaling back may cost [1]
constexpr double kRoundingFrom = 1e-8;   // Residuals below this may be due to rounding [1]
constexpr double kRoundingGoal = 1e-14;  // Residuals below this are not worth another step [1]
constexpr int kPolishSteps = 2;          // Most Newton steps that polish an answer
// A residual below this share of the best so far counts as progress [1]
constexpr double kProgressRatio = 0.9;
constexpr int kStalledSteps = 6;  // Newton steps without progress after which a try ends
// Sweeps before Newton's second try; each further try has twice as many
constexpr int kFirstSweeps = 5;
constexpr int kMostRounds = 2;      // Most rounds of sweeps and Newton, before interior points
constexpr int kPivotTurns = 20;     // Most Newton steps by pivots
constexpr int kFrozenTurns = 20;    // Most turns of the fixed point on |ut|
constexpr int kInteriorTurn = 40;   // Steps of interior points in one turn
constexpr int kMostRestarts = 20;   // Most restarts from invented impulses
constexpr int kSweepsPerCheck = 5;  // Sweeps between two checks of the residual
constexpr std::uint64_t kRestartSeed = 1;

/// Damping of Newton's steps: with kYes they become more proximal where they do not lower the
/// residual.
enum class Damped { kNo, kYes };
constexpr double kLeastDamping = 0.3, kMostDamping = 10;  // stiffness over the residual [1]

}  // namespace

/// Everything that a solve needs. The runs below go on from f, and are true at the goal.
struct ContactSolver::Workspace {
  internal::ScaledContacts contacts;
  internal::ContactNewton newton;
  internal::GaussSeidel sweeper;
  internal::InteriorContact interior;
  bool sweeper_ready = false, is_warm = false;
  VectorXd f_room, u_room, best_room, turn_room;  // scaled
  double residual = 0, best = 0, goal = 0;        // of f, of the best, and the goal
  ContactSolverOptions options;
  ContactSolution solution;

  auto f() { return f_room.head(contacts.rows()); }
  auto u() { return u_room.head(contacts.rows()); }

  void assign(const ContactProblem& problem, const Ref<const VectorXd>& warm_start);
  bool measure();
  void go_to(const Ref<const VectorXd>& impulses);
  bool run_newton(Damped damped);
  bool run_sweeps(int sweeps);
  bool run_tries();
  bool run_pivots();
  bool run_interior();
  bool run_restarts();
  bool run_automatic();
  void run_pyramid(const ContactProblem& problem);
  bool run();
  void polish();
  [[nodiscard]] bool is_polished() const { return options.method != ContactMethod::kGaussSeidel; }
  bool is_answer(const ContactProblem& problem, const Ref<const VectorXd>& warm_start);
  void certify(const ContactProblem& problem);
};

void ContactSolver::Workspace::assign(const ContactProblem& problem,
                                      const Ref<const VectorXd>& warm_start) {
  // Scaled problem and vectors, whose memory only grows.
  contacts.assign(problem);
  newton.assign(contacts);
  sweeper_ready = false;
  const Index n = contacts.rows();
  if (n > f_room.size())
    for (VectorXd* v : {&f_room, &u_room, &best_room, &turn_room}) v->resize(n);
  // Counters, and the goal: scaling back to units may cost the rest of the tolerance.
  solution.newton_steps = solution.sweeps = solution.interior_steps = solution.pivots = 0;
  solution.pyramid_residual = 0;
  solution.method = options.method;
  goal = kToleranceShare * options.tolerance;
  best = kInfinity;
  // Zero b without a prescribed impulse has the answer f = 0 and the scale 0, over which the
  // rounding of a warm start would be an infinite residual.
  is_warm = warm_start.size() > 0 && contacts.scale() > 0;
  f().setZero();
  if (is_warm) f() = warm_start.cwiseQuotient(contacts.s());
  go_to(f());
}

/// Measures f and keeps it if it is the best.
bool ContactSolver::Workspace::measure() {
  residual = contacts.residual(f(), u());
  if (residual < best) {
    best = residual;
    best_room.head(contacts.rows()) = f();
  }
  // Solved: within the goal, or within what rounding can hide.
  return residual <= goal ||
         (residual < kRoundingFrom && residual <= kToleranceShare * contacts.rounding(f()));
}

/// Sets f and u, without measuring.
void ContactSolver::Workspace::go_to(const Ref<const VectorXd>& impulses) {
  f() = impulses;
  u().noalias() = contacts.A() * f();
  u() += contacts.b();
}

/// Steps of Newton until none counts any more.
bool ContactSolver::Workspace::run_newton(Damped damped) {
  double least = kInfinity, damping = 0;
  residual = contacts.residual(f(), u());
  for (int idle = 0; idle < kStalledSteps && solution.newton_steps < options.max_newton_steps;) {
    ++solution.newton_steps;
    end_if_stopped();
    // Step with a proximal term that falls with the residual, so that convergence stays quadratic.
    const double before = residual;
    if (!newton.step(contacts, damping * std::min(residual, 1.0), f(), u())) return false;
    if (measure()) {
      solution.method = ContactMethod::kNewton;
      return true;
    }
    // Halve the damping after a step that halves the residual, double it after any other.
    if (damped == Damped::kYes)
      damping = residual < before / 2 ? damping / 2
                                      : std::clamp(2 * damping, kLeastDamping, kMostDamping);
    // Count the steps without progress over the best of this try.
    idle = residual < kProgressRatio * least ? 0 : idle + 1;
    least = std::min(least, residual);
  }
  return false;
}

bool ContactSolver::Workspace::run_sweeps(int sweeps) {
  // Prepare the local problems of the blocks, once a problem.
  if (!sweeper_ready) sweeper.assign(contacts);
  sweeper_ready = true;
  // Sweep in small groups; u and the residual are computed only after each group.
  sweeps = std::min(sweeps, options.max_sweeps - solution.sweeps);
  for (int done = 0; done < sweeps; done += kSweepsPerCheck) {
    const int count = std::min(kSweepsPerCheck, sweeps - done);
    sweeper.sweep(contacts, count, f());
    solution.sweeps += count;
    go_to(f());
    if (measure()) {
      solution.method = ContactMethod::kGaussSeidel;
      return true;
    }
  }
  return false;
}

/// Tries sweeps from the best point found, and then Newton again.
bool ContactSolver::Workspace::run_tries() {
  for (int k = 0; k < kMostRounds; ++k) {
    // Start from the best point, with twice as many sweeps each round.
    f() = best_room.head(contacts.rows());
    if (run_sweeps(kFirstSweeps << k) || run_newton(Damped::kYes)) return true;
  }
  return false;
}

/// Takes Newton steps with pivots from the best point found, on the contacts that bear.
bool ContactSolver::Workspace::run_pivots() {
  f() = best_room.head(contacts.rows());
  go_to(f());
  for (int k = 0; k < kPivotTurns; ++k) {
    // Linearise at f and u, and let Lemke's algorithm choose the contacts that bear.
    const double before = residual;
    if (!internal::pivot_sliding(contacts, f(), u(), solution.pivots)) return false;
    go_to(f());
    if (measure()) {
      solution.method = ContactMethod::kNewton;
      return true;
    }
    // End where turns no longer lower the residual.
    if (k > 2 && residual > kProgressRatio * before) break;
  }
  return false;
}

/// Interior points with |ut| as an unknown, then as a fixed point. Each turn ends with Newton: near
/// an answer from the interior the state of every contact (open, stick, slip) is clear.
bool ContactSolver::Workspace::run_interior() {
  using Coupling = internal::InteriorContact::Coupling;
  auto turn = turn_room.head(contacts.rows());
  turn.setZero();
  // The first turn has |ut| as an unknown; the others freeze it at the impulses of the turn before.
  for (int k = 0; k <= kFrozenTurns; ++k) {
    const int most = std::min(kInteriorTurn, options.max_interior_steps - solution.interior_steps);
    if (most <= 0) return false;
    solution.interior_steps +=
        interior.run(contacts, k > 0 ? Coupling::kFrozen : Coupling::kFull, most, 0.1 * goal, turn);
    // Measure, and let Newton find the last digits.
    go_to(turn);
    if (measure() || run_newton(Damped::kYes)) {
      solution.method = ContactMethod::kInteriorPoint;
      return true;
    }
  }
  return false;
}

/// Sweeps and Newton from made-up normal impulses: a method may be held by a point that is no
/// answer, as no function is known that falls towards answers alone.
bool ContactSolver::Workspace::run_restarts() {
  for (int start = 0; start < kMostRestarts; ++start) {
    // Random normal impulses up to twice the scale, no friction; the seed is fixed.
    RandomStream random(kRestartSeed, 0, static_cast<std::uint32_t>(start));
    for (const internal::ScaledBlock& block : contacts.blocks()) {
      f().segment(block.start, block.rows).setZero();
      f()(block.start) = 2 * contacts.scale() * random.uniform();
      if (!block.is_cone())
        f()(block.start) = std::clamp(f()(block.start), block.lower, block.upper);
    }
    // Few sweeps and undamped steps, then more sweeps and damped steps.
    if (run_sweeps(kFirstSweeps) || run_newton(Damped::kNo)) return true;
    if (run_sweeps(2 * kFirstSweeps) || run_newton(Damped::kYes)) return true;
  }
  return false;
}

bool ContactSolver::Workspace::run_automatic() {
  // Try from the warm start: Newton, then sweeps with Newton, then pivots.
  if (run_newton(Damped::kYes) || run_tries() || run_pivots()) return true;
  // Try from zero, because a misleading warm start may be what holds Newton back.
  if (is_warm) {
    f().setZero();
    go_to(f());
    if (measure() || run_newton(Damped::kYes)) return true;
  }
  // Methods that need no start, which are slower.
  if (run_interior() || run_restarts()) return true;
  // Last resort: sweeps from the best point until max_sweeps.
  f() = best_room.head(contacts.rows());
  for (int sweeps = 4 * kFirstSweeps; solution.sweeps < options.max_sweeps; sweeps *= 2)
    if (run_sweeps(sweeps)) return true;
  return false;
}

bool ContactSolver::Workspace::run() {
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

/// Improves an answer to rounding by Newton steps that at least halve the residual, because its
/// errors would add up from step to step.
void ContactSolver::Workspace::polish() {
  for (int k = 0; k < kPolishSteps && best > kRoundingGoal; ++k) {
    // Undamped step from the best f; measure() keeps it only if it is better.
    const double before = best;
    go_to(best_room.head(contacts.rows()));
    ++solution.newton_steps;
    if (!newton.step(contacts, 0, f(), u())) return;
    (void)measure();
    if (best > before / 2) return;
  }
}

void ContactSolver::Workspace::run_pyramid(const ContactProblem& problem) {
  // Lemke's algorithm on the complementarity problem of the pyramids.
  const internal::PyramidProblem pyramids =
      internal::friction_pyramids(contacts, options.pyramid_edges);
  ComplementarityOptions pivoting;
  pivoting.tolerance = options.tolerance;
  const ComplementaritySolution found = solve_complementarity(pyramids.lcp, pivoting);
  solution.pivots = found.pivots;
  // Impulses from the generators; residuals on the true cones, the status of the pyramids.
  best_room.head(contacts.rows()) =
      pyramids.origin + pyramids.generators * found.z.head(pyramids.generators.cols());
  certify(problem);
  solution.status = found.status;
  solution.pyramid_residual = found.residual;
}

/// Returns whether a warm start is an answer. It is then the solution, bit for bit, unless
/// polishing halves its residual.
bool ContactSolver::Workspace::is_answer(const ContactProblem& problem,
                                         const Ref<const VectorXd>& warm_start) {
  // Residual of the warm start as given, because scaling to and fro would change its bits.
  solution.f = warm_start;
  solution.u = problem.b;
  solution.u.noalias() += problem.W * warm_start;
  solution.residual = internal::contact_residual_at(problem, solution.f, solution.u);
  if (!solution.residual.is_within(options.tolerance)) return false;
  solution.status = Status::kSolved;
  // Polish its scaled copy, and take the result only if that halves the residual.
  const double before = best;
  if (is_polished()) polish();
  if (best < before / 2) certify(problem);
  return true;
}

/// The best f in the problem's own units, and its residual from W and b.
void ContactSolver::Workspace::certify(const ContactProblem& problem) {
  solution.f = best_room.head(contacts.rows()).cwiseProduct(contacts.s());
  solution.u = problem.b;
  solution.u.noalias() += problem.W * solution.f;
  solution.residual = internal::contact_residual_at(problem, solution.f, solution.u);
  // Status from that residual; a failure is a limit where a count has run out.
  const bool spent = solution.newton_steps >= options.max_newton_steps ||
                     solution.sweeps >= options.max_sweeps ||
                     solution.interior_steps >= options.max_interior_steps;
  solution.status = solution.residual.is_within(options.tolerance) ? Status::kSolved
                    : spent                                        ? Status::kLimit
                                                                   : Status::kStalled;
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
  // Pyramids: an approximation with a status and a residual of its own.
  if (options.method == ContactMethod::kPyramid) {
    work.run_pyramid(problem);
    return work.solution;
  }

  // Return a warm start that is an answer already.
  const bool solved = work.measure();
  if (warm_start.size() > 0 && work.is_answer(problem, warm_start)) return work.solution;
  // Otherwise run the method, polish its answer and certify it on the unscaled problem.
  if ((solved || work.run()) && work.is_polished()) work.polish();
  work.certify(problem);
  return work.solution;
}

}  // namespace thenar
