// Tests for tendons/net/net_friction.cpp: equilibria that can be worked out by hand.

#include "tendons/net/net_friction.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/units.h"
#include "tests/matrix_near.h"
#include "tests/tendons/net/sample_nets.h"

namespace thenar {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kPulleyRadius = 0.005, kMu = 0.3, kDown = kPi / 6;

/// A node on top of a bone, between a muscle and a band of 2 N, 30 degrees down on either side.
/// With tensions a and b the bone presses with (a + b) sin 30, and friction has (a - b) cos 30 to
/// bear.
struct Saddle {
  explicit Saddle(SurfaceShape shape, double mu = kMu) {
    constexpr double kLength = 0.05, kStiff = 200;  // [m], [N]
    net.surfaces = {{"bone", -1, shape, {kPulleyRadius, 0.05, 0}, {}}};
    net.muscles = {"a"};
    net.friction = mu;
    add_node(net, true, -1, {0, kPulleyRadius, 0}, {0});
    for (int side : {1, -1}) {
      const Vector3d way(side * std::cos(kDown), -std::sin(kDown), 0);
      add_node(net, false, -1, Vector3d(0, kPulleyRadius, 0) + kLength * way);
    }
    add_pull(net, 0, 1, 0);
    add_band(net, 0, 2, kLength / (1 + 2 / kStiff), kStiff);
  }
  [[nodiscard]] NetFrictionRest rest(double a) const {
    return solve_net_friction(net, {}, {VectorXd::Constant(1, a), {}});
  }
  Net net;
};

constexpr SurfaceShape kPulleys[] = {SurfaceShape::kSphere, SurfaceShape::kCylinder};

/// Largest a that 2 N on the other side hold:  (a - b) cos = mu (a + b) sin.
double most_held() {
  const double k = kMu * std::tan(kDown);
  return 2 * (1 + k) / (1 - k);
}

TEST(NetFriction, HoldsANodeWhereItStartedUpToTheLimit) {
  for (SurfaceShape shape : kPulleys) {
    const NetFrictionRest rest = Saddle(shape).rest(most_held() * (1 - 1e-9));
    ASSERT_TRUE(rest.settled);
    ASSERT_EQ(rest.nodes.size(), 1U);
    EXPECT_TRUE(rest.nodes[0].sticks);
    EXPECT_TRUE(matrix_near(rest.rest.x.col(0), Vector3d(0, kPulleyRadius, 0), 0));
  }
}

TEST(NetFriction, ReportsTheForcesOfANodeThatSticks) {
  for (SurfaceShape shape : kPulleys) {
    const NetFrictionRest rest = Saddle(shape).rest(2.5);
    ASSERT_EQ(rest.nodes.size(), 1U);
    EXPECT_NEAR(rest.nodes[0].normal, 4.5 * std::sin(kDown), 1e-12);
    EXPECT_TRUE(matrix_near(rest.nodes[0].force, Vector3d(-0.5 * std::cos(kDown), 0, 0), 1e-12));
    ASSERT_EQ(rest.rest.contacts.size(), 1U);
    EXPECT_NEAR(rest.rest.contacts[0].force, 4.5 * std::sin(kDown), 1e-12);
  }
}

// On a cylinder: from a sphere it would slip sideways too.
TEST(NetFriction, LetsANodeSlipBeyondTheLimit) {
  const NetFrictionRest rest = Saddle(SurfaceShape::kCylinder).rest(most_held() * 1.01);
  ASSERT_TRUE(rest.settled);
  ASSERT_EQ(rest.nodes.size(), 1U);
  EXPECT_FALSE(rest.nodes[0].sticks);
  EXPECT_GT(rest.rest.x(0, 0), 1e-6);
}

// Bands, the bone's normal force and mu times it against the slip, from places alone.
TEST(NetFriction, BalancesANodeThatSlips) {
  const NetFrictionRest rest = Saddle(SurfaceShape::kCylinder).rest(3.5);
  ASSERT_TRUE(rest.settled);
  ASSERT_EQ(rest.nodes.size(), 1U);
  const NodeFriction& rub = rest.nodes[0];
  const Vector3d x = rest.rest.x.col(0), n = Vector3d(x.x(), x.y(), 0).normalized();
  const Vector3d bands = 3.5 * (rest.rest.x.col(1) - x).normalized() +
                         rest.rest.tension(1) * (rest.rest.x.col(2) - x).normalized();
  EXPECT_TRUE(matrix_near(bands + rub.normal * n + rub.force, Vector3d::Zero(), 5e-9));
  EXPECT_NEAR(rub.force.norm(), kMu * rub.normal, 5e-9);
  EXPECT_NEAR(rub.force.dot(n), 0, 1e-9);
  EXPECT_LT(rub.force.x(), 0);
}

TEST(NetFriction, WithoutFrictionIsThePlainNet) {
  SampleNet sample = sample_net_on_bone(15, 40);
  const NetEquilibrium plain = NetSolver(sample.net).solve(sample.state(), sample.drive);
  for (double mu : {0.0, 1e-9}) {
    sample.net.friction = mu;
    const NetFrictionRest rest = solve_net_friction(sample.net, sample.state(), sample.drive);
    ASSERT_TRUE(rest.settled);
    EXPECT_TRUE(matrix_near(rest.rest.x, plain.x, 1e-9));
    EXPECT_TRUE(matrix_near(rest.rest.tension, plain.tension, 1e-7));
  }
}

/// Ratio of tensions at the ends of a string of 0.5 N that a muscle of 1 N draws over a quarter of
/// a cylinder by way of `nodes`, each of which it turns by the same angle.
double drawn_over_a_quarter(int nodes, NetFrictionRest& rest) {
  Net net;
  net.friction = kMu;
  net.muscles = {"m"};
  net.surfaces = {{"bone", -1, SurfaceShape::kCylinder, {kPulleyRadius, 0.05, 0}, {}}};
  const double turn = kPi / 2 / nodes;
  const auto on = [&](int i) {
    return Vector3d(kPulleyRadius * std::sin(turn * i), kPulleyRadius * std::cos(turn * i), 0);
  };
  constexpr double kStiff = 1e4;  // [N]
  const double slack = (on(1) - on(0)).norm() / (1 + 0.5 / kStiff);
  for (int i = 0; i < nodes; ++i) add_node(net, true, -1, on(i), {0});
  add_band(net, 0, add_node(net, false, -1, on(-1)), slack, kStiff);
  for (int i = 0; i + 1 < nodes; ++i) add_band(net, i, i + 1, slack, kStiff);
  add_pull(net, nodes - 1, add_node(net, false, -1, on(nodes)), 0);
  rest = solve_net_friction(net, {}, {VectorXd::Ones(1), {}});
  return 1 / rest.rest.tension(0);
}

// A node that turns the string by d: T2 cos(d/2) - T1 cos(d/2) = mu (T1 + T2) sin(d/2). The string
// gives by 1e-4, so that angles are equal to 1e-4.
TEST(NetFriction, MultipliesTensionAtEveryNodeThatSlips) {
  for (int nodes : {1, 4, 16}) {
    NetFrictionRest rest;
    const double ratio = drawn_over_a_quarter(nodes, rest);
    ASSERT_TRUE(rest.settled) << nodes << " nodes: " << rest.iterations << ", " << rest.change;
    for (const NodeFriction& rub : rest.nodes) EXPECT_FALSE(rub.sticks);
    const double k = kMu * std::tan(kPi / 4 / nodes);
    EXPECT_NEAR(ratio, std::pow((1 + k) / (1 - k), nodes), 2e-3);
  }
}

// The capstan: e^(mu theta), from which k above is off by a part of mu theta (turn / 2)^2 / 3.
TEST(NetFriction, BecomesACapstanWithManyNodes) {
  NetFrictionRest rest;
  const double ratio = drawn_over_a_quarter(24, rest);
  ASSERT_TRUE(rest.settled);
  EXPECT_NEAR(ratio, std::exp(kMu * kPi / 2), 2e-3);
}

TEST(NetFriction, LeavesANodeAloneThatIsPulledOff) {
  Saddle saddle(SurfaceShape::kCylinder);
  for (NetNode& node : saddle.net.nodes)
    if (!node.free) node.p.y() += 0.1;  // from above
  add_band(saddle.net, 0, add_node(saddle.net, false, -1, {0, -0.02, 0}), 0.03, 100);
  const NetFrictionRest rest = saddle.rest(2);
  EXPECT_TRUE(rest.settled);
  EXPECT_TRUE(rest.nodes.empty());
  EXPECT_GT(rest.rest.x(1, 0), kPulleyRadius);
}

TEST(NetFriction, RefusesToPush) {
  EXPECT_THROW((void)Saddle(SurfaceShape::kSphere, -0.1).rest(1), InputError);
}

TEST(NetFriction, IsNamedWhereTheFrictionlessSolverRefuses) {
  try {
    const NetSolver solver(Saddle(SurfaceShape::kSphere).net);
    FAIL() << "expected InputError";
  } catch (const InputError& e) {
    EXPECT_STREQ(e.what(),
                 "net : nodes slide without friction here, got 0.3; solve_net_friction() has it");
  }
}

}  // namespace
}  // namespace thenar
