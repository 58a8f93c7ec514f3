// Tests for pads/pad_shape.cpp: ellipsoids, layers, areas and volumes in closed form.

#include "pads/pad_shape.h"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/units.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kLengthRounding = 1e-15;  // [m]

/// Places of the disc, the rim among them.
std::vector<Eigen::Vector2d> disc_places() {
  std::vector<Eigen::Vector2d> out{{0, 0}};
  for (const double r : {0.2, 0.7, 1.0})
    for (int k = 0; k < 7; ++k) out.emplace_back(r * std::cos(0.9 * k), r * std::sin(0.9 * k));
  return out;
}

/// Two half balls around one centre.
PadShape half_balls(double outer, double inner) {
  PadShape shape;
  shape.length = shape.width = 2 * outer;
  shape.height = outer;
  shape.bone_length = shape.bone_width = 2 * inner;
  shape.bone_height = inner;
  return shape;
}

/// Volume of the cells of a mesh [m^3]: det of the trilinear map by two Gauss points each way.
double cells_volume(const HexMesh& mesh) {
  double sum = 0;
  for (const int index : mesh.active()) {
    const HexCell& cell = mesh.cells()[static_cast<std::size_t>(index)];
    for (int q = 0; q < 8; ++q) {
      Matrix3d slope = Matrix3d::Zero();
      for (int c = 0; c < 8; ++c) {
        std::array<double, 3> shape{}, by{};
        for (int axis = 0; axis < 3; ++axis) {
          const double x = 0.5 + (((q >> axis) & 1) != 0 ? 0.5 : -0.5) / std::sqrt(3.0);
          const bool high = ((c >> axis) & 1) != 0;
          shape[static_cast<std::size_t>(axis)] = high ? x : 1 - x;
          by[static_cast<std::size_t>(axis)] = high ? 1 : -1;
        }
        const Vector3d gradient(by[0] * shape[1] * shape[2], shape[0] * by[1] * shape[2],
                                shape[0] * shape[1] * by[2]);
        slope += mesh.place(cell.corners[static_cast<std::size_t>(c)]) * gradient.transpose();
      }
      sum += slope.determinant() / 8;
    }
  }
  return sum;
}

TEST(PadShape, SkinAndBoneAreHalfEllipsoids) {
  const PadShape shape;
  const PadChart chart(shape);
  for (const Eigen::Vector2d& c : disc_places()) {
    const Vector3d skin = chart.place({c[0], c[1], 1}), bone = chart.place({c[0], c[1], 0});
    const Vector3d outer(shape.length / 2, shape.width / 2, shape.height),
        inner(shape.bone_length / 2, shape.bone_width / 2, shape.bone_height);
    EXPECT_NEAR(skin.cwiseQuotient(outer).norm(), 1, 1e-14);
    EXPECT_NEAR(bone.cwiseQuotient(inner).norm(), 1, 1e-14);
    EXPECT_GE(skin[2], -kLengthRounding);
    // The rim is on the nail's plane.
    if (c.norm() > 1 - 1e-12) {
      EXPECT_NEAR(skin[2], 0, 1e-12);
    }
  }
  EXPECT_NEAR(chart.thickness(0, 0), shape.height - shape.bone_height, kLengthRounding);
}

// With n layers the levels 1 - k / 2n are k layers below the skin, wherever it is.
TEST(PadShape, LevelsAreLayersBelowTheSkin) {
  PadShape shape;
  shape.layers = {{0.2e-3}, {0.9e-3}};
  const PadChart chart(shape);
  for (const Eigen::Vector2d& c : disc_places()) {
    const auto at = [&](double w) { return chart.place({c[0], c[1], w}); };
    EXPECT_NEAR((at(1) - at(0.75)).norm(), 0.2e-3, kLengthRounding);
    EXPECT_NEAR((at(1) - at(0.5)).norm(), 1.1e-3, kLengthRounding);
    // The pulp's levels are even.
    EXPECT_NEAR((at(0.25) - at(0)).norm(), 0.5 * (chart.thickness(c[0], c[1]) - 1.1e-3),
                kLengthRounding);
  }
}

// On a half ball the columns' areas are those of its zones, exactly; between half balls all columns
// are as thick, and their normals point away from the centre.
TEST(PadShape, ColumnsOfAHalfBallCoverIt) {
  const FoundationColumns columns = pad_columns(half_balls(10e-3, 6e-3), 7);
  EXPECT_NEAR(columns.area.sum(), 2 * kPi * 1e-4, 1e-16);
  for (Eigen::Index i = 0; i < columns.area.size(); ++i) {
    EXPECT_NEAR(columns.thickness[i], 4e-3, kLengthRounding);
    EXPECT_LT((columns.normal.col(i) - columns.skin.col(i) / 10e-3).norm(), 1e-12);
  }
}

TEST(PadShape, CountsCellsAndRegions) {
  PadShape shape;
  shape.layers = {{0.2e-3}, {0.9e-3}};
  const PadCells cells{3, 2, 4};
  const HexMesh mesh = pad_mesh(shape, cells);
  const std::size_t per_level = 3 * 3 + 2 * 4 * 3;
  ASSERT_EQ(mesh.cells().size(), per_level * (4 + 2));
  std::array<std::size_t, 3> regions{};
  for (const HexCell& cell : mesh.cells()) ++regions[static_cast<std::size_t>(cell.region)];
  EXPECT_EQ(regions, (std::array<std::size_t, 3>{4 * per_level, per_level, per_level}));
}

// Volumes come to 2/3 pi (abc - a'b'c'), and the error falls by about four as cells are halved.
TEST(PadShape, MeshFillsThePad) {
  const PadShape shape;
  const double whole = 2 * kPi / 3 *
                       (shape.length / 2 * shape.width / 2 * shape.height -
                        shape.bone_length / 2 * shape.bone_width / 2 * shape.bone_height);
  const double coarse = whole - cells_volume(pad_mesh(shape, {4, 2, 2})),
               fine = whole - cells_volume(pad_mesh(shape, {8, 4, 4}));
  EXPECT_LT(std::abs(fine), 0.02 * whole);
  EXPECT_GT(coarse / fine, 3);
  EXPECT_LT(coarse / fine, 5);
}

// New nodes of cells at the rim lie on the rim, which is held; those of the skin are on the skin.
TEST(PadShape, RefinedNodesKeepToTheSurfaces) {
  const PadShape shape;
  HexMesh mesh = pad_mesh(shape, {2, 1, 1});
  const int before = mesh.nodes();
  mesh.refine(mesh.active());
  const std::vector<bool> held = held_by_bone(mesh), skin = skin_nodes(mesh);
  int rims = 0;
  for (int node = before; node < mesh.nodes(); ++node) {
    const Vector3d c = mesh.chart_point(node), p = mesh.place(node);
    EXPECT_LE(c.head<2>().norm(), 1 + 1e-12);
    const auto i = static_cast<std::size_t>(node);
    if (PadChart::on_rim(c)) {
      ++rims;
      EXPECT_TRUE(held[i]);
      EXPECT_NEAR(p[2], 0, 1e-12);
    }
    const Vector3d outer(shape.length / 2, shape.width / 2, shape.height);
    EXPECT_EQ(skin[i], std::abs(p.cwiseQuotient(outer).norm() - 1) < 1e-9) << node;
  }
  // The rim had 8 nodes on 2 levels, and has 16 on 3.
  EXPECT_EQ(rims, 16 * 3 - 8 * 2);
}

TEST(PadShape, RefusesWhatDoesNotFit) {
  PadShape shape;
  shape.bone_width = 0;
  EXPECT_EQ(message_of([&] { (void)PadChart(shape); }), "a pad needs lengths above 0, got 0 m");
  shape = half_balls(10e-3, 6e-3);
  shape.layers = {{3e-3}, {2e-3}};
  EXPECT_EQ(message_of([&] { (void)PadChart(shape); }),
            "layers of skin, 5 mm, do not fit above the bone: 4 mm");
  shape.layers = {{0}};
  EXPECT_EQ(message_of([&] { (void)PadChart(shape); }),
            "a layer of skin needs a thickness above 0, got 0 m");
  EXPECT_EQ(message_of([] {
              (void)pad_mesh({}, {4, 0, 3});
            }),
            "a pad's mesh needs at least one cell each way");
  EXPECT_EQ(message_of([] { (void)pad_columns({}, 0); }),
            "a bed of springs needs at least one ring, got 0");
}

}  // namespace
}  // namespace thenar
