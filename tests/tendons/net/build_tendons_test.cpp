// Tests for tendons/net/build_tendons.cpp and net_tendons.cpp.

#include "tendons/net/build_tendons.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "tendons/linear_tendons.h"
#include "tendons/net/net_tendons.h"
#include "tests/data_folder.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

using Eigen::VectorXd;

const VectorXd kPosture = (VectorXd(4) << 0.5, 0.05, 0.4, 0.3).finished();
const VectorXd kTension = (VectorXd(6) << 3, 5, 4, 2, 1, 2.5).finished();

Subject finger() { return read_subject(kData + "/subjects/an_chao_middle.toml"); }
NetDescription net_named(const std::string& name) {
  return read_net(kData + "/nets/" + name + ".toml");
}

TEST(BuildTendons, SaysWhichHoodWasBuilt) {
  const NetDescription winslow = net_named("winslow");
  TendonOptions options;
  EXPECT_EQ(build_digit_tendons(finger(), "middle", options)->digit().fidelity.hood,
            Hood::kFractions);
  options.hood = Hood::kFloatingNet;
  EXPECT_EQ(build_digit_tendons(finger(), "middle", options, &winslow)->digit().fidelity.hood,
            Hood::kFloatingNet);
}

TEST(BuildTendons, WantsANetIfAndOnlyIfTheHoodFloats) {
  const NetDescription winslow = net_named("winslow");
  TendonOptions options;
  EXPECT_THROW((void)build_digit_tendons(finger(), "middle", options, &winslow), InputError);
  options.hood = Hood::kFloatingNet;
  EXPECT_THROW((void)build_digit_tendons(finger(), "middle", options), InputError);
}

// For linear tendons the interface must say what the digit's own statics say.
TEST(BuildTendons, TipForceIsThatOfTheDigitsStatics) {
  const auto tendons = build_digit_tendons(finger(), "middle");
  const TipForce own = tip_force(tip_statics(tendons->digit(), kPosture), kTension);
  EXPECT_TRUE(matrix_near(tip_force(*tendons, kPosture, kTension).force.f_W, own.f_W, 1e-12));
}

// R' t + tau_0 must be the torque, though a net's torque is not linear in t.
TEST(BuildTendons, StaticsOfANetCarryItsWholeTorque) {
  const NetDescription winslow = net_named("winslow");
  const auto tendons = build_net_tendons(finger(), "middle", {}, winslow);
  const TipStatics statics =
      tip_statics(tendons->digit(), kPosture, kTension, tendons->evaluate(kPosture, kTension));
  const VectorXd passive = passive_torque(tendons->digit().skeleton, kPosture);
  EXPECT_TRUE(matrix_near(statics.R.transpose() * kTension + statics.tau_0,
                          tendons->evaluate(kPosture, kTension).tau + passive, 1e-12));
}

// With its only band cut, nothing holds the knot that muscles pull.
TEST(NetTendons, TellsThatATornSlipIsDrawnIn) {
  auto linear = build_linear_tendons(finger(), "middle", {Path::kViaPoint, Hood::kSeparate});
  BuiltNet torn = cut(build_net(finger(), linear->digit(), net_named("chao_an")), "ulnar");
  const NetTendons tendons(std::move(linear), std::move(torn));
  const std::string warning = tendons.evaluate(kPosture, kTension, {}).warning;
  EXPECT_NE(warning.find("has drawn in 'ulnar_knot'"), std::string::npos) << warning;
}

TEST(BuildTendons, TipForceOfATornNetIsNotToBeTrusted) {
  auto linear = build_linear_tendons(finger(), "middle", {Path::kViaPoint, Hood::kSeparate});
  BuiltNet torn = cut(build_net(finger(), linear->digit(), net_named("chao_an")), "ulnar");
  const NetTendons tendons(std::move(linear), std::move(torn));
  const TendonTip tip = tip_force(tendons, kPosture, kTension);
  EXPECT_EQ(tip.warning, tendons.evaluate(kPosture, kTension, {}).warning);
  EXPECT_NE(tip.warning, "");
}

// A knot in its exit is held there whatever its muscle adds; the rest of the net still has arms.
TEST(NetTendons, HasTheMomentArmsOfADrawnInNet) {
  auto linear = build_linear_tendons(finger(), "middle", {Path::kViaPoint, Hood::kSeparate});
  BuiltNet torn = cut(build_net(finger(), linear->digit(), net_named("chao_an")), "ulnar");
  const NetTendons tendons(std::move(linear), std::move(torn));
  const TendonTorque at = tendons.evaluate(kPosture, kTension, {});
  constexpr double kStep = 1e-3;  // [N]
  for (Eigen::Index m = 0; m < kTension.size(); ++m) {
    VectorXd more = kTension, less = kTension;
    more(m) += kStep, less(m) -= kStep;
    const VectorXd slope = (tendons.evaluate(kPosture, more, at.nodes).tau -
                            tendons.evaluate(kPosture, less, at.nodes).tau) /
                           (2 * kStep);
    EXPECT_TRUE(matrix_near(at.R.row(m).transpose(), slope, 1e-8));  // [m/rad]
  }
}

TEST(NetTendons, SaysWhereTheNetHasNoMomentArms) {
  auto linear = build_linear_tendons(finger(), "middle", {Path::kViaPoint, Hood::kSeparate});
  BuiltNet built = build_net(finger(), linear->digit(), net_named("winslow"));
  NetSolverOptions hasty;
  hasty.max_iterations = 2;
  const NetTendons tendons(std::move(linear), std::move(built), hasty);
  const TendonTorque at = tendons.evaluate(kPosture, kTension, {});
  EXPECT_NE(at.warning.find("not balanced"), std::string::npos) << at.warning;
  EXPECT_NE(at.warning.find("moment arms are without the net"), std::string::npos) << at.warning;
  EXPECT_TRUE(at.R.allFinite());
}

/// Tendons without a net that are never to be trusted.
struct BadTendons : DigitTendons {
  explicit BadTendons(std::unique_ptr<DigitTendons> of) : good(std::move(of)) {}
  const TendonDigit& digit() const override { return good->digit(); }
  TendonTorque evaluate(const VectorXd& q, const VectorXd& t,
                        const Eigen::Matrix3Xd&) const override {
    TendonTorque pull = good->evaluate(q, t);
    pull.warning = "a path is not taut";
    return pull;
  }
  VectorXd lengths(const VectorXd& q, const VectorXd& t, const TendonTorque& at) const override {
    return good->lengths(q, t, at);
  }
  std::unique_ptr<DigitTendons> good;
};

TEST(NetTendons, HandsOnTheTroubleOfThePathsOutside) {
  auto bad = std::make_unique<BadTendons>(
      build_linear_tendons(finger(), "middle", {Path::kViaPoint, Hood::kSeparate}));
  BuiltNet built = build_net(finger(), bad->digit(), net_named("winslow"));
  const NetTendons tendons(std::move(bad), std::move(built));
  EXPECT_EQ(tendons.evaluate(VectorXd::Zero(4), kTension, {}).warning, "a path is not taut");
}

// A surface that has grown over an insertion buries the band that bends over it.
TEST(NetTendons, TellsThatABandIsBuried) {
  auto linear = build_linear_tendons(finger(), "middle", {Path::kViaPoint, Hood::kSeparate});
  BuiltNet built = build_net(finger(), linear->digit(), net_named("winslow"));
  for (BoneSurface& surface : built.net.surfaces)
    if (surface.name == "DIP_dorsum") surface.size[0] = 0.008;
  const NetTendons tendons(std::move(linear), std::move(built));
  const VectorXd straight = VectorXd::Zero(4);
  const std::string warning = tendons.evaluate(straight, kTension, {}).warning;
  EXPECT_NE(warning.find("ends inside 'DIP_dorsum'"), std::string::npos) << warning;
}

// What a pull carries of its rest saves a search and changes nothing: slopes found from its nodes
// alone are the same.
TEST(NetTendons, SlopesAreThoseOfTheRestThatAPullCarries) {
  const auto tendons = build_net_tendons(finger(), "middle", {}, net_named("winslow"));
  TendonTorque pull = tendons->evaluate(kPosture, kTension);
  ASSERT_NE(pull.rest, nullptr);
  EXPECT_TRUE(matrix_near(pull.rest->x, pull.nodes, 0));
  const Eigen::MatrixXd give = tendons->compliance(kPosture, kTension, pull);
  const Eigen::MatrixXd slopes = tendons->torque_by_posture(kPosture, kTension, pull);
  pull.rest.reset();
  EXPECT_GT(give.norm(), 1e-5);  // [m/N]
  EXPECT_TRUE(matrix_near(tendons->compliance(kPosture, kTension, pull), give, 1e-6 * give.norm()));
  EXPECT_TRUE(matrix_near(tendons->torque_by_posture(kPosture, kTension, pull), slopes,
                          1e-6 * slopes.norm()));
}

TEST(NetTendons, RefusesAStartOfAnotherNet) {
  const NetDescription winslow = net_named("winslow");
  const auto tendons = build_net_tendons(finger(), "middle", {}, winslow);
  EXPECT_THROW((void)tendons->evaluate(kPosture, kTension, Eigen::Matrix3Xd::Zero(3, 2)),
               InputError);
}

}  // namespace
}  // namespace thenar
