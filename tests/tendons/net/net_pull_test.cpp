// Tests for tendons/net/net_pull.cpp on nets of data/nets: potentials against their slopes, and
// both ways to pull against each other.

#include "tendons/net/net_pull.h"

#include <gtest/gtest.h>

#include "tendons/net/build_tendons.h"
#include "tendons/net/net_continuation.h"
#include "tests/matrix_near.h"
#include "tests/tendons/net/net_on_rod.h"

namespace thenar {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// A tendon that is the stiffer the more it pulls:  T = base + k l^2.
class Tendon : public TensionLaw {
 public:
  [[nodiscard]] BandResponse response_at(double length) const override {
    const double l = std::max(length, 0.0);
    return {kBase * length + kSteep * l * l * l / 3, kBase + kSteep * l * l, 2 * kSteep * l};
  }
  /// Length under a tension [m].
  static double length_at(double tension) { return std::sqrt((tension - kBase) / kSteep); }

 private:
  static constexpr double kBase = 0.02, kSteep = 1e8;  // [N], [N/m^2]
};

/// The index finger under a net, with its muscles at one posture and tensions.
class PulledNet : public testing::TestWithParam<const char*> {
 protected:
  PulledNet() {
    const Subject subject = read_subject(THENAR_DATA_DIR "/subjects/an_chao_index.toml");
    TendonOptions rungs;
    rungs.hood = Hood::kFloatingNet;
    smooth_ =
        build_net_tendons(subject, "index", rungs,
                          read_net(THENAR_DATA_DIR "/nets/" + std::string(GetParam()) + ".toml"))
            ->smoothed(1e-3);
    t_ = VectorXd::LinSpaced(static_cast<Index>(net().digit().names.muscles.size()), 1, 4);
    rest_ = follow_from_straight(net(), q_, t_).rest;
  }
  [[nodiscard]] const NetTendons& net() const { return dynamic_cast<const NetTendons&>(*smooth_); }

  /// Loads of tendons that pull with these tensions at this rest.
  [[nodiscard]] PostureAndLoad on_tendons() const {
    const VectorXd length = net().lengths(q_, t_, net().torque_at_equilibrium(q_, t_, rest_));
    PostureAndLoad at{q_, length};
    for (Index m = 0; m < t_.size(); ++m) at.load[m] -= Tendon::length_at(t_[m]);
    return at;
  }

  /// Largest difference between central differences of the potential and its slopes, over these.
  static double mismatch(const NetPull& pull, const PostureAndLoad& at, const NetEquilibrium& rest,
                         double turn, double more) {
    const NetPotential here = pull.potential(at, rest);
    const auto energy = [&](PostureAndLoad there) {
      return pull.potential(there, pull.rest(there, rest.x)).energy;
    };
    double most = 0;
    for (Index j = 0; j < at.q.size(); ++j) {
      PostureAndLoad up = at, down = at;
      up.q[j] += turn, down.q[j] -= turn;
      most = std::max(
          most, std::abs((energy(up) - energy(down)) / (2 * turn) + here.tau[j]) / here.tau.norm());
    }
    for (Index m = 0; m < at.load.size(); ++m) {
      PostureAndLoad up = at, down = at;
      up.load[m] += more, down.load[m] -= more;
      most = std::max(most, std::abs((energy(up) - energy(down)) / (2 * more) - here.by_load[m]) /
                                here.by_load.norm());
    }
    return most;
  }

  VectorXd q_ = Eigen::Vector4d(0.5, 0.1, 0.7, 0.4), t_;
  std::unique_ptr<DigitTendons> smooth_;
  NetEquilibrium rest_;
};

/// The same under nets that every muscle pulls by one band.
class NetOnTendons : public PulledNet {
 protected:
  PullByTendon pull_{
      net(), {static_cast<std::size_t>(t_.size()), std::make_shared<const Tendon>()}, rest_};
};

TEST_P(PulledNet, PotentialUnderTensionsChangesByTorqueAndLength) {
  const PullByTension pull(net());
  EXPECT_LT(mismatch(pull, {q_, t_}, rest_, 1e-4, 1e-3), 1e-5);
}

TEST_P(NetOnTendons, PotentialChangesByTorqueAndTension) {
  const PostureAndLoad at = on_tendons();
  EXPECT_LT(mismatch(pull_, at, pull_.rest(at, rest_.x), 1e-5, 1e-7), 1e-5);
}

// Tendons that pull as hard as tensions leave the net, and its torque, where they are, but for what
// exits take of pulls, kExitRadius^2 / 2 L^2.
TEST_P(NetOnTendons, TendonsThatPullAsHardHoldItWhereTensionsDo) {
  const PostureAndLoad at = on_tendons();
  const TendonTorque now = pull_.torque(at, pull_.rest(at, rest_.x));
  const TendonTorque there = net().torque_at_equilibrium(q_, t_, rest_);
  EXPECT_TRUE(matrix_near(now.tau, there.tau, 2e-4 * there.tau.norm()));
  EXPECT_LT((now.nodes - there.nodes).cwiseAbs().maxCoeff(), 2e-7);
}

INSTANTIATE_TEST_SUITE_P(Nets, PulledNet,
                         testing::Values("extensor_hood", "winslow", "dogadov2017", "chao_an"),
                         [](const auto& net) { return std::string(net.param); });

INSTANTIATE_TEST_SUITE_P(Nets, NetOnTendons, testing::Values("winslow", "dogadov2017"),
                         [](const auto& net) { return std::string(net.param); });

// A muscle of several bands would couple them.
TEST(PullByTendon, RefusesAMuscleThatPullsSeveralBands) {
  const Subject subject = read_subject(THENAR_DATA_DIR "/subjects/an_chao_index.toml");
  TendonOptions rungs;
  rungs.hood = Hood::kFloatingNet;
  const auto hood = build_net_tendons(subject, "index", rungs,
                                      read_net(THENAR_DATA_DIR "/nets/extensor_hood.toml"));
  const auto& net = dynamic_cast<const NetTendons&>(*hood);
  EXPECT_FALSE(pulls_one_band_each(net));
  const std::vector<std::shared_ptr<const TensionLaw>> laws(net.digit().names.muscles.size(),
                                                            std::make_shared<const Tendon>());
  EXPECT_THROW(PullByTendon(net, laws, {}), InputError);
}

/// A knot on the way from an exit to an anchor, held there by a band of 100 N/mm, or of this share
/// of it, that is slack at 5 mm from the exit.
NetTendons knot_before_exit(double share = 1) {
  constexpr double kAnchor = 0.02, kUnstretched = 0.015, kPerStrain = 1500;  // [m], [m], [N]
  Net net;
  net.name = "one exit";
  net.muscles = {"M"};
  const int knot = add_node(net, true, -1, {0.004, 0, 0});
  add_pull(net, knot, add_node(net, false, -1, {0, 0, 0}), 0);
  add_band(net, knot, add_node(net, false, -1, {kAnchor, 0, 0}), kUnstretched, share * kPerStrain);
  return sample::net_on_rod(std::move(net));
}

/// The knot at x from its exit, on a tendon of 100 N/mm with an end for that: on the band's force
/// F = share 100 N/mm (5 mm - x) with T x / L = F, L = sqrt(x^2 + kExitRadius^2).
TendonTorque held_at(double x, double share = 1) {
  const NetTendons tendons = knot_before_exit(share);
  const VectorXd q = VectorXd::Zero(1);
  const double first = 0.004;
  const NetEquilibrium rest = tendons.rest(
      q, VectorXd::Constant(1, share * sample::Spring::kStiffness * (0.005 - first)), {});
  const PullByTendon pull(tendons, {std::make_shared<const sample::Spring>()}, rest);
  const double line = std::hypot(x, kExitRadius);
  const double T = share * sample::Spring::kStiffness * (0.005 - x) * line / x;
  const double lengthened = std::hypot(first, kExitRadius) - first;
  const PostureAndLoad at{
      q, VectorXd::Constant(1, line - lengthened - T / sample::Spring::kStiffness)};
  const TendonTorque now = pull.torque(at, pull.rest(at, rest.x));
  EXPECT_NEAR(now.nodes(0, 0), x, 1e-9);
  EXPECT_NEAR(now.tension[0], T, 1e-6 * T + 1e-6);
  return now;
}

// What an exit takes of a pull, 1 - x / L, is told from 1 % on, if it is a force.
TEST(PullByTendon, TellsKnotsThatTheNetDoesNotHold) {
  const TendonTorque drawn = held_at(3 * kExitRadius);
  EXPECT_EQ(drawn.status, TendonStatus::kNodeCollapsed);
  EXPECT_NE(drawn.warning.find("has drawn in"), std::string::npos) << drawn.warning;
  EXPECT_EQ(held_at(0.5 * kExitRadius).status, TendonStatus::kNodeCollapsed);
  EXPECT_EQ(held_at(6.5 * kExitRadius).status, TendonStatus::kNodeCollapsed);  // 1.2 %
  EXPECT_EQ(held_at(8 * kExitRadius).status, TendonStatus::kValid);            // 0.8 %
  EXPECT_EQ(held_at(20 * kExitRadius).status, TendonStatus::kValid);
  EXPECT_EQ(held_at(3 * kExitRadius, 1e-4).warning, "");
}

// Rates of a knot a few radii from its exit against differences.
TEST(PullByTendon, SlopesHoldNearAnExit) {
  const NetTendons tendons = knot_before_exit();
  const VectorXd q = VectorXd::Zero(1);
  const NetEquilibrium rest = tendons.rest(q, VectorXd::Constant(1, 100), {});  // [N]
  const PullByTendon pull(tendons, {std::make_shared<const sample::Spring>()}, rest);
  for (const double end : {-0.003, -0.0045, -0.0052, -0.006}) {  // [m]
    const auto at = [&](double turn, double more) {
      const PostureAndLoad there{VectorXd::Constant(1, turn), VectorXd::Constant(1, end + more)};
      return pull.torque(there, pull.rest(there, rest.x));
    };
    constexpr double kTurn = 1e-5, kMore = 1e-7;  // [rad], [m]
    const PostureAndLoad here{q, VectorXd::Constant(1, end)};
    const EndSlopes slopes = pull.slopes(here, pull.rest(here, rest.x));
    const double by_end = (at(0, kMore).tension[0] - at(0, -kMore).tension[0]) / (2 * kMore);
    const double by_turn = (at(kTurn, 0).tau[0] - at(-kTurn, 0).tau[0]) / (2 * kTurn);
    EXPECT_NEAR(slopes.tension_by_end(0, 0), by_end, 1e-4 * std::abs(by_end)) << end;
    EXPECT_NEAR(slopes.torque_by_posture(0, 0), by_turn, 1e-4 * std::abs(by_turn) + 1e-9) << end;
  }
}

/// A tendon that no number holds when it is stretched.
class Endless : public TensionLaw {
 public:
  [[nodiscard]] BandResponse response_at(double length) const override {
    const double rise = std::exp(length / 1e-5);
    return {1e-5 * rise, rise, rise / 1e-5};
  }
};

// An infinite torque makes the integrator shorten its step; an exception would end the motion.
TEST(PullByTendon, TorqueIsInfiniteWhereALawIs) {
  const NetTendons tendons = knot_before_exit();
  const VectorXd q = VectorXd::Zero(1);
  const NetEquilibrium rest = tendons.rest(q, VectorXd::Constant(1, 100), {});
  const PullByTendon pull(tendons, {std::make_shared<const Endless>()}, rest);
  const PostureAndLoad at{q, VectorXd::Constant(1, -1)};
  EXPECT_FALSE(pull.torque(at, rest).tau.allFinite());
  EXPECT_EQ(pull.potential(at, rest).energy, HUGE_VAL);
}

}  // namespace
}  // namespace thenar
