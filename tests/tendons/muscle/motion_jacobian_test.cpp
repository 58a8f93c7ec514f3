// Tests for tendons/muscle/motion_jacobian.cpp and the slopes that it is made of.

#include <gtest/gtest.h>

#include "tendons/muscle/finger_motion.h"
#include "tendons/net/build_tendons.h"
#include "tests/matrix_near.h"
#include "tests/tendons/muscle/moving_samples.h"

namespace thenar {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

class EverySlope : public testing::TestWithParam<Muscle> {
 protected:
  /// Central differences of all rates, in parts of each state's scale.
  static MatrixXd differences(FingerMotion& motion, const MotionState& state, const VectorXd& e,
                              double part) {
    const VectorXd y = motion.pack(state), scale = motion.scale();
    MatrixXd J(y.size(), y.size());
    for (Index j = 0; j < y.size(); ++j) {
      const VectorXd step = part * scale[j] * VectorXd::Unit(y.size(), j);
      J.col(j) = (motion.pack(motion.slope(motion.unpack(y + step), e)) -
                  motion.pack(motion.slope(motion.unpack(y - step), e))) /
                 (2 * part * scale[j]);
    }
    return J;
  }

  /// Largest difference of an entry over what its row can do with states of their scale.
  static double mismatch(FingerMotion& motion, const MotionState& state, const VectorXd& e) {
    const VectorXd scale = motion.scale();
    const MatrixXd J = motion.jacobian(state, e) * scale.asDiagonal();
    const MatrixXd D = differences(motion, state, e, 1e-5) * scale.asDiagonal();
    const VectorXd rows = D.cwiseAbs().rowwise().maxCoeff().cwiseMax(1e-9);
    return (rows.cwiseInverse().asDiagonal() * (J - D)).cwiseAbs().maxCoeff();
  }

  static MotionState moving(FingerMotion& motion) {
    const VectorXd q = Eigen::Vector4d(0.5, 0.1, 0.7, 0.4);
    const VectorXd q_dot = Eigen::Vector4d(1, -0.5, 2, 1.5);
    MotionState state = motion.start(q, q_dot, VectorXd::LinSpaced(7, 0.1, 0.4)).state;
    state.reach *= 0.995;
    return state;
  }
};

TEST_P(EverySlope, IsThatOfSeparateTendons) {
  const sample::Mover mover(sample::index_finger(), GetParam());
  FingerMotion motion(mover.model());
  EXPECT_LT(mismatch(motion, moving(motion), VectorXd::Constant(7, 0.27)), 1e-4);
}

TEST_P(EverySlope, IsThatOfANet) {
  const Subject subject = sample::index_finger();
  TendonOptions rungs;
  rungs.hood = Hood::kFloatingNet;
  const auto tendons =
      build_net_tendons(subject, "index", rungs, read_net(THENAR_DATA_DIR "/nets/chao_an.toml"));
  const auto contraction =
      build_contraction(musculotendons(subject, tendons->digit(), GetParam()), GetParam());
  FingerMotion motion({*tendons, *contraction});
  MotionState state = moving(motion);
  (void)motion.accept(state);
  EXPECT_LT(mismatch(motion, state, VectorXd::Constant(7, 0.27)), 1e-3);
}

INSTANTIATE_TEST_SUITE_P(Muscles, EverySlope,
                         testing::Values(Muscle::kBounds, Muscle::kRigidTendon,
                                         Muscle::kElasticTendon));

}  // namespace
}  // namespace thenar
