// Tests for tendons/net/net_pull.cpp on nets of data/nets: potentials against their slopes, and
// both ways to pull against each other.

#include "tendons/net/net_pull.h"

#include <gtest/gtest.h>

#include "tendons/net/build_tendons.h"
#include "tendons/net/net_continuation.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// A tendon that is the stiffer the more it pulls:  T = base + k l^2.
class Tendon : public TensionLaw {
 public:
  [[nodiscard]] BandResponse at(double length) const override {
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
    const VectorXd length = net().lengths(q_, t_, net().torque_at_rest(q_, t_, rest_));
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
  PullByTendon pull_{net(),
                     {static_cast<std::size_t>(t_.size()), std::make_shared<const Tendon>()}};
};

TEST_P(PulledNet, PotentialUnderTensionsChangesByTorqueAndLength) {
  const PullByTension pull(net());
  EXPECT_LT(mismatch(pull, {q_, t_}, rest_, 1e-4, 1e-3), 1e-5);
}

TEST_P(NetOnTendons, PotentialChangesByTorqueAndTension) {
  const PostureAndLoad at = on_tendons();
  EXPECT_LT(mismatch(pull_, at, pull_.rest(at, rest_.x), 1e-5, 1e-7), 1e-5);
}

// Tendons that pull as hard as tensions leave the net, and its torque, where they are. The radius
// of the exits lengthens lines by up to kExitRadius^2 / 2 L, for which tendons make up.
TEST_P(NetOnTendons, TendonsThatPullAsHardHoldItWhereTensionsDo) {
  const PostureAndLoad at = on_tendons();
  const TendonTorque now = pull_.torque(at, pull_.rest(at, rest_.x));
  const TendonTorque there = net().torque_at_rest(q_, t_, rest_);
  EXPECT_TRUE(matrix_near(now.tau, there.tau, 0.02 * there.tau.norm()));
  EXPECT_LT((now.nodes - there.nodes).cwiseAbs().maxCoeff(), 2e-5);
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
  EXPECT_THROW(PullByTendon(net, laws), InputError);
}

}  // namespace
}  // namespace thenar
