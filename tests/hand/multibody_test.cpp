// Tests for hand/multibody.cpp: two machines from one skeleton, and laws of dynamics.

#include "hand/multibody.h"

#include <gtest/gtest.h>
#include <thread>

#include <Eigen/Eigenvalues>

#include "base/error.h"
#include "tests/hand/same_machines.h"
#include "tests/hand/sample_subjects.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

const Loads kGravity{{0, 0, -9.81}, {}};

JointMotion random_motion(const Skeleton& skeleton, sample::Draw& draw) {
  const Eigen::VectorXd q = draw.posture(skeleton);
  return {q, draw.numbers(q.size(), -2, 2)};
}

TEST(Multibody, EqualsTheChain) {
  for (unsigned seed = 1; seed <= 3; ++seed)
    expect_same_machines(build_skeleton(sample::random_hand(seed)));
  expect_same_machines(build_skeleton(sample::random_hand(4, 0)));
  expect_same_machines(build_skeleton(sample::two_link()));
}

TEST(Multibody, EqualsTheChainWithACoupledJoint) {
  expect_same_machines(build_skeleton(sample::coupled_digit()));
}

TEST(Multibody, EqualsTheChainWithFrozenJoints) {
  SkeletonOptions options;
  options.frozen = {{"wrist_1", 0.3}, {"thumb_0_0", -0.4}, {"ring_1_0", 0.8}};
  expect_same_machines(build_skeleton(sample::random_hand(5), options));
  options.frozen = {{"MCP_FE", 0.3}};
  expect_same_machines(build_skeleton(sample::coupled_digit(), options));
}

TEST(Multibody, StandsStillWithEverythingFrozen) {
  SkeletonOptions options;
  options.frozen = {{"J1", 0.3}, {"J2", 0.4}};
  Multibody body(build_skeleton(sample::two_link(), options));
  const Eigen::VectorXd none(0);
  EXPECT_TRUE(body.pose(none).empty());
  EXPECT_EQ(body.jacobian(none, -1, {0, 0, 0}).cols(), 0);
  EXPECT_EQ(body.forward_dynamics({none, none}, none).size(), 0);
}

TEST(Multibody, BaseDoesNotMove) {
  Multibody body(build_skeleton(sample::two_link()));
  EXPECT_TRUE(body.jacobian(Eigen::Vector2d(1, 1), -1, {0.1, 0, 0}).isZero(0));
}

// Weights need mass only, motion its spread, too.
TEST(Multibody, RefusesToMoveAMassOfUnknownSpread) {
  Subject subject = sample::two_link();
  subject.segments[2].mass = 0.02;
  subject.segments[2].radius = 0;
  Multibody body(build_skeleton(subject));
  const Eigen::Vector2d q(0.1, 0.2), zero(0, 0);
  EXPECT_TRUE(body.load_torque(q, kGravity).allFinite());
  EXPECT_THROW((void)body.mass_matrix(q), InputError);
  EXPECT_THROW((void)body.kinetic_energy({q, zero}), InputError);
  EXPECT_THROW((void)body.inverse_dynamics({q, zero}, zero), InputError);
  try {
    (void)body.forward_dynamics({q, zero}, zero);
    FAIL() << "expected InputError";
  } catch (const InputError& e) {
    EXPECT_STREQ(e.what(), "segment 'lower' has mass but neither moments of inertia nor a radius");
  }
}

// Textbook: M11 = I1 + I2 + m1 c1^2 + m2 (l1^2 + c2^2 + 2 l1 c2 cos q2), and so on.
TEST(Multibody, MassMatrixOfTwoLinks) {
  const Skeleton skeleton = build_skeleton(sample::two_link());
  const LinkMass &a = skeleton.masses[0], &b = skeleton.masses[1];
  const double l1 = sample::kUpperLength, c1 = l1 / 2, c2 = sample::kLowerLength / 2, q2 = 0.8;
  const double far = b.inertia(2, 2) + b.mass * c2 * c2, cross = b.mass * l1 * c2 * std::cos(q2);
  Eigen::Matrix2d M;
  M << a.inertia(2, 2) + a.mass * c1 * c1 + b.mass * l1 * l1 + far + 2 * cross, far + cross,
      far + cross, far;
  EXPECT_TRUE(matrix_near(Multibody(skeleton).mass_matrix(Eigen::Vector2d(0.3, q2)), M, 1e-18));
}

// M = sum over links  m J_com' J_com + W' I W,  with J and W of the chain.
TEST(Multibody, MassMatrixIsTheSumOverLinks) {
  sample::Draw draw(51);
  for (const Subject& subject : {sample::random_hand(6), sample::coupled_digit()}) {
    const Skeleton skeleton = build_skeleton(subject);
    const Eigen::VectorXd q = draw.posture(skeleton);
    const TreeState<double> state = pose_tree(skeleton.tree, q);
    Eigen::MatrixXd M = Eigen::MatrixXd::Zero(q.size(), q.size());
    for (int i = 0; i < static_cast<int>(state.size()); ++i) {
      const LinkMass& mass = skeleton.masses[i];
      const Eigen::MatrixXd J = spatial_jacobian(skeleton.tree, state, i, moved(state, i, mass.com),
                                                 skeleton.coordinates());
      const Eigen::Matrix3d I = state[i].X.R * mass.inertia * state[i].X.R.transpose();
      M += mass.mass * J.bottomRows<3>().transpose() * J.bottomRows<3>() +
           J.topRows<3>().transpose() * I * J.topRows<3>();
    }
    EXPECT_TRUE(matrix_near(Multibody(skeleton).mass_matrix(q), M, 1e-15));
    EXPECT_GT(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(M).eigenvalues()[0], 0);
  }
}

TEST(Multibody, KineticEnergyIsHalfOfTheMassMatrix) {
  sample::Draw draw(52);
  const Skeleton skeleton = build_skeleton(sample::coupled_digit());
  Multibody body(skeleton);
  const JointMotion motion = random_motion(skeleton, draw);
  EXPECT_NEAR(body.kinetic_energy(motion),
              motion.q_dot.dot(body.mass_matrix(motion.q) * motion.q_dot) / 2, 1e-15);
}

TEST(Multibody, ForwardDynamicsUndoesInverseDynamics) {
  sample::Draw draw(53);
  for (const Subject& subject :
       {sample::two_link(), sample::random_hand(7), sample::coupled_digit()})
    for (const Passive passive : {Passive::kOff, Passive::kOn}) {
      const Skeleton skeleton = build_skeleton(subject);
      Multibody body(skeleton, passive);
      const JointMotion motion = random_motion(skeleton, draw);
      const Eigen::VectorXd q_ddot = draw.numbers(motion.q.size(), -50, 50);
      Loads loads = kGravity;
      loads.forces.push_back({skeleton.tips[0].link, skeleton.tips[0].p, draw.vector(3)});
      const Eigen::VectorXd tau = body.inverse_dynamics(motion, q_ddot, loads);
      // Accelerations reach 1e2 rad/s^2 and M is conditioned like 1e4.
      EXPECT_TRUE(matrix_near(body.forward_dynamics(motion, tau, loads), q_ddot, 1e-8));
    }
}

TEST(Multibody, HoldingTorqueBalancesLoadsAndSprings) {
  sample::Draw draw(54);
  const Skeleton skeleton = build_skeleton(sample::random_hand(8));
  const Eigen::VectorXd q = draw.posture(skeleton), zero = Eigen::VectorXd::Zero(q.size());
  Multibody body(skeleton, Passive::kOn);
  const Eigen::VectorXd tau = body.inverse_dynamics({q, zero}, zero, kGravity);
  EXPECT_TRUE(
      matrix_near(tau, -load_torque(skeleton, q, kGravity) - passive_torque(skeleton, q), 1e-14));
}

// Along q(t) the power of the joints is the rate of kinetic energy, by central difference.
TEST(Multibody, JointPowerFeedsKineticEnergy) {
  sample::Draw draw(55);
  for (const Subject& subject : {sample::random_hand(9), sample::coupled_digit()}) {
    const Skeleton skeleton = build_skeleton(subject);
    Multibody body(skeleton);
    const JointMotion motion = random_motion(skeleton, draw);
    const Eigen::VectorXd q_ddot = draw.numbers(motion.q.size(), -5, 5);
    const double power = body.inverse_dynamics(motion, q_ddot).dot(motion.q_dot);
    const auto energy = [&](double t) {
      return body.kinetic_energy(
          {motion.q + t * motion.q_dot + t * t / 2 * q_ddot, motion.q_dot + t * q_ddot});
    };
    const double h = 1e-5;                                         // [s]
    EXPECT_NEAR((energy(h) - energy(-h)) / (2 * h), power, 1e-7);  // [W]
  }
}

TEST(Multibody, DampingTakesPower) {
  sample::Draw draw(56);
  const Skeleton skeleton = build_skeleton(sample::coupled_digit());
  const JointMotion motion = random_motion(skeleton, draw);
  Multibody damped(skeleton, Passive::kOn), free(skeleton);
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(3);
  const Eigen::VectorXd extra =
      damped.inverse_dynamics(motion, zero) - free.inverse_dynamics(motion, zero);
  Eigen::VectorXd expected = -passive_torque(skeleton, motion.q);
  for (int i = 0; i < 3; ++i) expected[i] += skeleton.limits[i].damping * motion.q_dot[i];
  EXPECT_TRUE(matrix_near(extra, expected, 1e-15));
}

// One object per thread is the rule; objects then do not disturb each other.
TEST(Multibody, WorksInThreadsOfItsOwn) {
  const Skeleton skeleton = build_skeleton(sample::random_hand(10));
  std::vector<int> wrong(4, 0);
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t)
    threads.emplace_back([&, t] {
      sample::Draw draw(100 + t);
      Multibody body(skeleton);
      for (int trial = 0; trial < 50; ++trial) {
        const Eigen::VectorXd q = draw.posture(skeleton);
        const Eigen::VectorXd difference =
            body.load_torque(q, kGravity) - load_torque(skeleton, q, kGravity);
        if (!(difference.cwiseAbs().maxCoeff() < 1e-12)) ++wrong[t];
      }
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(wrong, std::vector<int>(4, 0));
}

TEST(Multibody, SaysWhatHasNoMass) {
  Subject subject = sample::two_link();
  subject.segments[2].radius = 0;
  Multibody body(build_skeleton(subject));
  const Eigen::Vector2d zero(0, 0);
  EXPECT_TRUE(body.inverse_dynamics({zero, zero}, zero).isZero(0));
  try {
    (void)body.forward_dynamics({zero, zero}, zero);
    FAIL() << "expected InputError";
  } catch (const InputError& e) {
    EXPECT_STREQ(e.what(), "joint 'J2' moves nothing that has mass");
  }
}

TEST(Multibody, RejectsWrongShapes) {
  Multibody body(build_skeleton(sample::two_link()));
  const Eigen::Vector2d zero(0, 0);
  EXPECT_THROW((void)body.pose(Eigen::Vector3d(0, 0, 0)), InputError);
  EXPECT_THROW((void)body.jacobian(zero, 2, {0, 0, 0}), InputError);
  EXPECT_THROW((void)body.inverse_dynamics({zero, Eigen::VectorXd()}, zero), InputError);
  EXPECT_THROW((void)body.load_torque(zero, {{0, 0, 0}, {{5, {0, 0, 0}, {0, 0, 1}}}}), InputError);
}

}  // namespace
}  // namespace thenar
