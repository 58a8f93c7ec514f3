// Tests for geometry/repair_to_solid.cpp, mesh_parts.cpp and hull_mesh.cpp.

#include "geometry/repair_to_solid.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/cache.h"
#include "geometry/cached_mesh.h"
#include "geometry/mesh_check.h"
#include "geometry/mesh_parts.h"
#include "geometry/solid.h"
#include "tests/geometry/enclosed_volume.h"
#include "tests/geometry/sample_meshes.h"
#include "tests/message_of.h"
#include "tests/temporary_folder.h"

namespace thenar {
namespace {

using Eigen::Vector3d, Eigen::Vector3i;

TriangleMesh box_at(const Vector3d& centre, double edge = 0.02) {
  TriangleMesh box = box_mesh(Vector3d::Constant(edge));
  box.vertices.colwise() += centre;
  return box;
}

TriangleMesh inside_out(TriangleMesh mesh) {
  mesh.triangles.row(0).swap(mesh.triangles.row(1));
  return mesh;
}

/// Every triangle with corners of its own, as STL files have them, moved by `shift`, all but the
/// first `left_out`.
TriangleMesh loose(const TriangleMesh& mesh, double shift, Eigen::Index left_out = 0) {
  const Eigen::Index count = mesh.triangles.cols() - left_out;
  TriangleMesh soup{Eigen::Matrix3Xd(3, 3 * count), Eigen::Matrix3Xi(3, count)};
  for (Eigen::Index t = 0; t < count; ++t)
    for (int k = 0; k < 3; ++k) {
      soup.vertices.col(3 * t + k) =
          mesh.vertices.col(mesh.triangles(k, t + left_out)).array() + shift * (t % 3 - 1);
      soup.triangles(k, t) = static_cast<int>(3 * t + k);
    }
  return soup;
}

double distance(const TriangleMesh& mesh, const Vector3d& p) {
  ShapeSpec spec;
  spec.kind = ShapeKind::kMesh;
  spec.mesh = mesh;
  return build_solid({spec}).shape->distance(p);
}

TEST(SolidParts, JoinsOverlappingBoxes) {
  const TriangleMesh two = joined({box_at({0, 0, 0}), box_at({0.015, 0, 0})});
  EXPECT_EQ(solid_parts(two).size(), 2U);
  // In the overlap, 5 mm thick, the deeper part tells: 5 mm below one's face, 0 to 5 for the other.
  EXPECT_NEAR(distance(two, {0.0075, 0, 0}), -0.0025, 1e-15);
  EXPECT_NEAR(distance(two, {0.005, 0, 0}), -0.005, 1e-15);
  EXPECT_NEAR(distance(two, {0.03, 0, 0}), 0.005, 1e-15);
}

TEST(SolidParts, TurnsPartsOutwardsButKeepsCavities) {
  const TriangleMesh apart = joined({box_at({0, 0, 0}), inside_out(box_at({0.05, 0, 0}))});
  EXPECT_EQ(solid_parts(apart).size(), 2U);
  EXPECT_NEAR(distance(apart, {0.05, 0, 0}), -0.01, 1e-15);
  const TriangleMesh hollow = joined({box_at({0, 0, 0}, 0.04), inside_out(box_at({0, 0, 0}))});
  EXPECT_EQ(solid_parts(hollow).size(), 1U);
  EXPECT_NEAR(distance(hollow, {0, 0, 0}), 0.01, 1e-15);
  EXPECT_NEAR(distance(hollow, {0.013, 0, 0}), -0.003, 1e-15);
}

TEST(SolidParts, TakesBoxesThatShareAnEdge) {
  TriangleMesh two = joined({box_at({0, 0, 0}), box_at({0.02, 0.02, 0})});
  EXPECT_EQ(repair_to_solid(loose(two, 0)).done, "corners at the same place joined");
  EXPECT_NEAR(distance(repair_to_solid(loose(two, 0)).mesh, {0.02, 0.02, 0}), -0.01, 1e-15);
}

TEST(SolidParts, LeavesASoundMeshAsItIs) {
  EXPECT_EQ(solid_parts(mug()).front().vertices, mug().vertices);
  EXPECT_EQ(repair_to_solid(mug()).done, "");
  EXPECT_EQ(repair_to_solid(mug()).mesh.triangles, mug().triangles);
}

TEST(MendMesh, JoinsCornersThatNearlyMeet) {
  const RepairedSolid mended = repair_to_solid(loose(mug(), 1e-8));
  EXPECT_EQ(mended.done, "corners at the same place joined");
  EXPECT_NEAR(enclosed_volume(mended.mesh), enclosed_volume(mug()), 1e-10);
}

TEST(MendMesh, ClosesHoles) {
  const RepairedSolid mended = repair_to_solid(loose(box_at({0, 0, 0}), 0, 1));
  EXPECT_EQ(mended.done,
            "corners at the same place joined, 1 hole(s) closed, the longest 68.28 mm around");
  EXPECT_NEAR(enclosed_volume(mended.mesh), 8e-6, 1e-18);
}

// A face of two triangles whose neighbour has its edge in two halves.
TEST(MendMesh, CutsEdgesThatCornersLieOn) {
  TriangleMesh box = box_at({0, 0, 0});
  const int a = box.triangles(0, 0), b = box.triangles(1, 0), c = box.triangles(2, 0);
  const auto middle = static_cast<int>(box.vertices.cols());
  box.vertices.conservativeResize(3, middle + 1);
  box.vertices.col(middle) = (box.vertices.col(a) + box.vertices.col(b)) / 2;
  box.triangles.conservativeResize(3, 13);
  box.triangles.col(0) << a, middle, c;
  box.triangles.col(12) << middle, b, c;
  const RepairedSolid mended = repair_to_solid(box);
  EXPECT_EQ(mended.done, "1 triangle(s) cut where corners of others lie on them");
  EXPECT_NEAR(enclosed_volume(mended.mesh), 8e-6, 1e-18);
}

TEST(MendMesh, LeavesOutAWallWithin) {
  TriangleMesh two = joined({box_at({0, 0, 0}), box_at({0.02, 0, 0})});
  const RepairedSolid mended = repair_to_solid(loose(two, 0));
  EXPECT_NEAR(distance(mended.mesh, {0.01, 0, 0}), -0.01, 1e-15) << mended.done;
}

TEST(MendMesh, LeavesOutSheets) {
  TriangleMesh sheet{Eigen::Matrix3Xd(3, 4), Eigen::Matrix3Xi(3, 2)};
  sheet.vertices << 0, 0.01, 0.01, 0, 0, 0, 0.01, 0.01, 0.03, 0.03, 0.03, 0.03;
  sheet.triangles << 0, 0, 1, 2, 2, 3;
  const RepairedSolid mended = repair_to_solid(joined({box_at({0, 0, 0}), sheet}));
  EXPECT_EQ(mended.done, "1 part(s) that enclose nothing left out");
  EXPECT_NEAR(enclosed_volume(mended.mesh), 8e-6, 1e-18);
  EXPECT_EQ(message_of([&] { (void)repair_to_solid(sheet); }),
            "the mesh is flat: all its triangles lie in one plane, and no repair gives it a "
            "thickness");
}

// A corner all but at its neighbour: joining both leaves no edge more open than before.
TEST(MendMesh, SaysSoWhereJoiningCornersIsAll) {
  TriangleMesh cup = mug();
  const int to = cup.triangles(0, 0), from = cup.triangles(1, 0);
  cup.vertices.col(from) = cup.vertices.col(to) + Vector3d(1e-16, 2e-16, 1e-16);
  ASSERT_NE(message_of([&] { (void)solid_parts(cup); }), "nothing was thrown");
  const RepairedSolid mended = repair_to_solid(cup);
  EXPECT_EQ(mended.done, "corners at the same place joined");
  EXPECT_EQ(solid_parts(mended.mesh).size(), 1U);
}

// A tetrahedron of 1e-19 m^3, on which no feature tells a side, beside a box of 20 mm.
TEST(MendMesh, LeavesOutSlivers) {
  TriangleMesh sliver{Eigen::Matrix3Xd(3, 4), Eigen::Matrix3Xi(3, 4)};
  sliver.vertices << 0.03, 0.05, 0.038, 0.042, 0, 0, 1e-8, 2e-8, 0, 0, 3e-8, -3e-8;
  sliver.triangles << 0, 0, 1, 2, 2, 1, 2, 0, 1, 3, 3, 3;
  const TriangleMesh both = joined({box_at({0, 0, 0}), sliver});
  EXPECT_NEAR(distance(both, {0.04, 0, 0}), 0.03, 1e-15);
  const RepairedSolid mended = repair_to_solid(both);
  EXPECT_EQ(mended.done, "1 part(s) that enclose nothing left out");
  EXPECT_EQ(mended.mesh.triangles.cols(), 12);
}

/// A band of 4 mm around a ring of 10 mm that turns over once: it has no sides to close.
TriangleMesh moebius_strip() {
  constexpr int kSteps = 24;
  TriangleMesh band{Eigen::Matrix3Xd(3, 2 * kSteps), Eigen::Matrix3Xi(3, 2 * kSteps)};
  for (int i = 0; i < kSteps; ++i) {
    const double angle = 2 * kPi * i / kSteps;
    const Vector3d out(std::cos(angle), std::sin(angle), 0);
    const Vector3d across = std::cos(angle / 2) * out + std::sin(angle / 2) * Vector3d::UnitZ();
    band.vertices.col(2 * i) = 0.01 * out + 0.002 * across;
    band.vertices.col(2 * i + 1) = 0.01 * out - 0.002 * across;
    // The last step meets the first turned over.
    const bool over = i + 1 == kSteps;
    const int next = over ? 1 : 2 * i + 2, below = over ? 0 : 2 * i + 3;
    band.triangles.col(2 * i) << 2 * i, 2 * i + 1, below;
    band.triangles.col(2 * i + 1) << 2 * i, below, next;
  }
  return band;
}

TEST(MendMesh, NamesPartsThatGiveWayToTheirHulls) {
  TriangleMesh band = moebius_strip();
  band.vertices.row(0).array() += 0.04;
  const RepairedSolid mended = repair_to_solid(joined({box_at({0, 0, 0}, 0.05), band}));
  EXPECT_NE(mended.done.find("part 2 of 2, "), std::string::npos) << mended.done;
  EXPECT_NE(mended.done.find(" mm, replaced by its convex hull"), std::string::npos);
  EXPECT_LT(distance(mended.mesh, {0.04, 0, 0}), 0);
}

// Faces that nothing joins enclose nothing: their hull stands for them.
TEST(MendMesh, FallsBackToTheConvexHull) {
  TriangleMesh faces = loose(box_at({0, 0, 0}), 0);
  for (Eigen::Index t = 0; t < faces.triangles.cols(); ++t)
    for (int k = 0; k < 3; ++k) {
      auto p = faces.vertices.col(3 * t + k);
      p = 0.9 * p + 0.1 * (faces.vertices.middleCols<3>(3 * t).rowwise().mean());
    }
  const RepairedSolid mended = repair_to_solid(faces);
  EXPECT_EQ(mended.done, "replaced by its convex hull");
  EXPECT_GT(enclosed_volume(mended.mesh), 5e-6);
}

TEST(HullMesh, IsTheBoxOfAGridOfPoints) {
  Eigen::Matrix3Xd points(3, 1000);
  for (int i = 0; i < 1000; ++i)
    points.col(i) = Eigen::Vector3i(i % 10, i / 10 % 10, i / 100).cast<double>();
  const TriangleMesh hull = hull_mesh(points / 9);
  EXPECT_NEAR(enclosed_volume(hull), 1, 1e-5);
  EXPECT_TRUE(hull_mesh(Eigen::Matrix3Xd::Zero(3, 10)).empty());
}

TEST(HullMesh, HoldsEveryPoint) {
  const TriangleMesh mug = handled_mug(0.01), hull = hull_mesh(mug.vertices);
  EXPECT_GT(enclosed_volume(hull), enclosed_volume(mug));
  for (Eigen::Index t = 0; t < hull.triangles.cols(); ++t) {
    const Vector3d a = hull.vertices.col(hull.triangles(0, t));
    const Vector3d normal = (hull.vertices.col(hull.triangles(1, t)) - a)
                                .cross(hull.vertices.col(hull.triangles(2, t)) - a)
                                .normalized();
    EXPECT_LT((normal.transpose() * (mug.vertices.colwise() - a)).maxCoeff(), 2e-7);
  }
}

// A face of a box turned takes away twice the pyramid under it: 1/3 of the volume.
TEST(WatertightMesh, TurnsAFaceThatBuildSolidForgives) {
  TriangleMesh box = box_at({0, 0, 0});
  for (Eigen::Index t = 0; t < box.triangles.cols(); ++t) {
    const Eigen::Vector3i corners = box.triangles.col(t);
    const auto z = [&](int k) { return box.vertices(2, corners(k)); };
    if (z(0) > 0 && z(1) > 0 && z(2) > 0) std::swap(box.triangles(0, t), box.triangles(1, t));
  }
  EXPECT_EQ(check_mesh(box).reversed_edges, 4);
  EXPECT_NEAR(check_mesh(box).volume, 8e-6 * 2 / 3, 1e-18);
  const RepairedSolid mended = watertight_mesh(box);
  EXPECT_TRUE(check_mesh(mended.mesh).watertight());
  EXPECT_NEAR(check_mesh(mended.mesh).volume, 8e-6, 1e-18);
  EXPECT_EQ(mended.done, "put right: 4 edge(s) whose triangles face opposite ways");
}

TEST(WatertightMesh, TurnsABoxRightSideOutAndLeavesASoundOne) {
  const RepairedSolid turned = watertight_mesh(inside_out(box_at({0, 0, 0})));
  EXPECT_NEAR(check_mesh(turned.mesh).volume, 8e-6, 1e-18);
  EXPECT_EQ(turned.done, "turned right side out");
  EXPECT_EQ(watertight_mesh(box_at({0, 0, 0})).done, "");
}

TEST(WatertightMesh, ClosesWhatIsOpen) {
  const RepairedSolid mended = watertight_mesh(loose(box_at({0, 0, 0}), 1e-9, 1));
  EXPECT_TRUE(check_mesh(mended.mesh).watertight());
  EXPECT_NEAR(check_mesh(mended.mesh).volume, 8e-6, 1e-12);
}

TEST(MeshReport, TellsOfEightHolesAndCountsTheRest) {
  std::vector<TriangleMesh> open;
  for (int i = 0; i < 10; ++i) {
    open.push_back(box_at({0.1 * i, 0, 0}));
    open.back().triangles = open.back().triangles.leftCols(11).eval();
  }
  const std::string told = describe(check_mesh(joined(open)));
  EXPECT_EQ(told.find("10 hole(s): 3 edges"), 0U);
  EXPECT_EQ(told.substr(told.size() - 11), " and 2 more");
}

class KeptMending : public TemporaryFolder {
 protected:
  void SetUp() override { use_cache({path("cache")}); }
  void TearDown() override { use_cache({}); }

  static bool same(const TriangleMesh& a, const TriangleMesh& b) {
    return bytes_of(a) == bytes_of(b);
  }
};

TEST_F(KeptMending, IsThatOfTheFirstTime) {
  const TriangleMesh open = loose(mug(600), 0, 1);
  use_cache({});
  const RepairedSolid anew = repair_to_solid(open);
  use_cache({path("cache")});
  const RepairedSolid first = repair_to_solid(open), second = repair_to_solid(open);
  EXPECT_NE(anew.done, "");
  EXPECT_EQ(first.done, anew.done);
  EXPECT_EQ(second.done, anew.done);
  EXPECT_TRUE(same(first.mesh, anew.mesh));
  EXPECT_TRUE(same(second.mesh, anew.mesh));
}

TEST_F(KeptMending, IsNotDoneAgainUnlessWhatWasKeptIsBroken) {
  const TriangleMesh open = loose(mug(600), 0, 1);
  const std::string mended = repair_to_solid(open).done;
  store_cached("mended mesh 2", bytes_of(open), "as kept\n" + bytes_of(box_at({0, 0, 0})));
  EXPECT_EQ(repair_to_solid(open).done, "as kept");
  for (const std::string broken : {"", "as kept", "as kept\n", "as kept\nno mesh"}) {
    store_cached("mended mesh 2", bytes_of(open), broken);
    EXPECT_EQ(repair_to_solid(open).done, mended);
  }
}

}  // namespace
}  // namespace thenar
