// Tests for data/io/mesh/: one cube through every format, round trips, and what is refused.

#include "data/io/mesh/mesh_file.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <functional>
#include <limits>
#include <sstream>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/file_io.h"
#include "tests/data/mesh/cube_files.h"
#include "tests/data/mesh/mesh_sums.h"
#include "tests/matrix_near.h"
#include "tests/message_of.h"
#include "tests/temporary_folder.h"

namespace thenar {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

class MeshFile : public TemporaryFolder {
 protected:
  [[nodiscard]] std::string written(const std::string& name, const std::string& content) const {
    write_file(path(name), content);
    return path(name);
  }

  [[nodiscard]] std::string refusal(const std::string& name, const std::string& content) const {
    const std::string file = written(name, content);
    const std::string message = message_of<DataError>([&] { (void)read_mesh(file); });
    EXPECT_THAT(message, StartsWith(file + ":"));
    return message.substr(std::min(message.size(), file.size() + 1));
  }

  /// A cube of edge 2 whose least corner stands at (x, 0, 0), read in metres.
  void expect_cube(const std::string& name, const std::string& content, double x = 0) const {
    SCOPED_TRACE(name);
    const TriangleMesh mesh = read_mesh(written(name, content));
    EXPECT_EQ(mesh.vertices.cols(), 8);
    EXPECT_EQ(mesh.triangles.cols(), 12);
    EXPECT_TRUE(matrix_near(mesh.vertices.rowwise().minCoeff(), Eigen::Vector3d(x, 0, 0), 0));
    EXPECT_TRUE(matrix_near(mesh.vertices.rowwise().maxCoeff(), Eigen::Vector3d(x + 2, 2, 2), 0));
    EXPECT_DOUBLE_EQ(enclosed_volume(mesh), 8);
  }
};

TEST_F(MeshFile, ReadsACubeInEveryFormat) {
  expect_cube("cube.obj", cube_obj());
  expect_cube("cube.off", cube_off());
  expect_cube("cube.ply", cube_ply());
  expect_cube("binary.ply", cube_binary_ply());
  expect_cube("cube.stl", cube_stl());
  expect_cube("binary.STL", cube_binary_stl());
}

TEST_F(MeshFile, PlacesTheCubeByTheSceneGraph) { expect_cube("cube.gltf", cube_gltf(), 10); }

// Collada's half metres become metres, and its z stays z.
TEST_F(MeshFile, ReadsColladaAsRosDoes) { expect_cube("cube.DAE", cube_collada(), 10); }

// assimp would read on for ever at what is no digit, and anywhere beyond an array.
TEST_F(MeshFile, NamesTheLineOfABrokenCollada) {
  std::string text = cube_collada();
  text.replace(text.find("<p>0"), 4, "<p>\nx");
  EXPECT_EQ(refusal("cube.dae", text), "2: wanted whole numbers in <p>, got 'x'");
  text = cube_collada();
  text.replace(text.find("count='24'"), 10, "count='23'");
  EXPECT_EQ(refusal("cube.dae", text), "2: <accessor> reaches to 24 of 23 numbers in '#a'");
}

// Corners of three numbers between others: the last of them ends before the next would begin.
TEST_F(MeshFile, ReadsColladaWhoseArraysAreShared) {
  std::string text = cube_collada();
  std::string shared;  // three numbers of another kind before each corner
  std::istringstream corners(cube_corners("", " "));
  for (double x, y, z; corners >> x >> y >> z;) shared += fmt::format("7 7 7 {} {} {} ", x, y, z);
  const std::size_t begin = text.find("count='24'>") + 11;
  text.replace(begin, text.find("</float_array>") - begin, shared);
  text.replace(text.find("count='24'"), 10, "count='48'");
  text.replace(text.find("stride='3'"), 10, "stride='6' offset='3'");
  expect_cube("shared.dae", text, 10);
  text.replace(text.find("offset='3'"), 10, "offset='4'");
  EXPECT_EQ(refusal("shared.dae", text), "2: <accessor> reaches to 49 of 48 numbers in '#a'");
}

// Capitals, tabs, all on a line, two solids, bytes after the last triangle, "solid" before bytes.
TEST_F(MeshFile, ReadsStlAsItIsFound) {
  std::string capitals = cube_stl(), lines = cube_stl(), bytes = cube_binary_stl();
  for (char& c : capitals) c = static_cast<char>(std::toupper(c));
  std::replace(capitals.begin(), capitals.end(), ' ', '\t');
  std::replace(lines.begin(), lines.end(), '\n', ' ');
  lines += "solid none\nendsolid none\n";
  for (const std::string& text :
       {capitals, lines, bytes + "more", "solid" + bytes.substr(5) + "more"}) {
    const TriangleMesh mesh = read_mesh(written("cube.stl", text));
    EXPECT_EQ(mesh.triangles.cols(), 12);
    EXPECT_DOUBLE_EQ(enclosed_volume(mesh), 8);
  }
  EXPECT_THAT(refusal("cube.stl", bytes.substr(0, 400)),
              HasSubstr("wanted 12 triangles of 50 bytes after the heading, got 316 bytes"));
  EXPECT_THAT(refusal("cube.stl", "solid\nfacet\nvertex 1 2 x\n"),
              StartsWith("3: wanted three numbers after 'vertex', got 'x'"));
}

// A name ends with its line, whatever words it has.
TEST_F(MeshFile, ReadsStlWhoseNameHasItsKeywords) {
  const std::string cube = cube_stl();
  const std::string facets = cube.substr(cube.find('\n'), cube.rfind("endsolid") - cube.find('\n'));
  for (const std::string name : {"solid", "a vertex b", "endsolid facet 2", ""}) {
    SCOPED_TRACE(name);
    const std::string file = written("cube.stl", "solid " + name + facets + "endsolid " + name);
    EXPECT_DOUBLE_EQ(enclosed_volume(read_mesh(file)), 8);
  }
  EXPECT_THAT(refusal("cube.stl", "solid endsolid" + facets), HasSubstr("'endsolid' is missing"));
}

TEST_F(MeshFile, ReadsPlyWhoseCommentComesFirst) {
  std::string text = cube_ply();
  text.insert(text.find("format"), "comment first\n");
  EXPECT_DOUBLE_EQ(enclosed_volume(read_mesh(written("cube.ply", text))), 8);
}

TEST_F(MeshFile, ScalesToMetres) {
  const TriangleMesh mesh = read_mesh(written("cube.obj", cube_obj()), 1e-3);
  EXPECT_NEAR(enclosed_volume(mesh), 8e-9, 1e-22);
  EXPECT_THROW((void)read_mesh(path("cube.obj"), 0), InputError);
}

#ifdef THENAR_HAS_COIN

TEST_F(MeshFile, ReadsACubeInVrmlAndInventor) {
  expect_cube("cube.wrl", cube_vrml1(), 10);
  expect_cube("cube.iv", cube_vrml1("#Inventor V2.1 ascii"), 10);
  expect_cube("cube2.wrl", cube_vrml2(), 10);
}

TEST_F(MeshFile, TurnsClockwiseSurfacesAndMirrorsRound) {
  std::string clockwise = cube_vrml1("#Inventor V2.1 ascii");
  clockwise.insert(clockwise.find("Coordinate3"), "ShapeHints { vertexOrdering CLOCKWISE }\n");
  EXPECT_DOUBLE_EQ(enclosed_volume(read_mesh(written("clockwise.iv", clockwise))), -8);
  std::string mirrored = cube_vrml1();
  mirrored.insert(mirrored.find("Coordinate3"), "Scale { scaleFactor -1 1 1 }\n");
  EXPECT_DOUBLE_EQ(enclosed_volume(read_mesh(written("mirrored.wrl", mirrored))), 8);
  std::string other = cube_vrml2();
  other.insert(other.find("coordIndex"), "ccw FALSE ");
  EXPECT_DOUBLE_EQ(enclosed_volume(read_mesh(written("other.wrl", other))), -8);
}

TEST_F(MeshFile, TessellatesBallsOfInventor) {
  const TriangleMesh mesh =
      read_mesh(written("ball.iv", "#Inventor V2.1 ascii\nSphere {radius 3}"));
  // Inscribed, so less than the ball; Coin's own fineness.
  EXPECT_LT(enclosed_volume(mesh), 36 * M_PI);
  EXPECT_GT(enclosed_volume(mesh), 0.9 * 36 * M_PI);
}

TEST_F(MeshFile, HasNoNeedOfTexturesThatAreNotThere) {
  testing::internal::CaptureStderr();
  std::string inventor = cube_vrml1("#Inventor V2.1 ascii");
  inventor.insert(inventor.find("Coordinate3"), "Texture2 { filename \"lost.png\" }\n");
  expect_cube("textured.iv", inventor, 10);
  std::string vrml = cube_vrml1();
  vrml.insert(vrml.find("Coordinate3"), "Texture2 { filename \"lost.rgb\" }\n");
  expect_cube("textured.wrl", vrml, 10);
  std::string vrml2 = cube_vrml2();
  vrml2.insert(vrml2.find("geometry"),
               "appearance Appearance { texture ImageTexture { url \"lost.jpg\" } }\n");
  expect_cube("textured2.wrl", vrml2, 10);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST_F(MeshFile, NamesTheLineOfBrokenInventor) {
  testing::internal::CaptureStderr();
  EXPECT_THAT(refusal("bad.iv", "#Inventor V2.1 ascii\nSeparator {\n  Cube { width x }\n}\n"),
              StartsWith("3: "));
  EXPECT_THAT(refusal("none.wrl", "a text\n"), StartsWith("1: "));
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

#else

TEST_F(MeshFile, SaysWhatToInstallForInventor) {
  EXPECT_THAT(refusal("cube.iv", cube_vrml1()), HasSubstr("install libcoin-dev"));
}

#endif

TEST_F(MeshFile, ComesBackAsItWasWritten) {
  const TriangleMesh cube = read_mesh(written("cube.obj", cube_obj()));
  for (const char* name : {"a.obj", "a.stl", "a.ply", "a.off"}) {
    SCOPED_TRACE(name);
    write_mesh(path(name), cube);
    const TriangleMesh again = read_mesh(path(name));
    ASSERT_EQ(again.triangles.cols(), 12);
    for (int t = 0; t < 12; ++t)
      for (int k = 0; k < 3; ++k)
        EXPECT_EQ(Eigen::Vector3d(again.vertices.col(again.triangles(k, t))),
                  Eigen::Vector3d(cube.vertices.col(cube.triangles(k, t))));
  }
}

TEST_F(MeshFile, LeavesOutTrianglesWithoutArea) {
  const TriangleMesh mesh =
      read_mesh(written("flat.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv -0 0 0\nf 1 2 3\nf 1 4 2\n"));
  EXPECT_EQ(mesh.vertices.cols(), 3);
  EXPECT_EQ(mesh.triangles.cols(), 1);
}

TEST_F(MeshFile, RefusesFilesWithoutASurface) {
  EXPECT_THAT(refusal("empty.obj", ""), StartsWith("1: "));
  EXPECT_THAT(refusal("empty.stl", ""), StartsWith("1: "));
  EXPECT_THAT(refusal("points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n"), StartsWith("1: "));
  EXPECT_THAT(refusal("line.obj", "v 0 0 0\nv 1 0 0\nl 1 2\n"), HasSubstr("without triangles"));
  EXPECT_THAT(refusal("text.off", "not a mesh"), StartsWith("1: "));
  EXPECT_THAT(refusal("half.gltf", "{\"asset\": "), StartsWith("1: "));
}

TEST_F(MeshFile, RefusesFilesThatAreCutOff) {
  EXPECT_THAT(refusal("cut.stl", cube_binary_stl().substr(0, 100)), StartsWith("1: "));
  EXPECT_THAT(refusal("cut.stl", cube_stl().substr(0, 100)), StartsWith("5: wanted three numbers"));
  EXPECT_THAT(refusal("cut.stl", cube_stl().substr(0, 1000)), HasSubstr("cut off"));
  EXPECT_THAT(refusal("cut.ply", cube_binary_ply().substr(0, 300)), StartsWith("1: "));
}

TEST_F(MeshFile, RefusesCornersThatAreNoNumbersOrNowhere) {
  EXPECT_THAT(refusal("nan.obj", "v 0 0 nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"),
              HasSubstr("1: wanted a finite number, got 'nan'"));
  EXPECT_EQ(refusal("far.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n"),
            "4: a face has corner 8, and there are 3 vertices, counted from 0");
  EXPECT_EQ(refusal("back.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 -4\n"),
            "4: corner -4 of a face lies before the first of 3 vertices");
  EXPECT_EQ(refusal("large.obj", "v 0 0 0\nv 1e300 0 0\nv 0 1 0\nf 1 2 3\n"),
            "1: triangle 0 has a corner beyond 1000000 m");
}

TEST_F(MeshFile, NamesTheLineOfABrokenOff) {
  EXPECT_EQ(refusal("word.off", "OBJ\n"), "1: wanted an OFF in text, got 'OBJ'");
  EXPECT_EQ(refusal("inf.off", "OFF\n# few\n3 1 0\n0 0 inf\n1 0 0\n0 1 0\n3 0 1 2\n"),
            "4: wanted a finite number, got 'inf'");
  EXPECT_EQ(refusal("far.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 9\n"),
            "6: wanted a whole number in 0..2, got 9");
  EXPECT_EQ(refusal("cut.off", "OFF 3 1 0\n0 0 0\n1 0 0\n# 0 1 0\n"),
            "4: the file ends before all corners and faces are listed");
}

TEST_F(MeshFile, NamesTheLineOfABrokenPlyHeader) {
  EXPECT_EQ(refusal("word.ply", "ply\nformat ascii 1.0\nelement333 vertex"),
            "3: wanted the header of a PLY, got 'element333 vertex'");
  EXPECT_EQ(refusal("cut.ply", "ply\nformat ascii 1.0\ncomment a cube\n"),
            "3: the header of this PLY has no end");
}

// As a repository holds large files that were not fetched.
TEST_F(MeshFile, NamesPointersOfGitLfs) {
  for (const char* name : {"a.stl", "a.obj", "a.dae", "a.ply"}) {
    write_file(path(name), "version https://git-lfs.github.com/spec/v1\noid sha256:00\nsize 9\n");
    EXPECT_EQ(
        message_of<DataError>([&] { (void)read_mesh(path(name)); }),
        path(name) +
            ":1: this is a pointer of Git LFS, not the mesh; `git lfs pull` fetches the mesh");
  }
}

TEST_F(MeshFile, RefusesUnknownEndingsAndMissingFiles) {
  EXPECT_THAT(refusal("cube.step", "x"), HasSubstr(".obj"));
  EXPECT_EQ(message_of<DataError>([] { (void)read_mesh("/nowhere/a.obj"); }),
            "/nowhere/a.obj:1: cannot be read: No such file or directory");
  const TriangleMesh cube = read_mesh(written("cube.obj", cube_obj()));
  EXPECT_THAT(message_of([&] { write_mesh(path("cube.glb"), cube); }), HasSubstr(".off"));
}

TEST_F(MeshFile, WritesNoMeshThatIsBroken) {
  TriangleMesh cube = read_mesh(written("cube.obj", cube_obj()));
  cube.triangles(0, 0) = 8;
  EXPECT_THAT(message_of([&] { write_mesh(path("a.obj"), cube); }), HasSubstr("does not exist"));
  cube.vertices(0, 0) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(message_of([&] { write_mesh(path("a.obj"), cube); }), HasSubstr("finite"));
}

}  // namespace
}  // namespace thenar
