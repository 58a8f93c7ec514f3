// Every object and world in data/ reads, survives, and is what it says.

#include <filesystem>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "base/units.h"
#include "data/io/world/world.h"
#include "tests/data/mesh/mesh_sums.h"
#include "tests/data_folder.h"

namespace thenar {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> files_in(const std::string& folder) {
  std::vector<fs::path> paths;
  for (const auto& entry : fs::directory_iterator(kData + "/" + folder))
    if (entry.path().extension() == ".toml") paths.push_back(entry.path());
  return paths;
}

/// Edges that are not passed once in each direction.
std::size_t open_edges(const TriangleMesh& mesh) {
  std::map<std::pair<int, int>, int> passed;
  for (const auto& t : mesh.triangles.colwise())
    for (int k = 0; k < 3; ++k) ++passed[{t(k), t((k + 1) % 3)}];
  std::size_t open = 0;
  for (const auto& [edge, count] : passed)
    if (count != 1 || passed.count({edge.second, edge.first}) == 0) ++open;
  return open;
}

TEST(DataObjects, ReadAndComeBack) {
  const std::vector<fs::path> paths = files_in("objects");
  EXPECT_GE(paths.size(), 10U);
  std::set<ShapeKind> kinds;
  for (const fs::path& path : paths) {
    SCOPED_TRACE(path);
    const BodySpec body = read_object(path);
    EXPECT_EQ(body.name, path.stem().string());
    EXPECT_FALSE(body.description.empty());
    EXPECT_NO_THROW((void)built_in_materials().between("skin", body.material));
    EXPECT_TRUE(body.mass || body.uniform_mass > 0 || body.density > 0);
    EXPECT_EQ(object_toml(parse_object(object_toml(body), path)), object_toml(body));
    for (const ShapeSpec& shape : body.shapes) kinds.insert(shape.kind);
  }
  for (const ShapeKind kind : {ShapeKind::kSphere, ShapeKind::kBox, ShapeKind::kCylinder,
                               ShapeKind::kSuperellipsoid, ShapeKind::kMesh})
    EXPECT_EQ(kinds.count(kind), 1U) << name_of(kind);
}

TEST(DataObjects, MugIsAClosedSurfaceAroundAnOpenCavity) {
  const BodySpec mug = read_object(kData + "/objects/mug.toml");
  const TriangleMesh& mesh = mug.shapes.at(0).mesh;
  EXPECT_EQ(open_edges(mesh), 0U);
  // Sizes of mug.py [m]: a wall of 41 and 37 mm about a cavity of 90 mm, and half an ellipse of
  // handle, 14 x 10 mm thick, with semi-axes 29 and 25.2 mm. Flat facets lose 0.2 % of each ring,
  // the rim its round edge.
  const double wall = kPi * (0.041 * 0.041 * 0.095 - 0.037 * 0.037 * 0.090);
  const double handle = kPi * 0.007 * 0.005 * kPi * (0.029 + 0.0252) / 2;
  EXPECT_NEAR(enclosed_volume(mesh), wall + handle, 0.02 * wall);
  EXPECT_NEAR(mesh.vertices.row(0).maxCoeff(), 0.075, 1e-6);
}

TEST(DataWorlds, ReadAndComeBack) {
  const std::vector<fs::path> paths = files_in("worlds");
  EXPECT_GE(paths.size(), 3U);
  for (const fs::path& path : paths) {
    SCOPED_TRACE(path);
    const WorldSpec world = read_world(path);
    EXPECT_EQ(world.name, path.stem().string());
    EXPECT_FALSE(world.hands.empty());
    EXPECT_FALSE(world.bodies.empty());
    EXPECT_EQ(world_toml(parse_world(world_toml(world), path)), world_toml(world));
  }
}

}  // namespace
}  // namespace thenar
