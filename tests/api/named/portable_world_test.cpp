// Tests for api/named/portable_world.cpp: worlds that are saved, moved and read again.

#include "api/named/portable_world.h"

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "api/named/worlds.h"
#include "base/error.h"
#include "base/file_io.h"
#include "base/provenance.h"
#include "tests/data_folder.h"
#include "tests/message_of.h"
#include "tests/temporary_folder.h"

namespace thenar {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

/// A tetrahedron whose top is this high [m], as OBJ.
std::string tetrahedron_obj(const std::string& height) {
  return "v 0 0 0\nv .02 0 0\nv 0 .02 0\nv 0 0 " + height + "\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
}

class PortableWorlds : public TemporaryFolder {
 protected:
  /// A hand, an object, an obstacle and materials of one's own in folders beside each other.
  [[nodiscard]] std::string own_world() const {
    write("parts/meshes/palm.obj", tetrahedron_obj(".03"));
    write("parts/own.urdf",
          "<robot name='own'><link name='palm'><collision><geometry>"
          "<mesh filename='meshes/palm.obj'/></geometry></collision></link>"
          "<link name='finger'><collision><geometry><box size='.01 .01 .03'/></geometry>"
          "</collision></link><joint name='bend' type='revolute'><parent link='palm'/>"
          "<child link='finger'/><origin xyz='0 0 .05'/><axis xyz='1 0 0'/>"
          "<limit lower='0' upper='1' effort='1' velocity='1'/></joint></robot>");
    write("things/wedge.obj", tetrahedron_obj(".04"));
    write("things/wedge.toml",
          "name = 'wedge'\nsource = 'Own'\nmass_g = 20\n[sources]\nOwn = 'Made up'\n"
          "[[shape]]\nkind = 'mesh'\nfile = 'wedge.obj'\n");
    write("tables/soft.toml",
          "name = 'soft'\nsource = 'Own'\n[sources]\nOwn = 'Made up'\n"
          "[[material]]\nname = 'foam'\ndensity_kg_m3 = 30\n");
    write("worlds/own.toml",
          "name = 'own'\nsource = 'Own'\nmaterials = '../tables/soft.toml'\n"
          "[sources]\nOwn = 'Made up'\n"
          "[camera]\neye_m = [1, 0, 0]\ntarget_m = [0, 0, 0]\n"
          "[[hand]]\nname = 'own'\nfile = '../parts/own.urdf'\n"
          "[[hand]]\nname = 'jaws'\nfile = 'parallel_jaw'\nposition_m = [1, 0, 0]\n"
          "[[body]]\nrole = 'object'\nfile = '../things/wedge.toml'\n"
          "[[body]]\nrole = 'object'\nname = 'cup'\nfile = 'mug'\n"
          "[[body]]\nrole = 'obstacle'\nname = 'stop'\nmass_g = 5\n"
          "[[body.shape]]\nkind = 'mesh'\nfile = '../things/wedge.obj'\n");
    return path("worlds/own.toml");
  }
  void write(const std::string& name, const std::string& text) const {
    write_file(path(name), text);
  }
  [[nodiscard]] WorldSpec read(const std::string& file) const { return read_world_at(file, kData); }
  /// How high the meshes of all bodies reach [m].
  static std::vector<double> tops(const WorldSpec& world) {
    std::vector<double> all;
    for (const PlacedBody& placed : world.bodies)
      for (const ShapeSpec& shape : placed.body.shapes)
        if (shape.kind == ShapeKind::kMesh)
          all.push_back(shape.mesh.vertices.row(2).maxCoeff());
    return all;
  }
};

TEST_F(PortableWorlds, AreReadWhereTheyWereMovedTo) {
  const WorldSpec world = read(own_world());
  save_world(world, path("out/kept.toml"));
  const std::string text = read_file(path("out/kept.toml"), 100'000);
  EXPECT_THAT(text, Not(HasSubstr("..")));
  EXPECT_THAT(text, Not(HasSubstr(path(""))));
  EXPECT_THAT(text, HasSubstr("file = \"parallel_jaw\"\n"));
  EXPECT_THAT(text, HasSubstr("file = \"mug\"\n"));
  // What they were made of is gone.
  fs::rename(path("out"), path("moved"));
  for (const char* folder : {"parts", "things", "tables", "worlds"}) fs::remove_all(path(folder));
  const WorldSpec moved = read(path("moved/kept.toml"));
  EXPECT_EQ(tops(moved), tops(world));
  EXPECT_EQ(moved.materials.at("foam").density, 30);
  const WorldHand hand = hand_of_world(moved, "own", "kept.toml", data_for(moved.folder, kData));
  EXPECT_EQ(hand.named.hand->layout().coordinates, std::vector<std::string>{"bend"});
  EXPECT_EQ(hand.named.hand->surfaces().size(), 2U);
  // Saved once more beside, it takes nothing along a second time.
  save_world(moved, path("moved/again.toml"));
  EXPECT_FALSE(fs::exists(path("moved/again_files")));
}

TEST_F(PortableWorlds, AreSavedInTheWorkingFolder) {
  const WorldSpec world = read(own_world());
  const fs::path before = fs::current_path();
  fs::current_path(path("tables"));
  save_world(world, "kept.toml");
  fs::current_path(before);
  EXPECT_EQ(tops(read(path("tables/kept.toml"))), tops(world));
  EXPECT_TRUE(fs::exists(path("tables/kept_files/1")));
}

TEST_F(PortableWorlds, TakeTheFolderThatHasTheSameFiles) {
  const std::string own = own_world();
  save_world(read(own), path("out/kept.toml"));
  const std::string first = read_file(path("out/kept.toml"), 100'000);
  save_world(read(own), path("out/kept.toml"));
  EXPECT_EQ(read_file(path("out/kept.toml"), 100'000), first);
  write("things/wedge.obj", tetrahedron_obj(".05"));
  save_world(read(own), path("out/kept.toml"));
  EXPECT_NE(read_file(path("out/kept.toml"), 100'000), first);
  EXPECT_EQ(tops(read(path("out/kept.toml")))[0], 0.05);
}

TEST_F(PortableWorlds, TellByNameOnlyWhatComesWithThenar) {
  const std::string ours = kData + "/objects/mug.toml";
  EXPECT_EQ(shipped_name(ours, "objects", digests_of({ours})), "mug");
  EXPECT_EQ(shipped_name(ours, "robots", digests_of({ours})), "");
  // A copy is as good, unless one of its files differs.
  fs::create_directories(path("objects"));
  for (const char* file : {"mug.toml", "mug.obj"})
    fs::copy_file(kData + "/objects/" + file, path("objects/") + file);
  const std::string copy = path("objects/mug.toml");
  EXPECT_EQ(shipped_name(copy, "objects", digests_of({copy, path("objects/mug.obj")})), "mug");
  write("objects/mug.obj", tetrahedron_obj(".03"));
  EXPECT_EQ(shipped_name(copy, "objects", digests_of({copy, path("objects/mug.obj")})), "");
}

TEST_F(PortableWorlds, SayWhatANameIsNot) {
  write("w.toml",
        "name = 'w'\nsource = 'Own'\n[sources]\nOwn = 'Made up'\n"
        "[camera]\neye_m = [1, 0, 0]\ntarget_m = [0, 0, 0]\n"
        "[[body]]\nrole = 'object'\nfile = 'mugg'\n");
  EXPECT_THAT(message_of<DataError>([&] { (void)read(path("w.toml")); }),
              HasSubstr("w.toml:10: 'mugg' is neither a file nor one of objects; looked in "));
}

}  // namespace
}  // namespace thenar
