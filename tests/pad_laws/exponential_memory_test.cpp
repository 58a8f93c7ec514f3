// Tests for pad_laws/exponential_memory.cpp.

#include "pad_laws/exponential_memory.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/numbers.h"

namespace thenar {
namespace {

const std::vector<ExponentialTerm> kTerms{{0.3, 4e-3}, {0.25, 70e-3}, {0.2, 1.4}};

double relaxed(double t) {
  double g = 0.25;
  for (const ExponentialTerm& term : kTerms) g += term.share * std::exp(-t / term.time);
  return g;
}

TEST(ExponentialMemory, AJumpThatIsHeldDecaysExactlyInUnequalSteps) {
  ExponentialMemory memory;
  EXPECT_DOUBLE_EQ(remember(memory_step(kTerms, 0), 2, memory), 2);
  double t = 0;
  for (const double h : {1e-3, 0.03, 0.022}) {
    t += h;
    EXPECT_NEAR(remember(memory_step(kTerms, h), 2, memory), 2 * relaxed(t), 1e-14);
  }
  EXPECT_NEAR(remember(memory_step(kTerms, kInfinity), 2, memory), 2 * 0.25, 1e-14);
}

TEST(ExponentialMemory, ARampIsTheIntegralOfTheRelaxation) {
  // Over T:  y(T) = rate (g_inf T + sum g_i tau_i (1 - exp(-T / tau_i))).
  constexpr double kRate = 3, kTime = 0.1;
  double integral = 0.25 * kTime;
  for (const ExponentialTerm& term : kTerms)
    integral += term.share * term.time * -std::expm1(-kTime / term.time);
  for (const int steps : {1, 3}) {
    ExponentialMemory memory;
    double y = 0;
    for (int k = 1; k <= steps; ++k)
      y = remember(memory_step(kTerms, kTime / steps), kRate * kTime * k / steps, memory);
    EXPECT_NEAR(y, kRate * integral, 1e-14);
  }
}

TEST(ExponentialMemory, WithoutTermsNothingIsRemembered) {
  ExponentialMemory memory;
  EXPECT_EQ(remember(memory_step({}, 1), 5, memory), 5);
  EXPECT_EQ(remember(memory_step({}, 1), 2, memory), 2);
}

TEST(ExponentialMemory, RefusesWhatDoesNotRelax) {
  EXPECT_THROW(check_exponential_terms({{0.6, 1}, {0.4, 2}}, "x"), InputError);
  EXPECT_THROW(check_exponential_terms({{-0.1, 1}}, "x"), InputError);
  EXPECT_THROW(check_exponential_terms({{0.1, 0}}, "x"), InputError);
  EXPECT_THROW(check_exponential_terms({{kNaN, 1}}, "x"), InputError);
  EXPECT_THROW((void)memory_step(kTerms, -1), InputError);
  EXPECT_THROW((void)memory_step(kTerms, kNaN), InputError);
}

}  // namespace
}  // namespace thenar
