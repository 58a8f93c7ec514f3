// Tests for tendons/net/solve_net.cpp: equilibria that can be worked out by hand.

#include "tendons/net/solve_net.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/error.h"
#include "tests/matrix_near.h"

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

// Two bands at +-60 degrees from the pull share it: 2 T cos 60 = t.
TEST(SolveNet, SharesAPullBetweenTwoBands) {
  Net net{"Y", {floating({0, 0, 0}), fixed({0.01, 0, 0})}, {}, {}, {"pull"}, 0};
  const double c = 0.5, s = std::sqrt(0.75), L = 0.02, EA = 200, t = 3;
  const double slack = L / (1 + t / EA);  // so that T = t at length L
  net.nodes.push_back(fixed({-L * c, L * s, 0}));
  net.nodes.push_back(fixed({-L * c, -L * s, 0}));
  net.bands = {pulled(0, 1, 0), passive(0, 2, slack, EA), passive(0, 3, slack, EA)};
  const NetEquilibrium rest = solve(net, tensions(Eigen::VectorXd::Constant(1, t)));
  EXPECT_EQ(rest.status, NetStatus::kBalanced);
  EXPECT_TRUE(matrix_near(rest.x.col(0), Vector3d::Zero(), 1e-12));
  EXPECT_TRUE(matrix_near(rest.tension, Vector3d(t, t, t), 1e-9));
}

}  // namespace
}  // namespace thenar
