// Scenes as clients are sent them, meshes by hash, and glTF of the same picture.

#include "server/scene_message.h"

#include <cstring>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/provenance.h"
#include "server/gltf.h"
#include "tests/server/small_model.h"

namespace thenar {
namespace {

/// Bytes of base64 (RFC 4648), decoded anew.
std::string decoded(const std::string& text) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned value = 0, bits = 0;
  for (const char c : text) {
    if (c == '=') break;
    value = value << 6U | static_cast<unsigned>(digits.find(c));
    bits += 6;
    if (bits < 8) continue;
    bits -= 8;
    bytes += static_cast<char>(value >> bits & 0xffU);
  }
  return bytes;
}

template <typename Number>
Number number_at(const std::string& bytes, std::size_t offset) {
  Number number;
  EXPECT_LE(offset + sizeof(number), bytes.size());
  std::memcpy(&number, bytes.data() + offset, sizeof(number));
  return number;
}

TEST(SceneMessage, NamesMeshesByTheirContent) {
  SmallModel model;
  MeshStore meshes;
  const OrderedJson scene = scene_message(model.shape(), 5, LiveMode::kMotion, meshes);
  EXPECT_EQ(scene["revision"], 5);
  EXPECT_EQ(scene["mode"], "motion");
  EXPECT_TRUE(scene["bodies"][1]["mesh"].is_null());
  const std::string id = scene["bodies"][0]["mesh"];
  const auto bytes = meshes.bytes(id);
  ASSERT_NE(bytes, nullptr);
  EXPECT_EQ(id, sha256(*bytes).substr(0, 32));
  // Vertices and triangles, then 1, 0, 0 as the second vertex, and 0, 2, 1 as the first triangle.
  EXPECT_EQ(number_at<std::uint32_t>(*bytes, 0), 4U);
  EXPECT_EQ(number_at<std::uint32_t>(*bytes, 4), 4U);
  EXPECT_EQ(number_at<float>(*bytes, 8 + 12), 1.0F);
  EXPECT_EQ(number_at<float>(*bytes, 8 + 3 * 12 + 8), 3.0F);
  EXPECT_EQ(number_at<std::uint16_t>(*bytes, 8 + 4 * 12 + 2), 2U);
  EXPECT_EQ(bytes->size(), 8U + 4 * 12 + 4 * 6);
}

TEST(SceneMessage, HasCloudsAsNumbers) {
  SmallModel model;
  MeshStore meshes;
  const OrderedJson scene = scene_message(model.shape(), 0, LiveMode::kFit, meshes);
  const std::string bytes = decoded(scene["clouds"][0]["segments"]);
  ASSERT_EQ(bytes.size(), 24U);
  EXPECT_EQ(number_at<float>(bytes, 12), 1.0F);
  EXPECT_EQ(number_at<float>(bytes, 20), 3.0F);
  EXPECT_EQ(scene["arrows"][0]["kind"], "moment");
  EXPECT_EQ(scene["joints"][0]["upper"], 0.5);
}

TEST(MeshStore, LetsOldMeshesGoAndKnowsNewOnesAtTheSamePlace) {
  MeshStore store;
  const std::string id = store.add(tetrahedron());  // the mesh itself is gone at once
  for (int scene = 0; scene < 8; ++scene) store.begin_scene();
  EXPECT_NE(store.bytes(id), nullptr);
  store.begin_scene();
  EXPECT_EQ(store.bytes(id), nullptr);
  EXPECT_EQ(store.bytes("nonsense"), nullptr);
  // Meshes that take the place of others in memory are not mistaken for them.
  for (int i = 0; i < 100; ++i) {
    TriangleMesh mesh = *tetrahedron();
    mesh.vertices(0, 1) = i;
    const auto shared = std::make_shared<const TriangleMesh>(mesh);
    EXPECT_EQ(*store.bytes(store.add(shared)), mesh_bytes(mesh));
  }
}

TEST(StateMessage, SaysWhatCanBeUndoneAndWhereTimeStands) {
  Session session({});
  OrderedJson state = state_message(session, 2);
  EXPECT_EQ(state["mode"], "world");
  EXPECT_EQ(state["clients"], 2);
  EXPECT_TRUE(state["motion"].is_null());
  auto model = std::make_shared<SmallModel>();
  session.open(LiveMode::kWorld, model);
  model->lift(0.1);
  state = state_message(session, 1);
  EXPECT_EQ(state["world"]["name"], "small");
  EXPECT_EQ(state["world"]["unsaved"], true);
  EXPECT_EQ(state["undo"], "lift");
  EXPECT_TRUE(state["redo"].is_null());
  session.open(LiveMode::kMotion, model);
  model->step(500);
  EXPECT_NEAR(state_message(session, 1)["motion"]["t"].get<double>(), 0.5, 1e-12);
  EXPECT_TRUE(state_message(session, 1)["motion"]["duration"].is_null());
}

TEST(StateMessage, TellsOfAMotionThatIsNotShownAndPauses) {
  Session session({});
  session.open(LiveMode::kWorld, std::make_shared<SmallModel>());
  auto motion = std::make_shared<SmallModel>();
  session.open(LiveMode::kMotion, motion);
  motion->playing = true;
  EXPECT_EQ(state_message(session, 1)["motion"]["shown"], true);
  session.show(LiveMode::kMotion);  // is shown already, and goes on
  EXPECT_EQ(state_message(session, 1)["motion"]["playing"], true);
  session.show(LiveMode::kWorld);
  const OrderedJson state = state_message(session, 1);
  EXPECT_EQ(state["motion"]["shown"], false);
  EXPECT_EQ(state["motion"]["playing"], false);
}

// Two bytes count up to 65536 vertices, four count more.
TEST(MeshBytes, CountVerticesByAsManyBytesAsTheyNeed) {
  for (const Eigen::Index vertices : {3, 65536, 65537}) {
    TriangleMesh mesh;
    mesh.vertices.setZero(3, vertices);
    mesh.triangles.resize(3, 1);
    mesh.triangles.col(0) << 0, 1, static_cast<int>(vertices - 1);
    const std::string bytes = mesh_bytes(mesh);
    const std::size_t start = 8 + 12 * static_cast<std::size_t>(vertices);
    std::uint32_t last = 0;
    const std::size_t width = vertices > 65536 ? 4 : 2;
    ASSERT_EQ(bytes.size(), start + 3 * width);
    for (std::size_t i = 0; i < width; ++i)
      last |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[start + 2 * width + i]))
              << (8 * i);
    EXPECT_EQ(last, vertices - 1);
  }
}

// Corners of the file, turned as its nodes say, are the corners of the picture with y up.
TEST(Gltf, HasTheBodiesWhereTheyStand) {
  SmallModel model;
  model.lift(0.25);
  const Json file = Json::parse(gltf_text(model.shape(), model.instant()));
  EXPECT_EQ(file["asset"]["version"], "2.0");
  const std::string uri = file["buffers"][0]["uri"];
  const std::string buffer = decoded(uri.substr(uri.find(',') + 1));
  ASSERT_EQ(buffer.size(), file["buffers"][0]["byteLength"].get<std::size_t>());
  const Json& node = file["nodes"][0];
  const Json& primitive = file["meshes"][node["mesh"].get<int>()]["primitives"][0];
  const Json& accessor = file["accessors"][primitive["attributes"]["POSITION"].get<int>()];
  const std::size_t offset =
      file["bufferViews"][accessor["bufferView"].get<int>()]["byteOffset"].get<std::size_t>();
  EXPECT_EQ(accessor["max"], Json({1.0, 2.0, 3.0}));
  EXPECT_EQ(accessor["count"], 4);
  const auto turned = [&](const Json& of, const Eigen::Vector3d& point) {
    const Json& q = of["rotation"];
    return Eigen::Vector3d(Eigen::Quaterniond(q[3].get<double>(), q[0].get<double>(),
                                              q[1].get<double>(), q[2].get<double>()) *
                           point);
  };
  const Json& root = file["nodes"][file["scenes"][0]["nodes"][0].get<int>()];
  EXPECT_EQ(root["children"].size(), 2U);  // a body and a line
  for (std::size_t i = 0; i < 4; ++i) {
    Eigen::Vector3d corner;
    for (std::size_t k = 0; k < 3; ++k)
      corner(static_cast<int>(k)) = number_at<float>(buffer, offset + 12 * i + 4 * k);
    const Eigen::Vector3d shift(node["translation"][0], node["translation"][1],
                                node["translation"][2]);
    const Eigen::Vector3d world =
        model.instant().bodies[0] * tetrahedron()->vertices.col(static_cast<int>(i));
    const Eigen::Vector3d in_file = turned(root, turned(node, corner) + shift);
    // z up becomes y up: (x, y, z) stands at (x, z, -y).
    EXPECT_NEAR((in_file - Eigen::Vector3d(world.x(), world.z(), -world.y())).norm(), 0, 1e-6);
  }
}

}  // namespace
}  // namespace thenar
