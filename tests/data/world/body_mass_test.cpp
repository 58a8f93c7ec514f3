// Tests for data/io/world/body_mass.cpp.

#include "data/io/world/body_mass.h"

#include <cmath>

#include <gmock/gmock.h>

#include "base/units.h"
#include "tests/data_folder.h"
#include "tests/matrix_near.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

constexpr double kCellError = 0.005;  // of bodies summed up in cells, as documented

BodySpec body_of(ShapeKind kind, const Eigen::Vector3d& size) {
  BodySpec body;
  body.name = "body";
  ShapeSpec shape;
  shape.kind = kind;
  shape.size = size;
  body.shapes = {shape};
  return body;
}

TEST(BodyMass, IsAsStated) {
  BodySpec body = body_of(ShapeKind::kSphere, {1, 0, 0});
  body.mass = BodyMass{2, {1, 2, 3}, Eigen::Matrix3d::Identity()};
  EXPECT_EQ(body_mass(body).mass, 2);
  EXPECT_EQ(body_mass(body).com, Eigen::Vector3d(1, 2, 3));
}

// I = m/12 (b^2 + c^2, ..).
TEST(BodyMass, SpreadsAMassOverABox) {
  BodySpec body = body_of(ShapeKind::kBox, {0.12, 0.06, 0.04});
  body.spread_mass = 0.15;
  body.shapes[0].X_BS.p.x() = 0.1;
  const BodyMass mass = body_mass(body);
  EXPECT_NEAR(mass.mass, 0.15, 1e-15);
  EXPECT_TRUE(matrix_near(mass.com, Eigen::Vector3d(0.1, 0, 0), 1e-15));
  const Eigen::Vector3d moments =
      0.15 / 12 * Eigen::Vector3d(0.0036 + 0.0016, 0.0144 + 0.0016, 0.0144 + 0.0036);
  EXPECT_TRUE(matrix_near(mass.inertia, moments.asDiagonal().toDenseMatrix(), 1e-15));
}

TEST(BodyMass, TakesItsDensityOrItsMaterials) {
  BodySpec body = body_of(ShapeKind::kBox, {0.1, 0.1, 0.1});
  body.material = "felt";
  Materials materials;
  materials.materials = {{"felt", 200, 0, 0}};
  EXPECT_NEAR(body_mass(body, materials).mass, 0.2, 1e-15);
  body.density = 500;
  EXPECT_NEAR(body_mass(body, materials).mass, 0.5, 1e-15);
}

// Disc of radius 12 and blade 8..42 x 8 overlap where x > 8: 4 sqrt(128) + 144 asin(1/3) - 64
// [mm^2] with the first moment (640 - 128/3) / 2 [mm^3].
TEST(BodyMass, CountsOverlappingShapesOnce) {
  const BodySpec key = read_object(kData + "/objects/key.toml");
  const double overlap = 4 * std::sqrt(128.0) + 144 * std::asin(1.0 / 3) - 64;
  const double area = kPi * 144 + 34 * 8 - overlap;
  const double x = (34 * 8 * 25 - (640 - 128.0 / 3) / 2) / area;
  const BodyMass mass = body_mass(key);
  EXPECT_NEAR(mass.mass, 0.009, 1e-15);
  EXPECT_TRUE(matrix_near(mass.com, Eigen::Vector3d(1e-3 * x, 0, 0), kCellError * 0.042));
  BodySpec dense = key;
  dense.spread_mass = 0;
  dense.density = 1e9;  // 1 kg/mm^3
  EXPECT_NEAR(body_mass(dense).mass, area * 2.2, kCellError * area * 2.2);
}

// With equal radii a capsule, whose volume is pi r^2 h + 4/3 pi r^3.
TEST(BodyMass, SumsTaperedCapsules) {
  BodySpec body = body_of(ShapeKind::kTaperedCapsule, {0.01, 0.01, 0.05});
  body.density = 1000;
  const double volume = kPi * 1e-4 * 0.05 + 4 * kPi / 3 * 1e-6;
  EXPECT_NEAR(body_mass(body).mass, 1000 * volume, kCellError * 1000 * volume);
  BodySpec capsule = body_of(ShapeKind::kCapsule, {0.01, 0.05, 0});
  capsule.density = 1000;
  EXPECT_NEAR(body_mass(capsule).mass, 1000 * volume, 1e-12);
  EXPECT_TRUE(matrix_near(body_mass(body).inertia, body_mass(capsule).inertia,
                          2 * kCellError * body_mass(capsule).inertia(0, 0)));
}

TEST(BodyMass, IsRefusedWhereNothingIsKnown) {
  const BodySpec body = body_of(ShapeKind::kSphere, {1, 0, 0});
  EXPECT_EQ(message_of([&] { (void)body_mass(body); }),
            "body 'body' has neither mass nor density, nor has its material '': state mass_g or "
            "density_kg_m3 beside its shapes, in its object file or its [[body]] of the world");
}

// As a box, whichever way its triangles face; with a hole it is no solid.
TEST(BodyMass, OfAMeshDoesNotDependOnWhichWayATriangleFaces) {
  ShapeSpec shape;
  shape.kind = ShapeKind::kMesh;
  shape.mesh = read_object(kData + "/objects/mug.toml").shapes.front().mesh;
  BodySpec body;
  body.name = "mug";
  body.density = 2000;
  body.shapes = {shape};
  const double mass = body_mass(body).mass;
  TriangleMesh& mesh = body.shapes[0].mesh;
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); t += 7)
    std::swap(mesh.triangles(0, t), mesh.triangles(1, t));
  EXPECT_NEAR(body_mass(body).mass, mass, 1e-12 * mass);
  mesh.triangles = mesh.triangles.leftCols(mesh.triangles.cols() - 1).eval();
  EXPECT_THAT(message_of<InputError>([&] { (void)body_mass(body); }), testing::HasSubstr("1 hole"));
}

}  // namespace
}  // namespace thenar
