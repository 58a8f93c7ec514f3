#pragma once

/// The chain and the multibody of one skeleton must agree.

#include <gtest/gtest.h>

#include "hand/multibody.h"
#include "hand/statics.h"
#include "tests/hand/sample_subjects.h"
#include "tests/matrix_near.h"

namespace thenar {

inline constexpr double kSameMachines = 1e-10;  // of poses [m, 1], Jacobians and torques [N m]

/// Poses, Jacobians and static torques at random postures within the limits.
inline void expect_same_machines(const Skeleton& skeleton) {
  sample::Draw draw(99);
  Multibody body(skeleton);
  const int links = static_cast<int>(skeleton.tree.size());
  for (int trial = 0; trial < 5; ++trial) {
    const Eigen::VectorXd q = draw.posture(skeleton);
    const TreeState<double> state = pose_tree(skeleton.tree, q);
    const std::vector<Pose<double>> poses = body.pose(q);
    ASSERT_EQ(poses.size(), state.size());
    Loads loads{draw.vector(9.81), {}};
    for (int i = 0; i < links; ++i) {
      EXPECT_TRUE(matrix_near(poses[i].R, state[i].X.R, kSameMachines));
      EXPECT_TRUE(matrix_near(poses[i].p, state[i].X.p, kSameMachines));
      const Eigen::Vector3d p = draw.vector(0.1);
      EXPECT_TRUE(matrix_near(
          body.jacobian(q, i, p),
          spatial_jacobian(skeleton.tree, state, i, moved(state, i, p), skeleton.coordinates()),
          kSameMachines));
      loads.forces.push_back({i, p, draw.vector(20)});
    }
    EXPECT_TRUE(
        matrix_near(body.load_torque(q, loads), load_torque(skeleton, q, loads), kSameMachines));
  }
}

}  // namespace thenar
