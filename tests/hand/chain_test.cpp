// Tests for hand/chain.h.

#include "hand/chain.h"

#include <gtest/gtest.h>
#include <Eigen/SVD>

#include "tests/hand/sample_subjects.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

using sample::kLowerLength;
using sample::kUpperLength;

struct PosedTip {
  TreeState<double> state;
  Eigen::Vector3d p;   // where the tip is [m]
  Eigen::Matrix3Xd J;  // [m/rad]
  Eigen::Matrix3Xd W;  // [1]
};

PosedTip pose_tip(const Skeleton& skeleton, const SkeletonTip& tip, const Eigen::VectorXd& q) {
  const TreeState<double> state = pose_tree(skeleton.tree, q);
  const Eigen::Vector3d p = moved(state, tip.link, tip.p);
  return {state, p, position_jacobian(skeleton.tree, state, tip.link, p, skeleton.coordinates()),
          rotation_jacobian(skeleton.tree, state, tip.link, skeleton.coordinates())};
}

// Textbook: x = l1 c1 + l2 c12,  y = l1 s1 + l2 s12.
TEST(Chain, MatchesPlanarTwoLinkDigit) {
  const Skeleton skeleton = build_skeleton(sample::two_link());
  for (const double q1 : {-0.7, 0.0, 1.1})
    for (const double q2 : {-0.2, 0.4, 2.0}) {
      const PosedTip posed = pose_tip(skeleton, skeleton.tips[0], Eigen::Vector2d(q1, q2));
      const double c1 = std::cos(q1), s1 = std::sin(q1);
      const double c12 = std::cos(q1 + q2), s12 = std::sin(q1 + q2);
      const Eigen::Vector3d p(kUpperLength * c1 + kLowerLength * c12,
                              kUpperLength * s1 + kLowerLength * s12, 0);
      Eigen::Matrix<double, 3, 2> J;
      J << -p.y(), -kLowerLength * s12, p.x(), kLowerLength * c12, 0, 0;
      EXPECT_TRUE(matrix_near(posed.p, p, 1e-16));
      EXPECT_TRUE(matrix_near(posed.J, J, 1e-16));
      EXPECT_TRUE(matrix_near(posed.W.row(2), Eigen::RowVector2d(1, 1), 1e-16));
    }
}

// A rank-1 Jacobian: only forces across the finger move its joints; nothing becomes NaN.
TEST(Chain, StraightFingerLosesOneRank) {
  const Skeleton skeleton = build_skeleton(sample::two_link());
  const PosedTip posed = pose_tip(skeleton, skeleton.tips[0], Eigen::Vector2d(0.3, 0.0));
  ASSERT_TRUE(posed.J.allFinite());
  Eigen::JacobiSVD<Eigen::MatrixXd> svd(posed.J);
  svd.setThreshold(1e-12);
  EXPECT_EQ(svd.rank(), 1);
  EXPECT_LT(svd.singularValues()[1], 1e-15);
}

TEST(Chain, ParallelAxesTurnTheTipAlike) {
  const Skeleton skeleton = build_skeleton(sample::two_link());
  const PosedTip posed = pose_tip(skeleton, skeleton.tips[0], Eigen::Vector2d(0.3, -0.9));
  EXPECT_TRUE(matrix_near(posed.W.col(0), posed.W.col(1), 1e-16));
}

// Two hinges on one line act as one that turns by the sum.
TEST(Chain, CoincidentAxesAdd) {
  Subject subject = sample::two_link();
  subject.joints[1].point = subject.joints[0].point;
  const Skeleton skeleton = build_skeleton(subject);
  const SkeletonTip& tip = skeleton.tips[0];
  const PosedTip a = pose_tip(skeleton, tip, Eigen::Vector2d(0.3, 0.5));
  const PosedTip b = pose_tip(skeleton, tip, Eigen::Vector2d(0.8, 0.0));
  EXPECT_TRUE(matrix_near(a.p, b.p, 1e-16));
}

TEST(Chain, JacobianMatchesFiniteDifferences) {
  sample::Draw draw(11);
  const double h = 1e-6;  // [rad]; truncation and rounding both leave about 1e-11
  for (unsigned seed = 1; seed <= 3; ++seed) {
    const Skeleton skeleton = build_skeleton(sample::random_hand(seed));
    const Eigen::VectorXd q = draw.posture(skeleton);
    for (const SkeletonTip& tip : skeleton.tips) {
      const PosedTip at = pose_tip(skeleton, tip, q);
      for (Eigen::Index i = 0; i < q.size(); ++i) {
        const Eigen::VectorXd step = h * Eigen::VectorXd::Unit(q.size(), i);
        const PosedTip plus = pose_tip(skeleton, tip, q + step);
        const PosedTip minus = pose_tip(skeleton, tip, q - step);
        EXPECT_TRUE(matrix_near(at.J.col(i), (plus.p - minus.p) / (2 * h), 1e-9));

        // [omega] = dR/dq R'.
        const Eigen::Matrix3d spin = (plus.state[tip.link].X.R - minus.state[tip.link].X.R) /
                                     (2 * h) * at.state[tip.link].X.R.transpose();
        const Eigen::Vector3d omega(spin(2, 1), spin(0, 2), spin(1, 0));
        EXPECT_TRUE(matrix_near(at.W.col(i), omega, 1e-9));
      }
    }
  }
}

// Virtual work: f' (J q_dot) = (J' f)' q_dot, with the velocity from a finite difference.
TEST(Chain, PowerInIsPowerOut) {
  sample::Draw draw(12);
  const Skeleton skeleton = build_skeleton(sample::random_hand(4));
  const Eigen::VectorXd q = draw.posture(skeleton);
  const Eigen::VectorXd q_dot = draw.numbers(q.size(), -1, 1);
  const Eigen::Vector3d f = draw.vector(10);  // [N]
  const double h = 1e-6;                      // [s]
  for (const SkeletonTip& tip : skeleton.tips) {
    const Eigen::VectorXd tau = pose_tip(skeleton, tip, q).J.transpose() * f;
    const Eigen::Vector3d velocity =
        (pose_tip(skeleton, tip, q + h * q_dot).p - pose_tip(skeleton, tip, q - h * q_dot).p) /
        (2 * h);
    EXPECT_NEAR(tau.dot(q_dot), f.dot(velocity), 1e-8);  // [W]
  }
}

TEST(Chain, PointMaySlideAlongItsAxis) {
  sample::Draw draw(13);
  const Skeleton skeleton = build_skeleton(sample::random_hand(5));
  Skeleton slid = skeleton;
  for (Hinge<double>& hinge : slid.tree) hinge.point += draw.number(-0.05, 0.05) * hinge.direction;
  const Eigen::VectorXd q = draw.posture(skeleton);
  for (const SkeletonTip& tip : skeleton.tips) {
    const PosedTip a = pose_tip(skeleton, tip, q), b = pose_tip(slid, tip, q);
    EXPECT_TRUE(matrix_near(a.p, b.p, 1e-15));
    EXPECT_TRUE(matrix_near(a.J, b.J, 1e-15));
  }
}

TEST(Chain, ReversedAxisTurnsTheOtherWay) {
  sample::Draw draw(14);
  const Skeleton skeleton = build_skeleton(sample::random_hand(6));
  Skeleton reversed = skeleton;
  for (Hinge<double>& hinge : reversed.tree) hinge.direction = -hinge.direction;
  const Eigen::VectorXd q = draw.posture(skeleton);
  const SkeletonTip& tip = skeleton.tips[0];
  EXPECT_TRUE(matrix_near(pose_tip(skeleton, tip, q).p, pose_tip(reversed, tip, -q).p, 1e-15));
}

TEST(Chain, BaseDoesNotMove) {
  const Skeleton skeleton = build_skeleton(sample::two_link());
  const TreeState<double> state = pose_tree(skeleton.tree, Eigen::Vector2d(1, 1));
  const Eigen::Vector3d p(1, 2, 3);
  EXPECT_EQ(moved(state, -1, p), p);
  EXPECT_TRUE(spatial_jacobian(skeleton.tree, state, -1, p, 2).isZero(0));
}

}  // namespace
}  // namespace thenar
