// Tests for tendons/hand/tendon_hand.cpp.

#include "tendons/hand/tendon_hand.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "base/error.h"
#include "data/io/net.h"
#include "tendons/net/build_tendons.h"
#include "tests/hand/hand_laws.h"
#include "tests/hand/skin/human_subjects.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

const std::map<std::string, double>& still_wrist() {
  static const std::map<std::string, double> frozen{{"WRIST_FE", 0}, {"WRIST_AA", 0}};
  return frozen;
}

/// Tendons of these digits; every muscle pulls with up to 100 N.
HandTendons tendons_of(const Subject& subject, const std::vector<std::string>& digits) {
  HandTendons tendons;
  for (const std::string& digit : digits) {
    TendonOptions options;
    options.hood = Hood::kSeparate;
    tendons.digits.push_back(build_digit_tendons(subject, digit, options));
    for (const std::string& name : tendons.digits.back()->digit().names.muscles)
      tendons.max_force[name] = 100;
  }
  return tendons;
}

int index_of(const std::vector<std::string>& names, const std::string& name) {
  return static_cast<int>(std::find(names.begin(), names.end(), name) - names.begin());
}

TEST(TendonHand, ObeysTheLawsOfHands) {
  const Subject subject = sample::subject("mirakhorlo2016");
  expect_hand_laws(TendonHand(build_skeleton(subject, {{"thumb", "index"}, still_wrist()}),
                              tendons_of(subject, {"thumb", "index"})),
                   11);
}

// Linear tendons: B is the transposed moment arms, joint by joint and muscle by muscle.
TEST(TendonHand, PullsByMomentArms) {
  const Subject subject = sample::subject("mirakhorlo2016");
  const TendonHand hand(build_skeleton(subject, {{"index", "middle"}, still_wrist()}),
                        tendons_of(subject, {"index", "middle"}));
  const auto middle = build_digit_tendons(subject, "middle", {Path::kViaPoint, Hood::kSeparate});
  const Eigen::VectorXd q = Eigen::VectorXd::LinSpaced(8, 0.05, 0.4);
  const Actuation actuation = hand.actuation(q);
  const TendonPull pull =
      middle->pull(q.tail(4), Eigen::VectorXd::Zero(middle->digit().max_tension.size()));
  const TendonNames& names = middle->digit().names;
  for (std::size_t m = 0; m < names.muscles.size(); ++m)
    for (std::size_t j = 0; j < names.coordinates.size(); ++j)
      EXPECT_NEAR(actuation.B(index_of(hand.layout().coordinates, names.coordinates[j]),
                              index_of(hand.layout().actuators, names.muscles[m])),
                  pull.R(static_cast<int>(m), static_cast<int>(j)), 1e-15);
  EXPECT_TRUE(actuation.lower.isZero(0));
  EXPECT_TRUE((actuation.upper.array() == 100).all());
  EXPECT_LT(actuation.tau_0.norm(), 1e-12);  // this subject's joints state no stiffness
}

// The first dorsal interosseus runs from the thumb's metacarpal to the index finger.
TEST(TendonHand, HasOneActuatorForAMuscleOfTwoDigits) {
  const Subject subject = sample::subject("mirakhorlo2016");
  const TendonHand hand(build_skeleton(subject, {{"thumb", "index"}, still_wrist()}),
                        tendons_of(subject, {"thumb", "index"}));
  const HandLayout& layout = hand.layout();
  EXPECT_EQ(std::count(layout.actuators.begin(), layout.actuators.end(), "DI1_MC1"), 1);
  const Eigen::MatrixXd B = hand.actuation(Eigen::VectorXd::Zero(8)).B;
  const int muscle = index_of(layout.actuators, "DI1_MC1");
  EXPECT_NE(B(index_of(layout.coordinates, "MCP2_AA"), muscle), 0);
  EXPECT_NE(B(index_of(layout.coordinates, "CMC1_FE"), muscle), 0);
}

// A net's torque by its tangent: right at the tensions where it is taken, and near them to second
// order.
TEST(TendonHand, TakesNetsByTheirTangent) {
  const Subject subject = sample::subject("mirakhorlo2016");
  const NetDescription net = read_net(THENAR_DATA_DIR "/nets/winslow.toml");
  const TendonOptions floating{Path::kViaPoint, Hood::kFloatingNet};
  HandTendons tendons;
  tendons.digits.push_back(build_digit_tendons(subject, "middle", floating, &net));
  for (const std::string& name : tendons.digits[0]->digit().names.muscles)
    tendons.max_force[name] = 50;
  tendons.working_share = 0.3;
  const TendonHand hand(build_skeleton(subject, {{"middle"}, still_wrist()}), std::move(tendons));
  const auto alone = build_digit_tendons(subject, "middle", floating, &net);
  const Eigen::Vector4d q(0.3, 0, 0.4, 0.2);
  const Actuation actuation = hand.actuation(q);
  const Eigen::VectorXd t = Eigen::VectorXd::Constant(hand.max_force().size(), 15);
  const auto off = [&](const Eigen::VectorXd& at) {
    return (actuation.B * at + actuation.tau_0 - alone->pull(q, at).tau).norm();
  };
  EXPECT_LT(off(t), 1e-9);
  Eigen::VectorXd step = Eigen::VectorXd::Zero(t.size());
  step[0] = 1;
  step[1] = -2;
  const double scale = (actuation.B * step).norm();
  EXPECT_LT(off(t + 0.1 * step), 0.05 * 0.1 * scale);
}

TEST(TendonHand, RefusesWhatItCannotPullWith) {
  const Subject subject = sample::subject("mirakhorlo2016");
  const Skeleton index = build_skeleton(subject, {{"index"}, still_wrist()});
  EXPECT_EQ(message_of([&] { (void)TendonHand(index, tendons_of(subject, {"middle"})); }),
            "tendons move joint 'MCP3_FE', which the hand lacks");
  HandTendons weak = tendons_of(subject, {"index"});
  weak.max_force["FDP2"] = 0;
  EXPECT_EQ(message_of([&] { (void)TendonHand(index, std::move(weak)); }),
            "largest tension of muscle 'FDP2' must be > 0 N, got 0");
  HandTendons unknown = tendons_of(subject, {"index"});
  unknown.max_force.erase("FDS2");
  EXPECT_EQ(message_of([&] { (void)TendonHand(index, std::move(unknown)); }),
            "no largest tension for muscle 'FDS2'");
}

}  // namespace
}  // namespace thenar
