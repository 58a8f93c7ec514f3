// Tests for grasp/quality/grasp_matrix.cpp.

#include "grasp/quality/grasp_matrix.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/error.h"

namespace thenar {
namespace {

// Two opposed soft fingers at r from the centre, scale s: forces along x come twice, so 2 on the
// diagonal of G G'; along y, z, 2; the twist about x 2; torques about y and z 2 (r/s)^2. Eight
// components less six: two internal forces, the squeeze and the twist against each other.
TEST(GraspMatrix, OfASoftPinch) {
  const double r = 0.02, s = 0.04;
  const Eigen::MatrixXd G = grasp_matrix(
      {{{-r, 0, 0}, {1, 0, 0}, 0.3, 0.001}, {{r, 0, 0}, {-1, 0, 0}, 0.7, 0.002}}, {0, 0, 0}, s);
  ASSERT_EQ(G.cols(), 8);
  const GraspMatrixMeasures found = grasp_matrix_measures(G);
  EXPECT_EQ(found.rank, 6);
  EXPECT_NEAR(found.min_singular_value, std::sqrt(2) * r / s, 1e-12);
  EXPECT_NEAR(found.isotropy, r / s, 1e-12);
  EXPECT_NEAR(found.volume, 8 * std::pow(r / s, 2), 1e-12);
  EXPECT_EQ(found.internal_forces, 2);
}

// Without torsion nothing turns the object about the line: 6 components of rank 5, one squeeze.
TEST(GraspMatrix, OfAHardPinchLacksATwist) {
  const GraspMatrixMeasures found = grasp_matrix_measures(grasp_matrix(
      {{{-1, 0, 0}, {1, 0, 0}, 0.5, 0}, {{1, 0, 0}, {-1, 0, 0}, 0.5, 0}}, {0, 0, 0}, 1));
  EXPECT_EQ(found.rank, 5);
  EXPECT_EQ(found.min_singular_value, 0);
  EXPECT_EQ(found.isotropy, 0);
  EXPECT_EQ(found.volume, 0);
  EXPECT_EQ(found.internal_forces, 1);
}

TEST(GraspMatrix, OfNothingIsNothing) {
  const GraspMatrixMeasures found = grasp_matrix_measures(grasp_matrix({}, {0, 0, 0}, 1));
  EXPECT_EQ(found.rank, 0);
  EXPECT_EQ(found.internal_forces, 0);
}

}  // namespace
}  // namespace thenar
