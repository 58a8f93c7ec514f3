// Tests for tendons/net/net_follower.cpp: a knot on a round bone between two exits inside of it.

#include "tendons/net/net_follower.h"

#include <gtest/gtest.h>

#include "tests/tendons/net/net_on_rod.h"

namespace thenar {
namespace {

using Eigen::Vector2d;
using Eigen::VectorXd;

constexpr double kRadius = 6e-3, kAside = 3e-3;  // of the bone, and of the exits from its axis [m]

/// The knot lies on the bone at an angle theta from the first exit. With r the radius and d the
/// distance of the exits from the axis its energy is
///   t1 sqrt(r^2 + d^2 - 2 r d cos theta) + t2 sqrt(r^2 + d^2 + 2 r d cos theta),
/// so that theta = 0 is a minimum while  t1 / (r - d) > t2 / (r + d),  and pi while
/// t2 / (r - d) > t1 / (r + d):  both, for pulls that differ by less than a factor of 3.
NetTendons two_exits() {
  Net net;
  net.name = "two exits";
  net.surfaces = {{"bone", -1, SurfaceShape::kCylinder, {kRadius, 0.01, 0}, {}}};
  net.muscles = {"FLX", "EXT"};
  const int knot = add_node(net, true, -1, {kRadius, 0, 0}, {0});
  add_pull(net, knot, add_node(net, false, -1, {kAside, 0, 0}), 0);
  add_pull(net, knot, add_node(net, false, -1, {-kAside, 0, 0}), 1);
  return sample::net_on_rod(std::move(net));
}

const VectorXd kStill = VectorXd::Zero(1);

double side_of(const TendonTorque& pull) { return pull.nodes(0, 0); }

// Where it snaps and what that releases, in closed form: as t1 falls from 1 N to 0.2 N under
// t2 = 1 N, at t1 = (r - d) / (r + d) N,  2 d (t2 - t1).
TEST(NetFollower, SnapsWhereTheEnergyFoldsAndTellsWhatThatReleases) {
  const NetTendons tendons = two_exits();
  NetFollower net(tendons);
  EXPECT_TRUE(net.accept(kStill, Vector2d(1, 1)).snaps.empty());
  const std::vector<NetSnap> snaps = net.accept(kStill, Vector2d(0.2, 1)).snaps;
  ASSERT_EQ(snaps.size(), 1U);
  const double fold = (kRadius - kAside) / (kRadius + kAside);  // [N]
  EXPECT_NEAR(snaps[0].share, (1 - fold) / 0.8, 1e-4);          // of stiffness lost in rounding
  EXPECT_NEAR(snaps[0].released, 2 * kAside * (1 - fold), 1e-6);
  EXPECT_NEAR(snaps[0].moved, 2 * kRadius, 1e-6);
  EXPECT_NEAR(side_of(net.torque_at(kStill, Vector2d(0.2, 1))), -kRadius, 1e-9);
}

// Between the folds either side is at rest: that from which it came.
TEST(NetFollower, RemembersFromWhichSideItCame) {
  const NetTendons tendons = two_exits();
  NetFollower net(tendons);
  (void)net.accept(kStill, Vector2d(1, 1));
  EXPECT_TRUE(net.accept(kStill, Vector2d(0.5, 1)).snaps.empty());
  EXPECT_NEAR(side_of(net.torque_at(kStill, Vector2d(0.5, 1))), kRadius, 1e-9);
  (void)net.accept(kStill, Vector2d(0.2, 1));
  EXPECT_TRUE(net.accept(kStill, Vector2d(1, 1)).snaps.empty());
  EXPECT_NEAR(side_of(net.torque_at(kStill, Vector2d(1, 1))), -kRadius, 1e-9);
}

// Trials of an integrator leave no trace.
TEST(NetFollower, ForgetsWhatWasNotAccepted) {
  const NetTendons tendons = two_exits();
  NetFollower net(tendons);
  (void)net.accept(kStill, Vector2d(1, 1));
  EXPECT_NEAR(side_of(net.torque_at(kStill, Vector2d(0.2, 1))), -kRadius, 1e-9);
  EXPECT_NEAR(side_of(net.torque_at(kStill, Vector2d(0.9, 1))), kRadius, 1e-9);
}

// On stiff tendons of one law it rests between the exits, where under tensions that stay its energy
// is greatest. In closed form: tensions k (L - p) in balance on the bone are as the lengths L, so
// L1 / L2 = p1 / p2, and with s = r^2 + d^2 + w^2, w the radius of the exits,
//   2 r d cos theta = s (p2^2 - p1^2) / (p2^2 + p1^2).
TEST(NetFollower, RestsOnTendonsWhereTensionsAloneDoNotHoldIt) {
  const NetTendons tendons = two_exits();
  const double s = kRadius * kRadius + kAside * kAside + kExitRadius * kExitRadius;
  const double product = 2 * kRadius * kAside;
  const auto lines = [&](double cosine) {
    return Vector2d(std::sqrt(s - product * cosine), std::sqrt(s + product * cosine));
  };
  // Ends of tendons stretched by 15 um and more with the knot at cos theta; lines begin as long as
  // they are without exits.
  const Vector2d lengthened = lines(1) - Vector2d(kRadius - kAside, kRadius + kAside);
  const auto ends = [&](double cosine) -> Vector2d {
    return (1 - 5e-3) * lines(cosine) - lengthened;
  };
  // A rest beside the first exit, by tensions that hold it there.
  NetFollower held(tendons);
  (void)held.accept(kStill, Vector2d(2, 1));
  const VectorXd first = ends(1);
  const TendonTorque at = held.torque_at(kStill, Vector2d(2, 1));
  const auto spring = std::make_shared<const sample::Spring>();
  const auto net = tendons.follower_on_tendons({{spring, spring}, kStill, first, at});
  ASSERT_TRUE(net);
  // All the way round without a snap.
  for (double cosine = 0.95; cosine > -0.96; cosine -= 0.05) {
    const NetStep step = net->accept(kStill, ends(cosine));
    EXPECT_TRUE(step.snaps.empty()) << cosine;
    EXPECT_NEAR(step.unexplained, 0, 1e-8);  // [J]
    const TendonTorque now = net->torque_at(kStill, ends(cosine));
    EXPECT_NEAR(side_of(now), kRadius * cosine, 1e-8);
    EXPECT_NEAR(now.tension[0] / now.tension[1],
                std::sqrt((s - product * cosine) / (s + product * cosine)), 1e-6);
  }
}

// An error leaves nothing that the same question would be answered with.
TEST(NetFollower, RefusesTheSameEndsAgain) {
  const NetTendons tendons = two_exits();
  NetFollower held(tendons);
  (void)held.accept(kStill, Vector2d(2, 1));
  const auto spring = std::make_shared<const sample::Spring>();
  const VectorXd first = Vector2d(kRadius - kAside, kRadius + kAside) - Vector2d(2e-5, 1e-5);
  const auto net = tendons.follower_on_tendons(
      {{spring, spring}, kStill, first, held.torque_at(kStill, Vector2d(2, 1))});
  const Vector2d wrong(first[0], std::nan(""));
  EXPECT_THROW((void)net->torque_at(kStill, wrong), InputError);
  EXPECT_THROW((void)net->torque_at(kStill, wrong), InputError);
  EXPECT_TRUE(net->torque_at(kStill, first).tau.allFinite());
}

}  // namespace
}  // namespace thenar
