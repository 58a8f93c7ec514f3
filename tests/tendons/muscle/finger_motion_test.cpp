// Tests for tendons/muscle/finger_motion.cpp and the slopes that it is made of.

#include <gtest/gtest.h>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include "tendons/muscle/finger_motion.h"
#include "tendons/muscle/simulate.h"
#include "tendons/net/build_tendons.h"
#include "tendons/net/net_statics.h"
#include "tendons/net/net_tendons.h"
#include "tests/matrix_near.h"
#include "tests/tendons/muscle/moving_samples.h"

namespace thenar {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

class EverySlope : public testing::TestWithParam<Muscle> {
 protected:
  /// Central differences of all rates, in parts of each state's scale.
  static MatrixXd differences(FingerMotion& motion, const MotionState& state, const VectorXd& e,
                              double part) {
    const VectorXd y = motion.pack(state), scale = motion.scale();
    MatrixXd J(y.size(), y.size());
    for (Index j = 0; j < y.size(); ++j) {
      const VectorXd step = part * scale[j] * VectorXd::Unit(y.size(), j);
      J.col(j) = (motion.pack(motion.slope(motion.unpack(y + step), e)) -
                  motion.pack(motion.slope(motion.unpack(y - step), e))) /
                 (2 * part * scale[j]);
    }
    return J;
  }

  /// Largest difference of an entry over what its row can do with states of their scale.
  static double mismatch(FingerMotion& motion, const MotionState& state, const VectorXd& e) {
    const VectorXd scale = motion.scale();
    const MatrixXd J = motion.jacobian(state, e) * scale.asDiagonal();
    const MatrixXd D = differences(motion, state, e, 1e-5) * scale.asDiagonal();
    const VectorXd rows = D.cwiseAbs().rowwise().maxCoeff().cwiseMax(1e-9);
    return (rows.cwiseInverse().asDiagonal() * (J - D)).cwiseAbs().maxCoeff();
  }

  static MotionState moving(FingerMotion& motion) {
    const VectorXd q = Eigen::Vector4d(0.5, 0.1, 0.7, 0.4);
    const VectorXd q_dot = Eigen::Vector4d(1, -0.5, 2, 1.5);
    MotionState state = motion.start(q, q_dot, VectorXd::LinSpaced(7, 0.1, 0.4)).state;
    state.projected_fibre *= 0.995;
    return state;
  }
};

TEST_P(EverySlope, IsThatOfSeparateTendons) {
  const sample::Mover mover(sample::index_finger(PassiveMoments::kOn), GetParam());
  FingerMotion motion(mover.model());
  EXPECT_LT(mismatch(motion, moving(motion), VectorXd::Constant(7, 0.27)), 1e-4);
}

// With muscles that pull several bands, and with one band each.
TEST_P(EverySlope, IsThatOfANet) {
  const Subject subject = sample::index_finger();
  TendonOptions rungs;
  rungs.hood = Hood::kFloatingNet;
  for (const char* name : {"chao_an", "dogadov2017"}) {
    const auto tendons = build_net_tendons(
        subject, "index", rungs, read_net(THENAR_DATA_DIR "/nets/" + std::string(name) + ".toml"));
    const auto contraction =
        build_contraction(musculotendons(subject, tendons->digit(), GetParam()), GetParam());
    FingerMotion motion({*tendons, *contraction});
    MotionState state = moving(motion);
    (void)motion.accept(state);
    EXPECT_LT(mismatch(motion, state, VectorXd::Constant(7, 0.27)), 1e-3) << name;
  }
}

INSTANTIATE_TEST_SUITE_P(Muscles, EverySlope,
                         testing::Values(Muscle::kBounds, Muscle::kRigidTendon,
                                         Muscle::kElasticTendon));

}  // namespace
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// The index finger under one net, with muscles that only pull as hard as they are excited.
class NetMotion : public testing::TestWithParam<const char*> {
 protected:
  NetMotion() {
    const Subject subject = sample::index_finger();
    TendonOptions rungs;
    rungs.hood = Hood::kFloatingNet;
    const NetDescription net = read_net(THENAR_DATA_DIR "/nets/" + std::string(GetParam()));
    tendons_ = build_net_tendons(subject, "index", rungs, net)->smoothed(kBlendStrain);
    contraction_ = build_contraction(musculotendons(subject, tendons_->digit(), Muscle::kBounds),
                                     Muscle::kBounds);
  }
  [[nodiscard]] const NetTendons& net() const { return dynamic_cast<const NetTendons&>(*tendons_); }
  [[nodiscard]] MotionModel model() const { return {*tendons_, *contraction_}; }
  [[nodiscard]] TreeState<double> pose(const VectorXd& q) const {
    return pose_tree(tendons_->digit().model.tree, q);
  }
  [[nodiscard]] VectorXd torque_of_net(const VectorXd& q, const NetEquilibrium& rest) const {
    return net_torque(net().net().net, tendons_->digit().model.tree, pose(q), rest, 4);
  }
  /// Length of the bands by which muscles pull the net [m] (pulls).
  [[nodiscard]] VectorXd muscle_band_length(const NetEquilibrium& rest) const {
    const Net& bands = net().net().net;
    VectorXd length = VectorXd::Zero(static_cast<Index>(bands.muscles.size()));
    for (std::size_t b = 0; b < bands.bands.size(); ++b)
      if (bands.bands[b].muscle >= 0)
        length[bands.bands[b].muscle] += rest.length[static_cast<Index>(b)];
    return length;
  }

  /// The net at one instant.
  struct Stretched {
    VectorXd q, drive, length, other;  // other: torque of all tendons beside the net [N m]
    double strain;                     // energy stored in its bands [J]
    Eigen::Matrix3Xd nodes;
  };
  [[nodiscard]] Stretched stretched(const VectorXd& q, const VectorXd& t,
                                    const Eigen::Matrix3Xd& start) const {
    const NetEquilibrium rest = net().rest(q, t, start);
    const VectorXd drive = net().drive(t), length = muscle_band_length(rest);
    return {q,
            drive,
            length,
            net().torque(q, t, rest) - torque_of_net(q, rest),
            rest.energy - drive.dot(length),
            rest.x};
  }

  /// Work of the muscles: on the net by shortening, on the bones beside it [J].
  static double put_in_by(const std::vector<Stretched>& at, std::size_t stride) {
    double work = 0;
    for (std::size_t i = stride; i < at.size(); i += stride) {
      const Stretched &from = at[i - stride], &to = at[i];
      work += (from.other + to.other).dot(to.q - from.q) / 2 -
              (from.drive + to.drive).dot(to.length - from.length) / 2;
    }
    return work;
  }

  void expect_balance(const Trajectory& path) const {
    ASSERT_EQ(path.status, MotionStatus::kCompleted) << path.warning;
    // Energy balances under pulls, too, that strain a band by more than tissue bears.
    EXPECT_TRUE(path.warning.empty() ||
                path.warning.find("more than tissue can") != std::string::npos)
        << path.warning;

    std::vector<Stretched> at;
    for (Index i = 0; i < path.time.size(); ++i)
      at.push_back(stretched(path.angle.row(i), path.tension.row(i),
                             i > 0 ? at.back().nodes : Eigen::Matrix3Xd()));
    // Trapezoids of one and of two samples, extrapolated to none.
    const double put_in = (4 * put_in_by(at, 1) - put_in_by(at, 2)) / 3;
    const Index last = path.time.size() - 1;
    const double stretch = at.back().strain - at.front().strain;
    const double gained = path.energy[last] - path.energy[0] + stretch;
    EXPECT_NEAR(gained, put_in - path.dissipated[last], 5e-7);  // of 0.04 [J]
    EXPECT_GT(std::abs(stretch), 2e-5);  // the net's share is not dissipated in that [J]
  }

  std::unique_ptr<DigitTendons> tendons_;
  std::unique_ptr<Contraction> contraction_;
};

const VectorXd kStart = Eigen::Vector4d(0.4, 0.05, 0.5, 0.3);
/// EDC, EIP, FDP, FDS, RI, LU, UI [1]
const VectorXd kExcited = (VectorXd(7) << 0.10, 0.05, 0.05, 0.02, 0.05, 0.10, 0.05).finished();

// Energy of motion and stops, and of the stretched net, is what muscles put in by shortening less
// what joints take out:  d (energy + E - t L) = -t dL + tau_other dq - d dissipated.
TEST_P(NetMotion, BalancesEnergyWithTheStrainOfTheNet) {
  SimulateOptions options;
  options.seconds = 0.05;
  options.sample = 1e-4;
  options.tolerance = 1e-7;  // at 1e-6 it makes up to 2e-6 J
  Excitation rising{Eigen::Vector2d(0, 0.05), Eigen::MatrixXd(2, 7)};
  rising.value << kExcited.transpose(), 2 * kExcited.transpose();
  expect_balance(simulate(model(), rising, {kStart, {}, {}}, options));
}

/// Torque of tendons, springs and stops [N m].
VectorXd held_torque(const MotionModel& model, const VectorXd& q, const VectorXd& t,
                     Eigen::Matrix3Xd& nodes) {
  const TendonTorque pull = model.tendons.evaluate(q, t, nodes);
  nodes = pull.nodes;
  return pull.tau + resistance_torque(model.tendons.digit().skeleton, model.resistance, q);
}

// Motion comes to rest where torques balance by Newton's method on statics alone.
TEST_P(NetMotion, ComesToRestInStaticBalance) {
  SimulateOptions options;
  options.seconds = 2;
  const Trajectory path =
      simulate(model(), constant_excitation(kExcited), {kStart, {}, {}}, options);
  ASSERT_EQ(path.status, MotionStatus::kCompleted) << path.warning;
  const Index last = path.time.size() - 1;
  const VectorXd t = path.tension.row(last), ended = path.angle.row(last);
  VectorXd q = ended;
  Eigen::Matrix3Xd nodes;
  constexpr double h = 1e-6;  // [rad]
  for (int i = 0; i < 20; ++i) {
    const VectorXd tau = held_torque(model(), q, t, nodes);
    Eigen::MatrixXd slope(4, 4);
    for (Index j = 0; j < 4; ++j) {
      const VectorXd step = h * VectorXd::Unit(4, j);
      slope.col(j) =
          (held_torque(model(), q + step, t, nodes) - held_torque(model(), q - step, t, nodes)) /
          (2 * h);
    }
    q -= slope.partialPivLu().solve(tau);
  }
  ASSERT_LT(held_torque(model(), q, t, nodes).norm(), 1e-9);
  EXPECT_TRUE(matrix_near(ended, q, 1e-3));  // what is left of the creep after 2 s [rad]
}

// Bones feel the same motion from the net's wrenches as from its torques. A moment acts as two
// opposite forces r x (m x r) / r^2 apart.
TEST_P(NetMotion, WrenchesOnBonesMoveThemAsTorquesDo) {
  const VectorXd q = kStart, t = 40 * kExcited;  // [N]
  const TreeState<double> state = pose(q);
  const NetEquilibrium rest = net().rest(q, t, {});
  ASSERT_EQ(rest.status, NetStatus::kBalanced);
  Loads loads;
  for (const LinkWrench& w : net_wrenches(net().net().net, state, rest)) {
    if (w.link < 0 || w.wrench.moment.isZero(0)) continue;  // untouched
    const Pose<double> to_reference = state[static_cast<std::size_t>(w.link)].X.inverse();
    const Eigen::Vector3d r = 0.01 * w.wrench.moment.unitOrthogonal();
    const Eigen::Vector3d pair = w.wrench.moment.cross(r) / r.squaredNorm();
    loads.forces.push_back(
        {w.link, to_reference * Eigen::Vector3d(0, 0, 0), w.wrench.force - pair});
    loads.forces.push_back({w.link, to_reference * r, pair});
  }
  Multibody bones(tendons_->digit().skeleton);
  const JointMotion motion{q, Eigen::Vector4d(1, -2, 3, -4)};
  const VectorXd by_torque = bones.forward_dynamics(motion, torque_of_net(q, rest));
  const VectorXd by_force = bones.forward_dynamics(motion, VectorXd::Zero(4), loads);
  EXPECT_TRUE(matrix_near(by_force, by_torque, 1e-9 * by_torque.norm()));
}

INSTANTIATE_TEST_SUITE_P(Nets, NetMotion,
                         testing::Values("winslow.toml", "dogadov2017.toml", "chao_an.toml"));

}  // namespace
}  // namespace thenar
