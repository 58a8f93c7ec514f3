// Tests for how data/io/mesh/ keeps the parts of a file apart and joins corners that rounding
// parted.

#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "base/file_io.h"
#include "base/units.h"
#include "data/io/mesh/mesh_file.h"
#include "data/io/mesh/triangle_soup.h"
#include "geometry/mesh_check.h"
#include "geometry/mesh_parts.h"
#include "geometry/repair_to_solid.h"
#include "geometry/shape_mass.h"
#include "geometry/tessellate.h"
#include "tests/temporary_folder.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

TriangleMesh box_between(const Vector3d& low, const Vector3d& high) {
  TriangleMesh box = box_mesh(high - low);
  box.vertices.colwise() += (low + high) / 2;
  return box;
}

/// Three boxes of a decomposition: neighbours share corners, edges and a part of a face; the last
/// reaches 0.5 into the first. Union 1 + 1 + 1.5 - 0.5 = 3.
std::vector<TriangleMesh> decomposition() {
  return {box_between({0, 0, 0}, {1, 1, 1}), box_between({1, 0, 0}, {2, 1, 1}),
          box_between({0, 0, 0.5}, {1, 1, 2})};
}

std::string obj_of(const std::vector<TriangleMesh>& parts) {
  std::string text;
  int first = 1, number = 0;
  for (const TriangleMesh& part : parts) {
    text += fmt::format("o convex_{}\n", number++);
    for (const auto& p : part.vertices.colwise())
      text += fmt::format("v {} {} {}\n", p.x(), p.y(), p.z());
    for (const auto& t : part.triangles.colwise())
      text += fmt::format("f {} {} {}\n", t.x() + first, t.y() + first, t.z() + first);
    first += static_cast<int>(part.vertices.cols());
  }
  return text;
}

TriangleSoup soup_of(const TriangleMesh& mesh) {
  TriangleSoup soup;
  for (Eigen::Index i = 0; i < mesh.triangles.size(); ++i)
    soup.corners.emplace_back(mesh.vertices.col(mesh.triangles(i)));
  return soup;
}

UnionMass mass_of(const TriangleMesh& mesh) {
  ShapeSpec shape;
  shape.kind = ShapeKind::kMesh;
  shape.mesh = mesh;
  return union_mass({shape});
}

/// The corner of a cube far from the origin whose edges its coordinates hardly tell apart.
TEST(MergeCorners, EndsWhereATriangleIsTinyAndFarAway) {
  const double x = 999999, step = std::nextafter(x, 2 * x) - x;  // 1e-10 m
  const Vector3d a(x, 0, 0), b(x + 10 * step, 0, 0), c(x, 1e-9, 0), d(x, 0, 1e-9);
  const TriangleMesh mesh = weld_vertices({{a, c, b, a, b, d}, {}}, 1, "tiny.obj");
  EXPECT_EQ(mesh.vertices.cols(), 4);
  EXPECT_EQ(mesh.triangles.cols(), 2);
  const Vector3d e(1, 0, 0), f(std::nextafter(1.0, 2.0), 0, 0), g(1, 1e-16, 0);
  EXPECT_EQ(weld_vertices({{e, f, g}, {}}, 1, "tinier.obj").triangles.cols(), 1);
}

// All corners but three lie within 64e-6 of the box from each other, many of them not within 1e-6:
// comparing all with all would take 10^10 comparisons.
TEST(MergeCorners, TakesManyLooseTriangles) {
  std::mt19937 rng(7);
  std::uniform_real_distribution<double> along(0, 64e-6);
  TriangleSoup soup;
  for (int i = 0; i < 3 * 80'000; ++i)
    soup.corners.emplace_back(along(rng), along(rng), along(rng));
  soup.corners.insert(soup.corners.end(), {{0.5, 0, 0}, {0.5, 0.2, 0}, {0.5, 0, 0.2}});
  const TriangleMesh mesh = weld_vertices(soup, 1, "loose.obj");
  EXPECT_GT(mesh.triangles.cols(), 0);
}

class MeshPartsFile : public TemporaryFolder {};

TEST_F(MeshPartsFile, KeepsPartsOfADecompositionApart) {
  write_file(path("parts.obj"), obj_of(decomposition()));
  write_mesh(path("parts.stl"), joined(decomposition()));
  for (const std::string name : {"parts.obj", "parts.stl"}) {
    SCOPED_TRACE(name);
    const TriangleMesh read = read_mesh(path(name));
    EXPECT_TRUE(check_mesh(read).watertight()) << describe(check_mesh(read));
    EXPECT_EQ(solid_parts(read).size(), 3U);
    EXPECT_NEAR(mass_of(read).mass.mass, 3, 1e-12);
    EXPECT_EQ(mass_of(read).error, 0);
  }
}

// What --repair writes is read again: the same triangles, the same parts.
TEST_F(MeshPartsFile, ComesBackFromWhatRepairWrites) {
  write_file(path("parts.obj"), obj_of(decomposition()));
  const RepairedSolid mended = watertight_mesh(read_mesh(path("parts.obj")));
  EXPECT_EQ(mended.done, "");
  for (const std::string name : {"again.obj", "again.stl", "again.ply", "again.off"}) {
    SCOPED_TRACE(name);
    write_mesh(path(name), mended.mesh);
    const TriangleMesh again = read_mesh(path(name));
    ASSERT_EQ(again.triangles.cols(), mended.mesh.triangles.cols());
    for (Eigen::Index i = 0; i < again.triangles.size(); ++i)
      EXPECT_EQ(again.vertices.col(again.triangles(i)),
                mended.mesh.vertices.col(mended.mesh.triangles(i)));
    EXPECT_EQ(solid_parts(again).size(), 3U);
  }
}

// Without numbers of vertices, and triangles of the parts in turns: no run of them is closed.
TEST(MergeCorners, StillJoinsPartsWhoseTrianglesTakeTurns) {
  const TriangleMesh a = box_between({0, 0, 0}, {1, 1, 1}), b = box_between({3, 0, 0}, {4, 1, 1});
  TriangleSoup soup;
  for (Eigen::Index t = 0; t < 12; ++t)
    for (const TriangleMesh* box : {&a, &b})
      for (int k = 0; k < 3; ++k)
        soup.corners.emplace_back(box->vertices.col(box->triangles(k, t)));
  const TriangleMesh merged = weld_vertices(soup, 1, "turns");
  EXPECT_EQ(merged.vertices.cols(), 16);
  EXPECT_EQ(solid_parts(merged).size(), 2U);
}

/// A ball as many programs write it: the seam at 2 pi and the poles computed anew in every face.
TriangleSoup rounded_ball(double radius, int around, int up) {
  TriangleSoup soup;
  const auto at = [&](int i, int j) {
    const double u = 2 * kPi * i / around, v = kPi * j / up;
    return Vector3d(radius * std::sin(v) * std::cos(u), radius * std::sin(v) * std::sin(u),
                    -radius * std::cos(v));
  };
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < up; ++j) {
      const Vector3d a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
      for (const Vector3d& p : {a, b, c, a, c, d}) soup.corners.push_back(p);
    }
  return soup;
}

TEST(MergeCorners, JoinsASeamThatRoundingParted) {
  const TriangleSoup soup = rounded_ball(0.03, 40, 20);
  const TriangleMesh ball = weld_vertices(soup, 1, "ball");
  EXPECT_TRUE(check_mesh(ball).watertight()) << describe(check_mesh(ball));
  EXPECT_EQ(ball.vertices.cols(), 40 * 19 + 2);
  EXPECT_NEAR(mass_of(ball).mass.mass, 4 * kPi / 3 * 2.7e-5, 2e-6);
}

// A gap of 2e-7 of the box between two plates that are closed stays; no corner is moved.
TEST(MergeCorners, LeavesThinFeaturesOfClosedSurfacesAsTheyAre) {
  const TriangleMesh thin = box_between({0, 0, 0}, {1, 1, 2e-7});
  const TriangleMesh alone = weld_vertices(soup_of(thin), 1, "thin");
  EXPECT_EQ(alone.vertices.cols(), 8);
  EXPECT_NEAR(check_mesh(alone).volume, 2e-7, 1e-18);
  const TriangleMesh two = weld_vertices(
      soup_of(
          joined({box_between({0, 0, 0}, {1, 1, 1}), box_between({0, 0, 1 + 2e-7}, {1, 1, 2})})),
      1, "gap");
  EXPECT_EQ(two.vertices.cols(), 16);
  EXPECT_EQ(solid_parts(two).size(), 2U);
}

// Three sheets that would meet in one edge, if it were joined, are left open.
TEST(MergeCorners, PutsNoThirdTriangleOnAnEdge) {
  TriangleSoup fan;
  for (int i = 0; i < 3; ++i) {
    const double u = 2 * kPi * i / 3, off = 1e-8 * i;
    for (const Vector3d& p :
         {Vector3d(off, 0, 0), Vector3d(off, 0, 1), Vector3d(std::cos(u), std::sin(u), 0.5)})
      fan.corners.push_back(p);
  }
  EXPECT_EQ(weld_vertices(fan, 1, "fan").vertices.cols(), 9);
}

}  // namespace
}  // namespace thenar
