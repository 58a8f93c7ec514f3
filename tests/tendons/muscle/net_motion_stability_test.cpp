// Where simulate() might break under a net: random excitations from rest, on every net of data/nets
// and every rung of muscles. THENAR_MOTIONS asks for more than the few of every day.

#include <algorithm>
#include <cstdlib>
#include <map>

#include <gtest/gtest.h>

#include "tendons/muscle/simulate.h"
#include "tendons/net/build_tendons.h"
#include "tests/tendons/muscle/moving_samples.h"

namespace thenar {
namespace {

using Eigen::VectorXd;

const char* const kNets[] = {"winslow", "dogadov2017", "chao_an"};
const Muscle kRungs[] = {Muscle::kBounds, Muscle::kRigidTendon, Muscle::kElasticTendon};
const char* const kEnds[] = {"done", "stopped", "stuck", "no progress", "unbalanced"};

std::unique_ptr<DigitTendons> net_with_stiffness(const Subject& subject, const std::string& net) {
  TendonOptions rungs;
  rungs.hood = Hood::kFloatingNet;
  return build_net_tendons(subject, "index", rungs,
                           read_net(THENAR_DATA_DIR "/nets/" + net + ".toml"));
}

/// A motion from muscles at rest.
struct FromRest {
  Muscle rung;
  VectorXd q, excitation;  // [rad], [1]
  double seconds, tolerance = 1e-6;
};

Trajectory motion_of(const DigitTendons& tendons, const Subject& subject, const FromRest& wanted) {
  const auto contraction =
      build_contraction(musculotendons(subject, tendons.digit(), wanted.rung), wanted.rung);
  SimulateOptions options;
  options.seconds = wanted.seconds;
  options.tolerance = wanted.tolerance;
  return simulate({tendons, *contraction}, constant_excitation(wanted.excitation),
                  {wanted.q, {}, VectorXd::Zero(wanted.excitation.size())}, options);
}

/// The k-th: half of the muscles are excited, most of them a little, and every other start is a
/// random posture.
Trajectory motion(int k, const DigitTendons& tendons, const Subject& subject, double seconds) {
  sample::Draw draw(1000 + static_cast<unsigned>(k));
  VectorXd excitation(7);
  for (double& e : excitation) e = draw.number(0, 1) < 0.5 ? 0 : std::pow(draw.number(0, 1), 2);
  const VectorXd q = k / 9 % 2 == 0 ? VectorXd::Zero(4) : draw.posture(tendons.digit().skeleton);
  return motion_of(tendons, subject, {kRungs[k / 3 % 3], q, excitation, seconds});
}

// Excursions are integrated, and lines have lengths of their own: where a nearly slack net gives a
// lot the two came apart, by how much hung on the steps, and angles ended up to 70 mrad apart.
TEST(NetMotionStability, EndsDoNotHangOnTheTolerance) {
  const Subject subject = sample::index_finger();
  const auto winslow = net_with_stiffness(subject, "winslow");
  const VectorXd excitation = (VectorXd(7) << 0.05, 0.02, 0.1, 0.02, 0.02, 0.02, 0.02).finished();
  for (const Muscle rung : {Muscle::kRigidTendon, Muscle::kElasticTendon}) {
    const auto end = [&](double tolerance) -> VectorXd {
      const Trajectory path = motion_of(
          *winslow, subject, {rung, VectorXd::Constant(4, 0.2), excitation, 0.2, tolerance});
      EXPECT_EQ(path.status, MotionStatus::kCompleted) << path.warning;
      EXPECT_EQ(path.warning, "");
      EXPECT_LT(path.drift.value_or(0), 1e-4);  // [m]
      return path.angle.bottomRows(1).transpose();
    };
    const VectorXd fine = end(1e-8);
    for (const double tolerance : {1e-5, 1e-6, 1e-7})
      EXPECT_LT((end(tolerance) - fine).cwiseAbs().maxCoeff(), 100 * tolerance) << tolerance;
  }
}

TEST(NetMotionStability, EveryMotionFromRestEndsAndBalancesOrSaysNot) {
  const char* wanted = std::getenv("THENAR_MOTIONS");
  const int count = wanted ? std::atoi(wanted) : 9;
  const double seconds = wanted ? 0.2 : 0.03;
  const Subject subject = sample::index_finger();
  std::map<std::string, std::unique_ptr<DigitTendons>> nets;
  for (const char* net : kNets) nets[net] = net_with_stiffness(subject, net);

  std::map<MotionStatus, int> ends;
  double worst = 0;
  for (int k = 0; k < count; ++k) {
    const std::string net = kNets[k % 3];
    const Muscle rung = kRungs[k / 3 % 3];
    const Trajectory path = motion(k, *nets[net], subject, seconds);
    ++ends[path.status];

    SCOPED_TRACE(
        fmt::format("motion {} of net {} on rung {}: {}", k, net, int(rung), path.warning));
    EXPECT_TRUE(path.angle.allFinite() && path.speed.allFinite() && path.tension.allFinite());
    EXPECT_GE(path.tension.minCoeff(), 0);
    if (path.status != MotionStatus::kCompleted) {
      EXPECT_NE(path.warning, "");
      continue;
    }
    EXPECT_NEAR(path.time.tail<1>()[0], seconds, 1e-12);
    EXPECT_LE(path.balance.error, 1e-4 * path.balance.turned_over + 1e-9);
    worst = std::max(worst, path.balance.error / path.balance.turned_over);
  }
  fmt::print("{} motions of {} s; energy of nothing at most {:.2g} of what was turned over\n",
             count, seconds, worst);
  for (const auto& [end, motions] : ends)
    fmt::print("  {} {}\n", motions, kEnds[static_cast<int>(end)]);
  EXPECT_GE(ends[MotionStatus::kCompleted], count * 9 / 10);
}

// Muscles once followed a net's moment arms without what its bands give. Where one drew a knot into
// its exit (motion 22), they pushed it in and out for ever.
TEST(NetMotionStability, GetsPastAKnotThatIsDrawnIn) {
  const Subject subject = sample::index_finger();
  const Trajectory path = motion(22, *net_with_stiffness(subject, "dogadov2017"), subject, 0.05);
  EXPECT_NEAR(path.time.tail<1>()[0], 0.05, 1e-12) << path.warning;
  EXPECT_LT(path.counts.steps, 2000);
  EXPECT_EQ(path.status, MotionStatus::kCompleted);
}

// Knots that bands clasp to a bone once lost it as soon as it moved 1 nm away from their start: the
// net came to rest elsewhere in all but the shortest steps.
TEST(NetMotionStability, KeepsKnotsOnBonesThatMoveOn) {
  const Subject subject = sample::index_finger();
  const Trajectory path = motion(283, *net_with_stiffness(subject, "dogadov2017"), subject, 0.02);
  EXPECT_EQ(path.status, MotionStatus::kCompleted) << path.warning;
  EXPECT_LT(path.counts.steps, 1000);
}

// With muscles at rest a net once made 16 mJ of 66, and 100 mJ, out of nothing; or it got nowhere.
TEST(NetMotionStability, MusclesThatStartAtRestMakeNoEnergy) {
  const Subject subject = sample::index_finger();
  const auto of = [](double EDC, double FDP, double LU) {
    VectorXd e = VectorXd::Zero(7);  // EDC, EIP, FDP, FDS, RI, LU, UI
    e[0] = EDC, e[2] = FDP, e[5] = LU;
    return e;
  };
  for (const VectorXd& excitation : {of(0.2, 0.2, 0), of(0.05, 0.02, 0.1)})
    for (const char* net : {"chao_an", "winslow"}) {
      const Trajectory path =
          motion_of(*net_with_stiffness(subject, net), subject,
                    {Muscle::kRigidTendon, VectorXd::Zero(4), excitation, 0.05});
      EXPECT_EQ(path.status, MotionStatus::kCompleted) << net << " " << path.warning;
      EXPECT_LT(path.balance.error, 1e-5 * path.balance.turned_over) << net;
      EXPECT_GT(path.balance.turned_over, 1e-6) << net;
    }
}

}  // namespace
}  // namespace thenar
