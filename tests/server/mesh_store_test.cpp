// Tests for server/mesh_store.cpp: bytes of meshes, and how long they are kept.

#include "server/mesh_store.h"

#include <cstdint>
#include <cstring>

#include <gtest/gtest.h>

#include "tests/server/small_model.h"

namespace thenar {
namespace {

template <typename Number>
Number read_at(const std::string& bytes, std::size_t offset) {
  Number number{};
  EXPECT_LE(offset + sizeof(number), bytes.size());
  std::memcpy(&number, bytes.data() + offset, sizeof(number));
  return number;
}

/// A mesh of so many vertices and one triangle of its last.
TriangleMesh long_mesh(int vertices) {
  TriangleMesh mesh{Eigen::Matrix3Xd::Zero(3, vertices), Eigen::Matrix3Xi(3, 1)};
  mesh.triangles << vertices - 3, vertices - 2, vertices - 1;
  return mesh;
}

// Counts, then coordinates of four bytes, then corners of two.
TEST(MeshStore, BytesAreCountsPointsAndCorners) {
  const std::string bytes = mesh_bytes(*tetrahedron());
  ASSERT_EQ(bytes.size(), 8U + 4 * 12 + 4 * 6);
  EXPECT_EQ(read_at<std::uint32_t>(bytes, 0), 4U);
  EXPECT_EQ(read_at<std::uint32_t>(bytes, 4), 4U);
  EXPECT_EQ(read_at<float>(bytes, 8 + 12), 1.0F);          // x of vertex 1
  EXPECT_EQ(read_at<float>(bytes, 8 + 3 * 12 + 8), 3.0F);  // z of vertex 3
  const std::uint16_t corners[] = {0, 2, 1};
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_EQ(read_at<std::uint16_t>(bytes, 8 + 48 + 2 * k), corners[k]);
}

// Two bytes count 65536 vertices; one more takes four.
TEST(MeshStore, CornersGetFourBytesWhereTwoAreTooFew) {
  const std::string few = mesh_bytes(long_mesh(65536)), many = mesh_bytes(long_mesh(65537));
  EXPECT_EQ(few.size(), 8U + 12 * 65536 + 6);
  EXPECT_EQ(read_at<std::uint16_t>(few, few.size() - 2), 65535U);
  EXPECT_EQ(many.size(), 8U + 12 * 65537 + 12);
  EXPECT_EQ(read_at<std::uint32_t>(many, many.size() - 4), 65536U);
}

// The id is of the content: two meshes alike are one entry, another mesh is another.
TEST(MeshStore, IdsAreOfTheContent) {
  MeshStore store;
  const auto one = tetrahedron(), same = tetrahedron();
  const auto other = std::make_shared<const TriangleMesh>(long_mesh(3));
  const std::string id = store.add(one);
  EXPECT_EQ(id.size(), 32U);
  EXPECT_EQ(id.find_first_not_of("0123456789abcdef"), std::string::npos);
  EXPECT_EQ(store.add(one), id);
  EXPECT_EQ(store.add(same), id);
  EXPECT_NE(store.add(other), id);
  ASSERT_NE(store.bytes(id), nullptr);
  EXPECT_EQ(*store.bytes(id), mesh_bytes(*one));
  EXPECT_EQ(store.bytes("no id"), nullptr);
}

// A mesh that no scene adds any more is there for eight scenes and gone after; one that is added
// again stays.
TEST(MeshStore, LetsMeshesGoAfterEightScenes) {
  MeshStore store;
  const auto old = tetrahedron();
  const auto used = std::make_shared<const TriangleMesh>(long_mesh(3));
  store.begin_scene();
  const std::string old_id = store.add(old), used_id = store.add(used);
  for (int scene = 0; scene < 8; ++scene) {
    store.begin_scene();
    (void)store.add(used);
    EXPECT_NE(store.bytes(old_id), nullptr) << scene;
  }
  store.begin_scene();
  EXPECT_EQ(store.bytes(old_id), nullptr);
  EXPECT_NE(store.bytes(used_id), nullptr);
  // Added once more it is encoded once more.
  EXPECT_EQ(store.add(old), old_id);
  EXPECT_NE(store.bytes(old_id), nullptr);
}

}  // namespace
}  // namespace thenar
