// Contact without friction against closed forms: lines, strips and discs on a thick layer.

#include <cmath>

#include <gtest/gtest.h>

#include "geometry/primitives.h"
#include "tests/pads/tissue_samples.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

constexpr double kHalfTurn = 3.14159265358979323846;

/// How a layer of thickness h that is stuck to its floor answers a pressure of wave number t / h,
/// over how a half space does: -> 1 for short waves.
double layer_answer(double t, double poisson_ratio) {
  const double k = 3 - 4 * poisson_ratio, e = std::exp(-2 * t);
  return (k * (1 - e * e) - 4 * t * e) / (k * (1 + e * e) + (1 + k * k + 4 * t * t) * e);
}

/// What the floor takes off the sinking of a layer: constants of Green's functions near the load,
///   line of force per length p:   w = 2 p / (pi E*) (ln(h / |x|) + line),
///   force F at a point:           w = F / (pi E*) (1 / r - point / h),
/// from  line = integral of (m - 1 + exp(-t)) / t,  point = integral of 1 - m.
struct LayerConstants {
  double line = 0, point = 0;
};
LayerConstants layer_constants(double poisson_ratio) {
  LayerConstants out;
  constexpr double kEnd = 40, kStep = 1e-3;
  for (double t = kStep / 2; t < kEnd; t += kStep) {
    const double m = layer_answer(t, poisson_ratio);
    out.line += kStep * (m - 1 + std::exp(-t)) / t;
    out.point += kStep * (1 - m);
  }
  return out;
}

TEST(LayerConstants, AreThoseOfDimitriadis) {
  // 2 / pi of them is 1.133 for an incompressible stuck layer, of a fit that is good to 1 %
  // [Dimitriadis2002].
  EXPECT_NEAR(2 / kHalfTurn * layer_constants(0.5).point, 1.133, 0.01);
}

/// A long slab: x across the line, y along it. Its ends are free, five thicknesses from the middle,
/// so that they do not tell there.
struct LongSlab : TissueBlock {
  static constexpr double kThickness = 1;
  /// @param half  coordinates across it from its middle, in cells of `fine` and more [m]
  LongSlab(const std::vector<double>& half, double fine, double growth, double poisson_ratio)
      : TissueBlock(
            graded_box(mirrored(half), mirrored({0, kRow, 3, 4.2, 5}), depths(fine, growth)),
            {neo_hookean(12e3, poisson_ratio)}) {}
  static std::vector<double> depths(double fine, double growth) {
    const std::vector<double> below = graded_half(fine, 2 * fine, growth, kThickness);
    std::vector<double> z;
    for (auto each = below.rbegin(); each != below.rend(); ++each) z.push_back(-*each);
    return z;
  }
  /// Force per length of the two cells in the middle, half of that on their outer nodes [N/m].
  [[nodiscard]] double line_force(const PressState& state) const {
    double sum = 0;
    for (std::size_t k = 0; k < surface.nodes.size(); ++k) {
      const double y = std::abs(mesh.place(node_of(k))[1]);
      const double share = y < 1e-9 ? 1 : y < kRow + 1e-9 ? 0.5 : 0;
      sum += share * state.normal_force[static_cast<Eigen::Index>(k)];
    }
    return sum / (2 * kRow);
  }

 private:
  static constexpr double kRow = 1.5;  // first nodes beside the middle [m]
};

TEST(Hertz, ACylinderMeetsTheLineContact) {
  constexpr double kNu = 0.49, kHalfWidth = 0.05, kRadius = 5;
  LongSlab slab(graded_half(kHalfWidth / 8, 1.1 * kHalfWidth, 1.4, 2.5), kHalfWidth / 8, 1.4, kNu);
  // The depth at which the patch is so wide: P' = pi E* a^2 / (4 R), and the sinking of its
  // half ellipse of pressure [Johnson1985] sec. 4.2.
  const double line = layer_constants(kNu).line;
  const double square = kHalfWidth * kHalfWidth;
  const double depth =
      square / (2 * kRadius) * (std::log(2 * LongSlab::kThickness / kHalfWidth) + 0.5 + line);
  const double force = kHalfTurn * plane_modulus(neo_hookean(12e3, kNu)) * square / (4 * kRadius);
  // The cylinder lies along y.
  PressGoal goal;
  goal.X_PO.R = rotation_about<double>({1, 0, 0}, kHalfTurn / 2);
  goal.X_PO.p = {0, 0, kRadius};
  PressState state = slab.at_rest(goal.X_PO);
  goal.X_PO.p[2] -= depth;
  PressOptions options;
  options.gap_tolerance = 1e-5 * depth;
  const PressOutcome out = slab.press({build_cylinder(kRadius, 20), 0}, goal, state, options);
  ASSERT_EQ(out.status, Status::kSolved) << out.message;
  EXPECT_NEAR(slab.line_force(state) / force, 1, 0.01);
}

TEST(FlatPunch, AStripMeetsItsLogarithm) {
  // Cells get small towards both edges, where pressure grows without bound.
  constexpr double kNu = 0.49, kHalfWidth = 0.05, kFinest = kHalfWidth / 64;
  const std::vector<double> inside = graded_half(kFinest, kFinest, 1.6, kHalfWidth);
  std::vector<double> half;
  for (auto each = inside.rbegin(); each != inside.rend(); ++each)
    half.push_back(kHalfWidth - *each);
  for (const double each : graded_half(kFinest, kFinest, 1.6, 2.5 - kHalfWidth))
    if (each > 0) half.push_back(kHalfWidth + each);
  LongSlab slab(half, kFinest, 1.6, kNu);
  // P' / sqrt(a^2 - x^2) / pi sinks everything below it by the same [Johnson1985] sec. 2.8.
  constexpr double kDepth = 1e-4 * kHalfWidth;
  const double force =
      kHalfTurn * plane_modulus(neo_hookean(12e3, kNu)) * kDepth /
      (2 * (std::log(2 * LongSlab::kThickness / kHalfWidth) + layer_constants(kNu).line));
  // Its edges lie a little outside the nodes of the patch.
  PressGoal goal;
  goal.X_PO.p = {0, 0, 0.5};
  PressState state = slab.at_rest(goal.X_PO);
  goal.X_PO.p[2] -= kDepth;
  PressOptions options;
  options.gap_tolerance = 1e-5 * kDepth;
  const PressOutcome out =
      slab.press({build_box({2.002 * kHalfWidth, 20, 1}), 0}, goal, state, options);
  ASSERT_EQ(out.status, Status::kSolved) << out.message;
  EXPECT_NEAR(slab.line_force(state) / force, 1, 0.01);
}

}  // namespace
}  // namespace thenar
