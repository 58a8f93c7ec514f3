// Tests for server/gltf.cpp: the structure that glTF 2.0 asks for.

#include "server/gltf.h"

#include <array>
#include <cmath>
#include <memory>

#include <gtest/gtest.h>
#include <Eigen/Geometry>
#include <nlohmann/json.hpp>

#include "tests/server/small_model.h"

namespace thenar {
namespace {

Json picture_of(const LiveShape& shape, const LiveInstant& instant) {
  return Json::parse(gltf_text(shape, instant));
}

Json small_picture(double height) {
  SmallModel model;
  model.lift(height);
  return picture_of(model.shape(), model.instant());
}

const Json& node_named(const Json& file, const std::string& name) {
  for (const Json& node : file["nodes"])
    if (node["name"] == name) return node;
  ADD_FAILURE() << "no node " << name;
  return file["nodes"][0];
}

// Views lie one after the other in the buffer and fill it, each as long as its accessor needs.
TEST(Gltf, ViewsFillTheBuffer) {
  const Json file = small_picture(0.25);
  std::size_t end = 0;
  ASSERT_EQ(file["accessors"].size(), file["bufferViews"].size());
  for (const Json& accessor : file["accessors"]) {
    const Json& view = file["bufferViews"][accessor["bufferView"].get<std::size_t>()];
    EXPECT_EQ(view["byteOffset"].get<std::size_t>(), end);
    const std::size_t each = accessor["type"] == "VEC3" ? 12 : 4;
    EXPECT_EQ(view["byteLength"].get<std::size_t>(), each * accessor["count"].get<std::size_t>());
    end += view["byteLength"].get<std::size_t>();
  }
  EXPECT_EQ(file["buffers"][0]["byteLength"].get<std::size_t>(), end);
  // Four characters for every three bytes.
  const std::string uri = file["buffers"][0]["uri"];
  EXPECT_EQ(uri.size() - uri.find(',') - 1, (end + 2) / 3 * 4);
}

// The tetrahedron's corners reach to 1, 2, 3 m: the limits that a file must state.
TEST(Gltf, StatesTheLimitsOfPoints) {
  const Json file = small_picture(0);
  const Json& mesh = file["meshes"][node_named(file, "box")["mesh"].get<std::size_t>()];
  const Json& points =
      file["accessors"][mesh["primitives"][0]["attributes"]["POSITION"].get<std::size_t>()];
  EXPECT_EQ(points["min"], (Json{0.0, 0.0, 0.0}));
  EXPECT_EQ(points["max"], (Json{1.0, 2.0, 3.0}));
  EXPECT_EQ(points["count"], 4);
}

// A body stands where it is at the instant; a line is as it runs there; bodies without a mesh are
// left out.
TEST(Gltf, PlacesBodiesAtTheInstant) {
  const Json file = small_picture(0.25);
  const Json& box = node_named(file, "box");
  EXPECT_EQ(box["translation"], (Json{0.0, 0.0, 0.25}));
  // A turn of 1 rad about z, as x, y, z, w.
  const std::array<double, 4> turn = box["rotation"];
  EXPECT_NEAR(turn[2], std::sin(0.5), 1e-15);
  EXPECT_NEAR(turn[3], std::cos(0.5), 1e-15);
  const Json& line = file["meshes"][node_named(file, "FDP")["mesh"].get<std::size_t>()];
  EXPECT_EQ(line["primitives"][0]["mode"], 3);  // a strip
  for (const Json& node : file["nodes"]) EXPECT_NE(node["name"], "frame");
}

// The root turns z up into y up: a quarter turn about x, which takes (0, 0, 1) to (0, 1, 0).
TEST(Gltf, TheRootTurnsZUpIntoYUp) {
  const Json file = small_picture(0);
  const std::size_t top = file["scenes"][0]["nodes"][0];
  const Json& root = file["nodes"][top];
  const std::array<double, 4> q = root["rotation"];
  const Eigen::Quaterniond turn(q[3], q[0], q[1], q[2]);
  EXPECT_LT((turn * Eigen::Vector3d::UnitZ() - Eigen::Vector3d::UnitY()).norm(), 1e-15);
  EXPECT_EQ(root["children"].size(), file["nodes"].size() - 1);
}

// Two bodies of one mesh and role have one mesh in the file; another role has its own material.
TEST(Gltf, SharesMeshesOfOneRole) {
  LiveShape shape;
  LiveInstant instant;
  const auto mesh = tetrahedron();
  for (int i = 0; i < 3; ++i) {
    LiveBody body;
    body.name = "body" + std::to_string(i);
    body.mesh = mesh;
    if (i == 2) body.role = static_cast<LiveRole>(static_cast<int>(body.role) == 0 ? 1 : 0);
    shape.bodies.push_back(body);
    instant.bodies.emplace_back();
  }
  const Json file = picture_of(shape, instant);
  EXPECT_EQ(file["meshes"].size(), 2U);
  EXPECT_EQ(node_named(file, "body0")["mesh"], node_named(file, "body1")["mesh"]);
  EXPECT_NE(node_named(file, "body0")["mesh"], node_named(file, "body2")["mesh"]);
}

TEST(Gltf, AnEmptyPictureHasNoBuffer) {
  const Json file = picture_of({}, {});
  EXPECT_FALSE(file.contains("buffers"));
  EXPECT_EQ(file["asset"]["version"], "2.0");
}

}  // namespace
}  // namespace thenar
