#include "pads/hex_mesh.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/error.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

/// A box of 2 x 2 x 2 cells, one corner of it refined three times.
HexMesh graded_mesh() {
  HexMesh mesh = box_mesh({1, 1, 1}, {2, 2, 2});
  int cell = 0;
  for (int level = 0; level < 3; ++level) {
    mesh.refine({cell});
    cell = mesh.cells()[static_cast<std::size_t>(cell)].first_child + 7;
  }
  return mesh;
}

double volume_of(const HexMesh& mesh) {
  double sum = 0;
  for (const int index : mesh.active()) {
    const HexCell& cell = mesh.cells()[static_cast<std::size_t>(index)];
    sum += (mesh.place(cell.corners[7]) - mesh.place(cell.corners[0])).prod();
  }
  return sum;
}

TEST(HexMesh, CellsFillTheBox) {
  EXPECT_NEAR(volume_of(box_mesh({1, 2, 3}, {2, 3, 4})), 6, 1e-13);
  EXPECT_NEAR(volume_of(graded_mesh()), 1, 1e-13);
}

TEST(HexMesh, HangingNodesLieAmongTheirMasters) {
  const HexMesh mesh = graded_mesh();
  int hanging = 0;
  for (int node = 0; node < mesh.nodes(); ++node) {
    const std::vector<NodeWeight>& masters = mesh.masters(node);
    if (!mesh.in_use(node) || masters.empty()) continue;
    ++hanging;
    double sum = 0;
    Vector3d mean(0, 0, 0);
    for (const NodeWeight& each : masters) {
      EXPECT_TRUE(mesh.in_use(each.node));
      EXPECT_TRUE(mesh.masters(each.node).empty());
      sum += each.weight;
      mean += each.weight * mesh.place(each.node);
    }
    EXPECT_NEAR(sum, 1, 1e-15);
    EXPECT_LT((mean - mesh.place(node)).norm(), 1e-15);  // the box is straight
  }
  EXPECT_GT(hanging, 20);
}

TEST(HexMesh, NeighboursDifferByOneLevel) {
  const HexMesh mesh = graded_mesh();
  // Cells that share a piece of a face: their boxes touch with an area.
  for (const int i : mesh.active())
    for (const int j : mesh.active()) {
      const HexCell &a = mesh.cells()[static_cast<std::size_t>(i)],
                    &b = mesh.cells()[static_cast<std::size_t>(j)];
      const Vector3d low = mesh.place(a.corners[0]).cwiseMax(mesh.place(b.corners[0]));
      const Vector3d high = mesh.place(a.corners[7]).cwiseMin(mesh.place(b.corners[7]));
      const int across = static_cast<int>(((high - low).array() > 1e-9).count());
      const bool touch = ((high - low).array() > -1e-9).all();
      if (touch && across >= 1) {
        EXPECT_LE(std::abs(a.level - b.level), 1);
      }
    }
}

TEST(HexMesh, InvertedCellsAreRefused) {
  class Mirrored final : public HexChart {
    [[nodiscard]] Vector3d place(const Vector3d& c) const override { return {-c[0], c[1], c[2]}; }
  };
  Eigen::Matrix3Xd points(3, 8);
  HexCell cell;
  for (int c = 0; c < 8; ++c) {
    points.col(c) << (c & 1), (c >> 1) & 1, (c >> 2) & 1;
    cell.corners[static_cast<std::size_t>(c)] = c;
  }
  EXPECT_THROW(HexMesh(std::make_shared<Mirrored>(), points, {cell}), InputError);
  cell.corners[3] = 8;
  EXPECT_THROW(HexMesh(std::make_shared<Mirrored>(), points, {cell}), InputError);
}

}  // namespace
}  // namespace thenar
