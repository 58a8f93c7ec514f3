// Tests for data/io/mesh/repair_shape.cpp.

#include "data/io/mesh/repair_shape.h"

#include <gmock/gmock.h>

#include "geometry/shape_mass.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Corner tetrahedron of edge a, without its last `missing` faces; its volume is a^3 / 6.
ShapeSpec tetrahedron(double a, int missing) {
  ShapeSpec shape;
  shape.kind = ShapeKind::kMesh;
  shape.mesh.vertices.resize(3, 4);
  shape.mesh.vertices << 0, a, 0, 0, 0, 0, a, 0, 0, 0, 0, a;
  Eigen::Matrix3Xi faces(3, 4);
  faces << 0, 0, 0, 1, 2, 1, 3, 2, 1, 3, 2, 3;
  shape.mesh.triangles = faces.leftCols(4 - missing);
  shape.mesh_file = "/somewhere/tip.stl";
  return shape;
}

TEST(RepairShape, LeavesSolidsAlone) {
  ShapeSpec shape = tetrahedron(0.1, 0);
  std::vector<std::string> warnings;
  EXPECT_TRUE(repair_shape(shape, "link 'tip'", warnings));
  EXPECT_THAT(warnings, IsEmpty());
  EXPECT_EQ(shape.mesh_file, "/somewhere/tip.stl");
  EXPECT_NO_THROW(require_solid(shape, "link 'tip'"));
}

TEST(RepairShape, ClosesAMissingFaceAndSaysSo) {
  ShapeSpec shape = tetrahedron(0.1, 1);
  EXPECT_THAT(message_of([&] { require_solid(shape, "link 'tip'"); }),
              HasSubstr("mesh 'tip.stl' of link 'tip'"));
  std::vector<std::string> warnings;
  EXPECT_TRUE(repair_shape(shape, "link 'tip'", warnings));
  EXPECT_THAT(warnings, ElementsAre(HasSubstr("MENDED mesh 'tip.stl' of link 'tip'")));
  EXPECT_NEAR(mass_at_unit_density(shape).mass, 1e-3 / 6, 1e-15);
  EXPECT_EQ(shape.mesh_file, "");  // no longer what the file holds
}

TEST(RepairShape, LeavesOutWhatIsFlat) {
  // One triangle: the hull of its corners has no volume.
  ShapeSpec flat = tetrahedron(0.1, 3), ball;
  flat.mesh.vertices.conservativeResize(3, 3);
  ball.size.x() = 0.01;
  std::vector<ShapeSpec> shapes{flat, ball};
  std::vector<std::string> warnings;
  repair_shapes(shapes, "link 'tip'", warnings);
  ASSERT_EQ(shapes.size(), 1U);
  EXPECT_EQ(shapes[0].kind, ShapeKind::kSphere);
  EXPECT_THAT(warnings, ElementsAre(HasSubstr("LEFT OUT mesh 'tip.stl' of link 'tip'")));
}

}  // namespace
}  // namespace thenar
