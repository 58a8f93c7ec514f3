// Tests for data/io/mesh/stl_copy.cpp.

#include "data/io/mesh/stl_copy.h"

#include <gmock/gmock.h>

#include "geometry/mesh_parts.h"
#include "geometry/tessellate.h"

namespace thenar {
namespace {

ShapeSpec shape_of(const TriangleMesh& mesh, const std::string& file = "") {
  ShapeSpec shape;
  shape.kind = ShapeKind::kMesh;
  shape.mesh = mesh;
  shape.mesh_file = file;
  return shape;
}

TriangleMesh moved_box(double x, double edge = 0.02) {
  TriangleMesh box = box_mesh(Eigen::Vector3d::Constant(edge));
  box.vertices.row(0).array() += x;
  return box;
}

TEST(StlCopy, KeepsPartsThatTouchApart) {
  const TriangleMesh touching = joined({moved_box(0), moved_box(0.02), moved_box(0.04)});
  EXPECT_EQ(solid_parts(as_in_stl(touching)).size(), 3U);
}

TEST(StlCopy, NamesFilesByOwnerAndWritesOverNoneThatIsNamed) {
  std::vector<ShapeSpec> shapes{shape_of(moved_box(0), "hand_left_palm_0.stl"),
                                shape_of(moved_box(1)), shape_of(moved_box(2))};
  ShapeSpec ball;
  ball.size.x() = 0.01;
  shapes.push_back(ball);
  StlFiles made("/there/hand.toml");
  made.leave(shapes);
  made.give(shapes, "left/palm");
  const auto& files = made.files();
  ASSERT_EQ(files.size(), 2U);
  EXPECT_EQ(files[0].first, "/there/hand_left_palm_1.stl");
  EXPECT_EQ(files[1].first, "/there/hand_left_palm_2.stl");
  EXPECT_EQ(shapes[1].mesh_file, "hand_left_palm_1.stl");
  EXPECT_EQ(files[0].second.size(), 84U + 12 * 50);  // header, and fifty bytes a triangle
  EXPECT_TRUE(shapes[3].mesh_file.empty());
}

// A plate of 1e-9 m at 1 m: in single precision both of its sides are one.
TEST(StlCopy, LeavesTrianglesWhereSinglePrecisionWouldLoseTheSolid) {
  TriangleMesh thin = box_mesh({0.02, 0.02, 1e-9});
  thin.vertices.row(2).array() += 1;
  std::vector<ShapeSpec> shapes{shape_of(thin)};
  StlFiles made("/there/hand.toml");
  made.give(shapes, "tip");
  EXPECT_TRUE(made.files().empty());
  EXPECT_TRUE(shapes[0].mesh_file.empty());
}

}  // namespace
}  // namespace thenar
