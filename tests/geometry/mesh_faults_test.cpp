// Tests for geometry/mesh_faults.cpp: causes, not the open edges that they leave.

#include "geometry/mesh_faults.h"

#include <vector>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "geometry/mesh_parts.h"
#include "geometry/repair_to_solid.h"
#include "tests/geometry/enclosed_volume.h"
#include "tests/geometry/sample_meshes.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

TriangleMesh box() { return box_mesh({0.02, 0.02, 0.02}); }

TriangleMesh square() {
  TriangleMesh sheet{Eigen::Matrix3Xd(3, 4), Eigen::Matrix3Xi(3, 2)};
  sheet.vertices << 0, 0.01, 0.01, 0, 0, 0, 0.01, 0.01, 0.03, 0.03, 0.03, 0.03;
  sheet.triangles << 0, 0, 1, 2, 2, 3;
  return sheet;
}

/// A mesh with one triangle more, and one vertex more.
TriangleMesh with_triangle(TriangleMesh mesh, const Eigen::Vector3i& corners,
                           const Eigen::Vector3d& vertex) {
  mesh.vertices.conservativeResize(3, mesh.vertices.cols() + 1);
  mesh.vertices.rightCols<1>() = vertex;
  mesh.triangles.conservativeResize(3, mesh.triangles.cols() + 1);
  mesh.triangles.rightCols<1>() = corners;
  return mesh;
}

TEST(MeshFaults, AreNoneOfASolid) {
  const MeshFaults faults = find_mesh_faults(box());
  EXPECT_EQ(describe(faults), "");
  EXPECT_EQ(faults.holes, 0);
}

// However it is turned, and with the rounding of single precision.
TEST(MeshFaults, SayThatAMeshIsFlat) {
  TriangleMesh sheet = square();
  EXPECT_TRUE(is_flat(sheet));
  sheet.vertices =
      Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()).matrix() * sheet.vertices;
  sheet.vertices = sheet.vertices.cast<float>().cast<double>();
  const MeshFaults faults = find_mesh_faults(sheet);
  EXPECT_TRUE(faults.flat);
  EXPECT_EQ(faults.holes, 0);
  const std::string cause =
      "flat: all its triangles lie in one plane, and no repair gives it a thickness";
  EXPECT_EQ(message_of([&] { (void)solid_parts(sheet); }),
            "a mesh bounds no solid: it is " + cause);
  EXPECT_EQ(message_of([&] { (void)repair_to_solid(sheet); }), "the mesh is " + cause);
}

TEST(MeshFaults, LeaveAThinPlateAlone) {
  EXPECT_FALSE(is_flat(box_mesh({0.02, 0.02, 1e-7})));
  EXPECT_NO_THROW((void)solid_parts(box_mesh({0.02, 0.02, 1e-7})));
}

// A fin hangs on an edge that has three triangles with it; a sheet on nothing.
TEST(MeshFaults, CountFlapsAsSuch) {
  const Eigen::Vector3i edge = box().triangles.col(0);
  const TriangleMesh fin = with_triangle(box(), {edge(0), edge(1), 8}, {0.03, 0.03, 0.03});
  ASSERT_EQ(box().vertices.cols(), 8);
  EXPECT_EQ(find_mesh_faults(fin).flaps, 1);
  EXPECT_EQ(find_mesh_faults(fin).holes, 0);
  const TriangleMesh sheet = joined({box(), square()});
  EXPECT_EQ(find_mesh_faults(sheet).flaps, 2);
  EXPECT_EQ(find_mesh_faults(sheet).holes, 0);
  EXPECT_EQ(message_of([&] { (void)solid_parts(fin); }),
            "a mesh bounds no solid: 1 triangle(s) of fins or sheets that enclose nothing");
  EXPECT_NEAR(enclosed_volume(repair_to_solid(fin).mesh), 8e-6, 1e-18);
}

TEST(MeshFaults, CountHolesBesideFlaps) {
  TriangleMesh open = box();
  open.triangles = Eigen::Matrix3Xi(open.triangles.leftCols(11));
  const MeshFaults faults = find_mesh_faults(joined({open, square()}));
  EXPECT_EQ(faults.holes, 1);
  EXPECT_EQ(faults.flaps, 2);
}

// A triangle on a line leaves an edge open; without it the box is closed.
TEST(MeshFaults, SayThatTrianglesHaveNoArea) {
  const TriangleMesh mesh = box();
  const Eigen::Vector3i corners = mesh.triangles.col(0);
  const Eigen::Vector3d middle =
      (mesh.vertices.col(corners(0)) + mesh.vertices.col(corners(1))) / 2;
  const MeshFaults faults =
      find_mesh_faults(with_triangle(mesh, {corners(0), 8, corners(1)}, middle));
  EXPECT_EQ(faults.degenerate, 1);
  EXPECT_EQ(faults.nonmanifold_edges, 0);
  EXPECT_EQ(faults.holes + faults.seams + faults.flaps, 0);
  EXPECT_EQ(describe(faults), "1 triangle(s) of no area, which leave edges open");
}

// One triangle is cut at the middle of an edge, its neighbour is not.
TEST(MeshFaults, TellSeamsFromHoles) {
  TriangleMesh mesh = box();
  const Eigen::Vector3i corners = mesh.triangles.col(0);
  const Eigen::Vector3d middle =
      (mesh.vertices.col(corners(0)) + mesh.vertices.col(corners(1))) / 2;
  mesh.triangles(1, 0) = 8;
  const MeshFaults faults =
      find_mesh_faults(with_triangle(mesh, {8, corners(1), corners(2)}, middle));
  EXPECT_EQ(faults.seams, 1);
  EXPECT_EQ(faults.holes, 0);
}

// Six faces that nothing joins may be meant as a box: they are open, not flaps.
TEST(MeshFaults, CallFacesThatNothingJoinsOpen) {
  const TriangleMesh whole = box();
  std::vector<TriangleMesh> faces;
  for (Eigen::Index t = 0; t < whole.triangles.cols(); ++t)
    faces.push_back({whole.vertices, whole.triangles.col(t)});
  const MeshFaults faults = find_mesh_faults(joined(faces));
  EXPECT_EQ(faults.flaps, 0);
  EXPECT_EQ(faults.holes, 12);
}

}  // namespace
}  // namespace thenar
