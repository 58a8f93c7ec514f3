// Tests for geometry/mesh_parts.cpp: parts of meshes that were joined.

#include "geometry/mesh_parts.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "geometry/tessellate.h"
#include "tests/geometry/enclosed_volume.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

TriangleMesh cube_at(const Vector3d& centre, double edge) {
  TriangleMesh mesh = box_mesh(Vector3d::Constant(edge));
  mesh.vertices.colwise() += centre;
  return mesh;
}
TriangleMesh turned(TriangleMesh mesh) {
  mesh.triangles.row(1).swap(mesh.triangles.row(2));
  return mesh;
}

TEST(MeshParts, TakesJoinedMeshesApart) {
  const std::vector<TriangleMesh> parts =
      connected_parts(joined({cube_at({0, 0, 0}, 1), cube_at({3, 0, 0}, 2)}));
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_EQ(parts[0].vertices.cols(), 8);
  EXPECT_EQ(parts[1].vertices.cols(), 8);
  EXPECT_NEAR(enclosed_volume(parts[0]), 1, 1e-14);
  EXPECT_NEAR(enclosed_volume(parts[1]), 8, 1e-13);
}

TEST(MeshParts, DiagonalIsThatOfTheBox) { EXPECT_NEAR(diagonal_of(box_mesh({2, 3, 6})), 7, 1e-14); }

// A cavity stays with the solid around it; the same surface elsewhere is a solid inside out.
TEST(MeshParts, TellsCavitiesFromSolidsInsideOut) {
  const std::vector<TriangleMesh> hollow =
      solid_parts(joined({cube_at({0, 0, 0}, 3), turned(cube_at({0, 0, 0}, 1))}));
  ASSERT_EQ(hollow.size(), 1U);
  EXPECT_NEAR(enclosed_volume(hollow[0]), 27 - 1, 1e-12);
  const std::vector<TriangleMesh> beside =
      solid_parts(joined({cube_at({0, 0, 0}, 3), turned(cube_at({5, 0, 0}, 1))}));
  ASSERT_EQ(beside.size(), 2U);
  EXPECT_NEAR(enclosed_volume(beside[0]) + enclosed_volume(beside[1]), 27 + 1, 1e-12);
}

// A solid within the cavity of another, like a nut in its shell.
TEST(MeshParts, KeepsASolidWithinACavity) {
  const std::vector<TriangleMesh> parts = solid_parts(
      joined({cube_at({0, 0, 0}, 5), turned(cube_at({0, 0, 0}, 3)), cube_at({0, 0, 0}, 1)}));
  ASSERT_EQ(parts.size(), 2U);
  double whole = 0;
  for (const TriangleMesh& part : parts) whole += enclosed_volume(part);
  EXPECT_NEAR(whole, 125 - 27 + 1, 1e-11);
}

TEST(MeshParts, LeavesSliversOut) {
  EXPECT_TRUE(is_sliver(1e-10, 1, 1));                   // flat
  EXPECT_TRUE(is_sliver(std::pow(1e-5, 3), 1.7e-5, 1));  // lost in the whole
  EXPECT_FALSE(is_sliver(std::pow(1e-3, 3), 1.7e-3, 1));
  const std::vector<TriangleMesh> parts =
      solid_parts(joined({cube_at({0, 0, 0}, 1), cube_at({1, 0, 0}, 1e-5)}));
  ASSERT_EQ(parts.size(), 1U);
  EXPECT_NEAR(enclosed_volume(parts[0]), 1, 1e-14);
}

TEST(MeshParts, RefusesWhatBoundsNoSolid) {
  TriangleMesh open = cube_at({0, 0, 0}, 1);
  open.triangles.conservativeResize(3, 11);
  const std::string message = message_of([&] { (void)solid_parts(open); });
  EXPECT_EQ(message.find("a mesh bounds no solid: 1 hole(s): 3 edges"), 0U) << message;
  EXPECT_TRUE(solids_or_none(open).empty());
  EXPECT_EQ(message_of([] { (void)solid_parts({}); }), "a mesh has no triangle");
}

}  // namespace
}  // namespace thenar
