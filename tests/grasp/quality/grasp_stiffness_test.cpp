// Tests for grasp/quality/grasp_stiffness.cpp and manipulability.cpp.

#include "grasp/quality/grasp_stiffness.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "base/error.h"
#include "grasp/quality/manipulability.h"
#include "tests/grasp/quality/pinch.h"
#include "tests/matrix_near.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

constexpr double kRigid = std::numeric_limits<double>::infinity();
constexpr double kExactStiffness = 1e-9;  // of stiffnesses of order 1000 N/m
const std::vector<PadStiffness> kPads(2, {2000, 1000, 0.3});

GraspStiffness stiffness(const std::vector<PadStiffness>& pads,
                         const std::optional<JointStiffness>& joints = {}) {
  return grasp_stiffness(pinch_contacts(0.5, 0.001), {0, 0, 0}, kScale, pads, joints);
}

// Along the pinch both pads press, across it both shear; turns about y and z shear them at the
// radius, those about x twist them. All by two, turns divided by the scale squared.
TEST(GraspStiffness, OfAPinchIsDiagonal) {
  const double turn = 2 * 1000 * std::pow(kRadius / kScale, 2);
  const double twist = 2 * 0.3 / (kScale * kScale);
  const WrenchCoordinates diagonal =
      (WrenchCoordinates() << 4000, 2000, 2000, twist, turn, turn).finished();
  const GraspStiffness found = stiffness(kPads);
  EXPECT_TRUE(matrix_near(found.K, Eigen::MatrixXd(diagonal.asDiagonal()), kExactStiffness));
  EXPECT_NEAR(found.min_eigenvalue, twist, kExactStiffness);
  EXPECT_NEAR(std::abs(found.softest.rotation_times_length.x()), 1, kExactStiffness);
}

// Springs in series: a joint of k at a lever of l yields like a pad of k / l^2.
TEST(GraspStiffness, JointsAreInSeriesWithPads) {
  JointStiffness joints{Eigen::MatrixXd::Zero(8, 2), Eigen::Vector2d(0.8, 0.8)};
  joints.J(0, 0) = joints.J(4, 1) = 0.04;
  const double series = 1 / (1 / 2000.0 + 0.04 * 0.04 / 0.8);
  EXPECT_NEAR(stiffness(kPads, joints).K(0, 0), 2 * series, kExactStiffness);
  joints.k.setConstant(kRigid);
  EXPECT_NEAR(stiffness(kPads, joints).K(0, 0), 4000, kExactStiffness);
}

TEST(GraspStiffness, IsZeroWithoutContactsAndAlongWhatNoPadResists) {
  EXPECT_TRUE(grasp_stiffness({}, {0, 0, 0}, kScale, {}).K.isZero(0));
  const GraspStiffness hard = stiffness({2, {2000, 1000, 0}});
  EXPECT_NEAR(hard.min_eigenvalue, 0, kExactStiffness);
  EXPECT_NEAR(std::abs(hard.softest.rotation_times_length.x()), 1, kExactStiffness);
}

TEST(GraspStiffness, RefusesRigidPadsOnRigidFingers) {
  EXPECT_EQ(message_of([] {
              (void)stiffness({2, {kRigid, 1000, 1}});
            }),
            "a rigid pad has no joint behind it that yields");
}

TEST(Manipulability, IsTheProductOfSingularValues) {
  Eigen::Matrix<double, 2, 3> M;
  M << 3, 0, 0, 0, 4, 0;
  const Manipulability found = manipulability(M);
  EXPECT_NEAR(found.volume, 12, kExactStiffness);
  EXPECT_NEAR(found.min_singular_value, 3, kExactStiffness);
  EXPECT_NEAR(found.isotropy, 0.75, kExactStiffness);
  EXPECT_EQ(found.rank, 2);
}

// Yoshikawa's two-link arm: |l1 l2 sin q2|, zero when straight.
TEST(Manipulability, IsZeroForAStraightArm) {
  const auto arm = [](double bend) {
    const double a = 0.3, b = 0.2;
    return (Eigen::Matrix2d() << -b * std::sin(bend), -b * std::sin(bend), a + b * std::cos(bend),
            b * std::cos(bend))
        .finished();
  };
  EXPECT_NEAR(manipulability(arm(0.7)).volume, 0.3 * 0.2 * std::sin(0.7), kExactStiffness);
  EXPECT_NEAR(manipulability(arm(0)).volume, 0, kExactStiffness);
  EXPECT_EQ(manipulability(arm(0)).rank, 1);
}

TEST(Manipulability, OfNothingOrTooFewJointsIsZero) {
  EXPECT_EQ(manipulability(Eigen::MatrixXd(6, 0)).volume, 0);
  EXPECT_EQ(manipulability(Eigen::MatrixXd::Identity(6, 3)).volume, 0);
}

// Fingers that move alike carry the object along: nu = q_dot.
TEST(Manipulability, FingersCarryTheObjectAlong) {
  const std::vector<Contact> contacts = pinch_contacts(1, kScale);
  const WrenchSet set = wrench_set(contacts, {0, 0, 0}, kScale);
  Eigen::Matrix<double, 6, Eigen::Dynamic> G(6, 8);
  for (Eigen::Index i = 0; i < 2; ++i) {
    const WrenchCap& cap = set.caps[static_cast<std::size_t>(i)];
    G.middleCols(4 * i, 4) << cap.c.vector(), cap.A;
  }
  const Eigen::MatrixXd J = G.transpose();  // both fingers move as one body of six coordinates
  EXPECT_TRUE(
      matrix_near(hand_object_jacobian(G, J), Eigen::MatrixXd::Identity(6, 6), kExactStiffness));
}

}  // namespace
}  // namespace thenar
