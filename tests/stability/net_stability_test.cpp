// What the solver of nets does where methods fail.

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "base/error.h"
#include "tendons/net/solve_net.h"
#include "tests/matrix_near.h"
#include "tests/tendons/net/sample_nets.h"

namespace thenar {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

NetDrive tension(double t) { return {VectorXd::Constant(1, t), {}}; }

/// A string from x = -2 cm through a floating node at p to x = 2 cm, of the given slack length.
Net string_through(const Vector3d& p, double slack) {
  Net net;
  add_node(net, true, -1, p);
  for (double x : {-0.02, 0.02})
    add_band(net, 0, add_node(net, false, -1, {x, 0, 0}), slack / 2, 100);
  return net;
}

BoneSurface ball(double radius) { return {"ball", -1, SurfaceShape::kSphere, {radius, 0, 0}, {}}; }

TEST(NetStability, AllSlackIsBalancedWhereItLiesAndLoose) {
  const Net net = string_through({0.003, 0.002, 0}, 0.06);
  const NetEquilibrium rest = NetSolver(net).solve({}, {VectorXd(0), {}});
  EXPECT_EQ(rest.status, NetStatus::kBalanced);
  EXPECT_EQ(rest.loose, std::vector<int>{0});
  EXPECT_TRUE(matrix_near(rest.x.col(0), net.nodes[0].p, 0));
}

TEST(NetStability, ExactlySlackStartStaysWithoutTension) {
  const Net net = string_through({0, 0, 0}, 0.04);
  const NetEquilibrium rest = NetSolver(net).solve({}, {VectorXd(0), {}});
  EXPECT_EQ(rest.status, NetStatus::kBalanced);
  EXPECT_EQ(rest.tension.maxCoeff(), 0);
}

TEST(NetStability, BandOfNoLengthMakesNoNaN) {
  Net net = string_through({0.02, 0, 0}, 0.03);  // the node starts in an anchor
  const NetEquilibrium rest = NetSolver(net).solve({}, {VectorXd(0), {}});
  EXPECT_EQ(rest.status, NetStatus::kBalanced);
  EXPECT_TRUE(matrix_near(rest.x.col(0), Vector3d::Zero(), 1e-9));
}

TEST(NetStability, MuscleThatOutpullsTheNetDrawsItsNodeIn) {
  Net net = string_through({0, 0, 0}, 0.06);
  net.muscles = {"m"};
  add_band(net, 0, add_node(net, false, -1, {0, 0.01, 0}), 0, 0, 0, 0);
  const NetEquilibrium rest = NetSolver(net).solve({}, tension(5));
  EXPECT_EQ(rest.status, NetStatus::kDrawnIn);
  ASSERT_EQ(rest.drawn.size(), 1u);
  EXPECT_LT(rest.drawn[0].force.norm(), 1e-12);  // all other bands are slack
  EXPECT_TRUE(matrix_near(rest.x.col(0), Vector3d(0, 0.01, 0), 0));
}

TEST(NetStability, NodeThatStartsInsideABoneIsPushedOutAndNamed) {
  for (const Vector3d& inside : {Vector3d(0, 0.001, 0), Vector3d(0, 0, 0)}) {
    Net net = string_through(inside, 0.03);
    net.surfaces = {ball(0.005)};
    net.nodes[0].surfaces = {0};
    const NetEquilibrium rest = NetSolver(net).solve({}, {VectorXd(0), {}});
    EXPECT_EQ(rest.pushed_out, std::vector<int>{0});
    EXPECT_NE(rest.status, NetStatus::kStalled);
    EXPECT_GE(rest.x.col(0).norm(), 0.005 - 1e-12);
  }
}

// A taut string laid exactly over the pole: the least push slides it off; it is never called
// stable.
TEST(NetStability, StringOverThePoleOfABallSlidesOff) {
  Net net = string_through({0, 0.005, 0}, 0.062);
  net.surfaces = {ball(0.005)};
  net.nodes[0].surfaces = {0};
  for (NetNode& node : net.nodes)
    if (!node.free) node.p.y() = -0.02;  // 2 T / L = 62 T/m holds it, force / radius = 312 T/m not
  const NetEquilibrium rest = NetSolver(net).solve({}, {VectorXd(0), {}});
  EXPECT_TRUE(rest.status == NetStatus::kUnstable || std::abs(rest.x(2, 0)) > 1e-4);
}

// Y of three bands, one of them 1e6 times weaker: T = t / 2 each side, whatever hangs there too.
TEST(NetStability, TensionsOfOneToAMillionBalance) {
  Net net = string_through({0, 0.001, 0}, 0.036);
  net.muscles = {"m", "n"};
  add_band(net, 0, add_node(net, false, -1, {0, 0.03, 0}), 0, 0, 0, 0);
  add_band(net, 0, add_node(net, false, -1, {0, 0, 0.03}), 0, 0, 0, 1);
  const NetEquilibrium rest = NetSolver(net).solve({}, {Eigen::Vector2d(50, 5e-5), {}});
  EXPECT_EQ(rest.status, NetStatus::kBalanced);
  EXPECT_LT(rest.residual, 1e-9);
}

TEST(NetStability, NaNInTheNetIsNamed) {
  Net net = string_through({0, 0, 0}, 0.03);
  net.nodes[0].p.x() = std::numeric_limits<double>::quiet_NaN();
  try {
    const NetSolver solver(net);
    FAIL() << "expected InputError";
  } catch (const InputError& e) {
    EXPECT_STREQ(e.what(), "node n0: its place is not finite");
  }
}

}  // namespace
}  // namespace thenar
