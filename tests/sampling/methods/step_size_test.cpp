// Tests for sampling/methods/step_size.cpp.

#include "sampling/methods/step_size.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/numbers.h"

namespace thenar::internal {
namespace {

// Where acceptance is exp(-step), the step of acceptance a is -ln a. After N steps the mean error
// of acceptance is still gamma ln(lean / step) / sqrt(N), so that of the step is 1 / a times that.
TEST(DualAveraging, FindsTheStepOfTheAcceptanceAskedFor) {
  for (const double target : {0.6, 0.8, 0.95})
    for (const double start : {1e-4, 1.0, 1e3}) {
      DualAveraging averaging(target);
      averaging.restart(start, 10);
      for (int i = 0; i < 3000; ++i) averaging.learn(std::exp(-averaging.step()), kInfinity);
      const double step = -std::log(target);
      const double left = 0.05 * std::abs(std::log(10 * start / step)) / std::sqrt(3000) / target;
      EXPECT_NEAR(averaging.averaged_step(), step, 1.5 * left) << target << " " << start;
    }
}

// First update by hand: error = (target - a) / 11, log step = log(10) - error / 0.05.
TEST(DualAveraging, FirstStepIsThatOfTheArticle) {
  DualAveraging averaging(0.8);
  averaging.restart(1, 10);
  averaging.learn(0.25, kInfinity);
  EXPECT_NEAR(averaging.step(), 10 * std::exp(-0.55 / 11 / 0.05), 1e-12);
  EXPECT_NEAR(averaging.averaged_step(), averaging.step(), 1e-12);
}

// Every step is accepted: without a limit they would grow for ever.
TEST(DualAveraging, StaysBelowItsLimit) {
  DualAveraging averaging(0.8);
  averaging.restart(1, 10);
  for (int i = 0; i < 100; ++i) {
    averaging.learn(1, 1.5);
    EXPECT_LE(averaging.step(), 1.5 * (1 + 1e-15));
  }
  EXPECT_NEAR(averaging.averaged_step(), 1.5, 1e-12);
}

// Energy error c step^2 passes -ln 0.8 = 0.2231 at step sqrt(0.2231 / c).
TEST(StepSearch, StopsBehindAnAcceptanceOfFourFifths) {
  const auto found = [](double c) {
    StepSearch search;
    search.start(1);
    while (!search.learn(c * search.step() * search.step())) {
    }
    return search.step();
  };
  EXPECT_EQ(found(1e-4), 64);        // behind 47.2
  EXPECT_EQ(found(1e4), 1.0 / 256);  // below 0.00472
}

TEST(StepSearch, GivesUpWhereThereIsNoScale) {
  StepSearch search;
  search.start(1);
  int tries = 1;
  while (!search.learn(0)) ++tries;
  EXPECT_LT(tries, 100);
}

}  // namespace
}  // namespace thenar::internal
