// Tests for solvers/stiff_ode.cpp.

#include "solvers/stiff_ode.h"

#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include "base/error.h"

namespace thenar {
namespace {

using Eigen::Vector2d;
using Eigen::VectorXd;

StiffOdeOptions tolerance(int n, double size) { return {size, VectorXd::Constant(n, size)}; }

VectorXd one(double y) { return VectorXd::Constant(1, y); }

void run_to(StiffOde& ode, double end) {
  while (ode.time() < end) ASSERT_EQ(ode.step(end), OdeStatus::kStepped);
}

// y' = -k (y - cos t) - sin t  has the solution cos t from y(0) = 1, however large k is.
TEST(StiffOde, FollowsSlowSolutionOfStiffEquation) {
  const double k = 1e6;
  StiffOde ode(
      [&](double t, const VectorXd& y) { return one(-k * (y[0] - std::cos(t)) - std::sin(t)); }, 0,
      one(1), tolerance(1, 1e-8));
  run_to(ode, 10);
  EXPECT_NEAR(ode.state()[0], std::cos(10.0), 1e-6);  // error of all steps together
  EXPECT_LT(ode.counts().steps, 2000);                // an explicit method needs 5 million
}

TEST(StiffOde, InterpolatesWithinLastStep) {
  StiffOde ode([](double, const VectorXd& y) { return VectorXd(-y); }, 0, one(1),
               tolerance(1, 1e-9));
  run_to(ode, 1);
  double before = 0;
  while (ode.time() < 2) {
    before = ode.time();
    ASSERT_EQ(ode.step(2), OdeStatus::kStepped);
  }
  const double middle = (before + ode.time()) / 2;
  EXPECT_NEAR(ode.state_at(middle)[0], std::exp(-middle), 1e-7);  // error of all steps together
  EXPECT_THROW((void)ode.state_at(0), InputError);
}

// |t - 1|' jumps at 1: from there the slope is another.
TEST(StiffOde, StopsAndRestartsWhereSlopeJumps) {
  double sign = -1;
  StiffOde ode([&](double, const VectorXd&) { return one(sign); }, 0, one(1), tolerance(1, 1e-9));
  run_to(ode, 1);
  EXPECT_EQ(ode.time(), 1);
  sign = 1;
  const long steps = ode.counts().steps;
  ode.restart();
  run_to(ode, 3);
  EXPECT_NEAR(ode.state()[0], 2, 1e-8);
  EXPECT_GT(ode.counts().steps, steps);
}

// Of y' = -y, errors of steps a hundred times as large take fewer steps, and end with the restart.
TEST(StiffOde, RestartsWithLargerErrors) {
  const auto steps_to_5 = [](double looser) {
    StiffOde ode([](double, const VectorXd& y) { return VectorXd(-y); }, 0, one(1),
                 tolerance(1, 1e-10));
    ode.restart(100);
    ode.restart(looser);
    run_to(ode, 5);
    EXPECT_NEAR(ode.state()[0], std::exp(-5.0), looser * 1e-9);
    return ode.counts().steps;
  };
  StiffOde plain([](double, const VectorXd& y) { return VectorXd(-y); }, 0, one(1),
                 tolerance(1, 1e-10));
  run_to(plain, 5);
  for (const double senseless : {0.0, -1.0, std::nan("")})
    EXPECT_THROW(plain.restart(senseless), InputError);
  EXPECT_EQ(steps_to_5(1), plain.counts().steps);
  EXPECT_LT(steps_to_5(100), plain.counts().steps);
}

// A slope that jumps unannounced makes steps fail; a straight line does not.
TEST(StiffOde, CountsStepsThatItRejects) {
  for (const double after : {1.0, -100.0}) {
    StiffOde ode([&](double t, const VectorXd&) { return one(t < 1 ? 1 : after); }, 0, one(0),
                 tolerance(1, 1e-9));
    run_to(ode, 2);
    EXPECT_EQ(ode.counts().rejected > 0, after != 1) << after;
    const long rejected = ode.counts().rejected;
    ode.restart();
    EXPECT_EQ(ode.counts().rejected, rejected);
  }
}

// y' = -1 / sqrt(y) has the solution (1 - 3 t / 2)^(2/3) from y(0) = 1, which ends at t = 2/3.
TEST(StiffOde, SaysWhereSolutionEnds) {
  StiffOde ode([](double, const VectorXd& y) { return one(-1 / std::sqrt(y[0])); }, 0, one(1),
               tolerance(1, 1e-9));
  OdeStatus status = OdeStatus::kStepped;
  while (status == OdeStatus::kStepped && ode.time() < 1) status = ode.step(1);
  EXPECT_EQ(status, OdeStatus::kNotFinite);
  EXPECT_NEAR(ode.time(), 2.0 / 3, 1e-6);  // error of all steps together
}

// y' = sqrt(1 - y) is not finite for y > 1; its solution y = 1 - (1 - t / 2)^2 comes near at t = 2.
TEST(StiffOde, ShortensStepWhereSlopeIsNotFinite) {
  StiffOde ode([](double, const VectorXd& y) { return one(std::sqrt(1 - y[0])); }, 0, one(0),
               tolerance(1, 1e-8));
  run_to(ode, 1);                           // y = 1 - (1 - t / 2)^2
  EXPECT_NEAR(ode.state()[0], 0.75, 1e-6);  // error of all steps together
}

// y'' = -w^2 (y - 1) with its exact Jacobian, which spares the slopes of differences.
TEST(StiffOde, TakesJacobianThatIsGiven) {
  Eigen::Matrix2d A;
  A << 0, 1, -100, -2000;
  const auto slope = [&](double, const VectorXd& y) { return VectorXd(A * y); };
  StiffOdeOptions with = tolerance(2, 1e-9);
  with.jacobian = [&](double, const VectorXd&) { return Eigen::MatrixXd(A); };
  StiffOde ode(slope, 0, Vector2d(1, 0), with),
      differs(slope, 0, Vector2d(1, 0), tolerance(2, 1e-9));
  run_to(ode, 1);
  run_to(differs, 1);
  // Both rates of decay from  x^2 + 2000 x + 100 = 0.
  const double s = -1000 + std::sqrt(1e6 - 100), f = -1000 - std::sqrt(1e6 - 100);
  EXPECT_NEAR(ode.state()[0], (f * std::exp(s) - s * std::exp(f)) / (f - s), 1e-7);
  EXPECT_LT(ode.counts().slopes, differs.counts().slopes);
}

TEST(StiffOde, HandsOnExceptions) {
  StiffOde ode([](double, const VectorXd&) -> VectorXd { throw std::runtime_error("broken"); }, 0,
               one(0), tolerance(1, 1e-6));
  EXPECT_THROW((void)ode.step(1), std::runtime_error);
}

TEST(StiffOde, RejectsTolerancesThatCannotBe) {
  const auto slope = [](double, const VectorXd& y) { return y; };
  EXPECT_THROW(StiffOde(slope, 0, one(1), tolerance(2, 1e-6)), InputError);
  EXPECT_THROW(StiffOde(slope, 0, one(1), tolerance(1, 0)), InputError);
  EXPECT_THROW(
      StiffOde(slope, 0, one(std::numeric_limits<double>::quiet_NaN()), tolerance(1, 1e-6)),
      InputError);
}

}  // namespace
}  // namespace thenar
