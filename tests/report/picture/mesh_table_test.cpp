// Tests for report/picture/mesh_table.cpp.

#include "report/picture/mesh_table.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/error.h"

namespace thenar {
namespace {

TriangleMesh tetrahedron(double edge) {
  TriangleMesh mesh;
  mesh.vertices.resize(3, 4);
  mesh.vertices << Eigen::Vector3d::Zero(), edge * Eigen::Matrix3d::Identity();
  mesh.triangles.resize(3, 4);
  mesh.triangles << 0, 0, 0, 1,  //
      1, 2, 3, 2,                //
      3, 1, 2, 3;
  return mesh;
}

std::string coded(const std::string& text) {
  return base64(reinterpret_cast<const unsigned char*>(text.data()), text.size());
}

// The examples of RFC 4648, section 10.
TEST(MeshTable, CodesAsTheStandardDoes) {
  EXPECT_EQ(coded(""), "");
  EXPECT_EQ(coded("f"), "Zg==");
  EXPECT_EQ(coded("fo"), "Zm8=");
  EXPECT_EQ(coded("foo"), "Zm9v");
  EXPECT_EQ(coded("foobar"), "Zm9vYmFy");
}

// A box of 20 mm about its middle in steps of 10 mm / 32767: corners are at -32767 and 32767, which
// are 0x8001 and 0x7FFF, low byte first.
TEST(MeshTable, RoundsCornersToStepsFromTheMiddle) {
  MeshTable table;
  const std::string name = table.add(tetrahedron(0.02));
  const Json& added = table.json()[name];
  EXPECT_EQ(added["origin"], Json({10.0, 10.0, 10.0}));
  EXPECT_DOUBLE_EQ(added["step"].get<double>(), 10.0 / 32767);
  const unsigned char corners[] = {0x01, 0x80, 0x01, 0x80, 0x01, 0x80, 0xFF, 0x7F,
                                   0x01, 0x80, 0x01, 0x80, 0x01, 0x80, 0xFF, 0x7F,
                                   0x01, 0x80, 0x01, 0x80, 0x01, 0x80, 0xFF, 0x7F};
  EXPECT_EQ(added["vertices"], base64(corners, sizeof(corners)));
  const unsigned char triangles[] = {0, 0, 1, 0, 3, 0, 0, 0, 2, 0, 1, 0,
                                     0, 0, 3, 0, 2, 0, 1, 0, 2, 0, 3, 0};
  EXPECT_EQ(added["triangles"], base64(triangles, sizeof(triangles)));
}

TEST(MeshTable, KeepsOneOfEqualMeshes) {
  MeshTable table;
  const std::string name = table.add(tetrahedron(0.02));
  EXPECT_EQ(table.add(tetrahedron(0.02)), name);
  EXPECT_NE(table.add(tetrahedron(0.03)), name);
  EXPECT_NE(table.add(tetrahedron(0.02), {30, {}}), name);
  EXPECT_EQ(table.json().size(), 3U);
}

TEST(MeshTable, RefusesWhatCannotBeDrawn) {
  MeshTable table;
  EXPECT_THROW((void)table.add({}), InputError);
  EXPECT_THROW((void)table.add(tetrahedron(NAN)), InputError);
  EXPECT_THROW((void)table.add(tetrahedron(1), {-1, {MeshColor(1, 2, 3)}}), InputError);
}

}  // namespace
}  // namespace thenar
