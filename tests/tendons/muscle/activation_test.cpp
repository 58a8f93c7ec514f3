// Tests for tendons/muscle/activation.cpp.

#include "tendons/muscle/activation.h"

#include <cmath>

#include <gtest/gtest.h>

#include "solvers/stiff_ode.h"

namespace thenar {
namespace {

constexpr ActivationTimes kTimes{0.015, 0.050};

double after(double excitation, double activation, double seconds) {
  const auto slope = [&](double, const Eigen::VectorXd& a) {
    return Eigen::VectorXd::Constant(1, activation_rate(excitation, a[0], kTimes));
  };
  StiffOde ode(slope, 0, Eigen::VectorXd::Constant(1, activation),
               {1e-9, Eigen::VectorXd::Constant(1, 1e-10)});
  while (ode.time() < seconds && ode.step(seconds) == OdeStatus::kStepped) continue;
  return ode.state()[0];
}

// Full excitation:  (0.5 + 1.5 a) a' / (1 - a) = 1 / rise  integrates to
//   -1.5 a - 2 log(1 - a) = t / rise.
TEST(Activation, RisesByItsClosedForm) {
  const double a = after(1, 0, 0.02);
  EXPECT_NEAR(-1.5 * a - 2 * std::log(1 - a), 0.02 / 0.015, 1e-6);
}

// No excitation:  a' = -a (0.5 + 1.5 a) / fall,  so  log(a / (0.5 + 1.5 a)) falls by 0.5 t / fall.
TEST(Activation, FallsByItsClosedForm) {
  const double a = after(0, 1, 0.1);
  EXPECT_NEAR(std::log(a / (0.5 + 1.5 * a)) - std::log(0.5), -0.5 * 0.1 / 0.050, 1e-6);
}

TEST(Activation, RestsAtItsExcitation) {
  for (const double e : {0.0, 0.3, 1.0}) EXPECT_EQ(activation_rate(e, e, kTimes), 0);
}

}  // namespace
}  // namespace thenar
