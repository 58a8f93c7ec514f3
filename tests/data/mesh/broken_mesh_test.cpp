// No broken mesh file does harm, whatever its kind.

#include <gtest/gtest.h>

#include "data/io/mesh/mesh_file.h"
#include "tests/data/broken_files.h"
#include "tests/data/mesh/cube_files.h"
#include "tests/temporary_folder.h"

namespace thenar {
namespace {

class BrokenMesh : public TemporaryFolder {
 protected:
  void expect_harmless(const std::string& name, const std::string& text, int usual = 300) {
    SCOPED_TRACE(name);
    expect_no_harm(
        text, path(name), [](const std::string& file) { (void)read_mesh(file); }, usual);
  }
  static constexpr int kFew = 20;  // of those that each start a program
};

TEST_F(BrokenMesh, InTextDoesNoHarm) {
  expect_harmless("cube.obj", cube_obj());
  expect_harmless("cube.off", cube_off());
  expect_harmless("cube.ply", cube_ply());
  expect_harmless("cube.stl", cube_stl());
  expect_harmless("cube.gltf", cube_gltf(), 2 * kFew);
  expect_harmless("cube.dae", cube_collada(), kFew);
}

TEST_F(BrokenMesh, InBytesDoesNoHarm) {
  expect_harmless("cube.stl", cube_binary_stl());
  expect_harmless("cube.ply", cube_binary_ply());
}

#ifdef THENAR_HAS_COIN
TEST_F(BrokenMesh, OfInventorDoesNoHarm) {
  expect_harmless("cube.wrl", cube_vrml1(), kFew);
  expect_harmless("cube.wrl", cube_vrml2(), kFew);
  expect_harmless("cube.iv", cube_vrml1("#Inventor V2.1 ascii"), kFew);
}
#endif

}  // namespace
}  // namespace thenar
