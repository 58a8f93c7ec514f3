// Tests for tendons/muscle/simulate.cpp and finger_motion.cpp.

#include "tendons/muscle/simulate.h"

#include <cmath>
#include <type_traits>

#include <gtest/gtest.h>
#include <Eigen/LU>

#include "base/error.h"
#include "tendons/digit_tendons.h"
#include "tests/matrix_near.h"
#include "tests/tendons/muscle/moving_samples.h"

namespace thenar {
namespace {

using Eigen::VectorXd;
using sample::Mover;
using sample::Pendulum;

// A model that outlived its tendons or muscles would read freed memory.
template <typename Tendons, typename Muscles>
constexpr bool kMakesAModel = std::is_constructible_v<MotionModel, Tendons, Muscles>;
static_assert(kMakesAModel<const DigitTendons&, const Contraction&>);
static_assert(!kMakesAModel<DigitTendons&&, const Contraction&>);
static_assert(!kMakesAModel<const DigitTendons&, Contraction&&>);
static_assert(!kMakesAModel<DigitTendons&&, Contraction&&>);

SimulateOptions seconds(double time, double tolerance = 1e-8) {
  SimulateOptions options;
  options.seconds = time;
  options.tolerance = tolerance;
  return options;
}

// Without friction  I q_dot^2 / 2 = tau q - m g d (1 - cos q)  at every instant.
TEST(Simulate, PendulumUnderConstantTensionKeepsItsFirstIntegral) {
  const Pendulum rod;
  const Mover mover(rod.subject(), Muscle::kBounds);
  MotionModel model = mover.model();
  model.gravity = {0, -9.81, 0};
  model.resistance.damping = 0;
  const Trajectory path = simulate(model, constant_excitation(mover.excited(0.25)),
                                   {VectorXd::Zero(1), {}, {}}, seconds(1, 1e-10));
  ASSERT_EQ(path.status, MotionStatus::kCompleted);
  const double tau = 0.25 * rod.F0 * rod.arm;
  for (Eigen::Index i = 0; i < path.time.size(); ++i) {
    const double q = path.angle(i, 0), q_dot = path.speed(i, 0);
    EXPECT_NEAR(rod.inertia() * q_dot * q_dot / 2,
                tau * q - rod.mass * 9.81 * rod.distance * (1 - std::cos(q)), 1e-9);  // [J]
  }
  EXPECT_GT(path.angle.maxCoeff(), 0.5);  // it does swing
}

// I q'' + c q' + k q = tau from rest:  q = tau / k (1 - e^-ut (cos wt + u / w sin wt)),
// u = c / 2 I, w^2 = k / I - u^2.
TEST(Simulate, SpringAndDamperFollowTheirClosedForm) {
  const Pendulum rod;
  Subject subject = rod.subject();
  subject.joints[0].stiffness = 0.05;
  subject.joints[0].damping = 4e-4;
  const Mover mover(subject, Muscle::kBounds);
  const Trajectory path = simulate(mover.model(), constant_excitation(mover.excited(0.5)),
                                   {VectorXd::Zero(1), {}, {}}, seconds(0.5));
  const double tau = 0.5 * rod.F0 * rod.arm, u = 4e-4 / (2 * rod.inertia());
  const double w = std::sqrt(0.05 / rod.inertia() - u * u);
  for (Eigen::Index i = 0; i < path.time.size(); ++i) {
    const double t = path.time[i];
    const double q =
        tau / 0.05 * (1 - std::exp(-u * t) * (std::cos(w * t) + u / w * std::sin(w * t)));
    EXPECT_NEAR(path.angle(i, 0), q, 1e-5) << t;  // error of all steps together [rad]
  }
}

TEST(Simulate, KeepsInstantsAtEqualDistances) {
  const Mover mover(Pendulum().subject(), Muscle::kBounds);
  SimulateOptions options = seconds(0.1);
  options.sample = 0.03;
  const Trajectory path = simulate(mover.model(), constant_excitation(mover.excited(0)),
                                   {VectorXd::Zero(1), {}, {}}, options);
  EXPECT_TRUE(matrix_near(path.time, Eigen::Vector4d(0, 0.03, 0.06, 0.09), 1e-15));
}

// From the jump of excitation on,  -1.5 a - 2 log(1 - a) = t / rise  [Thelen2003].
TEST(Simulate, ActivationFollowsJumpOfExcitation) {
  const Mover mover(Pendulum().subject(), Muscle::kBounds);
  const Excitation jump{Eigen::Vector2d(0.1, 0.1), Eigen::Vector2d(0, 1)};
  const Trajectory path = simulate(mover.model(), jump, {VectorXd::Zero(1), {}, {}}, seconds(0.15));
  for (Eigen::Index i = 0; i < path.time.size(); ++i) {
    const double a = path.activation(i, 0), since = std::max(0.0, path.time[i] - 0.1);
    EXPECT_NEAR(-1.5 * a - 2 * std::log(1 - a), since / ActivationTimes().rise, 1e-5) << since;
  }
}

class EveryRung : public testing::TestWithParam<Muscle> {};

// Energy of motion, weights and stops is what tendons put in less what dampers take out.
TEST_P(EveryRung, BalancesEnergyWithinTolerance) {
  const Mover mover(sample::index_finger(), GetParam());
  MotionModel model = mover.model();
  model.gravity = {0, -9.81, 0};
  VectorXd excitation = mover.excited(0.05);
  excitation[2] = 0.15;  // FDP
  const Trajectory path = simulate(model, constant_excitation(excitation),
                                   {VectorXd::Zero(4), {}, mover.excited(0)}, seconds(0.5, 1e-7));
  ASSERT_EQ(path.status, MotionStatus::kCompleted) << path.warning;
  EXPECT_GT(path.work.cwiseAbs().maxCoeff(), 1e-3);  // [J]
  EXPECT_LT(energy_error(path), 1e-6);               // [J]
}

// Work on the joints is what muscles lose in length under tension:  d work = - sum t d excursion.
TEST_P(EveryRung, TendonsPassOnThePowerOfMuscles) {
  const Mover mover(sample::index_finger(), GetParam());
  SimulateOptions options = seconds(0.3, 1e-8);
  options.sample = 1e-4;
  const Trajectory path = simulate(mover.model(), constant_excitation(mover.excited(0.1)),
                                   {VectorXd::Constant(4, 0.2), {}, mover.excited(0)}, options);
  double work = 0;
  for (Eigen::Index i = 1; i < path.time.size(); ++i)
    work -= (path.tension.row(i) + path.tension.row(i - 1))
                .dot(path.excursion.row(i) - path.excursion.row(i - 1)) /
            2;
  EXPECT_NEAR(path.work.tail<1>()[0], work, 1e-5);  // of the trapezoids [J]
}

INSTANTIATE_TEST_SUITE_P(Muscles, EveryRung,
                         testing::Values(Muscle::kBounds, Muscle::kRigidTendon,
                                         Muscle::kElasticTendon));

/// Torque at rest with muscles at activation a, fibres on rigid tendons [N m].
VectorXd static_torque(const Mover& mover, const VectorXd& q, double a) {
  const VectorXd e = excursion(*mover.tendons, VectorXd::Zero(q.size()), q, mover.excited(1)).e;
  VectorXd t(e.size());
  for (int m = 0; m < t.size(); ++m) {
    const double length =
        musculotendon_length_at_optimum(mover.contraction->muscles()[static_cast<std::size_t>(m)]) +
        e[m];
    t[m] = mover.contraction->tension(m, {a, length, 0, 0});
  }
  return mover.tendons->evaluate(q, t).tau +
         resistance_torque(mover.tendons->digit().skeleton, mover.model().resistance, q);
}

/// Newton's method on the torque alone.
VectorXd balanced_posture(const Mover& mover, VectorXd q, double a) {
  constexpr double h = 1e-6;
  for (int i = 0; i < 50; ++i) {
    const VectorXd tau = static_torque(mover, q, a);
    Eigen::MatrixXd slope(q.size(), q.size());
    for (Eigen::Index j = 0; j < q.size(); ++j) {
      const VectorXd step = h * VectorXd::Unit(q.size(), j);
      slope.col(j) =
          (static_torque(mover, q + step, a) - static_torque(mover, q - step, a)) / (2 * h);
    }
    q -= slope.partialPivLu().solve(tau);
    if (tau.norm() < 1e-12) break;
  }
  return q;
}

// Slow motion is static: a ramp of 4 s, held for 4 s, ends where torques balance.
TEST(Simulate, SlowRampEndsInStaticBalance) {
  const Mover mover(sample::index_finger(), Muscle::kRigidTendon);
  Excitation ramp{Eigen::Vector2d(0, 4), Eigen::MatrixXd::Zero(2, 7)};
  ramp.value.row(1).setConstant(0.2);
  const Trajectory path =
      simulate(mover.model(), ramp, {VectorXd::Constant(4, 0.3), {}, {}}, seconds(8, 1e-7));
  ASSERT_EQ(path.status, MotionStatus::kCompleted) << path.warning;
  const VectorXd last = path.angle.bottomRows<1>().transpose();
  const VectorXd balanced = balanced_posture(mover, last.array() + 0.05, 0.2);
  ASSERT_LT(static_torque(mover, balanced, 0.2).norm(), 1e-10);
  EXPECT_TRUE(matrix_near(last, balanced, 1e-4));  // what is left of the creep after 4 s [rad]
}

// The stretch of a tendon goes with its strain at F0, and with it the difference in posture, as
// long as no tendon goes slack: a fibre beside a slack tendon lags, one on a rigid tendon cannot.
TEST(Simulate, ElasticTendonsBecomeRigidAsTheyStiffen) {
  Subject subject = Pendulum().subject();
  subject.joints[0].stiffness = 0.1;
  subject.muscles[0].max_force = 50;
  subject.muscles[0].fibre_length = 0.06;
  subject.muscles[0].tendon_slack = 0.2;
  const auto angles = [&](Muscle rung, double strain) -> VectorXd {
    const Mover mover(subject, rung, {10, 0.1, strain});
    const Trajectory path = simulate(mover.model(), constant_excitation(mover.excited(0.3)),
                                     {VectorXd::Zero(1), {}, mover.excited(0.1)}, seconds(0.2));
    EXPECT_EQ(path.status, MotionStatus::kCompleted) << path.warning;
    EXPECT_GT(path.tension.minCoeff(), 0);
    return path.angle.col(0);
  };
  const VectorXd rigid = angles(Muscle::kRigidTendon, kTendonStrain);
  const double at_1e3 = (angles(Muscle::kElasticTendon, 1e-3) - rigid).cwiseAbs().maxCoeff();
  const double at_1e4 = (angles(Muscle::kElasticTendon, 1e-4) - rigid).cwiseAbs().maxCoeff();
  EXPECT_GT(rigid.maxCoeff(), 0.5);
  EXPECT_LT(at_1e4, at_1e3 / 8);  // tenfold in the limit
  EXPECT_LT(at_1e4, 2e-3);        // stretch over arm, 0.2 m 1e-4 / 0.01 m [rad]
}

// A light link between heavy ones, and a heavy one at the end of a light one.
TEST(Simulate, MassesOneToAThousandStaySound) {
  for (const double ratio : {1e-3, 1e3}) {
    Subject subject = sample::index_finger();
    Segment& tip = subject.segments.back();
    tip.mass *= ratio;
    tip.inertia *= ratio;
    const Mover mover(subject, Muscle::kRigidTendon);
    const Trajectory path =
        simulate(mover.model(), constant_excitation(mover.excited(0.1)),
                 {VectorXd::Constant(4, 0.2), {}, mover.excited(0)}, seconds(0.5, 1e-7));
    EXPECT_EQ(path.status, MotionStatus::kCompleted) << ratio << " " << path.warning;
    EXPECT_LT(energy_error(path), 1e-6) << ratio;  // [J]
  }
}

TEST(Simulate, StopsWhenAskedAndKeepsWhatItHas) {
  const Mover mover(Pendulum().subject(), Muscle::kBounds);
  SimulateOptions options = seconds(10);
  double done = 0;
  options.progress.report = [&](double fraction, const std::string&) { done = fraction; };
  options.progress.stop_requested = [&] { return done > 0.5; };
  const Trajectory path = simulate(mover.model(), constant_excitation(mover.excited(0.1)),
                                   {VectorXd::Zero(1), {}, {}}, options);
  EXPECT_EQ(path.status, MotionStatus::kStopped);
  EXPECT_GT(path.time.tail<1>()[0], 4.5);
  EXPECT_LT(path.time.tail<1>()[0], 9.5);
  EXPECT_EQ(path.angle.rows(), path.time.size());
}

TEST(Simulate, SaysWhyItIsStuck) {
  const Mover mover(Pendulum().subject(), Muscle::kBounds);
  SimulateOptions options = seconds(10);
  options.max_steps = 20;
  const Trajectory path = simulate(mover.model(), constant_excitation(mover.excited(0.1)),
                                   {VectorXd::Zero(1), {}, {}}, options);
  EXPECT_EQ(path.status, MotionStatus::kLimit);
  EXPECT_EQ(path.warning.rfind("more steps than allowed", 0), 0u) << path.warning;
}

// Tolerances at which energy comes of nothing, and a hundredth of which lets none in.
TEST(Simulate, IntegratesOnceMoreWhereEnergyDoesNotBalance) {
  const Mover mover(sample::index_finger(), Muscle::kRigidTendon);
  int again = 0;
  for (const double tolerance : {0.3, 0.1, 0.03, 0.01, 3e-3, 1e-3, 1e-6}) {
    const Trajectory path =
        simulate(mover.model(), constant_excitation(mover.excited(0.3)),
                 {VectorXd::Constant(4, 0.2), {}, mover.excited(0)}, seconds(0.2, tolerance));
    EXPECT_EQ(path.status == MotionStatus::kCompleted, path.balance.holds()) << tolerance;
    if (path.tolerance == tolerance) continue;
    EXPECT_DOUBLE_EQ(path.tolerance, tolerance / 100);
    EXPECT_EQ(path.status, MotionStatus::kCompleted) << tolerance;
    ++again;
  }
  EXPECT_GE(again, 1);
}

// What is integrated to a tolerance of a thousand, and then of ten, is no motion.
TEST(Simulate, NeverCallsDoneWhatMakesEnergyOfNothing) {
  const Mover mover(sample::index_finger(), Muscle::kRigidTendon);
  const Trajectory path =
      simulate(mover.model(), constant_excitation(mover.excited(0.3)),
               {VectorXd::Constant(4, 0.2), {}, mover.excited(0)}, seconds(0.2, 1e3));
  EXPECT_NE(path.status, MotionStatus::kCompleted);
  EXPECT_FALSE(path.balance.holds());
  EXPECT_GT(path.balance.error, 1e-4 * path.balance.turned_over);
}

// A tolerance that accepts any step ends in a status, whatever the numbers have become.
TEST(Simulate, EndsWithAStatusWhereTensionsAreNotFinite) {
  const Mover mover(sample::index_finger(), Muscle::kRigidTendon);
  VectorXd excitation = mover.excited(0);
  excitation[2] = 0.3;  // FDP
  const Trajectory path = simulate(mover.model(), constant_excitation(excitation),
                                   {VectorXd::Zero(4), {}, mover.excited(0)}, seconds(0.1, 1e3));
  EXPECT_NE(path.status, MotionStatus::kCompleted);
}

/// An excitation that jumps between 0 and 0.1, once in 1e-9 s.
Excitation jumping(int rows) {
  Excitation jumps{VectorXd(rows), Eigen::MatrixXd(rows, 1)};
  for (int k = 0; k < rows; ++k) {
    const int pair = k / 2, parity = (k + 1) / 2 % 2;
    jumps.time[k] = 1e-9 * pair;
    jumps.value(k, 0) = 0.1 * parity;
  }
  return jumps;
}

// Where excitation jumps 120 times, each after 1e-9 s, 200 steps get nowhere; larger errors carry
// the motion past, it says so, and its energy balances. Without that many it says nothing.
TEST(Simulate, GetsPastAPlaceWhereRatesJump) {
  const Mover mover(Pendulum().subject(), Muscle::kBounds);
  SimulateOptions options = seconds(0.1);
  options.stall_steps = 200;
  for (const bool many : {false, true}) {
    const Trajectory path =
        simulate(mover.model(), jumping(many ? 240 : 100), {VectorXd::Zero(1), {}, {}}, options);
    EXPECT_EQ(path.status, MotionStatus::kCompleted) << path.warning;
    EXPECT_TRUE(path.balance.holds());
    EXPECT_EQ(path.warning.rfind("its rates jump: in 1 stretch of ", 0) == 0, many) << path.warning;
  }
}

// Steps of at most 1e-9 s, as excitation jumps at every one, get nowhere.
TEST(Simulate, GivesUpWhereItDoesNotGetOn) {
  const Mover mover(Pendulum().subject(), Muscle::kBounds);
  const Excitation jumps = jumping(4000);
  SimulateOptions options = seconds(1);
  options.stall_steps = 200;
  const Trajectory path = simulate(mover.model(), jumps, {VectorXd::Zero(1), {}, {}}, options);
  EXPECT_EQ(path.status, MotionStatus::kNoProgress);
  EXPECT_EQ(path.warning.rfind("200 steps took it less than", 0), 0u) << path.warning;
  EXPECT_EQ(path.angle.rows(), path.time.size());
}

TEST(Simulate, NeedsMassBeyondEveryJoint) {
  Subject subject = sample::index_finger();
  for (Segment& segment : subject.segments) segment.mass = segment.radius = 0;
  const Mover mover(subject, Muscle::kBounds);
  EXPECT_THROW((void)simulate(mover.model(), constant_excitation(mover.excited(0)),
                              {VectorXd::Zero(4), {}, {}}),
               InputError);
}

/// Stands for a net: a tendon of constant arm that gives by `kGive` a newton.
class GivingTendon : public DigitTendons {
 public:
  static constexpr double kArm = 0.01, kGive = 2e-4;  // [m/rad], [m/N]
  explicit GivingTendon(TendonDigit digit) : digit_(std::move(digit)) {
    digit_.fidelity.hood = Hood::kFloatingNet;
  }
  [[nodiscard]] const TendonDigit& digit() const override { return digit_; }
  TendonTorque evaluate(const VectorXd&, const VectorXd& t,
                        const Eigen::Matrix3Xd&) const override {
    TendonTorque pull;
    pull.R = Eigen::MatrixXd::Constant(1, 1, kArm);
    pull.tau = pull.R.transpose() * t;
    return pull;
  }
  Eigen::MatrixXd compliance(const VectorXd&, const VectorXd&, const TendonTorque&) const override {
    return Eigen::MatrixXd::Constant(1, 1, kGive);
  }
  VectorXd lengths(const VectorXd& q, const VectorXd& t, const TendonTorque&) const override {
    return -kArm * q - kGive * t;
  }

 private:
  TendonDigit digit_;
};

// length = const - arm q - give t, whatever the muscle.
TEST(Simulate, ExcursionFollowsPostureAndWhatTendonsGive) {
  Subject subject = Pendulum().subject();
  subject.muscles[0].max_force = 50;
  subject.muscles[0].fibre_length = 0.06;
  subject.muscles[0].tendon_slack = 0.2;
  const GivingTendon tendons(build_tendon_digit(subject, "index"));
  for (const Muscle rung : {Muscle::kBounds, Muscle::kRigidTendon, Muscle::kElasticTendon}) {
    const auto contraction =
        build_contraction(musculotendons(subject, tendons.digit(), rung), rung);
    SimulateOptions options;
    options.seconds = 0.05;
    const VectorXd one = VectorXd::Ones(1);
    const Trajectory path = simulate({tendons, *contraction}, constant_excitation(0.4 * one),
                                     {0 * one, {}, 0 * one}, options);
    ASSERT_EQ(path.status, MotionStatus::kCompleted) << path.warning;
    const Eigen::Index last = path.time.size() - 1;
    const double turn = path.angle(last, 0) - path.angle(0, 0);
    const double more = path.tension(last, 0) - path.tension(0, 0);
    EXPECT_GT(GivingTendon::kGive * more, 1e-4);
    EXPECT_NEAR(path.excursion(last, 0) - path.excursion(0, 0),
                -GivingTendon::kArm * turn - GivingTendon::kGive * more,
                1e-6);  // [m], of 1e-3
  }
}

// Every bend of a tendon presses on its bone with t (u_in - u_out); bones feel the same motion
// from these forces as from the torques R' t.
TEST(FingerMotion, ForcesOnBonesMoveThemAsTorquesDo) {
  const Mover mover(sample::index_finger(), Muscle::kBounds);
  const TendonDigit& digit = mover.tendons->digit();
  const VectorXd q = Eigen::Vector4d(0.5, 0.1, 0.7, 0.3), t = VectorXd::LinSpaced(7, 1, 10);
  const TreeState<double> state = pose_tree(digit.model.tree, q);
  const VectorXd strands = strand_matrix(digit.model, q) * t;
  Loads loads;
  for (std::size_t s = 0; s < digit.model.paths.size(); ++s) {
    const TendonPath<double>& path = digit.model.paths[s];
    for (std::size_t k = 1; k < path.size(); ++k) {
      const Eigen::Vector3d run =
          moved(state, path[k].link, path[k].p) - moved(state, path[k - 1].link, path[k - 1].p);
      const Eigen::Vector3d pull = strands[static_cast<Eigen::Index>(s)] * run.normalized();
      loads.forces.push_back({path[k - 1].link, path[k - 1].p, pull});
      loads.forces.push_back({path[k].link, path[k].p, -pull});
    }
  }
  Multibody bones(digit.skeleton);
  const JointMotion motion{q, Eigen::Vector4d(1, -2, 3, -4)};
  const VectorXd by_torque = bones.forward_dynamics(motion, mover.tendons->evaluate(q, t).tau);
  const VectorXd by_force = bones.forward_dynamics(motion, VectorXd::Zero(4), loads);
  EXPECT_TRUE(matrix_near(by_force, by_torque, 1e-9 * by_torque.norm()));
}

}  // namespace
}  // namespace thenar
