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
  EXPECT_EQ(rest.undetermined, std::vector<int>{0});
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
  add_pull(net, 0, add_node(net, false, -1, {0, 0.01, 0}), 0);
  const NetEquilibrium rest = NetSolver(net).solve({}, tension(5));
  EXPECT_EQ(rest.status, NetStatus::kNodeCollapsed);
  ASSERT_EQ(rest.collapsed.size(), 1u);
  EXPECT_LT(rest.collapsed[0].force.norm(), 1e-12);  // all other bands are slack
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

// Y of three bands, one muscle 1e6 times weaker than the other, either way round.
TEST(NetStability, TensionsOfOneToAMillionBalance) {
  for (const Eigen::Vector2d& t : {Eigen::Vector2d(50, 5e-5), Eigen::Vector2d(5e-5, 50)}) {
    Net net = string_through({0, 0.001, 0}, 0.036);
    net.muscles = {"m", "n"};
    add_pull(net, 0, add_node(net, false, -1, {0, 0.03, 0}), 0);
    add_pull(net, 0, add_node(net, false, -1, {0, 0, 0.03}), 1);
    const NetEquilibrium rest = NetSolver(net).solve({}, {t, {}});
    EXPECT_EQ(rest.status, NetStatus::kBalanced);
    EXPECT_LT(rest.residual, 1e-9);
  }
}

// In line, the weak band and the strong one carry the same muscle:  L = slack (1 + t / EA).
TEST(NetStability, StiffnessesOfOneToAMillionBalance) {
  for (double ratio : {1e6, 1e-6}) {
    Net net;
    net.muscles = {"m"};
    for (double x : {0.0, 0.01, -0.01}) add_node(net, x >= 0, -1, {x, 0, 0});
    add_band(net, 2, 0, 0.01, 10);
    add_band(net, 0, 1, 0.01, 10 * ratio);
    add_pull(net, 1, add_node(net, false, -1, {0.05, 0, 0}), 0);
    const double t = ratio < 1 ? 1e-5 : 1;
    const NetEquilibrium rest = NetSolver(net).solve({}, tension(t));
    EXPECT_EQ(rest.status, NetStatus::kBalanced);
    EXPECT_NEAR(rest.length(0), 0.01 * (1 + t / 10), 1e-9 * 0.01 / 10 + 1e-16);
    EXPECT_NEAR(rest.length(1), 0.01 * (1 + t / (10 * ratio)), 1e-9 * 0.01 / (10 * ratio) + 1e-16);
  }
}

/// Two nodes on bands to anchors 3 cm to the left and right, of slack length 2 cm and EA of 100 and
/// 200 N, with a muscle between the two.
Net tug_of_war() {
  Net net;
  net.muscles = {"m"};
  for (double x : {-0.01, 0.012}) add_node(net, true, -1, {x, 0.001, 0});
  add_band(net, 0, add_node(net, false, -1, {-0.03, 0, 0}), 0.02, 100);
  add_band(net, 1, add_node(net, false, -1, {0.03, 0, 0}), 0.02, 200);
  add_pull(net, 0, 1, 0);
  return net;
}

// They meet at x where  100 (0.5 + 50 x) = 200 (0.5 - 50 x):  x = 1/300 m, with 66.7 N.
TEST(NetStability, StrongMuscleDrawsTwoFloatingNodesTogether) {
  const NetEquilibrium rest = NetSolver(tug_of_war()).solve({}, tension(80));
  EXPECT_EQ(rest.status, NetStatus::kNodeCollapsed);
  ASSERT_EQ(rest.collapsed.size(), 1u);
  EXPECT_TRUE(matrix_near(rest.collapsed[0].force, Vector3d(200.0 / 3, 0, 0), 2e-9));
  EXPECT_TRUE(matrix_near(rest.x.col(0), Vector3d(1.0 / 300, 0, 0), 1e-9));
  EXPECT_TRUE(matrix_near(rest.x.col(1), rest.x.col(0), 1e-9));
}

TEST(NetStability, WeakMuscleLeavesTwoFloatingNodesApart) {
  const NetEquilibrium rest = NetSolver(tug_of_war()).solve({}, tension(40));
  EXPECT_EQ(rest.status, NetStatus::kBalanced);
  EXPECT_TRUE(matrix_near(rest.tension, Vector3d(40, 40, 40), 2e-9));
}

// Bands of k = EA / slack = 5e9 N/m: a rounding of 1e-17 m is 5e-8 N, so 1e-9 N may not be reached;
// then the status says so, and what is left is rounding.
TEST(NetStability, MillionNewtonsEndInRoundingAndSaySo) {
  Net net = string_through({0, 0.001, 0}, 0.036);
  for (NetBand& band : net.bands) band.EA = 1e8;
  net.muscles = {"m"};
  add_pull(net, 0, add_node(net, false, -1, {0, 0.03, 0}), 0);
  const NetEquilibrium rest = NetSolver(net).solve({}, tension(1e6));
  const NetStatus fair = rest.residual <= 1e-9 ? NetStatus::kBalanced : NetStatus::kStalled;
  EXPECT_EQ(rest.status, fair);
  EXPECT_LT(rest.residual, 2 * 5e9 * 1e-16);
}

// A band passes a rod on the side y > 0; another draws their node past the half-plane y < 0, x = 0,
// beyond which the way round that side would take 0.48 J more. The other band has 0.07 J to give.
TEST(NetStability, BandThatWindsRoundItsCylinderIsNamed) {
  Net net;
  net.surfaces = {{"rod", -1, SurfaceShape::kCylinder, {0.005, 0.01, 0}, {}}};
  add_node(net, true, -1, {-0.003, -0.012, 0}, {0});
  add_band(net, 0, add_node(net, false, -1, {-0.01, 0.001, 0}), 0.015, 50);
  net.bands[0].over = 0;
  add_band(net, 0, add_node(net, false, -1, {0.02, -0.02, 0}), 0.01, 10);
  const NetEquilibrium rest = NetSolver(net).solve({}, {VectorXd(0), {}});
  EXPECT_EQ(rest.status, NetStatus::kFarSideWrap);
  EXPECT_EQ(rest.far_side_bands, std::vector<int>{0});
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
