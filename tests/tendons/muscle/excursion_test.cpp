// Tests for tendons/muscle/excursion.cpp.

#include "tendons/muscle/excursion.h"

#include <gtest/gtest.h>

#include "tests/matrix_near.h"
#include "tests/tendons/muscle/moving_samples.h"

namespace thenar {
namespace {

using Eigen::VectorXd;

// Separate tendons lengthen as their paths do.
TEST(Excursion, IsChangeOfPathLength) {
  const Subject subject = sample::index_finger();
  TendonOptions separate;
  separate.hood = Hood::kSeparate;
  const auto tendons = build_linear_tendons(subject, "index", separate);
  const TendonModel<double>& model = tendons->digit().model;
  const VectorXd from = Eigen::Vector4d(-0.2, 0.1, 0.1, 0), to = Eigen::Vector4d(1.2, -0.1, 1, 0.8);
  VectorXd change(7);
  for (Eigen::Index m = 0; m < 7; ++m) {
    const TendonPath<double>& path =
        model.paths[static_cast<std::size_t>(model.pulls[static_cast<std::size_t>(m)])];
    change[m] = path_length(pose_tree(model.tree, to), path) -
                path_length(pose_tree(model.tree, from), path);
  }
  EXPECT_TRUE(matrix_near(excursion(*tendons, from, to, VectorXd::Ones(7)), change, 1e-12));  // [m]
}

TEST(Excursion, ConstantArmsShortenInProportion) {
  const sample::Mover mover(sample::Pendulum().subject(), Muscle::kBounds);
  const VectorXd one = VectorXd::Ones(1);
  EXPECT_NEAR(excursion(*mover.tendons, 0 * one, 0.7 * one, one)[0], -0.01 * 0.7, 1e-16);
  EXPECT_EQ(excursion(*mover.tendons, one, one, one)[0], 0);
}

}  // namespace
}  // namespace thenar
