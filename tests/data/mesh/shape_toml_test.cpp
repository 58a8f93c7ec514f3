// Tests for data/io/mesh/shape_toml.cpp and data/io/toml_text.cpp.

#include "data/io/mesh/shape_toml.h"

#include <cmath>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/file_io.h"
#include "base/units.h"
#include "data/io/mesh/mesh_file.h"
#include "data/io/toml_text.h"
#include "tests/data/mesh/cube_files.h"
#include "tests/matrix_near.h"
#include "tests/message_of.h"
#include "tests/temporary_folder.h"

namespace thenar {
namespace {

using testing::HasSubstr;

const std::string kHead = "source = \"Barr1981\"\n";  // any will do

ShapeSpec shape_of(const std::string& keys, const std::string& path = "object.toml") {
  const TomlFile file(kHead + keys, path);
  TomlTable table = file.top();
  return read_shape_table(table, path);
}

std::string refusal(const std::string& keys) {
  return message_of<DataError>([&] { (void)shape_of(keys); });
}

Mat3<double> rotation_of(const std::string& keys) {
  return shape_of("kind = \"sphere\"\nsize_mm = [1]\n" + keys).X_BS.R;
}

std::string written(const ShapeSpec& shape) {
  return fmt::format("{}\n", fmt::join(toml_of(shape), "\n"));
}

TEST(ShapeToml, ReadsSizesInTheirUnits) {
  const ShapeSpec box = shape_of("kind = \"box\"\nsize_mm = [30, 20, 10]\nposition_cm = [0, 0, 1]");
  EXPECT_EQ(box.kind, ShapeKind::kBox);
  EXPECT_TRUE(matrix_near(box.size, Eigen::Vector3d(0.03, 0.02, 0.01), 1e-17));
  EXPECT_TRUE(matrix_near(box.X_BS.p, Eigen::Vector3d(0, 0, 0.01), 1e-17));
}

TEST(ShapeToml, TakesRotationsInFourWays) {
  const Mat3<double> R = rotation_about<double>({0, 0, 1}, kPi / 2);
  for (const char* keys :
       {"rotation = [[0, -1, 0], [1, 0, 0], [0, 0, 1]]", "rpy_deg = [0, 0, 90]",
        "quaternion_wxyz = [0.7071068, 0, 0, 0.7071068]", "axis = [0, 0, 3]\nangle_deg = 90"})
    EXPECT_TRUE(matrix_near(rotation_of(keys), R, 1e-15)) << keys;
}

TEST(ShapeToml, SurvivesToTheBit) {
  ShapeSpec shape;
  shape.kind = ShapeKind::kSuperellipsoid;
  shape.size = Eigen::Vector3d(0.1, 1.0 / 3, 1e-7);
  shape.exponents = Eigen::Vector2d(0.1 + 0.2, 1);
  shape.X_BS = {rotation_about<double>(Eigen::Vector3d(1, 2, 3).normalized(), 0.7),
                Eigen::Vector3d(-0.0, 5e-324, 0.1 * 3)};
  const ShapeSpec again = shape_of(written(shape));
  EXPECT_EQ(again.kind, shape.kind);
  EXPECT_EQ(again.size, shape.size);
  EXPECT_EQ(again.exponents, shape.exponents);
  EXPECT_EQ(again.X_BS.R, shape.X_BS.R);
  EXPECT_EQ(again.X_BS.p, shape.X_BS.p);
  EXPECT_TRUE(std::signbit(again.X_BS.p.x()));
}

TEST(ShapeToml, WritesTrianglesOutWhereThereIsNoFile) {
  ShapeSpec shape;
  shape.kind = ShapeKind::kMesh;
  shape.mesh.vertices = Eigen::Matrix3d::Identity() / 3;
  shape.mesh.triangles = Eigen::Vector3i(2, 0, 1);
  const ShapeSpec again = shape_of(written(shape));
  EXPECT_EQ(again.mesh.vertices, shape.mesh.vertices);
  EXPECT_EQ(again.mesh.triangles, shape.mesh.triangles);
}

class ShapeTomlFile : public TemporaryFolder {};

TEST_F(ShapeTomlFile, FindsMeshesBesideTheFile) {
  write_file(path("meshes/cube.obj"), cube_obj());
  const ShapeSpec shape =
      shape_of("kind = \"mesh\"\nfile = \"meshes/cube.obj\"\nscale = 0.001", path("object.toml"));
  EXPECT_EQ(shape.mesh.vertices.maxCoeff(), 0.002);
  const ShapeSpec again = shape_of(written(shape), path("object.toml"));
  EXPECT_EQ(again.mesh.vertices, shape.mesh.vertices);
  EXPECT_EQ(again.mesh_file, "meshes/cube.obj");
}

TEST(ShapeToml, RefusesWhatIsNoShape) {
  EXPECT_THAT(refusal("kind = \"cone\""), HasSubstr("object.toml:2: wanted 'kind' to be one of"));
  EXPECT_THAT(refusal("kind = \"box\"\nsize_mm = [1, 2]"), HasSubstr(":3: wanted 3 numbers"));
  EXPECT_THAT(refusal("kind = \"sphere\"\nsize_mm = [0]"), HasSubstr(":3: wanted 'size_mm' > 0"));
  EXPECT_THAT(refusal("kind = \"mesh\"\nfile = \"no.obj\""), HasSubstr(":3: there is no mesh"));
  EXPECT_THAT(refusal("kind = \"mesh\"\nfile = \"" + std::string(300, 'a') + ".obj\""),
              HasSubstr(":3: there is no mesh"));
  EXPECT_THAT(refusal("kind = \"mesh\"\nvertices_m = [0, 0, 0]\ntriangles = [0, 0, 1]"),
              HasSubstr(":4: wanted corners 0..0 in 'triangles', got 1"));
  EXPECT_THAT(refusal("kind = \"superellipsoid\"\nsize_mm = [1, 1, 1]\nexponents = [3, 1]"),
              HasSubstr(":4: wanted 'exponents' in 0.1..2"));
  EXPECT_THAT(refusal("kind = \"sphere\"\nsize_mm = [1]\ncolour = 3"), HasSubstr("unknown key"));
}

TEST(ShapeToml, RefusesWhatIsNoRotation) {
  const std::string sphere = "kind = \"sphere\"\nsize_mm = [1]\n";
  EXPECT_THAT(refusal(sphere + "quaternion_wxyz = [1, 1, 0, 0]"), HasSubstr(":4: wanted"));
  EXPECT_THAT(refusal(sphere + "rotation = [[1, 0, 0], [0, 1, 0], [0, 0, -1]]"),
              HasSubstr(":4: wanted 'rotation' as the rows of a rotation"));
  EXPECT_THAT(refusal(sphere + "rpy_deg = [0, 0, 0]\nquaternion_wxyz = [1, 0, 0, 0]"),
              HasSubstr("got several"));
}

TEST(TomlText, QuotesAndEscapes) {
  const std::string text = "a \"b\" \\ \n\t\x01 \xc3\xa4";
  EXPECT_EQ(parse_toml("a = " + toml_quoted(text), "a").find("a")->text, text);
  EXPECT_EQ(toml_keys("A, B"), "[\"A\", \"B\"]");
  EXPECT_EQ(toml_number(3), "3.0");
  EXPECT_EQ(toml_number(-0.0), "-0.0");
  EXPECT_EQ(toml_number(1e300), "1e+300");
  EXPECT_THROW((void)toml_number(NAN), InputError);
}

}  // namespace
}  // namespace thenar
