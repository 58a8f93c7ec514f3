// Tests for api/import.cpp and api/mesh_facts.cpp.

#include "api/import.h"

#include <fstream>

#include <gtest/gtest.h>

#include "base/file_io.h"
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
  EXPECT_EQ(lost_in(found, path("corner.stl")).size(), 1U);
}

TEST_F(ImportMesh, RefusesAMassWithoutAVolume) {
  ImportRequest request = corner(true);
  EXPECT_FALSE(import_file(request).mesh->solid);
  request.mass = 3;
  EXPECT_EQ(message_of([&] { (void)import_file(request); }),
            "'" + request.file +
                "' has no volume that a mass could fill: its surface is open in 1 place; --repair "
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
  EXPECT_EQ(import_file(request).warnings,
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
      import_file(request).warnings,
      (std::vector<std::string>{"1 triangle of fins or sheets that enclose nothing: with them "
                                "the surface has no volume; --repair leaves them out",
                                "1 edge has more than two triangles; --repair mends this"}));
  request.mass = 1;
  EXPECT_EQ(message_of([&] { (void)import_file(request); }),
            "'" + request.file +
                "' has no volume that a mass could fill: 1 triangle of fins or sheets encloses "
                "nothing; --repair leaves them out");
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
                         "than two triangles; --repair mends this");
}

TEST_F(ImportMesh, RefusesUnknownMaterialsAndTwoMasses) {
  ImportRequest request = corner(false);
  request.material = "ruber";
  EXPECT_NE(message_of([&] { (void)import_file(request); }).find("did you mean 'rubber'?"),
            std::string::npos);
  request.material.clear();
  request.mass = request.density = 1;
  EXPECT_EQ(message_of([&] { (void)import_file(request); }), "wanted one of --mass and --density");
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
  EXPECT_EQ(import_file(request).warnings.back(),
            "object 'corner' has no mass: 'plastic' has no density; state --mass or --density");
}

}  // namespace
}  // namespace thenar
