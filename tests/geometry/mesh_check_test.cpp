// Tests for geometry/mesh_check.cpp.

#include "geometry/mesh_check.h"

#include <limits>

#include <gtest/gtest.h>

#include "geometry/solid.h"
#include "tests/geometry/enclosed_volume.h"
#include "tests/geometry/sample_meshes.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

/// 20 mm, without the two triangles of its face at z = +10 mm.
TriangleMesh open_box() {
  TriangleMesh box = box_mesh({0.02, 0.02, 0.02});
  Eigen::Matrix3Xi kept(3, 10);
  for (Eigen::Index t = 0, n = 0; t < 12; ++t) {
    double top = 0;
    for (int k = 0; k < 3; ++k) top += box.vertices(2, box.triangles(k, t));
    if (top < 0.029) kept.col(n++) = box.triangles.col(t);
  }
  box.triangles = kept;
  return box;
}

ShapeSpec spec(const TriangleMesh& mesh) {
  ShapeSpec made;
  made.kind = ShapeKind::kMesh;
  made.mesh = mesh;
  return made;
}

TEST(CheckMesh, FindsNothingWrongWithAMug) {
  EXPECT_TRUE(check_mesh(mug()).watertight());
  EXPECT_EQ(describe(check_mesh(mug())), "");
}

TEST(CheckMesh, NamesTheHole) {
  const MeshReport report = check_mesh(open_box());
  ASSERT_EQ(report.holes.size(), 1U);
  EXPECT_EQ(report.holes[0].loop.size(), 4U);
  EXPECT_NEAR(report.holes[0].length, 0.08, 1e-15);
  EXPECT_EQ(describe(report), "1 hole(s): 4 edges, 80 mm long, about (0, 0, 10) mm");
}

TEST(CheckMesh, FindsTurnedAndDegenerateTriangles) {
  TriangleMesh box = box_mesh({0.02, 0.02, 0.02});
  std::swap(box.triangles(0, 3), box.triangles(1, 3));
  EXPECT_EQ(check_mesh(box).reversed_edges, 3);
  EXPECT_EQ(describe(check_mesh(box)), "3 edge(s) whose triangles face opposite ways");
  TriangleMesh line = box_mesh({0.02, 0.02, 0.02});
  line.vertices.col(0) = line.vertices.col(1);
  EXPECT_GT(check_mesh(line).degenerate, 0);
}

TEST(RepairMesh, ClosesTheHole) {
  const MeshRepair repair = repair_mesh(open_box());
  EXPECT_EQ(repair.closed_holes, 1);
  EXPECT_NEAR(enclosed_volume(repair.mesh), 8e-6, 1e-18);
}

TEST(RepairMesh, TurnsWhatFacesInwards) {
  TriangleMesh box = box_mesh({0.02, 0.02, 0.02});
  std::swap(box.triangles(0, 3), box.triangles(1, 3));
  EXPECT_EQ(repair_mesh(box).turned, 1);
  EXPECT_NEAR(enclosed_volume(repair_mesh(box).mesh), 8e-6, 1e-18);
  box = mug();
  box.triangles.row(0).swap(box.triangles.row(1));
  EXPECT_EQ(repair_mesh(box).turned, box.triangles.cols());
  EXPECT_GT(enclosed_volume(repair_mesh(box).mesh), 0);
}

TEST(RepairMesh, DropsWhatIsThereTwice) {
  TriangleMesh box = box_mesh({0.02, 0.02, 0.02});
  box.triangles.conservativeResize(3, 13);
  box.triangles.col(12) = box.triangles.col(5);
  EXPECT_EQ(check_mesh(box).nonmanifold_edges, 3);
  EXPECT_EQ(repair_mesh(box).dropped, 1);
  EXPECT_TRUE(check_mesh(repair_mesh(box).mesh).watertight());
}

TEST(BuildSolid, RefusesALeakyMeshNamingItsHoles) {
  EXPECT_EQ(message_of([] { (void)build_solid({spec(open_box())}); }),
            "a mesh bounds no solid: 1 hole(s): 4 edges, 80 mm long, about (0, 0, 10) mm");
}

TEST(BuildSolid, TurnsAMeshOutwards) {
  TriangleMesh inward = box_mesh({0.02, 0.02, 0.02});
  inward.triangles.row(0).swap(inward.triangles.row(1));
  const Solid solid = build_solid({spec(inward)});
  EXPECT_NEAR(solid.shape->distance({0, 0, 0}), -0.01, 1e-17);
  EXPECT_GT(enclosed_volume(solid.visual), 0);
}

TEST(BuildSolid, RefusesNumbersThatAreNone) {
  TriangleMesh mesh = box_mesh({0.02, 0.02, 0.02});
  mesh.vertices(0, 0) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(message_of([&] { (void)build_solid({spec(mesh)}); }),
            "a mesh has a coordinate that is not finite");
}

}  // namespace
}  // namespace thenar
