// Tests for pad_laws/skin_columns.cpp.

#include "pad_laws/skin_columns.h"

#include <gtest/gtest.h>

namespace thenar {
namespace {

/// A square of 4 mm in the plane z = 0, normal +z.
TriangleMesh square() {
  TriangleMesh mesh;
  mesh.vertices.resize(3, 4);
  mesh.vertices << -2e-3, 2e-3, 2e-3, -2e-3,  //
      -2e-3, -2e-3, 2e-3, 2e-3,               //
      0, 0, 0, 0;
  mesh.triangles.resize(3, 2);
  mesh.triangles << 0, 0,  //
      1, 2,                //
      2, 3;
  return mesh;
}

TEST(SkinColumns, CoverTheAreaOfTheSkin) {
  const FoundationColumns columns = skin_columns(square(), {0, 0, 0}, 3e-3);
  // A piece of sides up to 0.7 mm has less than half of 0.7 mm squared.
  EXPECT_GT(static_cast<double>(columns.area.size()), 16.0 / (0.5 * 0.7 * 0.7));
  EXPECT_NEAR(columns.area.sum(), 16e-6, 1e-15);
  EXPECT_TRUE((columns.thickness.array() == 3e-3).all());
  EXPECT_TRUE((columns.normal.row(2).array() > 1 - 1e-12).all());
}

TEST(SkinColumns, AreNoneOutOfReach) {
  EXPECT_EQ(skin_columns(square(), {0, 0, 0.1}, 3e-3).area.size(), 0);
}

}  // namespace
}  // namespace thenar
