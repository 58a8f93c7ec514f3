// Tests for grasp/limits/wrench_support.cpp and the force sets it asks.

#include "grasp/limits/wrench_support.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "base/error.h"
#include "grasp/limits/grasp_force.h"
#include "tests/grasp/quality/pinch.h"
#include "tests/matrix_near.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

constexpr double kSolvedLoad = 1e-8;  // of forces of order 10 N
constexpr double kNoForceLimit = std::numeric_limits<double>::infinity();

WrenchSet random_friction_set(std::mt19937& rng, int contacts) {
  const auto number = [&] { return 2.0 * rng() / std::mt19937::max() - 1; };
  std::vector<Contact> result;
  for (int i = 0; i < contacts; ++i) {
    const Eigen::Vector3d p = Eigen::Vector3d::NullaryExpr(number);
    result.push_back({p, Eigen::Vector3d::NullaryExpr(number).normalized(), std::abs(number()),
                      i % 2 ? std::abs(number()) : 0});
  }
  return wrench_set(result, {0, 0, 0}, 1);
}

// The support of unit forces is known without a programme: support(), or 0 where that is less.
TEST(Withstood, SupportOfUnitForcesIsThatOfTheCaps) {
  std::mt19937 rng(2);
  for (int trial = 0; trial < 100; ++trial) {
    const WrenchSet set = random_friction_set(rng, 1 + trial % 6);
    const ScaledWrench u = ScaledWrench::from_coordinates(
        WrenchCoordinates::NullaryExpr([&] { return 2.0 * rng() / std::mt19937::max() - 1; }));
    for (const ForceNorm limit : {ForceNorm::kL1, ForceNorm::kLinf}) {
      const WrenchSupport reach = wrench_support(unit_forces(set, limit), u);
      ASSERT_EQ(reach.status, Status::kSolved);
      ASSERT_NEAR(reach.value, std::max(0.0, support(set, u, limit)), kSolvedLoad);
      ASSERT_NEAR(reach.wrench.dot(u), reach.value, kSolvedLoad);
    }
  }
}

// Each finger presses 6 N at most: the pinch bears mu 12 N across.
TEST(Withstood, LoadAcrossAPinchIsBoundByItsMotors) {
  const ForceSet hand = hand_forces(pinch(0.5, 0), pinch_torques(0.5, 0), pinch_motors(0, 6));
  const WrenchSupport reach = load_margin(hand, ScaledWrench::unit(2));
  ASSERT_EQ(reach.status, Status::kSolved);
  EXPECT_NEAR(reach.value, 6, kSolvedLoad);
  EXPECT_TRUE(matrix_near(reach.wrench.vector(), -6 * WrenchCoordinates::Unit(2), kSolvedLoad));
}

// Along the line of the contacts one finger gives way first: at 6 N, the other one at 0.
TEST(Withstood, LoadAlongAPinchIsBoundByOneMotor) {
  const ForceSet hand = hand_forces(pinch(0.5, 0), pinch_torques(0.5, 0), pinch_motors(0, 6));
  EXPECT_NEAR(load_margin(hand, ScaledWrench::unit(0)).value, 6, kSolvedLoad);
}

// The centre of mass lies beside the line of two points, as rounding has it, or a ten-thousandth of
// the scale; farther off the object turns about the line.
TEST(Withstood, APinchBearsWhatItsLinePassesByNoMoreThanPlacesAreKnown) {
  for (const double off : {0.0, 1e-13, 1e-12, 1e-10, 1e-7, 1.9e-6, 1e-4}) {
    const WrenchSet set = wrench_set(pinch_contacts(0.5, 0), {0, off, 0}, kScale);
    const ForceSet hand = hand_forces(set, pinch_torques(0.5, 0), pinch_motors(0, 6));
    const WrenchSupport reach = load_margin(hand, ScaledWrench::unit(2));
    const GraspForce least =
        minimum_grasp_force(free_forces(set), ScaledWrench::unit(2), GraspForceObjective::kSum);
    if (off > 1e-4 * kScale) {
      EXPECT_TRUE(reach.status != Status::kSolved || reach.value < kSolvedLoad) << off;
      EXPECT_NE(least.status, Status::kSolved) << off;
      continue;
    }
    ASSERT_EQ(reach.status, Status::kSolved) << off;
    EXPECT_NEAR(reach.value, 6, 1e-6) << off;
    ASSERT_EQ(least.status, Status::kSolved) << off;
    EXPECT_NEAR(least.objective, 2, 1e-6) << off;
  }
}

// A passive torque of 2 N on each slide adds to what the motors press.
TEST(Withstood, CountsPassiveTorques) {
  Actuation motors = pinch_motors(0, 6);
  motors.tau_0.setConstant(2);
  const ForceSet hand = hand_forces(pinch(0.5, 0), pinch_torques(0.5, 0), motors);
  EXPECT_NEAR(load_margin(hand, ScaledWrench::unit(2)).value, 8, kSolvedLoad);
}

// One tendon that pulls both fingers shares its 10 N: 5 N each, and none can press more than the
// other, so that nothing is borne along the line of the contacts.
TEST(Withstood, OneTendonForTwoFingersBalancesThem) {
  const Actuation tendon{Eigen::Vector2d(0.5, 0.5), Eigen::Vector2d::Zero(),
                         Eigen::VectorXd::Zero(1), Eigen::VectorXd::Constant(1, 10)};
  const ForceSet hand = hand_forces(pinch(0.5, 0), pinch_torques(0.5, 0), tendon);
  EXPECT_NEAR(load_margin(hand, ScaledWrench::unit(2)).value, 5, kSolvedLoad);
  EXPECT_NEAR(load_margin(hand, ScaledWrench::unit(0)).value, 0, kSolvedLoad);
}

TEST(Withstood, IsWithoutLimitWhereActuatorsAre) {
  const ForceSet hand = hand_forces(pinch(0.5, 0), pinch_torques(0.5, 0),
                                    pinch_motors(-kNoForceLimit, kNoForceLimit));
  const WrenchSupport reach = load_margin(hand, ScaledWrench::unit(2));
  EXPECT_EQ(reach.status, Status::kUnbounded);
  EXPECT_EQ(reach.value, kNoForceLimit);
}

// Motors that must push apart at least 1 N cannot hold a finger on the ball.
TEST(Withstood, SaysWhereNoForceBalancesTheHand) {
  const ForceSet hand = hand_forces(pinch(0.5, 0), pinch_torques(0.5, 0), pinch_motors(-3, -1));
  const WrenchSupport reach = load_margin(hand, ScaledWrench::unit(2));
  EXPECT_EQ(reach.status, Status::kInfeasible);
  EXPECT_TRUE(std::isnan(reach.value));
}

// A joint that no contact force turns (a singular posture) asks nothing of the contacts.
TEST(Withstood, ToleratesAJointThatFeelsNothing) {
  Eigen::MatrixXd T = Eigen::MatrixXd::Zero(3, 6);
  T.topRows(2) = pinch_torques(0.5, 0);
  const Actuation motors{Eigen::Matrix3d::Identity(), Eigen::Vector3d::Zero(),
                         Eigen::Vector3d::Zero(), Eigen::Vector3d::Constant(6)};
  EXPECT_NEAR(load_margin(hand_forces(pinch(0.5, 0), T, motors), ScaledWrench::unit(2)).value, 6,
              kSolvedLoad);
}

TEST(Withstood, IsZeroWithoutContactsOrFriction) {
  EXPECT_EQ(load_margin(unit_forces({}, ForceNorm::kL1), ScaledWrench::unit(2)).value, 0);
  EXPECT_NEAR(load_margin(unit_forces(pinch(0, 0), ForceNorm::kL1), ScaledWrench::unit(2)).value, 0,
              kSolvedLoad);
}

TEST(Withstood, RefusesADirectionOfZero) {
  EXPECT_EQ(message_of([] {
              (void)load_margin(unit_forces(pinch(0.5, 0), ForceNorm::kL1), ScaledWrench{});
            }),
            "the direction must be finite and not zero, its norm is 0");
}

TEST(Withstood, RefusesLimitsTheWrongWayRound) {
  EXPECT_EQ(message_of([] {
              (void)hand_forces(pinch(0.5, 0), pinch_torques(0.5, 0), pinch_motors(1, -1));
            }),
            "actuator 0 has limits 1 and -1");
}

/// Two jaws that touch two faces of a box at random places, many at once, as found contacts do.
std::vector<Contact> jaws_on_box(std::mt19937& rng, int a_side) {
  const auto number = [&] { return 2.0 * rng() / std::mt19937::max() - 1; };
  const double half = 0.02 * (1.5 + number()), friction = 0.6 + 0.5 * number();
  std::vector<Contact> contacts;
  for (const double side : {-1.0, 1.0})
    for (int i = 0; i < a_side; ++i)
      contacts.push_back(
          {{side * half, 0.03 * number(), 0.01 * number()}, {-side, 0, 0}, friction});
  return contacts;
}

// One motor of 40 N that both jaws share in halves. Coplanar contacts leave forces undetermined:
// Newton steps lose digits there.
TEST(Withstood, JawsOnBoxesAlwaysHaveAnAnswer) {
  std::mt19937 rng(1);
  for (int trial = 0; trial < 100; ++trial) {
    const std::vector<Contact> contacts = jaws_on_box(rng, 4 + trial % 5);
    const WrenchSet set = wrench_set(contacts, {0, 0, 0}, 0.05);
    Eigen::MatrixXd T = Eigen::MatrixXd::Zero(2, 3 * static_cast<Eigen::Index>(contacts.size()));
    for (std::size_t i = 0; i < contacts.size(); ++i)
      T(contacts[i].p.x() > 0 ? 1 : 0, 3 * static_cast<Eigen::Index>(i)) = 1;
    const Actuation motor{Eigen::Vector2d(0.5, 0.5), Eigen::Vector2d::Zero(),
                          Eigen::VectorXd::Zero(1), Eigen::VectorXd::Constant(1, 40)};
    for (const int axis : {2, 5}) {
      const WrenchSupport reach = load_margin(hand_forces(set, T, motor), ScaledWrench::unit(axis));
      ASSERT_EQ(reach.status, Status::kSolved) << trial;
      ASSERT_LE(reach.residual, 1e-9) << trial;  // ten times what is asked for
    }
  }
}

/// The same jaws on worms, with contacts about the line between them, and the normals of one of
/// them a little off the other's.
ForceSet worm_jaws(const std::vector<Contact>& found, double tilt) {
  std::vector<Contact> contacts = found;
  for (Contact contact : found) {
    contact.p.tail<2>() *= -1;
    contacts.push_back(contact);
  }
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(tilt, Eigen::Vector3d::UnitZ()).matrix();
  Eigen::MatrixXd T = Eigen::MatrixXd::Zero(2, 3 * static_cast<Eigen::Index>(contacts.size()));
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const bool right = contacts[i].p.x() > 0;
    if (right) contacts[i].n = turn * contacts[i].n;
    T(right ? 1 : 0, 3 * static_cast<Eigen::Index>(i)) = 1;
  }
  Actuation motor{Eigen::Vector2d(0.5, 0.5), Eigen::Vector2d::Zero(), Eigen::VectorXd::Zero(1),
                  Eigen::VectorXd::Constant(1, 40)};
  motor.reactions.non_backdrivable = {0, 1};
  return hand_forces(wrench_set(contacts, {0, 0, 0}, 0.05), T, motor);
}

// Worms bear what is pressed along the jaws' line. Were the normals exactly parallel, nothing would
// limit it; 1e-8 rad apart friction of some 20 N does, by leverage: at 2e9 N.
TEST(Withstood, IsWithoutLimitWhereOnlyRoundingOfNormalsLimitsIt) {
  std::mt19937 rng(3);
  for (int trial = 0; trial < 10; ++trial) {
    const ForceSet jaws = worm_jaws(jaws_on_box(rng, 4 + trial % 5), 1e-8);
    const WrenchSupport reach = load_margin(jaws, ScaledWrench::unit(0));
    ASSERT_EQ(reach.status, Status::kUnbounded) << trial;
    ASSERT_EQ(reach.value, kNoForceLimit) << trial;
  }
}

}  // namespace
}  // namespace thenar
