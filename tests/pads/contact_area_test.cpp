// Tests for pads/contact_area.cpp: shares of triangles, and patches that cover all of the skin.

#include "pads/contact_area.h"

#include <random>

#include <gtest/gtest.h>

#include "geometry/primitives.h"
#include "tests/pads/tissue_samples.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

// Above 0 is a similar triangle at the corner, of (1/4)^2; and its complement.
TEST(ContactArea, SharesOfATriangleAreThoseOfSimilarOnes) {
  EXPECT_DOUBLE_EQ(positive_share({1, -3, -3}), 1.0 / 16);
  EXPECT_DOUBLE_EQ(positive_share({-1, 3, 3}), 15.0 / 16);
  EXPECT_DOUBLE_EQ(positive_share({3, 1, 2}), 1);
  EXPECT_DOUBLE_EQ(positive_share({-3, -1, -2}), 0);
  EXPECT_DOUBLE_EQ(positive_share({0, 1, -1}), 0.5);  // through a corner and the middle of a side
}

// The two sides of the line share the triangle, whichever corner comes first.
TEST(ContactArea, SharesOfBothSidesAreTheWhole) {
  std::mt19937 rng(4);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 200; ++trial) {
    const double a = normal(rng), b = normal(rng), c = normal(rng);
    EXPECT_NEAR(positive_share({a, b, c}) + positive_share({-a, -b, -c}), 1, 1e-12);
    EXPECT_NEAR(positive_share({a, b, c}), positive_share({c, a, b}), 1e-12);
    EXPECT_NEAR(positive_share({a, b, c}), positive_share({b, a, c}), 1e-12);
  }
}

/// A block of 6 x 4 x 4 mm under a slab that is wider than it.
struct SlabOnBlock {
  TissueBlock block{
      graded_box(even_axis(-3e-3, 3e-3, 3), even_axis(-2e-3, 2e-3, 2), even_axis(-4e-3, 0, 2)),
      {neo_hookean(12e3, 0.4)}};
  RigidObject slab{build_box({0.1, 0.1, 0.02}), 0};
  PressState state;

  /// Presses the slab so deep [m], below 0 where it stays away.
  explicit SlabOnBlock(double depth) {
    Pose<double> X;
    X.p[2] = 0.01 + 1e-3;
    state = block.at_rest(X);
    PressGoal goal;
    goal.X_PO.p[2] = 0.01 - depth;
    EXPECT_EQ(block.press(slab, goal, state).status, Status::kSolved);
  }
  [[nodiscard]] double area() const {
    std::vector<bool> top;
    for (int node = 0; node < block.mesh.nodes(); ++node)
      top.push_back(block.mesh.place(node)[2] > -1e-9);
    return contact_area(block.mesh, *block.body, {neo_hookean(12e3, 0.4)}, top, block.surface, slab,
                        state);
  }
};

// Where all of the top touches the patch is the deformed top, which has spread: the sum of its
// faces by their diagonals.
TEST(ContactArea, IsTheWholeTopUnderAWideSlab) {
  const SlabOnBlock pressed(0.4e-3);
  for (Eigen::Index k = 0; k < pressed.state.normal_force.size(); ++k)
    ASSERT_GT(pressed.state.normal_force[k], 0);
  const Eigen::Matrix3Xd u = pressed.block.body->node_displacements(pressed.state.x, {});
  double top = 0;
  for (const HexCell& cell : pressed.block.mesh.cells()) {
    if (pressed.block.mesh.place(cell.corners[4])[2] < -1e-9) continue;
    const auto at = [&](std::size_t c) {
      return Vector3d(pressed.block.mesh.place(cell.corners[c]) + u.col(cell.corners[c]));
    };
    top += 0.5 * (at(7) - at(4)).cross(at(6) - at(5)).norm();
  }
  EXPECT_GT(top, 1.01 * 24e-6);
  EXPECT_NEAR(pressed.area(), top, 1e-9 * top);
}

TEST(ContactArea, IsZeroWhereNothingTouches) { EXPECT_EQ(SlabOnBlock(-0.5e-3).area(), 0); }

}  // namespace
}  // namespace thenar
