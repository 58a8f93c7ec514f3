// Tests for grasp/limits/contact_support.cpp: no squeeze without effort. Closed forms.

#include "grasp/limits/contact_support.h"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "grasp/limits/grasp_force.h"
#include "grasp/limits/joint_limits.h"
#include "grasp/limits/wrench_support.h"
#include "grasp/quality/task_margin.h"
#include "tests/grasp/quality/pinch.h"

namespace thenar {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kSolvedPress = 1e-7;  // of forces of order 10 N
constexpr double kNoLimit = std::numeric_limits<double>::infinity();
constexpr double kMu = 0.5;

double load(const ForceSet& forces, int axis, double way = 1) {
  const WrenchSupport reach = load_margin(forces, way * ScaledWrench::unit(axis));
  EXPECT_TRUE(reach.status == Status::kSolved || reach.status == Status::kUnbounded);
  return reach.value;
}

/// Efforts from -most to most of one motor each, with an open stop at the coordinates named.
Actuation motors(const MatrixXd& B, double most, const std::vector<int>& stops) {
  Actuation actuation{B, VectorXd::Zero(B.rows()), VectorXd::Constant(B.cols(), -most),
                      VectorXd::Constant(B.cols(), most)};
  for (const int j : stops)
    add_reaction(actuation.reactions, VectorXd::Unit(B.rows(), j), 0, kNoLimit);
  return actuation;
}

ForceSet pinched(const Actuation& actuation) {
  return hand_forces(pinch(kMu, 0), pinch_torques(kMu, 0), actuation);
}

/// Both jaws on one coordinate.
ForceSet jaws(double most, const std::vector<int>& stops) {
  return hand_forces(pinch(kMu, 0), pinch_torques(kMu, 0).colwise().sum(),
                     motors(MatrixXd::Identity(1, 1), most, stops));
}

// One motor of 10 N for both: they press with 5 N each, on their stop as off it. What pushes them
// apart the stop bears.
TEST(Pressed, JawsAtTheirOpenStopPressAsFreeOnes) {
  EXPECT_NEAR(load(jaws(10, {}), 2), kMu * 10, kSolvedPress);
  EXPECT_NEAR(load(jaws(10, {0}), 2), kMu * 10, kSolvedPress);
  EXPECT_EQ(load(jaws(10, {0}), 0), kNoLimit);
}

// The same with coordinates of their own, which share the motor in halves.
TEST(Pressed, CoupledJawsAtTheirStopsPressAsFreeOnes) {
  EXPECT_NEAR(load(pinched(motors(Vector2d(0.5, 0.5), 10, {})), 2), kMu * 10, kSolvedPress);
  EXPECT_NEAR(load(pinched(motors(Vector2d(0.5, 0.5), 10, {0, 1})), 2), kMu * 10, kSolvedPress);
}

// Two stopped fingers with a motor each do not add what the stop of the other pushes back.
TEST(Pressed, FingersAtTheirStopsDoNotPushEachOtherBack) {
  EXPECT_NEAR(load(pinched(motors(Eigen::Matrix2d::Identity(), 6, {0, 1})), 2), kMu * 12,
              kSolvedPress);
}

// Without effort there is the frictionless line between them, and nothing else.
TEST(Pressed, StopsBearAlongTheirLineAloneWithoutEffort) {
  const ForceSet still = jaws(0, {0});
  EXPECT_EQ(load(still, 0), kNoLimit);
  for (const int axis : {1, 2, 4, 5}) EXPECT_NEAR(load(still, axis), 0, kSolvedPress);
}

// A finger of 6 N opposes one on its stop whose motor does nothing, a lock, or a palm: each pushes
// back 6 N.
TEST(Pressed, StopsLocksAndPalmsPushBackAlike) {
  Actuation stopped = motors(Vector2d(6, 0), 1, {1});
  EXPECT_NEAR(load(pinched(stopped), 2), kMu * 12, kSolvedPress);
  EXPECT_EQ(load(pinched(stopped), 0, 1), kNoLimit);
  EXPECT_NEAR(load(pinched(stopped), 0, -1), 6, kSolvedPress);
  Actuation locked = motors(Vector2d(6, 0), 1, {});
  add_reaction(locked.reactions, Vector2d::UnitY(), -kNoLimit, kNoLimit);
  EXPECT_NEAR(load(pinched(locked), 2), kMu * 12, kSolvedPress);
  const MatrixXd palm = pinch_torques(kMu, 0).topRows(1);
  const Actuation one = motors(VectorXd::Constant(1, 6), 1, {});
  EXPECT_NEAR(load(hand_forces(pinch(kMu, 0), palm, one), 2), kMu * 12, kSolvedPress);
}

// The stop at the other end pushes the other way, and helps nobody.
TEST(Pressed, StopThatAContactLiftsOffBearsNothing) {
  Actuation closed = motors(Vector2d(6, 0), 1, {});
  add_reaction(closed.reactions, -Vector2d::UnitY(), 0, kNoLimit);
  EXPECT_NEAR(load(pinched(closed), 0, 1), 0, kSolvedPress);
  EXPECT_NEAR(load(pinched(closed), 2), 0, kSolvedPress);
}

// Between two facets of a palm a ball rests along their line, and nothing squeezes it.
TEST(Pressed, PalmAloneSqueezesNothing) {
  const ForceSet wedged =
      hand_forces(pinch(kMu, 0), MatrixXd::Zero(1, 6), motors(MatrixXd::Identity(1, 1), 6, {}));
  EXPECT_EQ(load(wedged, 0), kNoLimit);
  EXPECT_NEAR(load(wedged, 2), 0, kSolvedPress);
}

// A jaw alone squeezes nothing. It bears what pushes its face, up to its motor's effort, although
// rounding turns its normal by 1e-8 from the push.
TEST(Pressed, LoneJawBearsAlongItsNormalAsTurnedByRounding) {
  for (const double turn : {0.0, 1e-8, -1e-8}) {
    const WrenchSet touched = wrench_set(
        {{{-kRadius, 0, 0}, Vector3d(1, turn, 0).normalized(), kMu, 0}}, {0, 0, 0}, kScale);
    const ForceSet lone = hand_forces(touched, Eigen::RowVector3d(-1, turn, 0),
                                      motors(MatrixXd::Identity(1, 1), 160, {}));
    EXPECT_NEAR(load(lone, 0, -1), 160, 160 * kSolvedPress) << turn;
    EXPECT_NEAR(load(lone, 0, 1), 0, kSolvedPress) << turn;
    EXPECT_NEAR(load(lone, 1), 0, kSolvedPress) << turn;
  }
}

// A worm on its stop presses as off it.
TEST(Pressed, WormAtItsStopPressesByItsMotorAlone) {
  for (const bool stop : {false, true}) {
    Actuation worms = motors(Eigen::Matrix2d::Identity(), 6, {});
    if (stop) worms = motors(Eigen::Matrix2d::Identity(), 6, {0, 1});
    worms.reactions.non_backdrivable = {0, 1};
    EXPECT_NEAR(load(pinched(worms), 2), kMu * 12, kSolvedPress) << stop;
    EXPECT_EQ(load(pinched(worms), 0), kNoLimit) << stop;
    EXPECT_NEAR(load(active_only(pinched(worms)), 0), 6, kSolvedPress) << stop;
  }
}

/// A digit with joints 50 mm apart presses things against walls across from it, 30 mm from each
/// joint; the knuckle is on its open stop, the motors have 0.3 N m and `knuckle` times as much.
double friction_of_digit(double knuckle, bool proximal, bool distal) {
  std::vector<Contact> contacts;
  MatrixXd T(2, 0);
  const auto press = [&](double x, const Vector2d& levers) {
    contacts.push_back({{x, 0, 0}, {0, 1, 0}, kMu, 0});
    contacts.push_back({{x, 0.02, 0}, {0, -1, 0}, kMu, 0});
    T.conservativeResize(2, T.cols() + 6);
    T.rightCols(6).setZero();
    T.col(T.cols() - 6) = levers;
  };
  if (proximal) press(0.03, {0.03, 0});
  if (distal) press(0.08, {0.08, 0.03});
  const Actuation actuation = motors(Vector2d(0.3 * knuckle, 0.3).asDiagonal(), 1, {0});
  return support_along(hand_forces(wrench_set(contacts, {0, 0, 0}, 1), T, actuation),
                       MatrixXd::Identity(3, 6), Vector3d::Zero(), Vector3d::UnitZ())
      .value;
}

// The outer joint presses 10 N, which the stop of the knuckle bears; the knuckle 10 N more on the
// phalanx that only it moves, and none without its motor: the stop is not lent.
TEST(Pressed, StopOfAKnuckleBearsTheOuterPhalanxButPressesNotTheInnerOne) {
  EXPECT_NEAR(friction_of_digit(1, false, true), kMu * 20, kSolvedPress);
  EXPECT_NEAR(friction_of_digit(0, false, true), kMu * 20, kSolvedPress);
  EXPECT_NEAR(friction_of_digit(1, true, false), kMu * 20, kSolvedPress);
  EXPECT_NEAR(friction_of_digit(1, true, true), kMu * 40, kSolvedPress);
  EXPECT_NEAR(friction_of_digit(0, true, true), kMu * 20, kSolvedPress);
}

// Jaws of 10 N at 60 degrees to their normals press a ball against a palm. Friction of 1 could
// carry any force along the bars; the motor makes normal forces of 10 / sin 60 degrees in sum, a
// and a. Across, a ball that must not turn asks 2 a sin 60 degrees of the palm, which is what it
// bears.
TEST(Pressed, RoughContactsDoNotJamWithoutLimit) {
  const double c = 0.5, s = std::sqrt(0.75);
  const std::vector<Contact> contacts{{{-c, s, 0}, {c, -s, 0}, 1, 0},
                                      {{c, s, 0}, {-c, -s, 0}, 1, 0},
                                      {{0, -1, 0}, {0, 1, 0}, 1, 0}};
  MatrixXd T = MatrixXd::Zero(1, 9);
  for (const int i : {0, 1}) {
    const Tangents t = tangents(contacts[i].n);
    const Vector3d way((i == 0 ? 1 : -1), 0, 0);
    T.middleCols(3L * i, 3) << way.dot(contacts[i].n), way.dot(t.e1), way.dot(t.e2);
  }
  const WrenchSet set = wrench_set(contacts, {0, 0, 0}, 1);
  const Actuation motor = motors(MatrixXd::Identity(1, 1), 10, {});
  EXPECT_NEAR(load(hand_forces(set, T, motor), 2), 10 / s + 10, kSolvedPress);
}

// Two contacts of one slide that oppose each other are one body: its motor moves both, and holds
// nothing between them.
TEST(Pressed, ForkSqueezesNothing) {
  MatrixXd T = pinch_torques(kMu, 0).topRows(1);
  T(0, 3) = -1;
  const Actuation motor = motors(MatrixXd::Identity(1, 1), 10, {});
  EXPECT_NEAR(load(hand_forces(pinch(kMu, 0), T, motor), 2), 0, kSolvedPress);
}

/// The pinch of two flexors, with a joint each that moves it along z, and `noise` along the normal.
ForceSet with_sideways(double flexors, double sideways, bool stopped, double noise = 0) {
  MatrixXd T = MatrixXd::Zero(4, 6);
  T.topRows(2) = pinch_torques(kMu, 0);
  for (const int i : {0, 1}) {
    const Tangents t = tangents(pinch_contacts(kMu, 0)[static_cast<std::size_t>(i)].n);
    T.row(2 + i).segment(3L * i, 3) << noise, kMu * t.e1.z(), kMu * t.e2.z();
  }
  Actuation actuation = motors(MatrixXd::Identity(4, 4), 1, {});
  actuation.upper << flexors, flexors, sideways, sideways;
  actuation.lower = -actuation.upper;
  for (const int j : {0, 1})
    if (stopped) add_reaction(actuation.reactions, VectorXd::Unit(4, j), 0, kNoLimit);
  return hand_forces(pinch(kMu, 0), T, actuation);
}

// What moves a contact along its face alone presses nothing, whatever its effort, and takes nothing
// from what flexors press.
TEST(Pressed, SidewaysJointsNeitherPressNorHinder) {
  for (const bool stopped : {false, true})
    for (const double sideways : {0.0, 0.1, 50.0})
      for (const double noise : {0.0, 1e-18, -1e-18}) {
        EXPECT_NEAR(load(with_sideways(6, sideways, stopped, noise), 1), kMu * 12, kSolvedPress);
        EXPECT_NEAR(load(with_sideways(0, sideways, stopped, noise), 1), 0, kSolvedPress);
      }
}

// Jaws of 10 N on an arm: it moves both alike, so that its effort squeezes nothing, and lack of it
// hinders no squeeze.
TEST(Pressed, ArmsNeitherPressNorHinder) {
  MatrixXd T(2, 6);
  T << 1, 0, 0, 1, 0, 0, 1, 0, 0, -1, 0, 0;
  for (const double arm : {0.0, 50.0})
    for (const double jaw : {0.0, 10.0})
      for (const std::vector<int>& stops : {std::vector<int>{}, std::vector<int>{0}}) {
        Actuation actuation = motors(MatrixXd::Identity(2, 2), 1, stops);
        actuation.upper = Vector2d(jaw, arm);
        actuation.lower = -actuation.upper;
        EXPECT_NEAR(load(hand_forces(pinch(kMu, 0), T, actuation), 2), kMu * jaw, kSolvedPress);
      }
}

// A spring of 2 N holds a jaw on its stop: a motor of 6 N has 4 N left for pressing, one of 1 N
// none. No force at all is in the set, whatever the motor.
TEST(Pressed, SpringsTowardsAStopAreOvercomeFirst) {
  for (const double most : {6.0, 1.0}) {
    Actuation sprung = motors(Eigen::Matrix2d::Identity(), most, {0, 1});
    sprung.tau_0.setConstant(-2);
    EXPECT_NEAR(load(pinched(sprung), 2), kMu * 2 * std::max(0.0, most - 2), kSolvedPress) << most;
  }
}

// A third finger whose spring is stronger than its motor rests, and leaves the others alone.
TEST(Pressed, SpringOfOneFingerStopsNoOther) {
  std::vector<Contact> contacts = pinch_contacts(kMu, 0);
  contacts.push_back({{0, -kRadius, 0}, {0, 1, 0}, kMu, 0});
  MatrixXd T = MatrixXd::Zero(3, 9);
  for (const int i : {0, 1, 2}) T(i, 3L * i) = 1;
  for (const double third : {2.01, 1.99}) {
    Actuation sprung = motors(MatrixXd::Identity(3, 3), 6, {0, 1, 2});
    sprung.upper(2) = third;
    sprung.tau_0.setConstant(-2);
    const ForceSet forces = hand_forces(wrench_set(contacts, {0, 0, 0}, kScale), T, sprung);
    for (const int axis : {1, 2}) EXPECT_NEAR(load(forces, axis), kMu * 8, kSolvedPress) << third;
  }
}

/// Frictionless contacts beside the middles of the faces of a cube, twisted so that it cannot move.
std::vector<Contact> cage() {
  std::vector<Contact> contacts;
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-1.0, 1.0})
      for (const double beside : {-0.5, 0.5}) {
        const Vector3d n = -side * Vector3d::Unit(axis);
        contacts.push_back({-n + beside * Vector3d::Unit((axis + 1) % 3), n, 0, 0});
      }
  return contacts;
}

// Form closure in a palm bears whatever comes: that is told, and is no number of the search.
TEST(Pressed, CageOfAPalmHasNoLimitAndSaysSo) {
  const ForceSet caged = hand_forces(wrench_set(cage(), {0, 0, 0}, 1), MatrixXd::Zero(1, 12),
                                     motors(MatrixXd::Identity(1, 1), 6, {}));
  const InscribedBall ball = inscribed_ball(caged);
  EXPECT_EQ(ball.status, Status::kUnbounded);
  EXPECT_EQ(ball.lower, kNoLimit);
  EXPECT_EQ(margin_of_ellipsoid(caged, Eigen::Matrix<double, 6, 2>::Identity()).lower, kNoLimit);
}

/// What a grasp of random contacts on joints with random stops, locks and worms squeezes most.
double most_squeeze(std::mt19937& rng, double effort) {
  const auto number = [&] { return 2.0 * rng() / std::mt19937::max() - 1; };
  constexpr int kContacts = 4, kJoints = 3;
  std::vector<Contact> contacts;
  for (int i = 0; i < kContacts; ++i) {
    const Vector3d p = Vector3d::NullaryExpr(number);
    contacts.push_back({p, -p.normalized(), std::abs(number()), 0});
  }
  MatrixXd T = MatrixXd::NullaryExpr(kJoints, 3L * kContacts, number);
  for (int i = 0; i < kContacts; ++i)
    for (int j = 0; j < kJoints; ++j)
      if (number() > 0) T.row(j).segment(3L * i, 3).setZero();
  Actuation actuation = motors(MatrixXd::Identity(kJoints, kJoints), effort, {});
  for (int j = 0; j < kJoints; ++j) {
    const double kind = number();
    if (kind < 0) add_reaction(actuation.reactions, VectorXd::Unit(kJoints, j), 0, kNoLimit);
    if (kind < -0.7) add_reaction(actuation.reactions, -VectorXd::Unit(kJoints, j), 0, kNoLimit);
    if (kind > 0.7 || std::abs(kind) < 0.1) actuation.reactions.non_backdrivable.push_back(j);
  }
  const ForceSet forces = hand_forces(wrench_set(contacts, {0, 0, 0}, 1), T, actuation);
  ConeProgram program{
      VectorXd::Zero(forces.wrench.cols()), forces.A, forces.b, forces.G, forces.h, forces.cones};
  for (int i = 0; i < kContacts; ++i) program.c(3L * i) = -1;
  const ConeResult result = solve(program);
  EXPECT_EQ(result.status, Status::kSolved);
  return -result.objective;
}

TEST(Pressed, NothingIsSqueezedWithoutEffort) {
  std::mt19937 rng(4);
  for (int trial = 0; trial < 200; ++trial)
    ASSERT_NEAR(most_squeeze(rng, 0), 0, kSolvedPress) << trial;
}

// Limits are linear in efforts.
TEST(Pressed, SqueezeGrowsAsEffortsDo) {
  for (unsigned seed = 0; seed < 100; ++seed) {
    std::mt19937 one(seed), three(seed);
    const double squeeze = most_squeeze(one, 1);
    ASSERT_LT(squeeze, 1e4) << seed;
    ASSERT_NEAR(most_squeeze(three, 3), 3 * squeeze, 1e-5 * (1 + squeeze)) << seed;
  }
}

}  // namespace
}  // namespace thenar
