// Tests for api/import.cpp and api/mesh_facts.cpp.

#include "api/import.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "api/validate.h"
#include "base/file_io.h"
#include "base/units.h"
#include "data/io/robot/import_robot.h"
#include "geometry/mesh_check.h"
#include "geometry/tessellate.h"
#include "tests/message_of.h"
#include "tests/temporary_folder.h"

namespace thenar {
namespace {

/// The corner of a unit cube cut off: volume 1/6, centroid (1/4, 1/4, 1/4). Without its slanted
/// face it is open.
class ImportMesh : public TemporaryFolder {
 protected:
  ImportRequest corner(bool open) {
    ImportRequest request;
    request.file = path(open ? "open.off" : "corner.off");
    write_file(request.file, std::string("OFF\n4 ") + (open ? "3" : "4") +
                                 " 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n" +
                                 (open ? "" : "3 1 2 3\n"));
    return request;
  }
};

TEST_F(ImportMesh, SpreadsAMassOverTheVolume) {
  ImportRequest request = corner(false);
  request.mass = 3;
  request.material = "rubber";
  const Imported found = import_file(request);
  ASSERT_TRUE(found.body && found.body->mass);
  EXPECT_DOUBLE_EQ(found.body->mass->mass, 3);
  EXPECT_NEAR((found.body->mass->com - Eigen::Vector3d::Constant(0.25)).norm(), 0, 1e-12);
  // About the centroid of this corner  I_xx = m (3/40),  I_xy = m / 80.
  EXPECT_NEAR(found.body->mass->inertia(0, 0), 3 * 3.0 / 40, 1e-12);
  EXPECT_NEAR(found.body->mass->inertia(0, 1), 3 * 1.0 / 80, 1e-12);
  EXPECT_EQ(found.body->material, "rubber");
}

TEST_F(ImportMesh, WeighsByDensity) {
  ImportRequest request = corner(false);
  request.density = 600;
  EXPECT_NEAR(import_file(request).body->mass->mass, 100, 1e-9);  // 600 kg/m^3 of 1/6 m^3
}

TEST_F(ImportMesh, WritesWhatWasStated) {
  ImportRequest request = corner(false);
  request.mass = 3;
  const Imported found = import_file(request);
  EXPECT_TRUE(write_imported(found, path("corner.toml")).empty());
  const BodySpec back = read_object(path("corner.toml"));
  ASSERT_TRUE(back.mass.has_value());
  EXPECT_DOUBLE_EQ(back.mass->mass, 3);
  EXPECT_EQ(unsupported_properties(found, path("corner.stl")).size(), 1U);
}

TEST_F(ImportMesh, RefusesAMassWithoutAVolume) {
  ImportRequest request = corner(true);
  EXPECT_FALSE(import_file(request).mesh->solid);
  request.mass = 3;
  EXPECT_EQ(message_of([&] { (void)import_file(request); }),
            "'" + request.file +
                "' has no volume that a mass could fill: its surface is open in 1 place; repairing "
                "closes it");
  request.repair = true;
  EXPECT_DOUBLE_EQ(import_file(request).body->mass->mass, 3);
}

// A square has no thickness that a repair could find, and a closed corner with a fin is not open.
TEST_F(ImportMesh, SaysWhatIsWrongRatherThanThatItIsOpen) {
  std::ofstream(path("flat.obj")) << "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n";
  std::ofstream(path("fin.obj")) << "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 1 1 1\n"
                                    "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\nf 2 3 5\n";
  ImportRequest request;
  request.file = path("flat.obj");
  EXPECT_EQ(import_file(request).outcome.warnings,
            std::vector<std::string>{"the surface is flat: all its triangles lie in one plane, so "
                                     "that it has no volume, and no repair gives it one"});
  request.repair = true;
  EXPECT_EQ(message_of([&] { (void)import_file(request); }),
            "'" + request.file +
                "': the mesh is flat: all its triangles lie in one plane, and no repair gives it a "
                "thickness");
  request = {};
  request.file = path("fin.obj");
  EXPECT_EQ(
      import_file(request).outcome.warnings,
      (std::vector<std::string>{"1 triangle of fins or sheets that enclose nothing: with them "
                                "the surface has no volume; repairing leaves them out",
                                "1 edge has more than two triangles; repairing mends this"}));
  request.mass = 1;
  EXPECT_EQ(message_of([&] { (void)import_file(request); }),
            "'" + request.file +
                "' has no volume that a mass could fill: 1 triangle of fins or sheets encloses "
                "nothing; repairing leaves them out");
  request.repair = true;
  EXPECT_NEAR(import_file(request).body->mass->mass, 1, 1e-12);
}

// Two tetrahedra on either side of a triangle that is there twice: its edges have four triangles.
TEST_F(ImportMesh, SaysWhichEdgesLeaveNoVolume) {
  std::ofstream(path("twin.obj")) << "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 0 -1\n"
                                     "f 1 2 3\nf 1 4 2\nf 2 4 3\nf 3 4 1\n"
                                     "f 1 2 5\nf 2 3 5\nf 3 1 5\n";
  ImportRequest request;
  request.file = path("twin.obj");
  request.mass = 3;
  const std::string message = message_of([&] { (void)import_file(request); });
  EXPECT_EQ(message, "'" + request.file +
                         "' has no volume that a mass could fill: 3 edges of its surface have more "
                         "than two triangles; repairing mends this");
}

TEST_F(ImportMesh, RefusesUnknownMaterialsAndTwoMasses) {
  ImportRequest request = corner(false);
  request.material = "ruber";
  EXPECT_NE(message_of([&] { (void)import_file(request); }).find("did you mean 'rubber'?"),
            std::string::npos);
  request.material.clear();
  request.mass = request.density = 1;
  EXPECT_EQ(message_of([&] { (void)import_file(request); }),
            "wanted a mass or a density, got both");
}

/// A robot of one link with the meshes of some files.
class ImportRobot : public TemporaryFolder {
 protected:
  [[nodiscard]] Imported robot(const std::vector<std::string>& meshes) const {
    std::string text =
        "<robot name='r'><link name='palm'><inertial><mass value='1'/><inertia ixx='1' iyy='1' "
        "izz='1' ixy='0' ixz='0' iyz='0'/></inertial>";
    for (const std::string& mesh : meshes)
      text += "<collision><geometry><mesh filename='" + mesh + "'/></geometry></collision>";
    ImportRequest request;
    request.file = path("r.urdf");
    write_file(request.file, text + "</link></robot>");
    return import_file(request);
  }
  /// A unit cube's corner cut off, sound or open.
  void write_corner(const std::string& name, bool open) const {
    write_file(path(name), std::string("OFF\n4 ") + (open ? "3" : "4") +
                               " 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n" +
                               (open ? "" : "3 1 2 3\n"));
  }
};

TEST_F(ImportRobot, WritesMendedMeshesBesideTheFileAsStl) {
  write_corner("open.off", true);
  write_corner("whole.off", false);
  const Imported found = robot({"open.off", "whole.off"});
  (void)write_imported(found, path("hand.toml"));
  const std::string text = read_text_file(path("hand.toml"));
  EXPECT_NE(text.find("file = \"hand_palm_0.stl\""), std::string::npos);
  EXPECT_NE(text.find("file = \"whole.off\""), std::string::npos);
  EXPECT_EQ(text.find("vertices"), std::string::npos);
  // As it was: corners of 0 and 1, and a third, in single precision.
  ImportRequest again;
  again.file = path("hand.toml");
  const auto& before = std::get<RobotSpec>(found.thing).links[0].shapes;
  const Imported back = import_file(again);
  const auto& after = std::get<RobotSpec>(back.thing).links[0].shapes;
  ASSERT_EQ(after.size(), 2U);
  EXPECT_NEAR(check_mesh(after[0].mesh).volume, check_mesh(before[0].mesh).volume, 1e-7);
  EXPECT_NEAR(check_mesh(after[0].mesh).volume, 1.0 / 6, 1e-7);
}

TEST_F(ImportRobot, WritesOverNoMeshThatItNames) {
  write_corner("open.off", true);
  write_mesh(path("hand_palm_0.stl"), box_mesh({1, 1, 1}));
  const std::string before = read_text_file(path("hand_palm_0.stl"));
  (void)write_imported(robot({"open.off", "hand_palm_0.stl"}), path("hand.toml"));
  EXPECT_EQ(read_text_file(path("hand_palm_0.stl")), before);
  EXPECT_TRUE(std::filesystem::exists(path("hand_palm_1.stl")));
}

// A band that turns over once, of eight corners: no repair closes it.
TEST_F(ImportRobot, NamesHullsAlsoWhenItsFileIsValidated) {
  std::string obj;
  for (int i = 0; i < 8; ++i) {
    const double angle = kPi / 4 * i, up = 0.3 * std::sin(angle / 2);
    const double in = 1 - 0.3 * std::cos(angle / 2), out = 1 + 0.3 * std::cos(angle / 2);
    obj += fmt::format("v {0} {1} {2}\nv {3} {4} {5}\n", out * std::cos(angle),
                       out * std::sin(angle), up, in * std::cos(angle), in * std::sin(angle), -up);
  }
  for (int i = 0; i < 8; ++i) {
    const int a = 2 * i + 1, c = i < 7 ? a + 2 : 2, d = i < 7 ? a + 3 : 1;
    obj += fmt::format("f {0} {1} {3}\nf {0} {3} {2}\n", a, a + 1, c, d);
  }
  write_file(path("band.obj"), obj);
  const Imported found = robot({"band.obj"});
  const auto told = [](const std::vector<std::string>& warnings) {
    return std::any_of(warnings.begin(), warnings.end(), [](const std::string& warning) {
      return warning.find("MENDED mesh 'band.obj' of link 'palm'") == 0 &&
             warning.find("convex hull") != std::string::npos;
    });
  };
  EXPECT_TRUE(told(found.outcome.warnings));
  (void)write_imported(found, path("hand.toml"));
  ValidateRequest request;
  request.things = {path("hand.toml")};
  const FileVerdict verdict = validate(request).files.front();
  EXPECT_TRUE(verdict.valid()) << verdict.error;
  EXPECT_TRUE(told(verdict.warnings));
}

TEST(SizeWarnings, DoubtsABoxOfHouses) {
  ShapeSpec box;
  box.kind = ShapeKind::kBox;
  box.size = {120, 60, 40};
  EXPECT_EQ(size_warnings({box}, "object 'tea'"),
            std::vector<std::string>{"object 'tea': a box of 120 m: are its numbers millimetres?"});
  box.size /= 1000;
  EXPECT_TRUE(size_warnings({box}, "object 'tea'").empty());
}

// A cube of 10 mm, 1 cm3: its grams are its g/cm3.
TEST(DensityWarnings, DoubtGramsForKilograms) {
  BodySpec cube;
  ShapeSpec box;
  box.kind = ShapeKind::kBox;
  box.size = {0.01, 0.01, 0.01};
  cube.shapes = {box};
  const auto words = [&](double mass) {
    cube.uniform_mass = mass;
    return density_warnings(cube, "object 'die'");
  };
  EXPECT_TRUE(words(0.0011).empty());
  EXPECT_TRUE(words(0.0226).empty());  // osmium
  EXPECT_EQ(words(1.1),
            std::vector<std::string>{
                "object 'die': 1100 g/cm3: is its mass or its size in another unit (grams)?"});
  EXPECT_EQ(words(5e-6),
            std::vector<std::string>{
                "object 'die': 0.005 g/cm3: is its mass or its size in another unit?"});
}

TEST_F(ImportMesh, WarnsOfAMaterialWithoutDensity) {
  ImportRequest request = corner(false);
  request.material = "plastic";
  EXPECT_EQ(import_file(request).outcome.warnings.back(),
            "object 'corner' has no mass: 'plastic' has no density; wanted a mass or a density");
}

/// A jaw of 80 mm stroke on a palm that carries a fixed one, or none; it closes downwards.
std::string one_jaw_urdf(bool fixed_jaw) {
  const auto box = [](const char* size, const char* at) {
    return fmt::format(
        R"(<collision><origin xyz="{}"/><geometry><box size="{}"/></geometry></collision>)", at,
        size);
  };
  return fmt::format(
      R"(<robot name="jaw"><link name="palm">{}{}</link><link name="mobile">{}</link>)"
      R"(<joint name="slide" type="prismatic"><parent link="palm"/><child link="mobile"/>)"
      R"(<axis xyz="0 1 0"/><limit lower="0" upper="0.08" effort="40" velocity="0.1"/></joint>)"
      R"(</robot>)",
      box("0.04 0.11 0.04", "0 0.02 -0.02"),
      fixed_jaw ? box("0.02 0.01 0.06", "0 -0.005 0.03") : "",
      box("0.02 0.01 0.06", "0 0.005 0.03"));
}

class ImportOneJaw : public TemporaryFolder {
 protected:
  std::vector<std::string> write(bool fixed_jaw) {
    write_file(path("jaw.urdf"), one_jaw_urdf(fixed_jaw));
    ImportRequest request;
    request.file = path("jaw.urdf");
    return write_imported(import_file(request), path("jaw.toml"));
  }
};

TEST_F(ImportOneJaw, WritesThatItClosesOnTheFixedOne) {
  (void)write(true);
  const RobotSpec jaw = import_robot(path("jaw.toml"));
  EXPECT_TRUE(jaw.closing_stated);
  EXPECT_LT(jaw.dofs.at(0).speed, 0);
  // Objects come along both jaws, on the side of the fixed one that the other closes on.
  EXPECT_NEAR(jaw.approach.direction.z(), 1, 1e-9);
  EXPECT_GT(jaw.approach.point.y(), 0);
}

TEST_F(ImportOneJaw, SaysThatNothingFixedHoldsAgainstIt) {
  EXPECT_THAT(write(false), testing::Contains(testing::HasSubstr("holds no ball")));
  EXPECT_FALSE(import_robot(path("jaw.toml")).closing_stated);
}

}  // namespace
}  // namespace thenar
