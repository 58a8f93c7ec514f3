// Tests for geometry/winding_number.cpp: solids and cavities whose windings are known.

#include "geometry/winding_number.h"

#include <cmath>

#include <gtest/gtest.h>

#include "geometry/mesh_parts.h"
#include "geometry/tessellate.h"
#include "tests/geometry/random_points.h"
#include "tests/geometry/sample_meshes.h"

namespace thenar::internal {
namespace {

using Eigen::Vector3d;

TriangleMesh facing_in(TriangleMesh mesh) {
  mesh.triangles.row(1).swap(mesh.triangles.row(2));
  return mesh;
}

TEST(WindingNumber, IsOneInABoxAndZeroOutside) {
  const TriangleTree tree(box_mesh({2, 1, 0.5}));
  std::mt19937 rng(1);
  for (int i = 0; i < 2000; ++i) {
    const Vector3d p = 1.5 * random_in_cube(rng);
    const bool inside = std::abs(p[0]) < 1 && std::abs(p[1]) < 0.5 && std::abs(p[2]) < 0.25;
    EXPECT_EQ(winding_number(tree, p), inside ? 1 : 0) << p.transpose();
  }
}

// Two boxes that overlap: their windings add up. A box within, inside out, is a cavity.
TEST(WindingNumber, AddsUpOverSurfaces) {
  TriangleMesh moved = box_mesh({2, 2, 2});
  moved.vertices.row(0).array() += 1;
  const TriangleTree two(joined({box_mesh({2, 2, 2}), moved}));
  EXPECT_EQ(winding_number(two, {0.5, 0.1, 0.2}), 2);
  EXPECT_EQ(winding_number(two, {-0.5, 0.1, 0.2}), 1);
  EXPECT_EQ(winding_number(two, {2.5, 0.1, 0.2}), 0);
  const TriangleTree hollow(joined({box_mesh({2, 2, 2}), facing_in(box_mesh({1, 1, 1}))}));
  EXPECT_EQ(winding_number(hollow, {0.1, 0.2, 0.3}), 0);
  EXPECT_EQ(winding_number(hollow, {0.1, 0.2, 0.7}), 1);
  EXPECT_EQ(winding_number(TriangleTree(facing_in(box_mesh({1, 1, 1}))), {0.1, 0.1, 0.1}), -1);
}

// Rays from the axis of a surface of revolution pass its edges and poles, and give way to others.
TEST(WindingNumber, GivesWayWhereRaysPassEdges) {
  const TriangleTree tree(mug(60));
  for (int i = 1; i < 96; ++i) {
    const double z = -0.05 + 0.001 * i + 1e-6;
    EXPECT_EQ(winding_number(tree, {0, 0, z}), z < -0.046 ? 1 : 0)
        << z;                                                // its floor, then the hollow
    EXPECT_EQ(winding_number(tree, {0.038, 0, z}), 1) << z;  // the wall
  }
}

}  // namespace
}  // namespace thenar::internal
