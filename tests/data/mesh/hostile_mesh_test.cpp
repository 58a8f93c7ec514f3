// No crafted mesh file ends the program, eats the machine or tells of files elsewhere.

#include <cstdlib>
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sys/resource.h>
#include <sys/stat.h>

#include "base/file_io.h"
#include "data/io/mesh/foreign_mesh.h"
#include "data/io/mesh/mesh_file.h"
#include "tests/data/mesh/hostile_files.h"
#include "tests/message_of.h"
#include "tests/temporary_folder.h"

namespace thenar {
namespace {

using testing::AnyOf;
using testing::HasSubstr;
using testing::Not;

constexpr double kMaxMemory = 1.5e9;  // of us or of the program that reads [bytes]

/// Largest resident set so far [bytes]. @param who  us or the processes that we waited for
double largest_memory(decltype(RUSAGE_SELF) who) {
  rusage used{};
  (void)getrusage(who, &used);
  return 1024.0 * static_cast<double>(used.ru_maxrss);
}

class HostileMesh : public TemporaryFolder {
 protected:
  [[nodiscard]] std::string refusal(const std::string& name, const std::string& content) const {
    write_file(path(name), content);
    return message_of<DataError>([&] { (void)read_mesh(path(name)); });
  }
};

TEST_F(HostileMesh, IsRefusedForWhatItIs) {
  for (const HostileFile& file : hostile_meshes()) {
    SCOPED_TRACE(file.name);
    const std::string message = refusal(file.name, file.content);
    EXPECT_THAT(message, HasSubstr(path(file.name) + ":"));
    EXPECT_THAT(message, HasSubstr(file.refusal));
    EXPECT_LT(message.size(), 1000U);
  }
  EXPECT_LT(largest_memory(RUSAGE_SELF), kMaxMemory);
  EXPECT_LT(largest_memory(RUSAGE_CHILDREN), kMaxMemory);
}

// Each in what a reader might take for a path to it: nothing of it comes back in a message.
TEST_F(HostileMesh, TellsNothingOfFilesElsewhere) {
  const std::string secret = "v 666 # a private matter\n";
  write_file(path("secret.txt"), secret);
  std::filesystem::create_directory(path("in"));
  std::filesystem::create_symlink("../secret.txt", path("in/link.bin"));
  for (const std::string& name : {std::string("../secret.txt"), path("secret.txt"),
                                  "file://" + path("secret.txt"), std::string("link.bin")}) {
    SCOPED_TRACE(name);
    std::string gltf = cube_gltf();
    const std::size_t uri = gltf.find(R"("uri": ")") + 8;
    gltf.replace(uri, gltf.rfind('"') - uri, name);
    const std::string message = refusal("in/a.gltf", gltf);
    EXPECT_THAT(message, HasSubstr(path("in/a.gltf") + ":"));
    EXPECT_THAT(message, Not(AnyOf(HasSubstr("666"), HasSubstr("private"))));
    write_file(path("in/a.obj"), "mtllib " + name + "\nusemtl a\n" + cube_obj());
    EXPECT_EQ(read_mesh(path("in/a.obj")).triangles.cols(), 12);
    const std::string dae = with(cube_collada(), "<instance_geometry url='#g'/>",
                                 "<instance_node url='" + name + "'/>");
    EXPECT_THAT(refusal("in/a.dae", dae), HasSubstr("names another file"));
#ifdef THENAR_HAS_COIN
    const std::string image = "Texture2 { filename \"" + name + "\" }\nCoordinate3";
    write_file(path("in/a.wrl"), with(cube_vrml1(), "Coordinate3", image));
    EXPECT_EQ(read_mesh(path("in/a.wrl")).triangles.cols(), 12);
#endif
  }
}

TEST_F(HostileMesh, ReadsBuffersOfGltfBesideIt) {
  std::string bytes;
  for (int i = 0; i < 8; ++i)
    for (const float x : cube_corner(i)) bytes += bytes_of(x);
  each_cube_triangle([&](int a, int b, int c) {
    for (const int i : {a, b, c}) bytes += bytes_of(static_cast<std::uint16_t>(i));
  });
  write_file(path("parts/cube.bin"), bytes);
  std::string gltf = cube_gltf();
  const std::size_t uri = gltf.find(R"("uri": ")") + 8;
  gltf.replace(uri, gltf.rfind('"') - uri, "parts/cube.bin");
  write_file(path("a.gltf"), gltf);
  EXPECT_EQ(read_mesh(path("a.gltf")).triangles.cols(), 12);
}

TEST_F(HostileMesh, ThatIsNoFileIsNotWaitedFor) {
  for (const char* name : {"pipe.obj", "pipe.dae", "pipe.wrl"}) {
    ASSERT_EQ(mkfifo(path(name).c_str(), 0600), 0);
    EXPECT_THAT(message_of<DataError>([&] { (void)read_mesh(path(name)); }),
                HasSubstr("wanted a file, got a pipe"));
  }
}

TEST_F(HostileMesh, SaysWhatIsMissingWithoutItsReader) {
  const std::string cube = cube_collada();
  ASSERT_EQ(setenv("THENAR_MESH_READER", "/nowhere/reader", 1), 0);
  EXPECT_THAT(refusal("a.dae", cube), HasSubstr("thenar-mesh-reader, which is not there"));
  ASSERT_EQ(setenv("THENAR_MESH_READER", "/bin/false", 1), 0);
  EXPECT_THAT(refusal("a.dae", cube), HasSubstr("ended with status 1"));
  ASSERT_EQ(setenv("THENAR_MESH_READER", "/bin/true", 1), 0);
  EXPECT_THAT(refusal("a.dae", cube), HasSubstr("broke off"));
  ASSERT_EQ(unsetenv("THENAR_MESH_READER"), 0);
  EXPECT_EQ(read_mesh(path("a.dae")).triangles.cols(), 12);
}

/// A program in the place of the one that reads.
void put_reader(const std::string& path, const std::string& script) {
  write_file(path, "#!/bin/sh\n" + script);
  ASSERT_EQ(chmod(path.c_str(), 0700), 0);
  ASSERT_EQ(setenv("THENAR_MESH_READER", path.c_str(), 1), 0);
}

// What one mesh takes is not there for the next.
TEST_F(HostileMesh, SharesItsTimeWithThoseOfTheSameFile) {
  write_file(path("a.dae"), cube_collada());
  put_reader(path("reader"), "exec sleep 20");
  MeshTime left{10, 0.2};
  const auto said = [&] {
    return message_of<DataError>(
        [&] { (void)read_foreign_mesh(path("a.dae"), MeshFormat::kCollada, left); });
  };
  EXPECT_THAT(said(), HasSubstr("took too long"));
  EXPECT_LT(left.clock, 0.01);
  EXPECT_THAT(said(), HasSubstr("the meshes before it took all the time"));
  // Some of the processor, in a program that waits for nothing.
  put_reader(path("reader"), "i=0\nwhile [ $i -lt 100000 ]; do i=$((i + 1)); done");
  left = {0.06, 10};
  EXPECT_THAT(said(), HasSubstr("broke off"));
  EXPECT_LT(left.processor, 0.05);
  EXPECT_THAT(said(), HasSubstr("the meshes before it took all the time"));
  ASSERT_EQ(unsetenv("THENAR_MESH_READER"), 0);
}

TEST_F(HostileMesh, IsReadOnceByOneReader) {
  write_file(path("a.dae"), cube_collada());
  write_file(path("b.obj"), cube_obj());
  put_reader(path("reader"), "echo once >> " + path("count") + "\nexit 1");
  MeshReader reader;
  for (int i = 0; i < 3; ++i)
    EXPECT_THAT(message_of<DataError>([&] { (void)reader.read(path("a.dae")); }),
                HasSubstr("a.dae:1: cannot be read: the program that reads it ended with status"));
  EXPECT_EQ(std::filesystem::file_size(path("count")), 5U);
  EXPECT_EQ(reader.read(path("b.obj")).triangles.cols(), 12);
  std::filesystem::remove(path("b.obj"));
  EXPECT_EQ(reader.read(path("b.obj")).triangles.cols(), 12);
  ASSERT_EQ(unsetenv("THENAR_MESH_READER"), 0);
}

// Nodes without a triangle, each used ten times a level: nothing but time tells.
TEST_F(HostileMesh, EndsWithItsTime) {
  if (std::getenv("THENAR_SLOW_MESHES") == nullptr) GTEST_SKIP() << "takes 8 s: ./run long";
#ifdef THENAR_HAS_COIN
  EXPECT_THAT(refusal("endless.wrl", tenfold_vrml(14, "")),
              HasSubstr("the program that reads it took too long"));
#endif
}

// A polygon that is not convex is cut along its inside: the area of an L is 3, that of its
// hull 3.5.
TEST_F(HostileMesh, CutsPolygonsThatAreNotConvex) {
  for (const char* face : {"f 1 2 3 4 5 6\n", "f 4 5 6 1 2 3\n", "f 6 5 4 3 2 1\n"}) {
    write_file(path("l.obj"),
               std::string("v 0 0 1\nv 2 0 1\nv 2 1 1\nv 1 1 1\nv 1 2 1\nv 0 2 1\n") + face);
    const TriangleMesh mesh = read_mesh(path("l.obj"));
    ASSERT_EQ(mesh.triangles.cols(), 4);
    double area = 0, total = 0;
    for (const auto& t : mesh.triangles.colwise()) {
      const Eigen::Vector3d a = mesh.vertices.col(t(0)), b = mesh.vertices.col(t(1)),
                            c = mesh.vertices.col(t(2));
      const double z = (b - a).cross(c - a).z() / 2;
      area += std::abs(z);
      total += z;
    }
    EXPECT_NEAR(area, 3, 1e-12);
    EXPECT_NEAR(std::abs(total), 3, 1e-12);
  }
}

}  // namespace
}  // namespace thenar
