// Tests for pads/skin_springs.cpp: a slab at an even depth, and slopes by differences.

#include "pads/skin_springs.h"

#include <random>

#include <gtest/gtest.h>

#include "geometry/primitives.h"
#include "tests/matrix_near.h"
#include "tests/pads/tissue_samples.h"

namespace thenar {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kPerArea = 1e7;       // of springs [N/m^3]
constexpr double kAsideShift = 1e-10;  // no place of the object is moved farther than this [m]

/// A block's top with springs of an even stiffness per area.
struct SprungBlock {
  TissueBlock block{
      graded_box(even_axis(-3e-3, 3e-3, 3), even_axis(-2e-3, 2e-3, 2), even_axis(-2e-3, 0, 1)),
      {neo_hookean(12e3, 0.4)}};
  SkinSprings springs{*block.body, block.surface};
  std::vector<double> stiffness;
  VectorXd x = VectorXd::Zero(block.body->unknowns());
  Matrix3Xd anchor, shear;

  SprungBlock() {
    for (Eigen::Index k = 0; k < block.surface.area.size(); ++k)
      stiffness.push_back(kPerArea * block.surface.area[k]);
    shear = Matrix3Xd::Zero(3, block.surface.area.size());
    anchor = block.surface.rest_positions;
  }
  /// @param slipped  of the nodes since the step began [m] (3)
  void find(const Shape& object, const Pose<double>& X, double friction, const Vector3d& slipped) {
    for (Eigen::Index k = 0; k < anchor.cols(); ++k)
      anchor.col(k) = X.inverse() * Vector3d(block.surface.rest_positions.col(k) - slipped);
    springs.update(object, X, x, stiffness, friction, {anchor, shear});
  }
};

Pose<double> lifted(double height) {
  Pose<double> X;
  X.p[2] = height;
  return X;
}

// At an even depth d nodes bear  k d  of their areas, and the energy is  k d^2 / 2  of the whole.
TEST(SkinSprings, PressAnEvenDepthByArea) {
  SprungBlock sample;
  const double depth = 0.3e-3;
  sample.find(*build_box({0.1, 0.1, 0.02}), lifted(0.01 - depth), 0, Vector3d::Zero());
  EXPECT_NEAR(sample.springs.max_depth(), depth, kAsideShift);
  EXPECT_NEAR(sample.springs.energy(), kPerArea * depth * depth / 2 * 24e-6,
              1e-6 * kPerArea * 1e-12);
  for (Eigen::Index k = 0; k < sample.shear.cols(); ++k)
    EXPECT_TRUE(matrix_near(sample.springs.normal_forces().col(k),
                            Vector3d(0, 0, -kPerArea * depth * sample.block.surface.area[k]),
                            1e-9));
}

TEST(SkinSprings, DoNothingToSkinOutside) {
  SprungBlock sample;
  sample.find(*build_box({0.1, 0.1, 0.02}), lifted(0.01 + 1e-4), 0.5, Vector3d(1e-3, 0, 0));
  EXPECT_EQ(sample.springs.energy(), 0);
  EXPECT_EQ(sample.springs.normal_forces().norm(), 0);
  EXPECT_EQ(sample.springs.friction_forces().norm(), 0);
}

// Friction is against the slip, in proportion to it while it sticks, and mu times the push after.
TEST(SkinSprings, FrictionGrowsWithSlipUpToItsCone) {
  SprungBlock sample;
  const auto slab = build_box({0.1, 0.1, 0.02});
  const double depth = 0.3e-3, mu = 0.4;
  const auto friction_at = [&](double slip) {
    sample.find(*slab, lifted(0.01 - depth), mu, slip * Vector3d(0.6, -0.8, 0));
    return Vector3d(sample.springs.friction_forces().rowwise().sum());
  };
  const Vector3d little = friction_at(1e-6), twice = friction_at(2e-6), much = friction_at(1e-2);
  EXPECT_TRUE(matrix_near(twice, 2 * little, 1e-9 * little.norm()));
  EXPECT_GT(little.norm(), 0);
  EXPECT_TRUE(matrix_near(much, -mu * kPerArea * depth * 24e-6 * Vector3d(0.6, -0.8, 0), 1e-8));
}

// Slopes of forces along normals and of friction against central differences, where a box's edge
// lies across faces. Slips are short, so that all nodes stick.
TEST(SkinSprings, LossIsTheSlopeOfTheForces) {
  for (const double friction : {0.0, 5.0}) {
    SprungBlock sample;
    std::mt19937 rng(8);
    std::uniform_real_distribution<double> unit(-1, 1);
    const VectorXd way = VectorXd::NullaryExpr(sample.x.size(), [&] { return unit(rng); });
    const auto object = build_box({0.02, 0.02, 0.02});
    Pose<double> X = lifted(0.01 - 0.3e-3);
    X.p[0] = 0.01 + 0.37e-3;
    const VectorXd rest = sample.x;
    const auto forces_at = [&](double step) {
      sample.x = rest + step * way;
      sample.find(*object, X, friction, Vector3d(1e-7, 0, 0));
      return Matrix3Xd(sample.springs.normal_forces() + sample.springs.friction_forces());
    };
    const double step = 1e-9;
    const Matrix3Xd slope = (forces_at(step) - forces_at(-step)) / (2 * step);
    (void)forces_at(0);
    const Matrix3Xd moved =
        deformed_positions(sample.block.surface, way) - sample.block.surface.rest_positions;
    const Matrix3Xd loss = sample.springs.force_loss(moved);
    EXPECT_TRUE(matrix_near(loss, -slope, 1e-5 * slope.cwiseAbs().maxCoeff())) << friction;
  }
}

// A slab that was above the skin and is now below it has pushed points out at its other side.
TEST(SkinSprings, NoticeSkinThatChangedSides) {
  SprungBlock sample;
  const auto plate = build_box({0.1, 0.1, 1e-3});
  const VectorXd rest = sample.x;
  sample.find(*plate, lifted(0.4e-3), 0, Vector3d::Zero());  // its lower side is nearest
  EXPECT_FALSE(sample.springs.has_changed_sides(*plate, lifted(0.6e-3), lifted(0.4e-3), rest, 0));
  sample.find(*plate, lifted(-0.4e-3), 0, Vector3d::Zero());  // its upper side is nearest
  EXPECT_TRUE(sample.springs.has_changed_sides(*plate, lifted(0.6e-3), lifted(-0.4e-3), rest, 0));
}

}  // namespace
}  // namespace thenar
