#pragma once

/// What every Hand must obey, human or robot.

#include <gtest/gtest.h>

#include "hand/hand.h"
#include "tests/hand/sample_subjects.h"
#include "tests/matrix_near.h"

namespace thenar {

/// Shapes agree, limits do not cross, rotations are rotations, the reference posture displaces
/// nothing unless a coupling says so, and Jacobians are the derivatives of poses.
inline void expect_hand_laws(const Hand& hand, unsigned seed) {
  const HandLayout& layout = hand.layout();
  const auto n = static_cast<Eigen::Index>(layout.coordinates.size());
  ASSERT_EQ(layout.lower.size(), n);
  ASSERT_EQ(layout.upper.size(), n);
  EXPECT_TRUE((layout.lower.array() <= layout.upper.array()).all());

  sample::Draw draw(seed);
  Eigen::VectorXd q(n);
  for (Eigen::Index i = 0; i < n; ++i) q[i] = draw.number(layout.lower[i], layout.upper[i]);

  const Actuation actuation = hand.actuation(q);
  const auto m = static_cast<Eigen::Index>(layout.actuators.size());
  EXPECT_EQ(actuation.B.rows(), n);
  EXPECT_EQ(actuation.B.cols(), m);
  EXPECT_EQ(actuation.tau_0.size(), n);
  ASSERT_EQ(actuation.lower.size(), m);
  ASSERT_EQ(actuation.upper.size(), m);
  EXPECT_TRUE((actuation.lower.array() <= actuation.upper.array()).all());

  const double h = 1e-6;  // [rad]
  const std::vector<Pose<double>> at = hand.pose(q);
  for (int link = 0; link < static_cast<int>(at.size()); ++link) {
    const Eigen::Matrix3d& R = at[link].R;
    EXPECT_TRUE(matrix_near(R * R.transpose(), Eigen::Matrix3d::Identity(), 1e-13));
    EXPECT_NEAR(R.determinant(), 1, 1e-13);

    const Eigen::Vector3d p = draw.vector(0.1);
    const Eigen::MatrixXd J = hand.jacobian(q, link, p);
    ASSERT_EQ(J.rows(), 6);
    ASSERT_EQ(J.cols(), n);
    for (Eigen::Index i = 0; i < n; ++i) {
      const Eigen::VectorXd step = h * Eigen::VectorXd::Unit(n, i);
      const Pose<double> plus = hand.pose(q + step)[link], minus = hand.pose(q - step)[link];
      const Eigen::Matrix3d spin = (plus.R - minus.R) / (2 * h) * R.transpose();
      Eigen::Matrix<double, 6, 1> column;
      column << spin(2, 1), spin(0, 2), spin(1, 0), (plus * p - minus * p) / (2 * h);
      EXPECT_TRUE(matrix_near(J.col(i), column, 1e-8));
    }
  }
}

}  // namespace thenar
