// Tests for tendons/net/solve_net.cpp: equilibria that can be worked out by hand.

#include <cmath>

#include <gtest/gtest.h>

#include "base/error.h"
#include "tendons/net/solve_net.h"
#include "tests/matrix_near.h"
#include "tests/tendons/net/sample_nets.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

NetNode fixed(const Vector3d& p) { return {"fixed", false, -1, p, {}}; }
NetNode floating(const Vector3d& p) { return {"floating", true, -1, p, {}}; }
NetBand passive(int a, int b, double slack, double EA) {
  NetBand band{"band", a, b};
  band.slack = slack;
  band.EA = EA;
  return band;
}
NetBand pulled(int a, int b, int muscle) {
  NetBand band{"muscle band", a, b};
  band.muscle = muscle;
  return band;
}
NetDrive tensions(const Eigen::VectorXd& t) { return {t, {}}; }

NetEquilibrium solve(const Net& net, const NetDrive& drive) {
  return NetSolver(net).solve({}, drive);
}

constexpr double kPull = 3;  // [N]

/// Two bands at +-60 degrees from a pull, which share it: 2 T cos 60 = kPull.
Net two_bands() {
  Net net{"Y", {floating({0, 0, 0}), fixed({0.01, 0, 0})}, {}, {}, {"pull"}, 0};
  const double c = 0.5, s = std::sqrt(0.75), L = 0.02, EA = 200;
  const double slack = L / (1 + kPull / EA);  // so that T = kPull at length L
  net.nodes.push_back(fixed({-L * c, L * s, 0}));
  net.nodes.push_back(fixed({-L * c, -L * s, 0}));
  net.bands = {pulled(0, 1, 0), passive(0, 2, slack, EA), passive(0, 3, slack, EA)};
  return net;
}

/// Pulls with kPull at the length that its band has there.
class PullAtRest : public TensionLaw {
 public:
  [[nodiscard]] BandResponse response_at(double length) const override {
    constexpr double kStiffness = 1e5;  // [N/m]
    const double T = kPull + kStiffness * (length - 0.01);
    return T > 0 ? BandResponse{T * T / (2 * kStiffness), T, kStiffness} : BandResponse{0, 0, 0};
  }
};

TEST(SolveNet, TakesTheTensionOfAMuscleFromALaw) {
  Net net = two_bands();
  net.nodes[0].p = {2e-3, 1e-3, 0};  // a start beside the rest
  NetDrive drive = tensions(Eigen::VectorXd::Zero(1));
  drive.law = {std::make_shared<const PullAtRest>()};
  const NetEquilibrium rest = solve(net, drive);
  EXPECT_EQ(rest.status, NetStatus::kBalanced);
  EXPECT_TRUE(matrix_near(rest.x.col(0), Vector3d::Zero(), 1e-12));
  EXPECT_TRUE(matrix_near(rest.tension, Vector3d(kPull, kPull, kPull), 1e-9));
  // As many laws as muscles, or none.
  drive.law.push_back(nullptr);
  EXPECT_THROW(solve(net, drive), InputError);
}

TEST(SolveNet, SharesAPullBetweenTwoBands) {
  const double t = kPull;
  const NetEquilibrium rest = solve(two_bands(), tensions(Eigen::VectorXd::Constant(1, t)));
  EXPECT_EQ(rest.status, NetStatus::kBalanced);
  EXPECT_TRUE(matrix_near(rest.x.col(0), Vector3d::Zero(), 1e-12));
  EXPECT_TRUE(matrix_near(rest.tension, Vector3d(t, t, t), 1e-9));
}

}  // namespace
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kBoneRadius = 0.005;

VectorXd angle(double q) { return VectorXd::Constant(1, q); }
const NetDrive kNothing{VectorXd(0), {}};

/// A taut string across a cylinder, by way of a node 6 mm over its axis, all on a link whose hinge
/// is 1 m away: q lowers it by 1 mm for every milliradian.
struct String {
  String() {
    net.surfaces = {{"bone", -1, SurfaceShape::kCylinder, {kBoneRadius, 0.05, 0}, {}}};
    add_node(net, true, 0, {0, 0.006, 0}, {0});
    for (double x : {-0.02, 0.02})
      add_band(net, 0, add_node(net, false, 0, {x, 0.006, 0}), 0.015, 100);
  }
  Net net;
  Tree<double> tree{{-1, 0, 1, 0, {0, 0, 1}, {1, 0, 0}}};
};

/// Solves the net at one posture after another, each time from the last balanced equilibrium.
/// @param start  initial nodes at the first posture [m] (3, nodes); empty: where links carry them
std::vector<NetEquilibrium> solve_postures(NetSolver& solver, const Tree<double>& tree,
                                           const std::vector<VectorXd>& postures,
                                           const NetDrive& drive, Eigen::Matrix3Xd start = {}) {
  std::vector<NetEquilibrium> rests;
  for (const VectorXd& q : postures) {
    rests.push_back(solver.solve(pose_tree(tree, q), drive, start.cols() == 0 ? nullptr : &start));
    if (rests.back().status == NetStatus::kBalanced) start = rests.back().x;
  }
  return rests;
}

// Clear of the bone the net turns with its link.
TEST(SolveNetAtPostures, CarriesANetThatTouchesNothing) {
  const String string;
  NetSolver solver(string.net);
  const auto rests =
      solve_postures(solver, string.tree, {angle(0), angle(-0.1), angle(-0.2)}, kNothing);
  ASSERT_EQ(rests.size(), 3U);
  for (int k = 0; k < 3; ++k) {
    const auto state = pose_tree(string.tree, angle(-0.1 * k));
    EXPECT_EQ(rests[k].status, NetStatus::kBalanced);
    EXPECT_TRUE(matrix_near(rests[k].x.col(0), moved(state, 0, string.net.nodes[0].p), 1e-11));
  }
}

// 8 mm lower the string lies over the bone still; taken there at once, its node is under it.
TEST(SolveNetAtPostures, KeepsANetOnTheSideOnWhichItCame) {
  const String string;
  NetSolver solver(string.net);
  std::vector<VectorXd> down;
  for (int k = 0; k <= 8; ++k) down.push_back(angle(1e-3 * k));
  const auto rests = solve_postures(solver, string.tree, down, kNothing);
  for (const NetEquilibrium& rest : rests) EXPECT_EQ(rest.status, NetStatus::kBalanced);
  EXPECT_GT(rests.back().x(1, 0), 0.9 * kBoneRadius);
  const auto at_once = solve_postures(solver, string.tree, {down.back()}, kNothing);
  EXPECT_LT(at_once[0].x(1, 0), 0);
}

TEST(SolveNetAtPostures, StartsWhereItIsTold) {
  const String string;
  NetSolver solver(string.net);
  const VectorXd low = angle(8e-3);
  const auto state = pose_tree(string.tree, low);
  Eigen::Matrix3Xd start(3, 3);
  for (int i = 0; i < 3; ++i) start.col(i) = moved(state, 0, string.net.nodes[i].p);
  start.col(0) = Vector3d(0, kBoneRadius, 0);
  const auto rests = solve_postures(solver, string.tree, {low}, kNothing, start);
  EXPECT_GT(rests[0].x(1, 0), 0.9 * kBoneRadius);
}

}  // namespace
}  // namespace thenar
