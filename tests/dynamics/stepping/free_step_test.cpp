// Tests for dynamics/stepping/free_step.cpp and its coefficients.

#include "dynamics/stepping/free_step.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <set>
#include <vector>

#include "tests/dynamics/stepping/sample_scenes.h"

namespace thenar {
namespace {

using Method = DormandPrince;

/// A rooted tree: the trees on its root, in order. It stands for a derivative of the solution.
struct Tree {
  std::vector<Tree> branches;
  bool operator<(const Tree& other) const { return branches < other.branches; }
};

int size_of(const Tree& tree) {
  int size = 1;
  for (const Tree& branch : tree.branches) size += size_of(branch);
  return size;
}

double density(const Tree& tree) {
  double product = size_of(tree);
  for (const Tree& branch : tree.branches) product *= density(branch);
  return product;
}

/// All trees with so many knots.
std::set<Tree> trees(int size) {
  if (size == 1) return {Tree{}};
  std::set<Tree> out;
  // One branch of a smaller tree grows by a knot, at each knot in turn.
  const std::function<void(const Tree&, const std::function<void(Tree)>&)> grow =
      [&](const Tree& tree, const std::function<void(Tree)>& keep) {
        Tree wider = tree;
        wider.branches.push_back({});
        std::sort(wider.branches.begin(), wider.branches.end());
        keep(wider);
        for (std::size_t i = 0; i < tree.branches.size(); ++i)
          grow(tree.branches[i], [&](const Tree& branch) {
            Tree grown = tree;
            grown.branches[i] = branch;
            std::sort(grown.branches.begin(), grown.branches.end());
            keep(grown);
          });
      };
  for (const Tree& tree : trees(size - 1)) grow(tree, [&](Tree grown) { out.insert(grown); });
  return out;
}

using Stages = std::array<double, Method::kStages>;

/// What a tree's derivative is at each stage.
Stages weights_at(const Tree& tree) {
  Stages out;
  out.fill(1);
  for (const Tree& branch : tree.branches) {
    const Stages inner = weights_at(branch);
    for (std::size_t i = 0; i < out.size(); ++i) {
      double sum = 0;
      for (std::size_t j = 0; j < i; ++j) sum += Method::a[i][j] * inner[j];
      out[i] *= sum;
    }
  }
  return out;
}

/// Largest miss of the conditions of one order: weights times those of the stages are 1 / density.
double worst_condition(const Stages& weights, int order) {
  double worst = 0;
  for (const Tree& tree : trees(order)) {
    const Stages at = weights_at(tree);
    double sum = 0;
    for (std::size_t i = 0; i < at.size(); ++i) sum += weights[i] * at[i];
    worst = std::max(worst, std::abs(sum - 1 / density(tree)));
  }
  return worst;
}

TEST(FreeStep, RowsAddUpToTheirNodes) {
  for (std::size_t i = 0; i < Method::kStages; ++i) {
    double sum = 0;
    for (const double entry : Method::a[i]) sum += entry;
    EXPECT_NEAR(sum, Method::c[i], 1e-14) << i;
  }
}

// All 1 + 1 + 2 + 4 + 9 + 20 + 48 + 115 = 200 conditions of order eight [Hairer1993], Table II.2.2.
TEST(FreeStep, MeetsAllConditionsOfItsOrder) {
  const std::array<std::size_t, 9> counts{0, 1, 1, 2, 4, 9, 20, 48, 115};
  Stages five = Method::b;
  for (std::size_t i = 0; i < five.size(); ++i) five[i] -= Method::b_minus_b5[i];
  for (int order = 1; order <= 8; ++order) {
    EXPECT_EQ(trees(order).size(), counts[static_cast<std::size_t>(order)]);
    EXPECT_LT(worst_condition(Method::b, order), 1e-14) << order;
    EXPECT_EQ(worst_condition(five, order) < 1e-14, order <= 5) << order;
    EXPECT_EQ(worst_condition(Method::b3, order) < 1e-14, order <= 3) << order;
  }
  // And no more.
  EXPECT_GT(worst_condition(Method::b, 9), 1e-6);
}

/// A rod let go at 90 degrees from below. @param quarter  of its period [s]
MovingScene pendulum(double& quarter) {
  MovingScene scene;
  ShapeSpec bob = sample::primitive(ShapeKind::kSphere, {0.01, 0, 0});
  bob.X_BS.p = {0.2, 0, 0};
  sample::add_on_joint(scene, "bob", bob, 0.1, JointKind::kHinge, {0, 1, 0}, {0, 0, 0});
  const double d = 0.2, inertia = 0.1 * d * d + 0.4 * 0.1 * 1e-4;
  quarter = std::comp_ellint_1(std::sqrt(0.5)) * std::sqrt(inertia / (0.1 * sample::kG * d));
  return scene;
}

// After a period  4 sqrt(I / (m g d)) K(sin 45)  it is back: half the step leaves 1/256 of the
// error. Estimates, those of a step, fall with its length to the eighth.
TEST(FreeStep, IsOfOrderEightOnAPendulum) {
  double quarter = 0;
  const MovingScene scene = pendulum(quarter);
  ContactStep steps(scene);
  std::vector<double> errors, estimates;
  for (const int count : {8, 16, 32}) {
    const double h = 4 * quarter / count;
    SceneState state = steps.initial_state(), first = state;
    FreeStep method(steps);
    estimates.push_back(method.take_step(steps, h / 4, first).v);
    for (int i = 0; i < count; ++i) (void)method.take_step(steps, h, state);
    errors.push_back(std::abs(state.v[0]));
  }
  for (const std::size_t i : {0, 1}) {
    EXPECT_GT(std::log2(errors[i] / errors[i + 1]), 7.5);
    EXPECT_GT(std::log2(estimates[i] / estimates[i + 1]), 7);
  }
  EXPECT_LT(errors[2], 1e-7);
}

// A step that is tried again from the same place gives the bits of a first try.
TEST(FreeStep, TriesAgainFromTheSamePlace) {
  double quarter = 0;
  const MovingScene scene = pendulum(quarter);
  ContactStep steps(scene);
  FreeStep method(steps), fresh(steps);
  SceneState tried = steps.initial_state(), again = steps.initial_state(),
             once = steps.initial_state();
  (void)method.take_step(steps, quarter, tried);
  (void)method.take_step(steps, 0.1 * quarter, again);
  (void)fresh.take_step(steps, 0.1 * quarter, once);
  EXPECT_EQ(again.q, once.q);
  EXPECT_EQ(again.v, once.v);
}

}  // namespace
}  // namespace thenar
