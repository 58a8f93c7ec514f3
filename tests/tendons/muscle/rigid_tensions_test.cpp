// Tests for tendons/muscle/rigid_tensions.cpp, and for tension solvers of the other rungs.

#include "tendons/muscle/rigid_tensions.h"

#include <random>

#include <gtest/gtest.h>

namespace thenar {
namespace {

/// With and without pennation.
std::vector<Musculotendon> some_muscles() {
  return {{"A", 150, 0.066, 0.29, 0.2}, {"B", 40, 0.03, 0.25, 0}, {"C", 700, 0.1, 0.1, 0.5}};
}

/// Fibres from slack to twice the optimal length, at up to 1.3 of the largest speed either way.
MuscleStates random_states(const std::vector<Musculotendon>& muscles, std::mt19937& rng) {
  std::uniform_real_distribution<double> part(0, 1);
  MuscleStates states;
  states.clear(static_cast<Eigen::Index>(muscles.size()));
  for (std::size_t i = 0; i < muscles.size(); ++i) {
    const auto m = static_cast<Eigen::Index>(i);
    const double optimum = muscles[i].optimal_fibre_length;
    states.activation[m] = part(rng);
    states.length[m] = muscles[i].slack + (2.1 * part(rng) - 0.1) * optimum;
    states.velocity[m] = 26 * (part(rng) - 0.5) * optimum;
    states.projected_fibre[m] = states.length[m] - muscles[i].slack * (1 + 0.05 * part(rng));
  }
  return states;
}

// Muscle by muscle to rounding, also where speeds alone have changed since the last call.
TEST(TensionSolver, AgreesWithSingleMuscles) {
  constexpr double kRounding = 1e-13;  // of F0, and of slopes over what they are of
  std::mt19937 rng(1);
  const std::vector<Musculotendon> muscles = some_muscles();
  for (const Muscle rung : {Muscle::kBounds, Muscle::kRigidTendon, Muscle::kElasticTendon}) {
    const auto contraction = build_contraction(muscles, rung);
    const auto solver = contraction->tension_solver();
    MuscleTensions alone, out;
    int cut = 0, pull = 0;
    MuscleStates at;
    for (int k = 0; k < 3000; ++k) {
      const MuscleStates next = random_states(muscles, rng);
      if (k % 3 == 0) at = next;
      at.velocity = next.velocity;
      solver->tensions(at, alone);
      solver->derivatives(at, out);
      EXPECT_EQ(alone.tension, out.tension);
      for (int m = 0; m < 3; ++m) {
        const Musculotendon& muscle = muscles[static_cast<std::size_t>(m)];
        const double t = contraction->tension(m, at.muscle(m));
        const TensionDerivatives by = contraction->tension_derivatives(m, at.muscle(m));
        const double F0 = muscle.F0, optimum = muscle.optimal_fibre_length;
        // Forces of stretched fibres may be many times F0.
        const double some = kRounding * std::max(F0, t);
        EXPECT_NEAR(out.tension[m], t, some);
        EXPECT_NEAR(out.by_activation[m], by.by_activation, some);
        EXPECT_NEAR(out.by_length[m], by.by_length, 100 * some / optimum);
        EXPECT_NEAR(out.by_velocity[m], by.by_velocity, some / optimum);
        EXPECT_NEAR(out.by_projected_fibre[m], by.by_projected_fibre, 100 * some / optimum);
        (t > 0 ? pull : cut) += 1;
      }
    }
    EXPECT_GT(pull, 1000);
    if (rung == Muscle::kRigidTendon) {
      EXPECT_GT(cut, 100);
    }
  }
}

// Without fibres, as of a muscle whose tension is given, there is no tension and no slope.
TEST(TensionSolver, LeavesMusclesWithoutStateAlone) {
  const auto contraction = build_contraction({{"A", 10, 0, 0, 0}}, Muscle::kRigidTendon);
  MuscleStates at;
  at.clear(1);
  MuscleTensions out;
  contraction->tension_solver()->derivatives(at, out);
  EXPECT_EQ(out.tension[0], 0);
  EXPECT_EQ(out.by_activation[0], 0);
  EXPECT_EQ(out.by_length[0], 0);
  EXPECT_EQ(out.by_velocity[0], 0);
}

}  // namespace
}  // namespace thenar
