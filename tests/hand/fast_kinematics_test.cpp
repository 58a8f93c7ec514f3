// Tests for tests/hand/fast_kinematics.cpp and the sine of base/simd.h.

#include "tests/hand/fast_kinematics.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/simd.h"
#include "tests/hand/sample_subjects.h"
#include "tests/matrix_near.h"

#pragma GCC diagnostic ignored "-Wpsabi"  // inlined functions have no calling convention

namespace thenar {
namespace {

void expect_equal_to_chain(const Skeleton& skeleton, const Eigen::VectorXd& q,
                           InstructionSet simd) {
  const FastHandPose hand = FastKinematics(skeleton, simd).pose(q);
  const TreeState<double> state = pose_tree(skeleton.tree, q);
  for (int i = 0; i < static_cast<int>(state.size()); ++i) {
    EXPECT_TRUE(matrix_near(hand.link(i).R, state[i].X.R, 1e-14));
    EXPECT_TRUE(matrix_near(hand.link(i).p, state[i].X.p, 1e-14));
  }
  for (int k = 0; k < static_cast<int>(skeleton.tips.size()); ++k) {
    const SkeletonTip& tip = skeleton.tips[k];
    const Eigen::Vector3d p = moved(state, tip.link, tip.p);
    EXPECT_TRUE(matrix_near(hand.tip(k), p, 1e-14));
    EXPECT_TRUE(matrix_near(
        hand.tip_jacobian(k),
        position_jacobian(skeleton.tree, state, tip.link, p, skeleton.coordinates()), 1e-14));
  }
}

TEST(FastKinematics, EqualsTheChain) {
  sample::Draw draw(61);
  for (const Subject& subject : {sample::random_hand(1, 1), sample::random_hand(2),
                                 sample::coupled_digit(), sample::two_link()}) {
    const Skeleton skeleton = build_skeleton(subject);
    for (int trial = 0; trial < 10; ++trial)
      for (const InstructionSet simd : {InstructionSet::kBest, InstructionSet::kBaseline})
        expect_equal_to_chain(skeleton, draw.posture(skeleton), simd);
  }
}

TEST(FastKinematics, GivesTheSameBitsOnEveryProcessor) {
  if (!__builtin_cpu_supports("avx2")) GTEST_SKIP() << "no AVX2 here";
  sample::Draw draw(62);
  const Skeleton skeleton = build_skeleton(sample::random_hand(3));
  const FastKinematics baseline(skeleton, InstructionSet::kBaseline),
      avx2(skeleton, InstructionSet::kAvx2);
  for (int trial = 0; trial < 100; ++trial) {
    const Eigen::VectorXd q = draw.posture(skeleton);
    const FastHandPose a = baseline.pose(q), b = avx2.pose(q);
    for (int i = 0; i < skeleton.coordinates(); ++i) EXPECT_EQ(a.link(i).R, b.link(i).R);
    for (int k = 0; k < 5; ++k) EXPECT_EQ(a.tip_jacobian(k), b.tip_jacobian(k));
  }
}

TEST(FastKinematics, TakesWeldedTips) {
  SkeletonOptions options;
  options.frozen = {{"J1", 0.3}, {"J2", 0.4}};
  const Skeleton skeleton = build_skeleton(sample::two_link(), options);
  const FastHandPose hand = FastKinematics(skeleton).pose(Eigen::VectorXd(0));
  EXPECT_EQ(hand.tip(0), skeleton.tips[0].p);
  EXPECT_EQ(hand.tip_jacobian(0).cols(), 0);
}

// Angles beyond the range of the fast sine are brought back; NaN stays NaN.
TEST(FastKinematics, TakesAnyAngle) {
  const Skeleton skeleton = build_skeleton(sample::two_link());
  for (const double q1 : {1e4, -1e5, 1e6, -1e9})
    expect_equal_to_chain(skeleton, Eigen::Vector2d(q1, 0.5), InstructionSet::kBest);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(FastKinematics(skeleton).pose(Eigen::Vector2d(nan, 0)).tip(0).hasNaN());
}

TEST(FastKinematics, SaysWhatItCannotHold) {
  Subject subject = sample::two_link();
  for (int i = 0; i < 31; ++i) {
    subject.joints.push_back(subject.joints[1]);
    subject.joints.back().name = fmt::format("extra {}", i);
  }
  try {
    (void)FastKinematics{build_skeleton(subject)};
    FAIL() << "expected InputError";
  } catch (const InputError& e) {
    EXPECT_STREQ(e.what(), "at most 32 hinges here, the skeleton has 33");
  }
  const FastKinematics two(build_skeleton(sample::two_link()));
  EXPECT_THROW((void)two.pose(Eigen::Vector3d(0, 0, 0)), InputError);
}

TEST(SinCos, IsRightToTheLastBits) {
  sample::Draw draw(63);
  for (const double bound : {0.1, 4.0, 1e3, internal::kSinCosBound})
    for (int trial = 0; trial < 20000; ++trial) {
      alignas(32) double a[4], s[4], c[4];
      for (double& angle : a) angle = draw.number(-bound, bound);
      const auto sc = internal::sin_cos(internal::load<internal::Double4>(a));
      internal::store(s, sc.sine);
      internal::store(c, sc.cosine);
      for (int k = 0; k < 4; ++k) {
        ASSERT_NEAR(s[k], std::sin(a[k]), 2.3e-16) << a[k];
        ASSERT_NEAR(c[k], std::cos(a[k]), 2.3e-16) << a[k];
      }
    }
}

}  // namespace
}  // namespace thenar
