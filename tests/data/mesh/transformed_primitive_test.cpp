// Tests for data/io/mesh/transformed_primitive.cpp, and for exact shapes of VRML and Inventor
// files.

#include "data/io/mesh/transformed_primitive.h"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/file_io.h"
#include "data/io/mesh/mesh_file.h"
#include "data/io/mesh/reader_answer.h"
#include "geometry/mesh_check.h"
#include "tests/data/mesh/cube_files.h"
#include "tests/temporary_folder.h"

namespace thenar {
namespace {

constexpr double kExact = 1e-12;
constexpr double kSingle = 3e-7;  // of a rotation, which Coin keeps in single precision

ShapeSpec solid(ShapeKind kind, const Eigen::Vector3d& size) {
  ShapeSpec shape;
  shape.kind = kind;
  shape.size = size;
  return shape;
}

TEST(ShortestDecimal, IsWhatWasWritten) {
  for (const double value : {0.035, 0.1, 1e-3, 12.5, -0.7071068, 0.0, 1e30, 1234567.0})
    EXPECT_EQ(shortest_decimal(static_cast<float>(value)), value);
  EXPECT_TRUE(std::isnan(shortest_decimal(std::numeric_limits<float>::quiet_NaN())));
}

TEST(PlacedPrimitive, KeepsItsKindUnderWhatKeepsIt) {
  Eigen::Affine3d even = Eigen::Affine3d::Identity();
  even.translate(Eigen::Vector3d(1, 2, 3)).rotate(Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitX()));
  const Eigen::Matrix3d R = even.linear();
  even.scale(2);
  Eigen::Affine3d uneven = even;
  uneven.scale(Eigen::Vector3d(1, 1, 3));

  for (const ShapeSpec& shape :
       {solid(ShapeKind::kSphere, {0.5, 0, 0}), solid(ShapeKind::kCylinder, {0.5, 4, 0}),
        solid(ShapeKind::kBox, {1, 2, 3})}) {
    const auto placed = place_primitive(shape, even);
    ASSERT_TRUE(placed);
    EXPECT_EQ(placed->kind, shape.kind);
    EXPECT_LT((placed->size - 2 * shape.size).norm(), kExact);
    EXPECT_LT((placed->X_BS.R - R).norm(), kExact);
    EXPECT_LT((placed->X_BS.p - Eigen::Vector3d(1, 2, 3)).norm(), kExact);
  }
  EXPECT_FALSE(place_primitive(solid(ShapeKind::kSphere, {0.5, 0, 0}), uneven));
  const auto rod = place_primitive(solid(ShapeKind::kCylinder, {0.5, 4, 0}), uneven);
  ASSERT_TRUE(rod);
  EXPECT_LT((rod->size - Eigen::Vector3d(1, 24, 0)).norm(), kExact);
  const auto box = place_primitive(solid(ShapeKind::kBox, {1, 2, 3}), uneven);
  ASSERT_TRUE(box);
  EXPECT_LT((box->size - Eigen::Vector3d(2, 4, 18)).norm(), kExact);
}

TEST(PlacedPrimitive, IsNoneUnderWhatBendsIt) {
  Eigen::Affine3d across = Eigen::Affine3d::Identity();
  across.scale(Eigen::Vector3d(1.001, 1, 1));
  EXPECT_FALSE(place_primitive(solid(ShapeKind::kCylinder, {1, 2, 0}), across));
  Eigen::Affine3d shear = Eigen::Affine3d::Identity();
  shear.linear()(0, 1) = 1e-4;
  Eigen::Affine3d flat = Eigen::Affine3d::Identity();
  flat.linear()(2, 2) = 0;
  Eigen::Affine3d broken = Eigen::Affine3d::Identity();
  broken.translation().x() = std::numeric_limits<double>::quiet_NaN();
  for (const Eigen::Affine3d& map : {shear, flat, broken})
    for (const ShapeKind kind : {ShapeKind::kSphere, ShapeKind::kCylinder, ShapeKind::kBox})
      EXPECT_FALSE(place_primitive(solid(kind, {1, 1, 1}), map));
  const Eigen::Affine3d still = Eigen::Affine3d::Identity();
  EXPECT_FALSE(place_primitive(solid(ShapeKind::kSphere, {0, 0, 0}), still));
  EXPECT_FALSE(place_primitive(solid(ShapeKind::kBox, {1, -1, 1}), still));
  EXPECT_FALSE(place_primitive(solid(ShapeKind::kMesh, {1, 1, 1}), still));
}

TEST(PlacedPrimitive, IsRightHandedBehindAMirror) {
  Eigen::Affine3d mirror = Eigen::Affine3d::Identity();
  mirror.scale(Eigen::Vector3d(-1, 1, 1));
  const auto box = place_primitive(solid(ShapeKind::kBox, {1, 2, 3}), mirror);
  ASSERT_TRUE(box);
  EXPECT_NEAR(box->X_BS.R.determinant(), 1, kExact);
  EXPECT_EQ(box->size, Eigen::Vector3d(1, 2, 3));
}

// ---- through the answer of the program that reads

TEST(ReaderAnswer, BringsExactShapes) {
  TriangleSoup soup;
  soup.corners.assign(3, {1, 2, 3});
  soup.exact = {solid(ShapeKind::kCylinder, {0.035, 0.2, 0})};
  soup.exact[0].X_BS.p = {1, 2, 3};
  const std::string answer = answer_of(soup);
  const TriangleSoup back = parse_answer(answer, "a.iv");
  ASSERT_EQ(back.exact.size(), 1U);
  EXPECT_EQ(back.exact[0].kind, ShapeKind::kCylinder);
  EXPECT_EQ(back.exact[0].size, soup.exact[0].size);
  EXPECT_EQ(back.exact[0].X_BS.p, soup.exact[0].X_BS.p);
  for (std::size_t i = 0; i < answer.size(); ++i)
    EXPECT_THROW((void)parse_answer(answer.substr(0, i), "a"), DataError);

  // A kind, a size or a rotation that is none.
  soup.exact[0].kind = ShapeKind::kMesh;
  EXPECT_THROW((void)parse_answer(answer_of(soup), "a"), DataError);
  soup.exact[0].kind = ShapeKind::kSphere;
  soup.exact[0].size.x() = -1;
  EXPECT_THROW((void)parse_answer(answer_of(soup), "a"), DataError);
  soup.exact[0].size.x() = 1;
  soup.exact[0].X_BS.R(0, 1) = 1;
  EXPECT_THROW((void)parse_answer(answer_of(soup), "a"), DataError);
}

#ifdef THENAR_HAS_COIN

const std::string kInventor = "#Inventor V2.1 ascii\n", kVrml1 = "#VRML V1.0 ascii\n",
                  kVrml2 = "#VRML V2.0 utf8\n";

class ExactShapes : public TemporaryFolder {
 protected:
  [[nodiscard]] std::vector<ShapeSpec> shapes(const std::string& content, double scale = 1) const {
    const std::string file = path(content.compare(0, 2, "#I") == 0 ? "a.iv" : "a.wrl");
    write_file(file, content);
    return read_mesh_content(file, scale).exact;
  }

  void expect_one(const std::string& content, ShapeKind kind, const Eigen::Vector3d& size,
                  const Eigen::Vector3d& p = {0, 0, 0}) const {
    SCOPED_TRACE(content);
    const std::vector<ShapeSpec> found = shapes(content);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].kind, kind);
    EXPECT_LT((found[0].size - size).norm(), kExact);
    EXPECT_LT((found[0].X_BS.p - p).norm(), kExact);
  }
};

TEST_F(ExactShapes, AreThoseOfInventorAndVrml) {
  for (const std::string& head : {kInventor, kVrml1}) {
    expect_one(head + "Sphere { radius 0.035 }", ShapeKind::kSphere, {0.035, 0, 0});
    expect_one(head + "Cube { width 0.1 height 0.2 depth 0.3 }", ShapeKind::kBox, {0.1, 0.2, 0.3});
    expect_one(head + "Cylinder { radius 0.035 height 0.11 }", ShapeKind::kCylinder,
               {0.035, 0.11, 0});
    // Their defaults.
    expect_one(head + "Separator { Sphere {} }", ShapeKind::kSphere, {1, 0, 0});
    expect_one(head + "Cylinder {}", ShapeKind::kCylinder, {1, 2, 0});
  }
  const auto shape = [](const std::string& node) {
    return kVrml2 + "Shape { geometry " + node + " }";
  };
  expect_one(shape("Sphere { radius 0.035 }"), ShapeKind::kSphere, {0.035, 0, 0});
  expect_one(shape("Box { size 0.1 0.2 0.3 }"), ShapeKind::kBox, {0.1, 0.2, 0.3});
  expect_one(shape("Cylinder { radius 0.035 height 0.11 }"), ShapeKind::kCylinder,
             {0.035, 0.11, 0});
}

TEST_F(ExactShapes, StandWhereTransformsPutThem) {
  const std::string move = "Translation { translation 0.1 0.2 0.3 } ";
  const std::string shrink = "Scale { scaleFactor 0.001 0.001 0.001 } ";
  expect_one(kInventor + "Separator { " + move + shrink + move + "Sphere { radius 35 } }",
             ShapeKind::kSphere, {0.035, 0, 0}, {0.1001, 0.2002, 0.3003});
  // What stands in a separator moves nothing behind it; a group's does.
  expect_one(kVrml1 + "Separator { Separator { " + move + "} Group { " + move + "} Sphere {} }",
             ShapeKind::kSphere, {1, 0, 0}, {0.1, 0.2, 0.3});
  expect_one(
      kInventor + "TransformSeparator { " + move + "} Transform { translation 1 0 0 } Cube{}",
      ShapeKind::kBox, {2, 2, 2}, {1, 0, 0});
  expect_one(kInventor + "MatrixTransform { matrix 0 2 0 0  -2 0 0 0  0 0 2 0  1 2 3 1 } Sphere {}",
             ShapeKind::kSphere, {2, 0, 0}, {1, 2, 3});
  expect_one(kVrml2 +
                 "Transform { translation 0.1 0 0 center 1 0 0 scale 0.5 0.5 0.5 children "
                 "Transform { translation 0 0.2 0 children Shape { geometry Sphere {} } } }",
             ShapeKind::kSphere, {0.5, 0, 0}, {0.6, 0.1, 0});
  expect_one(kInventor + "Transform { scaleFactor 1 2 3 } Cube { width 0.1 }", ShapeKind::kBox,
             {0.1, 4, 6});
}

TEST_F(ExactShapes, HaveCylindersAlongTheirY) {
  const auto axis = [&](const std::string& content) -> Eigen::Vector3d {
    const std::vector<ShapeSpec> found = shapes(content);
    return found.size() == 1 ? found[0].X_BS.R.col(2).eval() : Eigen::Vector3d::Zero().eval();
  };
  const std::string rod = "Cylinder { radius 1 height 5 }";
  EXPECT_LT((axis(kInventor + rod) - Eigen::Vector3d::UnitY()).norm(), kExact);
  // y turned by the angle a about x: (0, cos a, sin a).
  const Eigen::Vector3d turned(0, std::cos(0.4), std::sin(0.4));
  EXPECT_LT((axis(kInventor + "RotationXYZ { axis X angle 0.4 }" + rod) - turned).norm(), kExact);
  EXPECT_LT((axis(kVrml1 + "Rotation { rotation 1 0 0 0.4 }" + rod) - turned).norm(), kSingle);
  EXPECT_LT(
      (axis(kVrml2 + "Transform { rotation 1 0 0 0.4 children Shape { geometry " + rod + "} }") -
       turned)
          .norm(),
      kSingle);
}

// The triangles of Coin are inscribed: each corner lies on the solid that stands for them.
TEST_F(ExactShapes, HoldTheCornersOfTheirTriangles) {
  const std::string file = path("a.iv");
  write_file(file, kInventor +
                       "Transform { translation 1 2 3 rotation 1 2 3 0.7 center 0.5 0 0 "
                       "scaleFactor 2 3 2 scaleOrientation 0 1 0 0.3 }\nCylinder { height 5 }");
  const MeshContent content = read_mesh_content(file, 0.01);
  ASSERT_EQ(content.exact.size(), 1U);
  const ShapeSpec& rod = content.exact[0];
  EXPECT_LT((rod.size - Eigen::Vector3d(0.02, 0.15, 0)).norm(), 1e-8);
  for (Eigen::Index i = 0; i < content.mesh.vertices.cols(); ++i) {
    const Eigen::Vector3d q = rod.X_BS.inverse() * content.mesh.vertices.col(i).eval();
    EXPECT_NEAR(std::abs(q.z()), 0.075, 1e-7);
    const double r = q.head<2>().norm();
    EXPECT_LT(std::min(r, std::abs(r - 0.02)), 1e-7);
  }
}

TEST_F(ExactShapes, AreAllThatAFileHolds) {
  const std::string ball = "Separator { Translation { translation 3 0 0 } Sphere {} }\n";
  const std::vector<ShapeSpec> found = shapes(kInventor + ball + "Cube {}", 0.01);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].X_BS.p, Eigen::Vector3d(0.03, 0, 0));
  EXPECT_EQ(found[1].size, Eigen::Vector3d(0.02, 0.02, 0.02));
  // A node that is used twice is two, lines are nothing.
  EXPECT_EQ(shapes(kVrml1 + "DEF A " + ball + "Translation { translation 0 5 0 } USE A").size(),
            2U);
  EXPECT_EQ(shapes(kInventor + "Sphere {} Coordinate3 { point [0 0 0, 1 0 0] } LineSet {}").size(),
            1U);
}

TEST_F(ExactShapes, AreNoneBesideAnythingElse) {
  const std::string ball = "\nSphere { radius 0.1 }";
  for (const std::string& content :
       {kInventor + "Transform { scaleFactor 1 1 1.01 }" + ball, kInventor + "Cone {}",
        kInventor + "Separator { Cone {} }" + ball, kInventor + "Cylinder { parts SIDES }",
        kVrml2 + "Shape { geometry Cylinder { top FALSE } }",
        kVrml2 + "Transform { scale 1 2 1 children Shape { geometry Sphere {} } }",
        kInventor + "Transform { scaleFactor 2 1 1 scaleOrientation 0 0 1 0.5 } Cube {}",
        kInventor + "Units { units MILLIMETERS }" + ball, cube_vrml1() + ball,
        cube_vrml1(kInventor) + ball, cube_vrml2() + "\nShape { geometry Sphere {} }"}) {
    SCOPED_TRACE(content);
    EXPECT_TRUE(shapes(content).empty());
    EXPECT_GT(read_mesh(path(content.compare(0, 2, "#I") == 0 ? "a.iv" : "a.wrl")).triangles.cols(),
              0);
  }
  std::string many = kInventor;
  for (int i = 0; i < 65; ++i) many += "Translation { translation 3 0 0 } Cube {}\n";
  EXPECT_TRUE(shapes(many).empty());
}

#endif

}  // namespace
}  // namespace thenar
