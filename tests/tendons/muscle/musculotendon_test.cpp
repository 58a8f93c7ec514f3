// Tests for tendons/muscle/musculotendon.cpp.

#include <cmath>

#include <gtest/gtest.h>

#include "solvers/stiff_ode.h"
#include "tendons/muscle/hill_curves.h"
#include "tendons/muscle/musculotendon.h"

namespace thenar {
namespace {

// Roughly a deep flexor of a finger.
const Musculotendon kMuscle{"FDP", 70, 0.066, 0.290, 0.2};
const HillOptions kHill;

/// Length of muscle and tendon with the fibre at `l` optimal lengths and the tendon at `s` slacks.
double length_at(double l, double s) {
  const double height = kMuscle.optimal_fibre_length * std::sin(kMuscle.pennation);
  const double fibre = l * kMuscle.optimal_fibre_length;
  return s * kMuscle.slack + std::sqrt(fibre * fibre - height * height);
}

/// Height 0.2 in a fibre of l: the cosine of its angle.
double cosine_at(double l) { return std::sqrt(1 - std::pow(std::sin(0.2) / l, 2)); }

TEST(RigidTendon, PullsWithF0CosineAtOptimalLength) {
  EXPECT_NEAR(rigid_tendon_tension(kMuscle, kHill, 1, musculotendon_length_at_optimum(kMuscle), 0),
              70 * std::cos(0.2), 1e-12);
  EXPECT_NEAR(
      rigid_tendon_tension(kMuscle, kHill, 0.3, musculotendon_length_at_optimum(kMuscle), 0),
      0.3 * 70 * std::cos(0.2), 1e-12);
}

TEST(RigidTendon, BalancesForcesOfTheFibre) {
  const double l = 1.3, velocity = 0.15;
  const double v = velocity * cosine_at(l) / (10 * 0.066);
  const double force = 0.4 * active_force(l) * force_velocity(v) + passive_force(l) + 0.1 * v;
  EXPECT_NEAR(rigid_tendon_tension(kMuscle, kHill, 0.4, length_at(l, 1), velocity),
              70 * force * cosine_at(l), 1e-11);
}

TEST(RigidTendon, NeverPushes) {
  EXPECT_EQ(rigid_tendon_tension(kMuscle, kHill, 0, musculotendon_length_at_optimum(kMuscle), -0.1),
            0);
  EXPECT_EQ(rigid_tendon_tension(kMuscle, kHill, 1, 0.9 * kMuscle.slack, 0), 0);
  EXPECT_EQ(rigid_tendon_tension(kMuscle, kHill, 1, musculotendon_length_at_optimum(kMuscle), -100),
            0);
}

TEST(ElasticTendon, RateOfReachBalancesForces) {
  for (const double l : {0.6, 1.0, 1.4})
    for (const double s : {0.99, 1.005, 1.03, 1.06})
      for (const double a : {0.0, 1e-6, 0.02, 0.5, 1.0}) {
        const double length = length_at(l, s), projected_fibre = length - s * kMuscle.slack;
        const double v = projected_fibre_rate(kMuscle, kHill, a, length, projected_fibre) *
                         cosine_at(l) / (10 * 0.066);
        const double fibre = a * active_force(l) * force_velocity(v) + passive_force(l) + 0.1 * v;
        EXPECT_NEAR(tendon_force(s), fibre * cosine_at(l), 1e-12) << l << " " << s << " " << a;
      }
}

// Held at one length, the fibre creeps to where  fT = cos (a fl + fp).
TEST(ElasticTendon, IsometricContractionReachesAlgebraicBalance) {
  const double a = 0.6, length = length_at(1.1, 1.0);
  const auto slope = [&](double, const Eigen::VectorXd& x) {
    return Eigen::VectorXd::Constant(1, projected_fibre_rate(kMuscle, kHill, a, length, x[0]));
  };
  const double slack_start = isometric_projected_fibre(kMuscle, kHill, 0, length);
  StiffOde ode(slope, 0, Eigen::VectorXd::Constant(1, slack_start),
               {1e-9, Eigen::VectorXd::Constant(1, 1e-12)});
  while (ode.time() < 2) ASSERT_EQ(ode.step(2), OdeStatus::kStepped);
  const double projected_fibre = ode.state()[0],
               l = normalised_fibre_length(kMuscle, projected_fibre);
  const double fibre = cosine_at(l) * (a * active_force(l) + passive_force(l));
  EXPECT_LT(projected_fibre,
            slack_start - 0.003);  // the tendon has stretched by more than 1 % of 290 mm
  EXPECT_NEAR(tendon_force((length - projected_fibre) / kMuscle.slack), fibre,
              1e-7);  // of the integration
  EXPECT_NEAR(isometric_projected_fibre(kMuscle, kHill, a, length), projected_fibre, 1e-8);
}

// T = F0 cos (a fl + fp) at the length that a stretched tendon leaves; the stretch is of the order
// of the strain at F0, so the error falls in proportion to it.
TEST(ElasticTendon, BecomesRigidAsItStiffens) {
  const double length = length_at(1.2, 1.0), a = 0.5;
  const double rigid = rigid_tendon_tension(kMuscle, kHill, a, length, 0);
  double last = 1e9;
  for (const double strain : {1e-3, 1e-4, 1e-5}) {
    const HillOptions stiff{10, 0.1, strain};
    const double projected_fibre = isometric_projected_fibre(kMuscle, stiff, a, length);
    const double error =
        std::abs(elastic_tendon_tension(kMuscle, stiff, length, projected_fibre) - rigid);
    EXPECT_LT(error, last / 8);  // tenfold in the limit
    last = error;
  }
  EXPECT_LT(last, 1e-2);  // F0 slack strain slope(l) / optimal = 70 0.29 1e-5 1.5 / 0.066 N
}

TEST(ElasticTendon, FibreBesideSlackTendonStopsShortening) {
  const double length = 0.8 * kMuscle.slack;
  const double shortest = 0.05 * kMuscle.optimal_fibre_length;
  EXPECT_LT(projected_fibre_rate(kMuscle, kHill, 1, length, 0.5 * kMuscle.optimal_fibre_length), 0);
  EXPECT_EQ(projected_fibre_rate(kMuscle, kHill, 1, length, shortest), 0);
  EXPECT_EQ(isometric_projected_fibre(kMuscle, kHill, 1, length), shortest);
}

// Relaxed and shorter than optimal, neither fibre nor tendon carries anything: nothing moves.
TEST(ElasticTendon, RelaxedMuscleStaysWhereTendonIsJustTaut) {
  const double length = length_at(0.8, 1.0);
  const double projected_fibre = isometric_projected_fibre(kMuscle, kHill, 0, length);
  EXPECT_NEAR(length - projected_fibre, taut_tendon() * kMuscle.slack, 1e-12);
  EXPECT_NEAR(projected_fibre_rate(kMuscle, kHill, 0, length, projected_fibre), 0,
              1e-9);  // rounding times 1 / damping
}

}  // namespace
namespace {

constexpr ActivationTimes kTimes{0.015, 0.050};

double after(double excitation, double activation, double seconds) {
  const auto slope = [&](double, const Eigen::VectorXd& a) {
    return Eigen::VectorXd::Constant(1, activation_rate(excitation, a[0], kTimes).rate);
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
  for (const double e : {0.0, 0.3, 1.0}) EXPECT_EQ(activation_rate(e, e, kTimes).rate, 0);
}

}  // namespace
}  // namespace thenar
