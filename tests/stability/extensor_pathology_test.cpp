// What becomes of the extensor mechanism when its parts fail: a finger swept through the postures
// in which its lateral bands change sides.

#include <algorithm>

#include <gtest/gtest.h>

#include "base/lists.h"
#include "base/units.h"
#include "tendons/linear_tendons.h"
#include "tests/data_folder.h"
#include "tests/tendons/net/sweep_net.h"

namespace thenar {
namespace {

using Eigen::VectorXd;

constexpr int kPip = 2, kDip = 3;
constexpr double kPull = 2.9;  // of the extensor [N]

/// The normative middle finger with Winslow's rhombus, some bands cut.
NetTendons finger(const std::vector<std::string>& gone) {
  const Subject subject = read_subject(kData + "/subjects/an_chao_middle.toml");
  auto separate = build_linear_tendons(subject, "middle", {Path::kViaPoint, Hood::kSeparate});
  BuiltNet net = build_net(subject, separate->digit(), read_net(kData + "/nets/winslow.toml"));
  for (const std::string& band : gone) net = cut(net, band);
  return {std::move(separate), std::move(net)};
}

/// The central slip, torn with the fibres that tie the lateral bands to its end; and what holds the
/// lateral bands over the middle phalanx.
const std::vector<std::string> kTorn{"central_slip", "transverse_u", "transverse_r"};
const std::vector<std::string> kTornWithTriangular{"central_slip", "transverse_u", "transverse_r",
                                                   "triangular"};

/// The joint alone from straight to `angle` in steps of a degree, under the extensor alone.
std::vector<SweepPoint> bend_pip(const NetTendons& tendons, double angle) {
  const VectorXd straight = tendons.net().frame.straight;
  VectorXd end = straight, pull = VectorXd::Zero(6);
  end[kPip] += angle;
  pull[0] = kPull;
  return sweep_net(
      tendons, postures_between(straight, end, static_cast<int>(std::abs(angle) / kDegree)), pull);
}

/// Height of a lateral band beside the joint above its axis, in the proximal phalanx [m].
double height_beside(const NetTendons& tendons, const SweepPoint& point, const std::string& node) {
  const FingerBone& bone = tendons.net().frame.bone(BoneRole::kProximal);
  const TreeState<double> state = pose_tree(tendons.digit().model.tree, point.q);
  const Eigen::Vector3d p =
      state[static_cast<std::size_t>(bone.link)].X.inverse() *
      Eigen::Vector3d(point.rest.x.col(place_named(tendons.net().net.nodes, node)));
  return (p - bone.distal).dot(bone.dorsal);
}

TEST(Boutonniere, EveryPostureOfTheCutNetBalances) {
  for (const SweepPoint& point : bend_pip(finger(kTorn), 90 * kDegree))
    EXPECT_EQ(point.rest.status, NetStatus::kBalanced) << point.q[kPip] / kDegree;
}

// The deformity: the muscle that extends the joint in a straight finger flexes it in a bent one.
TEST(Boutonniere, ExtensorFlexesTheBentJointWithoutItsCentralSlip) {
  const auto cut_points = bend_pip(finger(kTorn), 90 * kDegree);
  EXPECT_LT(cut_points.front().tau[kPip], 0);
  EXPECT_GT(cut_points.back().tau[kPip], 0);
}

TEST(Boutonniere, IntactExtensorExtendsTheJointThroughout) {
  for (const SweepPoint& point : bend_pip(finger({}), 90 * kDegree))
    EXPECT_LT(point.tau[kPip], 0) << point.q[kPip] / kDegree;
}

TEST(Boutonniere, LateralBandsSlipPalmarOfTheAxis) {
  const NetTendons tendons = finger(kTorn);
  const auto points = bend_pip(tendons, 60 * kDegree);
  for (const char* node : {"beside_u", "beside_r"}) {
    EXPECT_GT(height_beside(tendons, points.front(), node), 0);
    EXPECT_LT(height_beside(tendons, points.back(), node), 0);
  }
}

// Elson's test [Elson1986]: with the joint bent to a right angle, the end joint is limp while the
// central slip is whole, and stiff when it is torn.
TEST(Boutonniere, ElsonsTestTellsTheTornSlip) {
  EXPECT_NEAR(bend_pip(finger({}), 90 * kDegree).back().slips.terminal, 0, 1e-6);
  EXPECT_GT(bend_pip(finger(kTorn), 90 * kDegree).back().slips.terminal, 0.1 * kPull);
}

TEST(Boutonniere, TornSlipLeavesMoreToTheEndJoint) {
  const auto whole = bend_pip(finger({}), 60 * kDegree);
  const auto torn = bend_pip(finger(kTorn), 60 * kDegree);
  for (std::size_t k = 0; k < whole.size(); ++k)
    EXPECT_LT(torn[k].tau[kDip], whole[k].tau[kDip] - 1e-4) << k;  // [N m]
}

/// Steps of a degree until the extensor begins to flex the joint; all of them if it never does.
std::size_t flexes_after(const std::vector<SweepPoint>& points) {
  const auto flexes = std::find_if(points.begin(), points.end(),
                                   [](const SweepPoint& point) { return point.tau[kPip] > 0; });
  return static_cast<std::size_t>(flexes - points.begin());
}

TEST(Boutonniere, TriangularLigamentDelaysIt) {
  EXPECT_LT(flexes_after(bend_pip(finger(kTornWithTriangular), 60 * kDegree)),
            flexes_after(bend_pip(finger(kTorn), 60 * kDegree)));
}

// With the triangular ligament gone too, a band no longer slides but snaps, and the sweep says so.
TEST(Boutonniere, SweepTellsWhereABandSnaps) {
  const NetTendons torn = finger(kTornWithTriangular);
  const auto points = bend_pip(torn, 60 * kDegree);
  const auto snap = std::find_if(points.begin(), points.end(),
                                 [](const SweepPoint& point) { return point.snapped; });
  ASSERT_NE(snap, points.end());
  EXPECT_GT(snap->moved, 4 * snap->carried);
  for (const SweepPoint& point : bend_pip(finger(kTorn), 60 * kDegree))
    EXPECT_FALSE(point.snapped) << point.q[kPip] / kDegree;
}

TEST(Boutonniere, IntactBandsDoNotSnap) {
  for (const SweepPoint& point : bend_pip(finger({}), 60 * kDegree))
    EXPECT_FALSE(point.snapped) << point.q[kPip] / kDegree;
}

// -- Swan neck: the ligaments that hold the lateral bands down are torn -------------------------

const std::vector<std::string> kRetinacular{"retinacular_u", "retinacular_r"};

TEST(SwanNeck, LateralBandsRiseInHyperextension) {
  const NetTendons tendons = finger(kRetinacular);
  const auto points = bend_pip(tendons, -15 * kDegree);
  for (const char* node : {"beside_u", "beside_r"})
    EXPECT_GT(height_beside(tendons, points.back(), node),
              height_beside(tendons, points.front(), node));
}

TEST(SwanNeck, RetinacularLigamentsHoldTheBandsDown) {
  const NetTendons tendons = finger({});
  for (const SweepPoint& point : bend_pip(tendons, -15 * kDegree))
    for (const char* node : {"beside_u", "beside_r"})
      EXPECT_LT(height_beside(tendons, point, node),
                tendons.net().frame.height[static_cast<std::size_t>(FingerJoint::kPip)] / 2);
}

// What makes the deformity grow: the further the joint is hyperextended, the harder the same pull
// hyperextends it, where the sound finger lets go.
TEST(SwanNeck, HyperextensionFeedsItself) {
  const auto torn = bend_pip(finger(kRetinacular), -15 * kDegree);
  const auto sound = bend_pip(finger({}), -15 * kDegree);
  for (std::size_t k = 1; k < torn.size(); ++k) {
    EXPECT_LT(torn[k].tau[kPip], torn[k - 1].tau[kPip]) << k;
    EXPECT_GT(sound[k].tau[kPip], sound[k - 1].tau[kPip]) << k;
  }
}

// The other half of the deformity: bands that have risen leave the end joint without extensor.
TEST(SwanNeck, EndJointDroops) {
  EXPECT_LT(bend_pip(finger(kRetinacular), -15 * kDegree).back().slips.terminal, 0.01 * kPull);
  EXPECT_GT(bend_pip(finger({}), -15 * kDegree).back().slips.terminal, 0.5 * kPull);
}

}  // namespace
}  // namespace thenar
