// Tests for geometry/mesh_from_distance.cpp.

#include "geometry/mesh_from_distance.h"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/units.h"
#include "geometry/primitives.h"
#include "geometry/shape_union.h"
#include "tests/geometry/enclosed_volume.h"
#include "tests/geometry/random_points.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

std::shared_ptr<const Shape> link_of_a_hand() {
  return join({build_tapered_capsule(0.010, 0.008, 0.045),
               place(build_sphere(0.0095), {Eigen::Matrix3d::Identity(), {0.002, 0, 0.022}})});
}

/// Inside or outside by lot: what no solid looks like, with every saddle a grid can have.
class Noise final : public Shape {
 public:
  double distance(const Vector3d& p) const override {
    const Eigen::Vector3i node = (p.array() * 2).round().cast<int>();
    std::mt19937 lot(1000003 * node.x() + 1009 * node.y() + 7 * node.z());
    lot.discard(3);
    return uniform(lot) - 0.5;
  }
  NearestSurface nearest(const Vector3d&) const override { return {0, Vector3d::UnitZ()}; }
  Eigen::AlignedBox3d bounds() const override {
    return {Vector3d::Constant(0.25), Vector3d::Constant(8.25)};
  }
  double accuracy() const override { return std::numeric_limits<double>::infinity(); }
};

TEST(MeshFromDistance, IsWatertightWhateverTheSides) {
  const TriangleMesh mesh = mesh_from_distance(Noise(), 0.5);
  EXPECT_GT(mesh.triangles.cols(), 10000);
  (void)enclosed_volume(mesh);
}

TEST(MeshFromDistance, PutsCornersOnTheSurface) {
  const auto link = link_of_a_hand();
  const TriangleMesh mesh = mesh_from_distance(*link, 0.001);
  EXPECT_GT(mesh.triangles.cols(), 4000);
  for (Eigen::Index i = 0; i < mesh.vertices.cols(); ++i)
    EXPECT_NEAR(link->distance(mesh.vertices.col(i)), 0, 1e-9);
}

// Chords of a ball of radius r sink in by about (cell / r)^2 / 8; four thirds pi r^3 less thrice
// that.
TEST(MeshFromDistance, EnclosesTheVolume) {
  const double exact = 4 * kPi / 3 * 8e-6;
  const double coarse = enclosed_volume(mesh_from_distance(*build_sphere(0.02), 0.002));
  const double fine = enclosed_volume(mesh_from_distance(*build_sphere(0.02), 0.001));
  EXPECT_NEAR(coarse / exact, 1, 3 * 0.01 / 8);
  EXPECT_NEAR((exact - coarse) / (exact - fine), 4, 0.4);  // second order
}

TEST(MeshFromDistance, KeepsACavityOpen) {
  class Bowl final : public Shape {  // half of a hollow ball
   public:
    double distance(const Vector3d& p) const override {
      return std::max(std::abs(p.norm() - 0.02) - 0.003, p.z());
    }
    NearestSurface nearest(const Vector3d& p) const override {
      const double hollow = p.norm() - 0.02;
      if (p.z() > std::abs(hollow) - 0.003) return {p.z(), Vector3d::UnitZ()};
      return {std::abs(hollow) - 0.003, std::copysign(1, hollow) * p.normalized()};
    }
    Eigen::AlignedBox3d bounds() const override {
      return {Vector3d::Constant(-0.023), Vector3d(0.023, 0.023, 0)};
    }
  };
  const double exact = 2 * kPi / 3 * (std::pow(0.023, 3) - std::pow(0.017, 3));
  EXPECT_NEAR(enclosed_volume(mesh_from_distance(Bowl(), 0.001)) / exact, 1, 0.02);
}

TEST(MeshFromDistance, RefusesCellsThatAreNoneOrTooMany) {
  const auto ball = build_sphere(0.02);
  EXPECT_EQ(message_of([&] { (void)mesh_from_distance(*ball, 0); }),
            "a cell must be positive and finite, got 0 m");
  EXPECT_THAT(message_of([&] { (void)mesh_from_distance(*ball, 1e-6); }),
              testing::StartsWith("cells of 1e-06 m are too small for a solid of 0.04 m"));
}

}  // namespace
}  // namespace thenar
