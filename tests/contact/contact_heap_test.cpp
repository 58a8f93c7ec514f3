// Tests that contact/contact_solver.cpp leaves the heap alone in a steady loop.

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "contact/contact_solver.h"
#include "tests/contact/contact_samples.h"
#include "tests/counted_malloc.h"

namespace thenar {
namespace {

TEST(ContactHeap, IsLeftAloneOnceAProblemAsLargeWasSeen) {
  for (const ContactMethod method : {ContactMethod::kAutomatic, ContactMethod::kNewton,
                                     ContactMethod::kGaussSeidel, ContactMethod::kInteriorPoint}) {
    std::mt19937 rng(1);
    sample::RandomTouch like;
    like.contacts = 8;
    like.limits = 0;
    like.soft = 0;
    std::vector<ContactProblem> problems;
    for (int k = 0; k < 30; ++k) problems.push_back(sample::random_touch(rng, like).problem());
    ContactSolverOptions options;
    options.method = method;
    options.max_sweeps = 50;
    ContactSolver solver;
    const Eigen::VectorXd none;
    // Every path of the method is taken once; pivots, the last resort, ask the heap.
    const auto pivots = [&](const ContactProblem& problem) {
      return solver.solve(problem, none, options).pivots > 0;
    };
    problems.erase(std::remove_if(problems.begin(), problems.end(), pivots), problems.end());
    ASSERT_GT(problems.size(), 25U);
    const std::size_t before = allocations;
    for (const ContactProblem& problem : problems) (void)solver.solve(problem, none, options);
    EXPECT_EQ(allocations, before) << static_cast<int>(method);
  }
}

TEST(ContactHeap, IsCountedHere) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "sanitizers count for themselves";
#endif
  const std::size_t before = allocations;
  const std::vector<double> block(100);
  const Eigen::VectorXd other(static_cast<Eigen::Index>(block.size()));
  EXPECT_GE(allocations, before + 2) << other.size();
}

}  // namespace
}  // namespace thenar
