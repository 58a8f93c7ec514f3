// Tests for contact/contact_solver.cpp: thousands of random problems, by a residual of
// their own.

#include <gtest/gtest.h>

#include <cmath>

#include "contact/contact_solver.h"
#include "tests/contact/contact_samples.h"

namespace thenar {
namespace {

using Eigen::Index;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// Faults of an answer by the words of the laws, in no norm of the library: velocities over the
/// largest velocity of the block's kind of row, impulses over the largest impulse of all rows of
/// that kind, powers over the product.
struct LawCheck {
  double velocity = 0, impulse = 0;  // sizes that faults are measured by
  double worst = 0;

  void velocity_is_zero(double u) { worst = std::max(worst, std::abs(u) / velocity); }
  void velocity_is_not_negative(double u) { worst = std::max(worst, -u / velocity); }
  void impulse_is_not_negative(double f) { worst = std::max(worst, -f / impulse); }
  void one_is_zero(double u, double f) {
    worst = std::max(worst, std::min(std::abs(u) / velocity, std::abs(f) / impulse));
  }
  void power_is_zero(double p) { worst = std::max(worst, std::abs(p) / (velocity * impulse)); }
};

void check_friction(const VectorXd& f, const VectorXd& u, double mu, LawCheck* check) {
  // f, u: normal, then all that shares one limit.
  const VectorXd ft = f.tail(f.size() - 1), ut = u.tail(u.size() - 1);
  check->impulse_is_not_negative(f(0));
  check->velocity_is_not_negative(u(0));
  check->power_is_zero(f(0) * u(0));
  check->impulse_is_not_negative(mu * f(0) - ft.norm());
  // All friction against the slip: no other force of the disc takes more power.
  check->power_is_zero(ft.dot(ut) + mu * f(0) * ut.norm());
}

/// 1 / root of the largest diagonal entry of a block, but for torsion.
double size_of(const ContactProblem& problem, const ContactBlock& block, Index start) {
  const Index rows = std::min(row_count(block.law), 3);
  return 1 / std::sqrt(problem.W.diagonal().segment(start, rows).maxCoeff());
}

double law_violation(const ContactProblem& problem, const VectorXd& f) {
  const VectorXd u = problem.W * f + problem.b;
  LawCheck check;
  // Sizes by energy: the root of each block's largest mobility brings its rows to one unit.
  Index start = 0;
  for (const ContactBlock& block : problem.blocks) {
    const double m = size_of(problem, block, start);
    const Index rows = std::min(row_count(block.law), 3);
    check.velocity =
        std::max(check.velocity, problem.b.segment(start, rows).lpNorm<Eigen::Infinity>() * m);
    check.impulse = std::max(check.impulse, f.segment(start, rows).lpNorm<Eigen::Infinity>() / m);
    start += row_count(block.law);
  }
  check.impulse = std::max(check.impulse, check.velocity);
  Index i = 0;
  for (const ContactBlock& block : problem.blocks) {
    const Index rows = row_count(block.law);
    // One size of a block, so that cones stay cones.
    const double m = size_of(problem, block, i);
    VectorXd g = f.segment(i, rows) / m, v = u.segment(i, rows) * m;
    if (rows == 1) {
      const bool two_sided = block.law == ConstraintLaw::kBox;
      const double lower = block.lower / m, upper = block.upper / m;
      if (block.law == ConstraintLaw::kBilateral) {
        check.velocity_is_zero(v(0));
      } else {
        const double low = two_sided ? lower : 0;
        check.impulse_is_not_negative(g(0) - low);
        if (two_sided) check.impulse_is_not_negative(upper - g(0));
        if (!two_sided) check.velocity_is_not_negative(v(0));
        if (v(0) > 0) check.one_is_zero(v(0), g(0) - low);
        if (v(0) < 0 && two_sided) check.one_is_zero(v(0), upper - g(0));
      }
    } else {
      if (rows == 4) {
        g(3) /= block.torsion_radius;
        v(3) *= block.torsion_radius;
      }
      check_friction(g, v, block.friction, &check);
    }
    i += rows;
  }
  return check.worst;
}

constexpr double kLawTolerance = 1e-9;  // 100 tolerances of the solver; sizes differ from its own

/// Problem number `trial` of `contacts` blocks on one to three bodies.
ContactProblem trial_problem(int trial, int contacts, double friction_high, double mass_decades) {
  std::mt19937 rng(static_cast<unsigned>(1000 * contacts + trial));
  sample::RandomTouch like;
  like.contacts = contacts;
  like.bodies = 1 + trial % 3;
  like.friction_high = friction_high;
  like.mass_decades = mass_decades;
  return sample::random_touch(rng, like).problem();
}

struct Tally {
  int problems = 0, solved = 0;
};

Tally count_solved(const std::vector<int>& sizes, int trials, double friction_high,
                   double mass_decades) {
  Tally out;
  ContactSolver solver;
  for (const int contacts : sizes) {
    for (int trial = 0; trial < trials; ++trial) {
      const ContactProblem problem = trial_problem(trial, contacts, friction_high, mass_decades);
      const ContactSolution& found = solver.solve(problem, VectorXd());
      ++out.problems;
      if (found.status != Status::kSolved) continue;
      ++out.solved;
      EXPECT_LT(law_violation(problem, found.f), kLawTolerance) << contacts << " " << trial;
    }
  }
  return out;
}

// Friction up to 1.2, masses 0.1 to 10 kg, soft fingers, limits, boxes and ties: every one.
TEST(RandomContacts, AllAreSolvedAndCertified) {
  const Tally found = count_solved({1, 2, 3, 4, 6, 8}, 900, 1.2, 1);
  EXPECT_EQ(found.problems, 5400);
  EXPECT_EQ(found.solved, found.problems);
}

// Many contacts on few bodies: heavily redundant.
TEST(RandomContacts, LargeSetsAreSolvedAndCertified) {
  const Tally found = count_solved({12, 20}, 100, 1.2, 1);
  EXPECT_EQ(found.solved, found.problems);
}

// Friction to 5 and masses from 1 g to 1000 kg wedge: nine in ten and more are solved, and where
// one is not, the status says so. Nothing is called solved that breaks a law.
TEST(RandomContacts, WedgedSetsAreSolvedOrSaidNotToBe) {
  const Tally found = count_solved({2, 4, 8}, 150, 5, 3);
  EXPECT_GE(found.solved, 0.95 * found.problems);
}

// The check itself must see faults.
TEST(RandomContacts, CheckSeesSmallFaults) {
  const ContactProblem problem = trial_problem(3, 4, 1.2, 1);
  ContactSolver solver;
  const ContactSolution found = solver.solve(problem, VectorXd());
  ASSERT_EQ(found.status, Status::kSolved);
  for (Index i = 0; i < found.f.size(); ++i) {
    VectorXd f = found.f;
    f(i) += 1e-5 * found.f.cwiseAbs().maxCoeff();
    EXPECT_GT(law_violation(problem, f), kLawTolerance) << i;
  }
}

// No force of the disc takes more power from the slip than the one found.
TEST(RandomContacts, FrictionDissipatesMost) {
  std::mt19937 rng(5);
  ContactSolver solver;
  int sliding = 0;
  for (int trial = 0; trial < 100; ++trial) {
    const ContactProblem problem = trial_problem(trial, 4, 1.2, 1);
    const ContactSolution& found = solver.solve(problem, VectorXd());
    ASSERT_EQ(found.status, Status::kSolved);
    Index i = 0;
    for (const ContactBlock& block : problem.blocks) {
      const Index rows = row_count(block.law);
      if (rows >= 3 && found.f(i) > 1e-6) {
        VectorXd ft = found.f.segment(i + 1, rows - 1), ut = found.u.segment(i + 1, rows - 1);
        if (rows == 4) ft(2) /= block.torsion_radius, ut(2) *= block.torsion_radius;
        const double radius = block.friction * found.f(i), power = ft.dot(ut);
        sliding += ut.norm() > 1e-6 ? 1 : 0;
        for (int sample = 0; sample < 50; ++sample) {
          const VectorXd other =
              radius * sample::random_direction(rng).head(rows - 1);  // within the disc
          EXPECT_GE(other.dot(ut), power - 1e-9 * (1 + radius * ut.norm()));
        }
      }
      i += rows;
    }
  }
  EXPECT_GT(sliding, 50);
}

// Without friction answers are those of a convex problem: velocities are unique, so all methods
// must agree on them.
TEST(RandomContacts, MethodsAgreeWithoutFriction) {
  ContactSolver solver;
  for (int trial = 0; trial < 200; ++trial) {
    ContactProblem problem = trial_problem(trial, 6, 1.2, 1);
    for (ContactBlock& block : problem.blocks) block.friction = 0;
    const VectorXd u = solver.solve(problem, VectorXd()).u;
    for (const ContactMethod method : {ContactMethod::kInteriorPoint, ContactMethod::kPyramid}) {
      ContactSolverOptions options;
      options.method = method;
      const ContactSolution& found = solver.solve(problem, VectorXd(), options);
      ASSERT_EQ(found.status, Status::kSolved) << trial << name_of(method);
      EXPECT_LT((found.u - u).norm(), 1e-7 * problem.b.norm()) << trial << name_of(method);
    }
  }
}

// An answer, given as the warm start, comes back as it is, by every method that takes one.
TEST(RandomContacts, WarmStartThatAnswersIsKept) {
  ContactSolver solver;
  for (int trial = 0; trial < 100; ++trial) {
    const ContactProblem problem = trial_problem(trial, 5, 1.2, 1);
    const VectorXd f = solver.solve(problem, VectorXd()).f;
    const ContactSolution& again = solver.solve(problem, f);
    EXPECT_EQ(again.f, f);
    EXPECT_LE(again.newton_steps, 1);  // to see whether one more would help
  }
}

// Impulses of a problem in newton steps or in its neighbour's: a little change takes few steps.
TEST(RandomContacts, WarmStartsTakeFewSteps) {
  ContactSolver solver;
  int steps = 0;
  constexpr int kTrials = 100;
  for (int trial = 0; trial < kTrials; ++trial) {
    ContactProblem problem = trial_problem(trial, 3, 0.8, 1);
    const VectorXd f = solver.solve(problem, VectorXd()).f;
    problem.b *= 1.001;
    const ContactSolution& next = solver.solve(problem, f);
    ASSERT_EQ(next.status, Status::kSolved);
    steps += next.newton_steps;
  }
  EXPECT_LT(steps, 2.5 * kTrials);
}

// Bits do not depend on what the solver has done before.
TEST(RandomContacts, SameProblemGivesTheSameBits) {
  for (const ContactMethod method :
       {ContactMethod::kAutomatic, ContactMethod::kNewton, ContactMethod::kGaussSeidel,
        ContactMethod::kInteriorPoint, ContactMethod::kPyramid}) {
    ContactSolverOptions options;
    options.method = method;
    ContactSolver used;
    (void)used.solve(trial_problem(1, 9, 1.2, 1), VectorXd(), options);
    for (int trial = 0; trial < 20; ++trial) {
      const ContactProblem problem = trial_problem(trial, 5, 1.2, 1);
      ContactSolver fresh;
      EXPECT_EQ(used.solve(problem, VectorXd(), options).f,
                fresh.solve(problem, VectorXd(), options).f);
    }
  }
}

TEST(RandomContacts, LimitsAreKept) {
  ContactSolver solver;
  ContactSolverOptions options;
  options.method = ContactMethod::kGaussSeidel;
  options.max_sweeps = 7;
  const ContactSolution& found = solver.solve(trial_problem(2, 8, 1.2, 1), VectorXd(), options);
  EXPECT_EQ(found.sweeps, 7);
  EXPECT_EQ(found.status, Status::kLimit);
}

}  // namespace
}  // namespace thenar
