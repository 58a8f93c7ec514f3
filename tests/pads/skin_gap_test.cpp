// Tests for pads/skin_gap.cpp: the deepest place of the skin against a search over all of it.

#include "pads/skin_gap.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "geometry/primitives.h"

namespace thenar {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kClose = 3e-7;  // [m]

/// The deepest overlap of all the skin [m]: each of a fine grid's best, then finer around them.
double brute_overlap(const PadChart& chart, const Shape& object, const Pose<double>& X_PO) {
  const Pose<double> X_OP = X_PO.inverse();
  const auto overlap = [&](const Vector2d& c) {
    return c.norm() > 1 ? -1e3 : -object.distance(X_OP * chart.place({c[0], c[1], 1}));
  };
  constexpr int kGrid = 60;
  std::vector<std::pair<double, Vector2d>> all;
  for (int i = -kGrid; i <= kGrid; ++i)
    for (int j = -kGrid; j <= kGrid; ++j) {
      const Vector2d c(i / double{kGrid}, j / double{kGrid});
      all.emplace_back(overlap(c), c);
    }
  const auto deeper = [](const auto& a, const auto& b) { return a.first > b.first; };
  std::partial_sort(all.begin(), all.begin() + 20, all.end(), deeper);
  double most = all[0].first;
  for (int k = 0; k < 20; ++k) {
    auto [best, at] = all[static_cast<std::size_t>(k)];
    for (double size = 2.0 / kGrid; size > 1e-8; size *= 0.6) {
      const Vector2d from = at;
      for (int i = -6; i <= 6; ++i)
        for (int j = -6; j <= 6; ++j) {
          const Vector2d c = from + size / 6 * Vector2d(i, j);
          const double found = overlap(c);
          if (found <= best) continue;
          best = found;
          at = c;
        }
    }
    most = std::max(most, best);
  }
  return most;
}

struct Pressing {
  const char* name;
  std::shared_ptr<const Shape> shape;
};

std::vector<Pressing> objects() {
  return {{"ball", build_sphere(8e-3)},
          {"small ball", build_sphere(2e-3)},
          {"cylinder", build_cylinder(4e-3, 60e-3)},
          {"short cylinder", build_cylinder(6e-3, 4e-3)},
          {"box", build_box({20e-3, 14e-3, 8e-3})},
          {"plate", build_box({50e-3, 50e-3, 3e-3})}};
}

Eigen::Matrix3d random_turn(std::mt19937& rng) {
  std::normal_distribution<double> normal;
  Eigen::Quaterniond q(normal(rng), normal(rng), normal(rng), normal(rng));
  return q.normalized().toRotationMatrix();
}

/// An object somewhere over the skin, moved along the skin's normal until it overlaps by a depth.
Pose<double> random_pose(const PadChart& chart, const Shape& object, double depth,
                         std::mt19937& rng) {
  std::uniform_real_distribution<double> on(-0.6, 0.6);
  const double a = on(rng), b = on(rng);
  const Vector3d at = chart.place({a, b, 1});
  const Vector3d out = at.cwiseQuotient(Vector3d(144, 64, 100)).normalized();
  Pose<double> X{random_turn(rng), at + 0.08 * out};
  // As near as nothing is overlapped, then deeper.
  for (int i = 0; i < 60; ++i) {
    const double gap = -deepest_skin(chart, object, X).overlap;
    X.p -= gap * out;
    if (std::abs(gap) < 1e-6) break;
  }
  X.p -= depth * out;
  return X;
}

TEST(DeepestSkin, IsTheDeepestOfAll) {
  const PadChart chart{PadShape()};
  std::mt19937 rng(5);
  std::uniform_real_distribution<double> deep(-2e-3, 1.5e-3);
  for (const Pressing& object : objects())
    for (int i = 0; i < 12; ++i) {
      const Pose<double> X = random_pose(chart, *object.shape, deep(rng), rng);
      const double all = brute_overlap(chart, *object.shape, X);
      EXPECT_NEAR(deepest_skin(chart, *object.shape, X).overlap, all, kClose)
          << object.name << " " << i;
    }
}

TEST(DeepestSkin, StaysTheDeepestWhileItsLeadLasts) {
  const PadChart chart{PadShape()};
  std::mt19937 rng(6);
  std::uniform_real_distribution<double> deep(-1e-3, 1.5e-3), part(-1, 1);
  for (const Pressing& object : objects())
    for (int i = 0; i < 8; ++i) {
      const Pose<double> X = random_pose(chart, *object.shape, deep(rng), rng);
      const DeepestSkin first = deepest_skin(chart, *object.shape, X);
      // Motions of all points of the pad by less than half of the lead, there and back.
      Vector2d at = first.disc;
      for (int k = 1; k <= 10; ++k) {
        const double most = 0.25 * first.lead;
        const Vector3d turn = most / 12e-3 * 0.5 * Vector3d(part(rng), part(rng), part(rng)),
                       way = most * 0.5 * Vector3d(part(rng), part(rng), part(rng));
        Pose<double> Y = X;
        Y.p += way;
        Y = Pose<double>{Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix(),
                         {0, 0, 0}} *
            Y;
        const DeepestSkin near = deepest_skin(chart, *object.shape, Y, at);
        at = near.disc;
        EXPECT_NEAR(near.overlap, deepest_skin(chart, *object.shape, Y).overlap, kClose)
            << object.name << " " << i << " " << k;
        EXPECT_EQ(near.lead, 0);
      }
    }
}

// A ball of radius R against a flat face: the second difference over h = 1 mm of its distance,
// sqrt(R^2 + h^2) - R on either side, for balls of any size.
TEST(SkinGap, IsMeasuredOverOneMillimetre) {
  constexpr double kStep = 1e-3, kDepth = 1e-4, kHalf = 5e-3;  // [m]
  const auto plate = build_box({80e-3, 80e-3, 2 * kHalf});
  for (const double R : {5e-3, 10e-3, 20e-3}) {
    Pose<double> X;
    X.p.z() = R - kDepth + kHalf;
    const RelativeCurvatures gap = skin_gap(*build_sphere(R), *plate, X, {0, 0, R});
    const double k = 2 * (std::hypot(R, kStep) - R) / (kStep * kStep);
    EXPECT_NEAR(gap.k1, k, 1e-6);
    EXPECT_NEAR(gap.k2, k, 1e-6);
  }
}

}  // namespace
}  // namespace thenar
