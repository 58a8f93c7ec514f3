// Tests for data/io/world/: objects and worlds read, written and refused.

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/file_io.h"
#include "base/units.h"
#include "data/io/world/world.h"
#include "tests/data_folder.h"
#include "tests/matrix_near.h"
#include "tests/message_of.h"
#include "tests/temporary_folder.h"

namespace thenar {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

const std::string kBall = R"(name = "ball"
description = "A ball"
source = "Mine"
material = "wood"
mass_g = 120

[sources]
Mine = "Own measurement, calliper"

[[shape]]
kind = "sphere"
size_mm = [35]
)";

const std::string kTableWorld = R"(name = "table"
source = "Scene"

[sources]
Scene = "Arranged by hand"

[camera]
eye_mm = [300, -400, 250]
target_mm = [0, 0, 50]

[[hand]]
name = "arm"

[[hand]]
name = "gripper"
position_mm = [0, 0, 200]
rpy_deg = [180, 0, 0]
angles_deg = {spread = 90}
ways_mm = {slide = 12}
carrier = "arm"
carrier_link = "flange"

[[body]]
role = "object"
file = "ball.toml"
name = "my_ball"
material = "rubber"
position_mm = [0, 0, 35]

[[body]]
role = "obstacle"
name = "top"
material = "wood"
density_g_cm3 = 0.5
position_mm = [0, 0, -10]
[[body.shape]]
kind = "box"
size_mm = [600, 400, 20]
)";

class World : public TemporaryFolder {
 protected:
  World() { write_file(path("ball.toml"), kBall); }

  [[nodiscard]] WorldSpec parsed(const std::string& text) const {
    return parse_world(text, path("world.toml"));
  }
  /// What is wrong, without the path.
  [[nodiscard]] std::string refusal(const std::string& text) const {
    const std::string message = message_of<DataError>([&] { (void)parsed(text); });
    EXPECT_THAT(message, StartsWith(path("world.toml") + ":"));
    return message.substr(std::min(message.size(), path("world.toml").size() + 1));
  }
};

std::string with_text(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST_F(World, HoldsHandsBodiesAndCamera) {
  const WorldSpec world = parsed(kTableWorld);
  ASSERT_EQ(world.hands.size(), 2U);
  const PlacedHand& gripper = world.hands[1];
  EXPECT_EQ(gripper.carrier_link, "flange");
  EXPECT_DOUBLE_EQ(gripper.posture.at("spread"), kPi / 2);
  EXPECT_DOUBLE_EQ(gripper.posture.at("slide"), 0.012);
  EXPECT_TRUE(
      matrix_near(gripper.X_WH.R, Eigen::Vector3d(1, -1, -1).asDiagonal().toDenseMatrix(), 1e-15));
  ASSERT_EQ(world.bodies.size(), 2U);
  EXPECT_TRUE(world.bodies[0].dynamic);
  EXPECT_EQ(world.bodies[0].body.name, "my_ball");
  EXPECT_EQ(world.bodies[0].body.material, "rubber");
  EXPECT_DOUBLE_EQ(world.bodies[0].body.uniform_mass, 0.12);
  EXPECT_DOUBLE_EQ(world.bodies[0].body.shapes[0].size(0), 0.035);
  EXPECT_FALSE(world.bodies[1].dynamic);
  EXPECT_DOUBLE_EQ(world.bodies[1].body.density, 500);
  EXPECT_DOUBLE_EQ(world.camera.eye.z(), 0.25);
}

void expect_same_bits(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  ASSERT_EQ(a.size(), b.size());
  for (Eigen::Index i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a.data()[i], b.data()[i]);
    EXPECT_EQ(std::signbit(a.data()[i]), std::signbit(b.data()[i]));
  }
}

void expect_same(const BodySpec& a, const BodySpec& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.description, b.description);
  EXPECT_EQ(a.source, b.source);
  EXPECT_EQ(a.material, b.material);
  EXPECT_EQ(a.density, b.density);
  EXPECT_EQ(a.uniform_mass, b.uniform_mass);
  ASSERT_EQ(a.mass.has_value(), b.mass.has_value());
  if (a.mass) {
    EXPECT_EQ(a.mass->mass, b.mass->mass);
    expect_same_bits(a.mass->com, b.mass->com);
    expect_same_bits(a.mass->inertia, b.mass->inertia);
  }
  ASSERT_EQ(a.shapes.size(), b.shapes.size());
  for (std::size_t i = 0; i < a.shapes.size(); ++i) {
    EXPECT_EQ(a.shapes[i].kind, b.shapes[i].kind);
    expect_same_bits(a.shapes[i].size, b.shapes[i].size);
    expect_same_bits(a.shapes[i].X_BS.R, b.shapes[i].X_BS.R);
    expect_same_bits(a.shapes[i].X_BS.p, b.shapes[i].X_BS.p);
  }
}

void expect_same(const WorldSpec& a, const WorldSpec& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.description, b.description);
  EXPECT_EQ(a.source, b.source);
  EXPECT_EQ(a.own_sources, b.own_sources);
  EXPECT_EQ(a.materials_file, b.materials_file);
  expect_same_bits(a.camera.eye, b.camera.eye);
  expect_same_bits(a.camera.target, b.camera.target);
  ASSERT_EQ(a.hands.size(), b.hands.size());
  for (std::size_t i = 0; i < a.hands.size(); ++i) {
    EXPECT_EQ(a.hands[i].name, b.hands[i].name);
    EXPECT_EQ(a.hands[i].file, b.hands[i].file);
    EXPECT_EQ(a.hands[i].posture, b.hands[i].posture);
    EXPECT_EQ(a.hands[i].carrier, b.hands[i].carrier);
    EXPECT_EQ(a.hands[i].carrier_link, b.hands[i].carrier_link);
    expect_same_bits(a.hands[i].X_WH.R, b.hands[i].X_WH.R);
    expect_same_bits(a.hands[i].X_WH.p, b.hands[i].X_WH.p);
  }
  ASSERT_EQ(a.bodies.size(), b.bodies.size());
  for (std::size_t i = 0; i < a.bodies.size(); ++i) {
    EXPECT_EQ(a.bodies[i].file, b.bodies[i].file);
    EXPECT_EQ(a.bodies[i].dynamic, b.bodies[i].dynamic);
    expect_same_bits(a.bodies[i].X_WB.R, b.bodies[i].X_WB.R);
    expect_same_bits(a.bodies[i].X_WB.p, b.bodies[i].X_WB.p);
    expect_same(a.bodies[i].body, b.bodies[i].body);
  }
}

TEST_F(World, ComesBackToTheBit) {
  WorldSpec world = parsed(kTableWorld);
  world.description = "quotes \" and\nlines";
  world.hands[1].X_WH.R = rotation_about<double>(Eigen::Vector3d(1, 2, 3).normalized(), 0.1);
  world.hands[1].posture["finger 1/b"] = 0.1 + 0.2;
  PlacedBody given = world.bodies[1];
  given.body.name = "given";
  given.body.source = "Barr1981, Elsewhere";
  world.own_sources["Elsewhere"] = "A catalogue";
  given.body.density = 0;
  given.body.mass = BodyMass{1.0 / 3, {-0.0, 1e-9, 0.1}, 0.1 * Eigen::Matrix3d::Identity()};
  given.body.shapes[0].X_BS.p.x() = 5e-324;
  world.bodies.push_back(given);
  expect_same(parsed(world_toml(world)), world);
}

TEST_F(World, ThatIsEmptyComesBack) {
  WorldSpec world;
  world.name = "nothing";
  expect_same(parsed(world_toml(world)), world);
}

TEST_F(World, ExplainsKeysOfBodiesThatCameFromElsewhere) {
  WorldSpec world = parsed(kTableWorld);
  world.bodies[1].body.source = "Elsewhere";
  EXPECT_EQ(parsed(world_toml(world)).own_sources.at("Elsewhere"),
            "As the file says that it was read from");
}

TEST_F(World, TakesItsOwnMaterials) {
  write_file(path("own.toml"),
             "source = \"Seo2009\"\n[[friction]]\nbetween = [\"wood\", \"rubber\"]\nstatic = 0.75\n"
             "kinetic = 0.5\n");
  const WorldSpec world =
      parsed(with_text(kTableWorld, "[sources]", "materials = \"own.toml\"\n[sources]"));
  EXPECT_EQ(world.materials.between("wood", "rubber").static_coefficient, 0.75);
  EXPECT_EQ(world.materials.between("wood", "wood").static_coefficient, 0.4);
  EXPECT_EQ(parsed(world_toml(world)).materials.between("rubber", "wood").kinetic_coefficient, 0.5);
}

TEST_F(World, NamesTheLineOfWhatIsWrong) {
  EXPECT_THAT(refusal(with_text(kTableWorld, "ball.toml", "bell.toml")),
              testing::AllOf(StartsWith("25: there is no file '"), HasSubstr("bell.toml'")));
  EXPECT_EQ(refusal(with_text(kTableWorld, "\"object\"", "\"thing\"")),
            "24: wanted 'role' to be one of object, obstacle, got 'thing'");
  EXPECT_THAT(refusal(with_text(kTableWorld, "\"rubber\"", "\"ruber\"")),
              StartsWith("27: no material 'ruber', did you mean 'rubber'?"));
  EXPECT_THAT(refusal(with_text(kTableWorld, "carrier = \"arm\"", "carrier = \"leg\"")),
              HasSubstr("'gripper' is carried by 'leg'"));
  EXPECT_THAT(refusal(with_text(kTableWorld, "name = \"my_ball\"", "name = \"top\"")),
              HasSubstr("two things are called 'top'"));
  EXPECT_THAT(refusal(with_text(kTableWorld, "spread = 90}", "slide = 90}")),
              HasSubstr("coordinate 'slide' is given twice"));
  EXPECT_THAT(refusal(with_text(kTableWorld, "eye_mm", "eyes_mm")), HasSubstr("eye"));
  EXPECT_THAT(refusal(with_text(kTableWorld, "density_g_cm3 = 0.5", "colour = \"red\"")),
              StartsWith("34: unknown key 'colour'"));
}

TEST(Object, ComesBackToTheBit) {
  const BodySpec ball = parse_object(kBall, "ball.toml");
  EXPECT_EQ(ball.source, "Mine");
  expect_same(parse_object(object_toml(ball), "again.toml"), ball);
}

TEST(Object, MayGiveItsPrincipalMomentsAlone) {
  const BodySpec ball =
      parse_object(with_text(kBall, "mass_g = 120",
                             "mass_g = 120\ncom_mm = [0, 0, 1]\ninertia_kg_m2 = [1, 2, 2.5]"),
                   "ball.toml");
  ASSERT_TRUE(ball.mass);
  EXPECT_TRUE(
      matrix_near(ball.mass->inertia, Eigen::Vector3d(1, 2, 2.5).asDiagonal().toDenseMatrix(), 0));
}

TEST(Object, RefusesWhatIsNoBody) {
  const auto refusal = [](const std::string& text) {
    return message_of<DataError>([&] { (void)parse_object(text, "o.toml"); });
  };
  EXPECT_THAT(refusal(with_text(kBall, "mass_g = 120", "mass_g = 120\ndensity_g_cm3 = 1")),
              HasSubstr("o.toml:6: give 'mass' or 'density', not both"));
  EXPECT_THAT(refusal(kBall.substr(0, kBall.find("[[shape]]"))), HasSubstr("needs a shape"));
  // A moment larger than the sum of the others.
  EXPECT_THAT(refusal(with_text(kBall, "mass_g = 120",
                                "mass_g = 120\ncom_mm = [0, 0, 0]\ninertia_kg_m2 = "
                                "[1, 1, 3, 0, 0, 0]")),
              HasSubstr("o.toml:7: no body has the principal moments of inertia 1, 1, 3"));
  EXPECT_THAT(refusal(with_text(kBall, "mass_g = 120", "mass_g = 0")), HasSubstr("o.toml:5: "));
}

}  // namespace
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
  body.uniform_mass = 0.15;
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
  materials.materials = {{"felt", 200, 0, 0, "", ""}};
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
  dense.uniform_mass = 0;
  dense.density = 1e9;  // 1 kg/mm^3
  EXPECT_NEAR(body_mass(dense).mass, area * 2.2, kCellError * area * 2.2);
}

// With equal radii a capsule, whose volume is pi r^2 h + 4/3 pi r^3.
TEST(BodyMass, SumsTaperedCapsules) {
  BodySpec body = body_of(ShapeKind::kTaperedCapsule, {0.01, 0.01, 0.05});
  body.density = 1000;
  const double volume = kPi * 1e-4 * 0.05 + 4 * kPi / 3 * 1e-6;
  EXPECT_NEAR(body_mass(body).mass, 1000 * volume, 1e-12 * 1000 * volume);
  BodySpec capsule = body_of(ShapeKind::kCapsule, {0.01, 0.05, 0});
  capsule.density = 1000;
  EXPECT_NEAR(body_mass(capsule).mass, 1000 * volume, 1e-12);
  EXPECT_TRUE(matrix_near(body_mass(body).inertia, body_mass(capsule).inertia,
                          1e-12 * body_mass(capsule).inertia(0, 0)));
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
