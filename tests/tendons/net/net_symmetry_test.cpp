// What may not matter to a net at rest: which hand it is, where the hand is, the unit of force, the
// order of its bands.

#include <algorithm>
#include <random>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tendons/net/solve_net.h"
#include "tests/matrix_near.h"
#include "tests/tendons/net/head_net.h"
#include "tests/tendons/net/sample_nets.h"

namespace thenar {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

// Forces are balanced to 1e-9 N in nets that are stiffer than 1e2 N/m.
constexpr double kSamePlace = 1e-11;   // [m]
constexpr double kSameTension = 1e-8;  // [N]

/// A net on posed bones under a drive.
struct SymmetryCase {
  Net net;
  TreeState<double> state;
  NetDrive drive;
  [[nodiscard]] NetEquilibrium rest(const NetSolverOptions& options = {}) const {
    return NetSolver(net, options).solve(state, drive);
  }
};

SymmetryCase case_of(const SampleNet& sample) { return {sample.net, sample.state(), sample.drive}; }

/// Nets that lie on bone, where all places are stiff.
std::vector<SymmetryCase> nets_on_bone() {
  std::vector<SymmetryCase> cases;
  for (const auto& [nodes, bands] : {std::pair{9, 24}, {15, 40}, {15, 55}, {24, 80}})
    cases.push_back(case_of(sample_net_on_bone(nodes, bands)));
  cases.push_back(case_of(net_over_head()));
  return cases;
}

/// The other hand: z turned round. Surfaces are their own images in the plane z = 0 of frame S.
SymmetryCase mirrored(SymmetryCase c) {
  const Matrix3d M = Vector3d(1, 1, -1).asDiagonal();
  for (NetNode& node : c.net.nodes) node.p = M * node.p;
  for (BoneSurface& surface : c.net.surfaces) {
    surface.X.R = M * surface.X.R * M;
    surface.X.p = M * surface.X.p;
  }
  for (NetBand& band : c.net.bands) band.side = M * band.side;
  for (LinkState<double>& link : c.state) {
    link.X.R = M * link.X.R * M;
    link.X.p = M * link.X.p;
  }
  return c;
}

/// The whole hand somewhere else.
SymmetryCase carried(SymmetryCase c, const Pose<double>& X) {
  for (NetNode& node : c.net.nodes)
    if (node.link < 0) node.p = X * node.p;
  for (BoneSurface& surface : c.net.surfaces)
    if (surface.link < 0) surface.X = X * surface.X;
  for (LinkState<double>& link : c.state) link.X = X * link.X;
  return c;
}

Pose<double> elsewhere() {
  Pose<double> X;
  X.R = rotation_about(Vector3d(Vector3d(2, -1, 3).normalized()), 1.1);
  X.p = {0.05, -0.11, 0.07};
  return X;
}

/// Twice the force everywhere.
SymmetryCase doubled(SymmetryCase c) {
  for (NetBand& band : c.net.bands) band.EA *= 2;
  c.drive.tension *= 2;
  return c;
}

/// The same bands told in another order: new[i] = old[order[i]].
SymmetryCase reordered(SymmetryCase c, const std::vector<int>& order) {
  const Net old = c.net;
  for (std::size_t i = 0; i < order.size(); ++i)
    c.net.bands[i] = old.bands[static_cast<std::size_t>(order[i])];
  return c;
}

std::vector<int> shuffled(std::size_t n) {
  std::vector<int> order(n);
  for (std::size_t i = 0; i < n; ++i) order[i] = static_cast<int>(i);
  std::shuffle(order.begin(), order.end(), std::mt19937(5));
  return order;
}

TEST(NetSymmetry, TheOtherHandHasTheMirroredShapeAndTheSameTensions) {
  const Vector3d mirror(1, 1, -1);
  for (const SymmetryCase& c : nets_on_bone()) {
    const NetEquilibrium here = c.rest(), there = mirrored(c).rest();
    ASSERT_EQ(here.status, NetStatus::kBalanced);
    ASSERT_EQ(there.status, NetStatus::kBalanced);
    EXPECT_TRUE(matrix_near(there.x, mirror.asDiagonal() * here.x, kSamePlace));
    EXPECT_TRUE(matrix_near(there.tension, here.tension, kSameTension));
    EXPECT_EQ(there.contacts.size(), here.contacts.size());
  }
}

TEST(NetSymmetry, WhereTheHandIsDoesNotMatter) {
  const Pose<double> X = elsewhere();
  for (const SymmetryCase& c : nets_on_bone()) {
    const NetEquilibrium here = c.rest(), there = carried(c, X).rest();
    ASSERT_EQ(here.status, NetStatus::kBalanced);
    ASSERT_EQ(there.status, NetStatus::kBalanced);
    EXPECT_TRUE(matrix_near(there.x, (X.R * here.x).colwise() + X.p, kSamePlace));
    EXPECT_TRUE(matrix_near(there.tension, here.tension, kSameTension));
    EXPECT_NEAR(there.energy, here.energy, 1e-14);
  }
}

TEST(NetSymmetry, TwiceTheForceAndStiffnessKeepTheShape) {
  for (const SymmetryCase& c : nets_on_bone()) {
    NetSolverOptions doubled_too;
    doubled_too.tolerance *= 2;
    const NetEquilibrium once = c.rest(), twice = doubled(c).rest(doubled_too);
    ASSERT_EQ(once.status, NetStatus::kBalanced);
    ASSERT_EQ(twice.status, NetStatus::kBalanced);
    EXPECT_TRUE(matrix_near(twice.x, once.x, 1e-12 * 0.03));  // nets of 3 cm
    EXPECT_TRUE(matrix_near(twice.tension, 2 * once.tension, 1e-12 * 2 * once.tension.maxCoeff()));
    EXPECT_NEAR(twice.energy, 2 * once.energy, 1e-12 * once.energy);
  }
}

TEST(NetSymmetry, TheOrderOfBandsDoesNotMatter) {
  for (const SymmetryCase& c : nets_on_bone()) {
    const std::vector<int> order = shuffled(c.net.bands.size());
    const NetEquilibrium here = c.rest(), there = reordered(c, order).rest();
    ASSERT_EQ(here.status, NetStatus::kBalanced);
    ASSERT_EQ(there.status, NetStatus::kBalanced);
    EXPECT_TRUE(matrix_near(there.x, here.x, kSamePlace));
    for (std::size_t i = 0; i < order.size(); ++i)
      EXPECT_NEAR(there.tension(static_cast<Eigen::Index>(i)), here.tension(order[i]),
                  kSameTension);
  }
}

// Random nets without bones have one set of tensions, and may have loose or soft places. Both
// answers are balanced to 1e-9 N, so each is off by a few times that.
TEST(NetSymmetry, HoldsForTensionsOfRandomNets) {
  const Pose<double> X = elsewhere();
  int compared = 0;
  for (unsigned seed = 0; seed < 200; ++seed) {
    std::mt19937 rng(seed);
    const SymmetryCase c = case_of(random_net(rng));
    const NetEquilibrium here = c.rest();
    const NetEquilibrium images[] = {mirrored(c).rest(), carried(c, X).rest(), doubled(c).rest()};
    for (int k = 0; k < 3; ++k) {
      if (here.status != images[k].status || here.status > NetStatus::kNodeCollapsed) continue;
      ++compared;
      EXPECT_TRUE(matrix_near(images[k].tension, (k == 2 ? 2 : 1) * here.tension, 2e-8))
          << "seed " << seed << ", image " << k;
    }
  }
  EXPECT_GE(compared, 590);  // of 600; one in a hundred may stall by rounding
}

}  // namespace
}  // namespace thenar
