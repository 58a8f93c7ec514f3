// Tests for dynamics/human/digit_pull.cpp and joint_stops.cpp.

#include "dynamics/human/digit_pull.h"

#include <cmath>

#include <gtest/gtest.h>

#include "dynamics/mechanism/build_mechanism.h"
#include "dynamics/mechanism/tree_model.h"
#include "dynamics/mechanism/tree_motion.h"
#include "dynamics/scene/measure_run.h"
#include "dynamics/stepping/simulate_scene.h"
#include "tendons/net/build_tendons.h"
#include "tests/matrix_near.h"
#include "tests/message_of.h"
#include "tests/tendons/muscle/moving_samples.h"

namespace thenar {
namespace {

using Eigen::VectorXd;
using sample::Mover;
using sample::Pendulum;

/// A digit alone as a scene: its bones, resisted as in FingerMotion.
struct DigitScene {
  DigitScene(std::shared_ptr<const DigitTendons> of, const JointResistance& resistance,
             const Eigen::Vector3d& gravity)
      : tendons(std::move(of)) {
    const Skeleton& skeleton = tendons->digit().skeleton;
    scene.mechanism = skeleton_mechanism(skeleton);
    const VectorXd damping = joint_damping(skeleton, resistance);
    for (MechanismJoint& joint : scene.mechanism.joints) {
      joint.lower = -1e9;
      joint.upper = 1e9;
      if (joint.name == skeleton.coordinate_names[static_cast<std::size_t>(joint.coordinate)])
        joint.damping = damping[joint.coordinate];
    }
    const MechanismLayout layout = layout_of(scene.mechanism);
    places = {layout.coordinate_q, layout.coordinate_v};
    scene.elements.push_back(
        std::make_shared<const JointStops>("stops", skeleton, places, resistance));
    scene.gravity = gravity;
    scene.q = VectorXd::Zero(layout.q);
    scene.v = VectorXd::Zero(layout.v);
  }

  /// The pull, for excitations or tensions to be added.
  [[nodiscard]] DigitPullModel pull() const {
    DigitPullModel model;
    model.name = "digit";
    model.tendons = std::make_shared<const TendonGroup>(
        std::vector<std::shared_ptr<const DigitTendons>>{tendons});
    model.indices = places;
    return model;
  }

  void add(DigitPullModel model) {
    scene.elements.push_back(std::make_shared<const DigitPull>(std::move(model)));
  }

  std::shared_ptr<const DigitTendons> tendons;
  CoordinateIndices places;
  MovingScene scene;
};

/// A pendulum that nothing damps.
DigitScene scene_of(const Pendulum& rod, const Eigen::Vector3d& gravity) {
  JointResistance smooth;
  smooth.damping = 0;
  return {std::shared_ptr<const DigitTendons>(build_linear_tendons(rod.subject(), "index")), smooth,
          gravity};
}

MuscleSchedule constant(int muscle, double value, const TimeSpan& when = {}) {
  return {muscle, when, VectorXd::Zero(1), VectorXd::Constant(1, value)};
}

SceneOptions lasting(double seconds, double tolerance = 1e-9) {
  SceneOptions options;
  options.duration = seconds;
  options.sample_interval = 0.01;
  options.tolerance = tolerance;
  return options;
}

/// The same excitations, from rest, by the integrator of single digits: Simbody and SUNDIALS.
Trajectory by_integrator(const MotionModel& model, const VectorXd& excitation, const VectorXd& q,
                         double seconds, double tolerance = 1e-9) {
  SimulateOptions options;
  options.seconds = seconds;
  options.sample = 0.01;
  options.tolerance = tolerance;
  return simulate(model, constant_excitation(excitation),
                  {q, {}, VectorXd::Zero(excitation.size())}, options);
}

/// The same as a scene.
DigitScene scene_of(const MotionModel& model, std::shared_ptr<const DigitTendons> tendons,
                    std::shared_ptr<const Contraction> contraction, const VectorXd& excitation,
                    const VectorXd& q) {
  DigitScene digit(std::move(tendons), model.resistance, model.gravity);
  digit.scene.q = q;
  DigitPullModel pull = digit.pull();
  pull.contraction = std::move(contraction);
  for (int m = 0; m < excitation.size(); ++m)
    pull.excitations.push_back(constant(m, excitation[m]));
  digit.add(std::move(pull));
  return digit;
}

// I q_dot^2 / 2 = t arm q - m g d (1 - cos q) without friction.
TEST(DigitPull, PendulumUnderConstantTensionKeepsItsFirstIntegral) {
  const Pendulum rod;
  const Mover mover(rod.subject(), Muscle::kBounds);
  DigitScene digit = scene_of(rod, {0, -9.81, 0});
  DigitPullModel pull = digit.pull();
  pull.tensions = {constant(0, 0.5)};
  digit.add(std::move(pull));
  const SceneRun run = simulate_scene(digit.scene, lasting(1));
  ASSERT_EQ(run.status, SceneStatus::kDone);
  for (const SceneSample& at : run.samples) {
    const double q = at.q[0], q_dot = at.v[0];
    EXPECT_NEAR(rod.inertia() * q_dot * q_dot / 2,
                0.5 * rod.arm * q - rod.mass * 9.81 * rod.distance * (1 - std::cos(q)), 1e-10);
    EXPECT_NEAR(at.z[0], 0.5 * rod.arm * q, 1e-9);  // work of the tendon [J]
  }
  EXPECT_GT(run.samples.back().t, 0.99);
}

// From the start of a drive on,  I q'' = t arm  gives  q = t arm s^2 / 2 I.
TEST(DigitPull, TensionBeginsAndEndsWhenItsTimeDoes) {
  const Pendulum rod;
  DigitScene digit = scene_of(rod, {0, 0, 0});
  DigitPullModel pull = digit.pull();
  pull.tensions = {constant(0, 0.02, {0.033, 0.15}), constant(0, 0.04, {0.15, 0.2})};
  digit.add(std::move(pull));
  const SceneRun run = simulate_scene(digit.scene, lasting(0.3));
  ASSERT_EQ(run.status, SceneStatus::kDone);
  const double a = 0.02 * rod.arm / rod.inertia();  // [1/s^2]
  double t = 0.1 - 0.033;
  EXPECT_NEAR(run.samples[10].q[0], a * t * t / 2, 1e-10);
  EXPECT_NEAR(run.samples[20].v[0], a * (0.15 - 0.033) + 2 * a * 0.05, 1e-9);
  EXPECT_NEAR(run.samples[30].v[0], run.samples[20].v[0], 1e-9);
}

// Straight between knots:  tension 0.02 t / 0.1  gives  q = a t^3 / 0.6.
TEST(DigitPull, TensionFollowsItsKnots) {
  const Pendulum rod;
  DigitScene digit = scene_of(rod, {0, 0, 0});
  DigitPullModel pull = digit.pull();
  pull.tensions = {{0, {}, Eigen::Vector3d(0, 0.1, 0.1), Eigen::Vector3d(0, 0.02, 0)}};
  digit.add(std::move(pull));
  const SceneRun run = simulate_scene(digit.scene, lasting(0.2));
  const double a = 0.02 * rod.arm / rod.inertia();
  EXPECT_NEAR(run.samples[10].q[0], a * 0.001 / 0.6, 1e-10);
  EXPECT_NEAR(run.samples[20].v[0], a * 0.05, 1e-9);
}

// A straight line down to 0, whose end rounding puts at -2e-16: the tension is 0 there and beyond,
// where a trial step may look. Tension 1.9 (1 - t / T) up to T gives the speed  1.9 T arm / 2 I.
TEST(DigitPull, TensionThatRampsDownEndsAtZero) {
  const Pendulum rod;
  DigitScene digit = scene_of(rod, {0, 0, 0});
  DigitPullModel model = digit.pull();
  model.tensions = {{0, {}, Eigen::Vector2d(0, 0.01), Eigen::Vector2d(1.9, 0)}};
  const DigitPull pull(model);
  const TreeModel tree = tree_model(digit.scene.mechanism);
  const TreeMotion<double> motion(tree);
  const VectorXd none = VectorXd::Zero(1);
  const auto tension_at = [&](double t) {
    return pull.state_at({t, 0.005, none, none, VectorXd(), motion, 0}).tension[0];
  };
  EXPECT_DOUBLE_EQ(tension_at(0.005), 0.95);
  EXPECT_EQ(tension_at(0.01), 0);
  EXPECT_EQ(tension_at(0.015), 0);
  digit.add(std::move(model));
  const SceneRun run = simulate_scene(digit.scene, lasting(0.02));
  ASSERT_EQ(run.status, SceneStatus::kDone);
  EXPECT_NEAR(run.samples.back().v[0], 1.9 * 0.01 / 2 * rod.arm / rod.inertia(), 1e-9);
}

class EveryRungOfMuscles : public testing::TestWithParam<Muscle> {};

// Two programs, one physics: recursions and extrapolation here, Simbody and SUNDIALS there.
TEST_P(EveryRungOfMuscles, MovesAFingerAsTheIntegratorOfSingleDigitsDoes) {
  const Subject subject = sample::index_finger(PassiveMoments::kOn);
  const Mover mover(subject, GetParam());
  MotionModel model = mover.model();
  model.gravity = {0, -9.81, 0};
  VectorXd excitation = mover.excited(0.05);
  excitation[2] = 0.15;  // FDP
  const VectorXd q = VectorXd::Constant(4, 0.2);
  const Trajectory path = by_integrator(model, excitation, q, 0.3);
  ASSERT_EQ(path.status, MotionStatus::kCompleted) << path.warning;
  Mover owned(subject, GetParam());
  const DigitScene digit =
      scene_of(model, std::move(owned.tendons), std::move(owned.contraction), excitation, q);
  const SceneRun run = simulate_scene(digit.scene, lasting(0.3));
  ASSERT_EQ(run.status, SceneStatus::kDone);
  ASSERT_EQ(run.samples.size(), static_cast<std::size_t>(path.time.size()));
  const RunMeasures measures = measure_run(digit.scene, run);
  EXPECT_GT((path.angle.row(30) - path.angle.row(0)).cwiseAbs().maxCoeff(), 0.3);  // it moves
  for (Eigen::Index i = 0; i < path.time.size(); ++i) {
    const SceneSample& at = run.samples[static_cast<std::size_t>(i)];
    EXPECT_TRUE(matrix_near(at.q, VectorXd(path.angle.row(i)), 1e-6)) << at.t;
    // Beyond what passive moments store since the start.
    EXPECT_NEAR(
        at.z[at.z.size() - 1] + at.energy.of_elements - run.samples.front().energy.of_elements,
        path.work[i], 1e-7)
        << at.t;
    for (Eigen::Index m = 0; m < excitation.size(); ++m) {
      const PullMeasure& muscle = measures.pulls.muscles[static_cast<std::size_t>(m)];
      EXPECT_NEAR(muscle.activation[i], path.activation(i, m), 1e-6) << at.t;
      EXPECT_NEAR(muscle.tension[i], path.tension(i, m), 2e-4) << at.t << " " << muscle.name;
    }
  }
  EXPECT_NEAR(measures.dissipated, path.dissipated.tail<1>()[0], 1e-7);
}

INSTANTIATE_TEST_SUITE_P(Muscles, EveryRungOfMuscles,
                         testing::Values(Muscle::kBounds, Muscle::kRigidTendon,
                                         Muscle::kElasticTendon));

// The same under a floating net, whose bands blend and whose excursions are held to lengths in
// both. Ends of the integrator hang on its tolerance by up to a hundred times itself
// (NetMotionStability.EndsDoNotHangOnTheTolerance), and its excursions come later than lines by
// 1 / kFollowRate, in which a joint turns by its speed times that.
TEST(DigitPull, MovesAFingerWithANetAsTheIntegratorDoes) {
  const Subject subject = sample::index_finger();
  TendonOptions rungs;
  rungs.hood = Hood::kFloatingNet;
  const std::shared_ptr<const DigitTendons> tendons =
      build_net_tendons(subject, "index", rungs, read_net(THENAR_DATA_DIR "/nets/winslow.toml"));
  const VectorXd excitation = (VectorXd(7) << 0.05, 0.02, 0.1, 0.02, 0.02, 0.02, 0.02).finished();
  const VectorXd q = VectorXd::Constant(4, 0.2);
  for (const Muscle rung : {Muscle::kBounds, Muscle::kRigidTendon, Muscle::kElasticTendon}) {
    const std::shared_ptr<const Contraction> contraction =
        build_contraction(musculotendons(subject, tendons->digit(), rung), rung);
    const MotionModel model(*tendons, *contraction);
    constexpr double kTolerance = 1e-7;
    const Trajectory path = by_integrator(model, excitation, q, 0.1, kTolerance);
    ASSERT_EQ(path.status, MotionStatus::kCompleted) << path.warning;
    const DigitScene digit = scene_of(model, tendons, contraction, excitation, q);
    const SceneRun run = simulate_scene(digit.scene, lasting(0.1, 1e-8));
    ASSERT_EQ(run.status, SceneStatus::kDone) << run.cost.unsolved;
    const double late = path.speed.cwiseAbs().maxCoeff() / kFollowRate;
    for (Eigen::Index i = 0; i < path.time.size(); ++i)
      EXPECT_TRUE(matrix_near(run.samples[static_cast<std::size_t>(i)].q,
                              VectorXd(path.angle.row(i)), 100 * kTolerance + late))
          << static_cast<int>(rung) << " " << path.time[i];
  }
}

/// Speeds and positions of a digit of hinges are its coordinates.
struct ElementAt {
  double t = 0;
  VectorXd q, v, z;
};
ElementAction action_at(ForceElement& element, const TreeModel& tree, const ElementAt& at,
                        ElementNeed need = ElementNeed::kAll) {
  TreeMotion<double> motion(tree);
  motion.set_position(at.q);
  motion.set_speed(at.v);
  ElementAction out;
  out.clear(at.v.size(), at.z.size());
  EXPECT_TRUE(element.add_action({at.t, at.t, at.q, at.v, at.z, motion, 0, need}, out));
  return out;
}

class SlopesOfPulls : public testing::TestWithParam<Muscle> {};

// A step moves positions, and lengths of tendons with them; its slopes are central differences of
// torques along that way, with activations and fibres held. At rest, as what arms that turn add to
// velocities of muscles is left out; tendons are drawn out, so that none is at the end of its
// slack.
TEST_P(SlopesOfPulls, AreDifferencesOfTorques) {
  Mover owned(sample::index_finger(), GetParam());
  const std::shared_ptr<const DigitTendons> tendons = std::move(owned.tendons);
  const DigitScene digit(tendons, {}, {0, 0, 0});
  DigitPullModel model = digit.pull();
  model.contraction = std::move(owned.contraction);
  model.tensions = {constant(0, 3)};
  DigitPull pull(model);
  const TreeModel tree = tree_model(digit.scene.mechanism);
  const VectorXd q = (VectorXd(4) << 0.3, 0.1, 0.5, 0.4).finished();
  const VectorXd v = (VectorXd(4) << 0.5, -0.3, 0.8, 0.2).finished();
  ElementAt at{0, q, VectorXd::Zero(4), pull.initial_states(q)};
  // Muscles 1 and up contract.
  const std::vector<Musculotendon>& muscles = model.contraction->muscles();
  const auto count = static_cast<Eigen::Index>(muscles.size()) - 1;
  at.z.head(count).setConstant(0.4);
  if (GetParam() == Muscle::kElasticTendon) at.z.segment(count, count).array() += 0.05;
  const TreeMotion<double> motion(tree);
  pull.accept_step({0, 0, at.q, at.v, at.z, motion, 0});
  const ElementAction still = action_at(pull, tree, at);
  ElementAt fast = at;
  fast.v = v;
  const ElementAction moving = action_at(pull, tree, fast);
  const Eigen::MatrixXd R = tendons->evaluate(q, VectorXd::Zero(count + 1), Eigen::Matrix3Xd()).R;
  constexpr double kStep = 1e-5;
  Eigen::MatrixXd by_position(4, 4), by_speed(4, 4);
  for (int j = 0; j < 4; ++j) {
    const auto tau = [&](double step, bool speeds) {
      ElementAt moved = speeds ? fast : at;
      (speeds ? moved.v : moved.q)[j] += step;
      if (!speeds && at.z.size() > count)
        for (Eigen::Index i = 0; i < count; ++i)
          moved.z[count + i] -=
              R(i + 1, j) * step / muscles[static_cast<std::size_t>(i) + 1].optimal_fibre_length;
      return action_at(pull, tree, moved).tau;
    };
    by_position.col(j) = -(tau(kStep, false) - tau(-kStep, false)) / (2 * kStep);
    by_speed.col(j) = -(tau(kStep, true) - tau(-kStep, true)) / (2 * kStep);
  }
  const double size = by_position.cwiseAbs().maxCoeff();
  EXPECT_GT(size, 1e-3);
  EXPECT_TRUE(matrix_near(still.stiffness,
                          Eigen::MatrixXd(0.5 * (by_position + by_position.transpose())),
                          1e-6 * size));
  EXPECT_TRUE(matrix_near(moving.damping, by_speed, 1e-6 * size));
  EXPECT_EQ(by_speed.cwiseAbs().maxCoeff() > 1e-4, GetParam() == Muscle::kRigidTendon);
}

INSTANTIATE_TEST_SUITE_P(Muscles, SlopesOfPulls,
                         testing::Values(Muscle::kBounds, Muscle::kRigidTendon,
                                         Muscle::kElasticTendon));

class NeedsOfPulls : public testing::TestWithParam<Muscle> {};

// A call that asks for less computes less; what it gives has the very bits of one that asks for
// all.
TEST_P(NeedsOfPulls, ChangeNoBitOfWhatIsAskedFor) {
  Mover owned(sample::index_finger(), GetParam());
  const std::shared_ptr<const DigitTendons> tendons = std::move(owned.tendons);
  const DigitScene digit(tendons, {}, {0, 0, 0});
  DigitPullModel model = digit.pull();
  model.contraction = std::move(owned.contraction);
  DigitPull pull(model);
  const TreeModel tree = tree_model(digit.scene.mechanism);
  for (int posture = 0; posture < 4; ++posture) {
    const VectorXd q = 0.2 * posture * (VectorXd(4) << 0.9, 0.1, 1.1, 0.7).finished();
    ElementAt at{0, q, (VectorXd(4) << 0.5, -0.3, 0.8, 0.2).finished(), pull.initial_states(q)};
    const auto count = static_cast<Eigen::Index>(model.contraction->muscles().size());
    at.z.head(count).setConstant(0.4);
    // Elastic tendons are drawn out, so that they pull.
    if (GetParam() == Muscle::kElasticTendon) at.z.segment(count, count).array() += 0.05;
    const ElementAction states = action_at(pull, tree, at, ElementNeed::kStates);
    const ElementAction rates = action_at(pull, tree, at, ElementNeed::kRates);
    DigitPull other(model);
    const ElementAction all = action_at(other, tree, at);
    EXPECT_EQ(rates.tau, all.tau);
    EXPECT_GT(all.tau.cwiseAbs().maxCoeff(), 1e-3);
    for (const ElementAction* less : {&rates, &states}) {
      EXPECT_EQ(less->z_rate, all.z_rate);
      EXPECT_EQ(less->z_decay, all.z_decay);
    }
    EXPECT_TRUE(rates.stiffness.isZero(0));
    EXPECT_FALSE(all.stiffness.isZero(0));
  }
}

INSTANTIATE_TEST_SUITE_P(Muscles, NeedsOfPulls,
                         testing::Values(Muscle::kBounds, Muscle::kRigidTendon,
                                         Muscle::kElasticTendon));

// The line of passive moments is the mechanism's, their ends are the stops'; none is left out.
TEST(JointStops, ActWithTheMechanismAsPassiveMoments) {
  const std::shared_ptr<const DigitTendons> tendons =
      build_linear_tendons(sample::index_finger(PassiveMoments::kOn), "index");
  const Skeleton& skeleton = tendons->digit().skeleton;
  const DigitScene digit(tendons, {}, {0, 0, 0});
  JointStops stops("stops", skeleton, digit.places);
  const ElementAt at{0, Eigen::Vector4d(0.7, 0.1, 0.2, -0.05), VectorXd::Zero(4), VectorXd()};
  VectorXd tau = action_at(stops, tree_model(digit.scene.mechanism), at).tau;
  EXPECT_GT(tau.cwiseAbs().minCoeff(), 0);
  for (int j = 0; j < 4; ++j) {
    const MechanismJoint& joint = digit.scene.mechanism.joints[static_cast<std::size_t>(j)];
    tau[j] -= joint.stiffness * (at.q[j] - joint.rest);
  }
  EXPECT_TRUE(matrix_near(tau, passive_torque(skeleton, at.q), 1e-15));
}

// Within ranges, in the toe and beyond it; torque is minus the slope of energy, too.
TEST(JointStops, SlopesAreDifferences) {
  const std::shared_ptr<const DigitTendons> tendons =
      build_linear_tendons(sample::index_finger(), "index");
  const Skeleton& skeleton = tendons->digit().skeleton;
  const DigitScene digit(tendons, {}, {0, 0, 0});
  JointStops stops("stops", skeleton, digit.places);
  const TreeModel tree = tree_model(digit.scene.mechanism);
  ElementAt at{0, VectorXd(4), VectorXd::Zero(4), VectorXd()};
  for (int j = 0; j < 4; ++j) {
    const CoordinateLimits& range = skeleton.limits[static_cast<std::size_t>(j)];
    at.q[j] = j == 0   ? range.upper + 0.02
              : j == 1 ? range.lower - 0.1
              : j == 2 ? range.upper + 0.2
                       : 0.5 * (range.lower + range.upper);
  }
  const ElementAction out = action_at(stops, tree, at);
  EXPECT_GT(out.tau.head(3).cwiseAbs().minCoeff(), 0.05);
  EXPECT_EQ(out.tau[3], 0);
  constexpr double kStep = 1e-5;
  const TreeMotion<double> motion(tree);
  Eigen::MatrixXd by_position(4, 4);
  for (int j = 0; j < 4; ++j) {
    ElementAt more = at, less = at;
    more.q[j] += kStep;
    less.q[j] -= kStep;
    by_position.col(j) =
        -(action_at(stops, tree, more).tau - action_at(stops, tree, less).tau) / (2 * kStep);
    EXPECT_NEAR(-(stops.energy({0, 0, more.q, more.v, more.z, motion, 0}) -
                  stops.energy({0, 0, less.q, less.v, less.z, motion, 0})) /
                    (2 * kStep),
                out.tau[j], 1e-8);
  }
  EXPECT_TRUE(matrix_near(out.stiffness, by_position, 1e-6));
  EXPECT_TRUE(out.damping.isZero(0));
  EXPECT_EQ(action_at(stops, tree, at, ElementNeed::kRates).tau, out.tau);
}

TEST(DigitPull, RefusesWhatCannotBe) {
  Mover owned(sample::index_finger(), Muscle::kBounds);
  const std::shared_ptr<const DigitTendons> tendons = std::move(owned.tendons);
  const std::shared_ptr<const Contraction> contraction = std::move(owned.contraction);
  const DigitScene digit(tendons, {}, {0, 0, 0});
  const auto complaint = [&](const std::vector<MuscleSchedule>& tensions,
                             const std::vector<MuscleSchedule>& excitations) {
    DigitPullModel model = digit.pull();
    model.tensions = tensions;
    model.excitations = excitations;
    model.contraction = contraction;
    return message_of<InputError>([&] { (void)DigitPull(model); });
  };
  EXPECT_EQ(complaint({constant(2, 1), constant(2, 2)}, {}),
            "two drives give 'FDP' its tension at once");
  EXPECT_EQ(complaint({constant(2, 1, {0, 1}), constant(2, 2, {1, 2})}, {}), "nothing was thrown");
  EXPECT_EQ(complaint({}, {constant(2, 1.5)}), "excitation of 'FDP' must be 0 to 1");
  EXPECT_EQ(complaint({constant(2, 1)}, {constant(2, 0.5)}),
            "'FDP' has a tension or cannot contract, and is excited");
  // Muscles in another order.
  std::vector<Musculotendon> turned = contraction->muscles();
  std::swap(turned[0], turned[1]);
  DigitPullModel model = digit.pull();
  model.contraction = build_contraction(turned, Muscle::kBounds);
  EXPECT_EQ(message_of<InputError>([&] { (void)DigitPull(model); }),
            fmt::format("muscle 0 contracts as '{}', 'digit' calls it '{}'", turned[0].name,
                        turned[1].name));
}

}  // namespace
}  // namespace thenar
