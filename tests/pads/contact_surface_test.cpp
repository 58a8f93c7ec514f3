// Tests for pads/contact_surface.cpp: areas, gaps and their slopes.

#include "pads/contact_surface.h"

#include <random>

#include <gtest/gtest.h>

#include "geometry/primitives.h"
#include "tests/matrix_near.h"
#include "tests/pads/tissue_samples.h"

namespace thenar {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// 8 x 6 x 4 mm in 4 x 3 x 2 cells, its top at z = 0.
TissueBlock plain_block() {
  return TissueBlock(
      graded_box(even_axis(-4e-3, 4e-3, 4), even_axis(-3e-3, 3e-3, 3), even_axis(-4e-3, 0, 2)),
      {neo_hookean(12e3, 0.4)});
}

VectorXd random_motion(const TissueBlock& block, double size, unsigned seed) {
  std::mt19937 rng(seed);
  std::uniform_real_distribution<double> unit(-size, size);
  return VectorXd::NullaryExpr(block.body->unknowns(), [&] { return unit(rng); });
}

Pose<double> above(double height) {
  Pose<double> X;
  X.p[2] = height;
  return X;
}

TEST(ContactSurface, NodesShareTheAreaOfTheirFaces) {
  const TissueBlock block = plain_block();
  const ContactSurface& surface = block.surface;
  ASSERT_EQ(surface.nodes.size(), 20U);
  ASSERT_EQ(surface.faces.size(), 12U);
  for (Eigen::Index k = 0; k < surface.area.size(); ++k) {
    // Faces of 2 x 2 mm: four around an inner node, two at an edge, one at a corner.
    const Vector3d p = surface.rest_positions.col(k);
    const double faces = (std::abs(p[0]) > 3.9e-3 ? 1 : 2) * (std::abs(p[1]) > 2.9e-3 ? 1 : 2);
    EXPECT_NEAR(surface.area[k], faces * 1e-6, 1e-18);
  }
}

// Hanging nodes hand their shares on: the area is that of the top, however it is cut.
TEST(ContactSurface, KeepsTheAreaWhereNodesHang) {
  HexMesh mesh =
      graded_box(even_axis(-4e-3, 4e-3, 4), even_axis(-3e-3, 3e-3, 3), even_axis(-4e-3, 0, 2));
  refine_where(mesh, 1, [](const Vector3d& low, const Vector3d&) {
    return low[0] < -1e-9 && low[2] > -3e-3;
  });
  const TissueBlock block(std::move(mesh), {neo_hookean(12e3, 0.4)});
  EXPECT_NEAR(block.surface.area.sum(), 48e-6, 1e-16);
  double points = 0;
  for (const SurfacePoint& point : block.surface.points) points += point.area;
  EXPECT_NEAR(points, 48e-6, 1e-16);
  // Shape functions sum to one at every point, hanging nodes or not.
  for (const SurfacePoint& point : block.surface.points) {
    double sum = 0;
    for (const NodeWeight& each : point.nodes) sum += each.weight;
    EXPECT_NEAR(sum, 1, 1e-14);
  }
}

// Over a plane gaps are those of the nodes, and no neighbour matters.
TEST(ContactSurface, GapsBelowAPlaneAreHeights) {
  const TissueBlock block = plain_block();
  const VectorXd x = random_motion(block, 1e-4, 1);
  const Matrix3Xd places = deformed_positions(block.surface, x);
  MeanGaps gaps(block.surface);
  gaps.update(*build_box({0.1, 0.1, 0.02}), above(0.012), x);
  EXPECT_FALSE(gaps.depends_on_neighbours());
  for (std::size_t k = 0; k < block.surface.nodes.size(); ++k) {
    EXPECT_NEAR(gaps.gap(k), 2e-3 - places(2, static_cast<Eigen::Index>(k)), 1e-16);
    EXPECT_TRUE(matrix_near(gaps.normal(k), -Vector3d::UnitZ(), 1e-12));
  }
}

// Linear change of gaps against central differences of find(), below a ball whose normals turn.
TEST(ContactSurface, SlopesOfGapsAreTheirDerivatives) {
  const TissueBlock block = plain_block();
  const VectorXd x = random_motion(block, 1e-4, 2), way = random_motion(block, 1, 3);
  const auto ball = build_sphere(6e-3);
  const Pose<double> X = above(6.5e-3);
  MeanGaps gaps(block.surface), before(block.surface), after(block.surface);
  gaps.update(*ball, X, x);
  EXPECT_TRUE(gaps.depends_on_neighbours());
  const double step = 1e-8;
  before.update(*ball, X, x - step * way);
  after.update(*ball, X, x + step * way);
  const VectorXd change =
      gaps.gap_changes(deformed_positions(block.surface, way) - block.surface.rest_positions);
  for (std::size_t k = 0; k < block.surface.nodes.size(); ++k)
    EXPECT_NEAR(change[static_cast<Eigen::Index>(k)], (after.gap(k) - before.gap(k)) / (2 * step),
                1e-6);
}

// A push does the work that gaps take: spread() is the transpose of change().
TEST(ContactSurface, SpreadIsTheTransposeOfChange) {
  const TissueBlock block = plain_block();
  MeanGaps gaps(block.surface);
  gaps.update(*build_sphere(6e-3), above(6.5e-3), random_motion(block, 1e-4, 4));
  std::mt19937 rng(5);
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto nodes = static_cast<Eigen::Index>(block.surface.nodes.size());
  const VectorXd push = VectorXd::NullaryExpr(nodes, [&] { return unit(rng); });
  const Matrix3Xd moved = Matrix3Xd::NullaryExpr(3, nodes, [&] { return unit(rng); });
  EXPECT_NEAR(push.dot(gaps.gap_changes(moved)), gaps.nodal_forces(push).cwiseProduct(moved).sum(),
              1e-12);
}

// Corners and points of a plane face lie on it: the middle is the mean of the corners.
TEST(ContactSurface, PointsOfAFlatFaceLieOnIt) {
  const TissueBlock block = plain_block();
  for (const SurfacePoint& point : block.surface.points)
    EXPECT_NEAR(point_position(point, block.surface.rest_positions)[2], 0, 1e-18);
  const FaceCorners corners =
      corner_positions(block.surface.faces.front(), block.surface.rest_positions);
  EXPECT_NEAR((corners.col(3) - corners.col(0)).cross(corners.col(2) - corners.col(1)).norm() / 2,
              4e-6, 1e-18);
}

// A ball over a node, and over the middle of a face where its nearest point is a Gauss point.
TEST(ContactSurface, SmallestGapSeesNodesAndPointsBetween) {
  const TissueBlock block = plain_block();
  const VectorXd rest = VectorXd::Zero(block.body->unknowns());
  const auto ball = build_sphere(1e-3);
  Pose<double> X = above(3e-3);
  X.p.head<2>() << 2e-3, 1e-3;  // a node
  EXPECT_NEAR(min_gap(block.surface, *ball, X, rest), 2e-3, 1e-15);
  X.p.head<2>() << 1e-3, 0;  // the middle of a face
  EXPECT_NEAR(min_gap(block.surface, *ball, X, rest), 2e-3, 1e-15);
}

// The edge of a box over the skin is one; a plane, and a ball that is larger than a face, have
// none.
TEST(ContactSurface, TellsEdgesFromRoundObjects) {
  const TissueBlock block = plain_block();
  const VectorXd rest = VectorXd::Zero(block.body->unknowns());
  Pose<double> X = above(0.01 + 1e-5);
  EXPECT_FALSE(has_edge_nearby(block.surface, *build_box({0.1, 0.1, 0.02}), X, rest));
  X.p[0] = 0.05 + 1e-3;  // the box begins at x = 1 mm
  EXPECT_TRUE(has_edge_nearby(block.surface, *build_box({0.1, 0.1, 0.02}), X, rest));
  EXPECT_FALSE(has_edge_nearby(block.surface, *build_sphere(20e-3), above(0.02 + 1e-5), rest));
}

}  // namespace
}  // namespace thenar
