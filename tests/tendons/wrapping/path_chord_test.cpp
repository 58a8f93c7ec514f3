// Paths over one round surface against wrap_string(), which finds them in closed form.

#include <random>

#include <gtest/gtest.h>

#include "tendons/wrapping/path_solver.h"
#include "tendons/wrapping/wrapped_string.h"
#include "tests/tendons/wrapping/wrap_samples.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

/// A bone of 5 mm, turned and moved.
BoneSurface bone_of(SurfaceShape shape) {
  BoneSurface bone{"bone", -1, shape, {0.005, 0.05, 0}, {}};
  bone.X.R = rotation_about(Vector3d(Vector3d(1, -2, 0.5).normalized()), 0.7);
  bone.X.p = {0.01, 0.02, -0.005};
  return bone;
}

void expect_same_lengths(SurfaceShape shape) {
  std::mt19937 rng(2);
  std::uniform_real_distribution<double> draw(-0.015, 0.015);
  const BoneSurface bone = bone_of(shape);
  const Vector3d side_S(0.2, 0.02, 0);
  for (int bent = 0; bent < 300;) {
    const Vector3d a(draw(rng), draw(rng), draw(rng)), b(draw(rng), draw(rng), draw(rng));
    if (probe(bone, a).gap < 1e-4 || probe(bone, b).gap < 1e-4) continue;
    const WrappedString chord = wrap_string(bone, a, b, side_S);
    const PathSet set = sample::string_over({bone}, bone.X * a, bone.X * b, bone.X * side_S);
    EXPECT_NEAR(sample::shape_of(set).length, chord.length, 1e-12);
    bent += chord.bent ? 1 : 0;
  }
}

TEST(PathChord, HasTheLengthOfTheClosedFormOnASphere) {
  expect_same_lengths(SurfaceShape::kSphere);
}

TEST(PathChord, HasTheLengthOfTheClosedFormOnACylinder) {
  expect_same_lengths(SurfaceShape::kCylinder);
}

}  // namespace
}  // namespace thenar
