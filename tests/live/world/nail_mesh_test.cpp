// Tests for live/nail_mesh.cpp.

#include "live/world/nail_mesh.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/units.h"

namespace thenar {
namespace {

/// A flat skin of 20 by 20 mm in cells of 1 mm, at z = 0, outward +z.
TriangleMesh flat_skin() {
  constexpr int kCells = 20;
  TriangleMesh mesh;
  mesh.vertices.resize(3, (kCells + 1) * (kCells + 1));
  mesh.triangles.resize(3, 2 * kCells * kCells);
  for (int i = 0; i <= kCells; ++i)
    for (int j = 0; j <= kCells; ++j)
      mesh.vertices.col(i * (kCells + 1) + j) << 1e-3 * (i - 10), 1e-3 * (j - 10), 0;
  int t = 0;
  for (int i = 0; i < kCells; ++i)
    for (int j = 0; j < kCells; ++j) {
      const int a = i * (kCells + 1) + j, b = a + kCells + 1;
      mesh.triangles.col(t++) << a, b, b + 1;
      mesh.triangles.col(t++) << a, b + 1, a + 1;
    }
  return mesh;
}

SkinPatch oval() {
  SkinPatch patch{
      PatchKind::kNail, {"index", "DP2", 0, {0, 0, 0}, {0, 0, 1}}, {1, 0, 0}, 6e-3, 4e-3};
  return patch;
}

TEST(NailMesh, IsAClosedRimAboveTheOval) {
  const TriangleMesh nail = nail_mesh(flat_skin(), oval());
  double top = 0;
  for (Eigen::Index t = 0; t < nail.triangles.cols(); ++t) {
    const Eigen::Vector3d a = nail.vertices.col(nail.triangles(0, t)),
                          b = nail.vertices.col(nail.triangles(1, t)),
                          c = nail.vertices.col(nail.triangles(2, t));
    const Eigen::Vector3d twice = (b - a).cross(c - a);
    if (std::min({a.z(), b.z(), c.z()}) > kNailHeight / 2) top += twice.z() / 2;
    EXPECT_GE(twice.z(), -1e-18);  // nothing looks into the skin
  }
  // Area of the ellipse, pi a b, within what chords of 1 mm cells cut off.
  EXPECT_NEAR(top, kPi * 6e-3 * 4e-3, 0.01 * kPi * 6e-3 * 4e-3);
  EXPECT_NEAR(nail.vertices.row(2).maxCoeff(), kNailHeight, 1e-15);
  EXPECT_EQ(nail.vertices.row(2).minCoeff(), 0);
  // Open at its foot alone: an edge of one triangle lies on the skin.
  for_each_edge(sides_by_edge(nail), [&](const MeshSide* first, const MeshSide* last) {
    if (last - first != 1) return;
    EXPECT_EQ(nail.vertices(2, first->low), 0);
    EXPECT_EQ(nail.vertices(2, first->high), 0);
  });
}

TEST(NailMesh, WallsLookOutwards) {
  const TriangleMesh nail = nail_mesh(flat_skin(), oval());
  for (Eigen::Index t = 0; t < nail.triangles.cols(); ++t) {
    const Eigen::Vector3d a = nail.vertices.col(nail.triangles(0, t)),
                          b = nail.vertices.col(nail.triangles(1, t)),
                          c = nail.vertices.col(nail.triangles(2, t));
    if (std::max({a.z(), b.z(), c.z()}) == std::min({a.z(), b.z(), c.z()})) continue;
    const Eigen::Vector3d outward((a + b + c).x(), (a + b + c).y(), 0);
    EXPECT_GT((b - a).cross(c - a).dot(outward), 0);
  }
}

TEST(NailMesh, IsEmptyWhereTheSkinIsElsewhere) {
  TriangleMesh skin = flat_skin();
  skin.vertices.row(0).array() += 0.1;
  EXPECT_TRUE(nail_mesh(skin, oval()).empty());
}

}  // namespace
}  // namespace thenar
