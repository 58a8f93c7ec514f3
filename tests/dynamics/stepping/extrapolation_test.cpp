// Tests for dynamics/stepping/extrapolation.cpp.

#include "dynamics/stepping/extrapolation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "base/error.h"

namespace thenar {
namespace {

using Verdict = Extrapolation::Verdict;

/// q, v and z are x, -x and (2 x, 3 x).
SceneState number(double x) {
  SceneState state;
  state.q = Eigen::VectorXd::Constant(1, x);
  state.v = -state.q;
  state.z = Eigen::Vector2d(2 * x, 3 * x);
  return state;
}

/// What the columns of Euler's method make of  x' = x  over a length.
double euler(double length, int substeps) { return std::pow(1 + length / substeps, substeps); }

// T_nn of  x' = x  is a polynomial of degree n that is right up to H^n: the Taylor polynomial. Its
// error  H^(n+1) / (n+1)! (1 + H / (n+2) + ..)  is of order n + 1: at half the length it is
// 1 / 2^(n + 1) of it. The next term changes log2 of that ratio by 0.2 / (n + 2) / log(2) =
// 0.29 / (n + 2), those after it by less than 0.11 / (n + 2).
TEST(Extrapolation, RaisesTheOrderByOneAColumn) {
  for (int n = 1; n <= 6; ++n) {
    std::vector<double> errors;
    for (const double length : {0.4, 0.2}) {
      Extrapolation table(number(1), Extrapolation::kMaxColumns);
      table.restart();
      for (int k = 1; k <= n; ++k) table.add_column(number(euler(length, k)), k);
      EXPECT_EQ(table.column_count(), n);
      errors.push_back(std::abs(table.highest_order().q[0] - std::exp(length)));
    }
    EXPECT_NEAR(std::log2(errors[0] / errors[1]), n + 1, 0.4 / (n + 2)) << n;
  }
}

// An expansion of two terms is gone with three columns.
TEST(Extrapolation, IsExactWhereTheExpansionEnds) {
  Extrapolation table(number(0), 4);
  table.restart();
  for (int k = 1; k <= 3; ++k) table.add_column(number(5 + 2.0 / k - 3.0 / (k * k)), k);
  const auto is_five = [](const SceneState& state) {
    EXPECT_NEAR(state.q[0], 5, 1e-14);
    EXPECT_NEAR(state.v[0], -5, 1e-14);
    ASSERT_EQ(state.z.size(), 2);
    EXPECT_NEAR(state.z[0], 10, 2e-14);
    EXPECT_NEAR(state.z[1], 15, 3e-14);
  };
  is_five(table.highest_order());
  table.add_column(number(5 + 2.0 / 4 - 3.0 / 16), 4);
  is_five(table.lower_order());
  is_five(table.highest_order());
}

/// Substeps that a whole run of  x' = x  from 0 to 10 takes, and its error over the tolerance.
struct GrowthRun {
  long substeps = 0, rejected = 0;
  double error = 0;
};
GrowthRun grow(int most, double tolerance) {
  GrowthRun out;
  Extrapolation table(number(1), most);
  double t = 0, x = 1, length = 1e-3, scale = 0;
  while (t < 10) {
    table.restart();
    const double step = std::min(length, 10 - t);
    for (int n = 1; !table.verdict(); ++n) {
      table.add_column(number(x * euler(step, n)), n);
      out.substeps += n;
      if (n < 2) continue;
      table.judge(std::abs(table.highest_order().q[0] - table.lower_order().q[0]) /
                  (x * tolerance));
    }
    if (table.verdict() == Verdict::kAccept) {
      t += step;
      x = table.highest_order().q[0];
      ++scale;
    } else {
      ++out.rejected;
    }
    length = table.plan_next(step, 10);
  }
  out.error = std::abs(x / std::exp(10.0) - 1) / tolerance / scale;
  return out;
}

// The order that is chosen takes less work than low orders do, and errs by no more than asked.
TEST(Extrapolation, ChoosesAnOrderThatSavesWork) {
  for (const double tolerance : {1e-4, 1e-7, 1e-10}) {
    const GrowthRun chosen = grow(8, tolerance);
    EXPECT_LT(chosen.error, 1) << tolerance;
    EXPECT_LE(chosen.rejected, 4) << tolerance;
    for (const int most : {2, 4}) {
      const GrowthRun bound = grow(most, tolerance);
      EXPECT_LT(bound.error, 1) << tolerance;
      EXPECT_LT(chosen.substeps, 1.2 * bound.substeps) << tolerance << ' ' << most;
    }
  }
  EXPECT_LT(5 * grow(8, 1e-10).substeps, grow(2, 1e-10).substeps);
}

TEST(Extrapolation, RejectsWhatIsNotANumber) {
  Extrapolation table(number(1), 3);
  table.restart();
  for (int n = 1; n <= 3; ++n) table.add_column(number(n), n);
  EXPECT_EQ(table.judge(std::nan("")), Verdict::kReject);
  const double next = table.plan_next(1, 1);
  EXPECT_LE(next, 0.9);
  EXPECT_GT(next, 0);
}

// Two columns of an error of 0.01 pay best, but only in the first step: the second judges three
// columns alone, and an error of 1/8, of order 3, becomes 1/2 in a step longer by 4^(1/3).
TEST(Extrapolation, ForgetsTheErrorsOfTheStepBefore) {
  Extrapolation table(number(1), 3);
  table.restart();
  for (int n = 1; n <= 2; ++n) table.add_column(number(n), n);
  EXPECT_EQ(table.judge(0.01), Verdict::kAccept);
  // Four times as long, and longer by the work of another column, 7 over 4.
  EXPECT_NEAR(table.plan_next(1, 100), 7, 1e-14);
  table.restart();
  EXPECT_FALSE(table.verdict());
  for (int n = 1; n <= 3; ++n) table.add_column(number(n), n);
  EXPECT_EQ(table.judge(0.125), Verdict::kAccept);
  EXPECT_NEAR(table.plan_next(1, 100), std::cbrt(4.0), 1e-14);
}

TEST(Extrapolation, RefusesCallsInAnotherOrder) {
  Extrapolation table(number(1), 2);
  table.restart();
  EXPECT_THROW(table.add_column(number(1), 2), InputError);  // the first has one substep
  EXPECT_THROW((void)table.judge(1), InputError);
  table.add_column(number(1), 1);
  EXPECT_THROW((void)table.judge(1), InputError);         // no order to compare with
  EXPECT_THROW((void)table.plan_next(1, 1), InputError);  // no verdict
  table.add_column(number(2), 2);
  EXPECT_THROW(table.add_column(number(3), 3), InputError);  // two columns at most
  EXPECT_EQ(table.judge(2), Verdict::kReject);
  EXPECT_THROW((void)table.judge(0), InputError);  // the step is decided
  (void)table.plan_next(1, 1);
  EXPECT_THROW((void)table.plan_next(1, 1), InputError);  // and planned from
  table.restart();
  EXPECT_EQ(table.column_count(), 0);
}

}  // namespace
}  // namespace thenar
