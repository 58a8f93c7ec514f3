// Tests for hand_versions/tendon_hand.cpp.

#include "hand_versions/tendon_hand.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "base/error.h"
#include "data/io/net_description.h"
#include "hand_versions/hand_actuator.h"
#include "tendons/net/build_tendons.h"
#include "tendons/net/digit_sweep.h"
#include "tendons/net/posture_sweep.h"
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

int find_index(const std::vector<std::string>& names, const std::string& name) {
  return static_cast<int>(std::find(names.begin(), names.end(), name) - names.begin());
}

/// The specimen, of whose joints passive moments are left out.
Subject tendons_alone() {
  return with_passive(sample::subject("mirakhorlo2016"), PassiveMoments::kOff);
}

TEST(TendonHand, ObeysTheLawsOfHands) {
  const Subject subject = sample::subject("mirakhorlo2016");
  expect_hand_laws(TendonHand(build_skeleton(subject, {{"thumb", "index"}, still_wrist()}),
                              tendons_of(subject, {"thumb", "index"})),
                   11);
}

// Linear tendons: B is the transposed moment arms, joint by joint and muscle by muscle.
TEST(TendonHand, PullsByMomentArms) {
  const Subject subject = tendons_alone();
  const TendonHand hand(build_skeleton(subject, {{"index", "middle"}, still_wrist()}),
                        tendons_of(subject, {"index", "middle"}));
  const auto middle = build_digit_tendons(subject, "middle", {Path::kViaPoint, Hood::kSeparate});
  const Eigen::VectorXd q = Eigen::VectorXd::LinSpaced(8, 0.05, 0.4);
  const Actuation actuation = hand.actuation(q);
  const TendonTorque pull =
      middle->evaluate(q.tail(4), Eigen::VectorXd::Zero(middle->digit().max_tension.size()));
  const TendonNames& names = middle->digit().names;
  for (std::size_t m = 0; m < names.muscles.size(); ++m)
    for (std::size_t j = 0; j < names.coordinates.size(); ++j)
      EXPECT_NEAR(actuation.B(find_index(hand.layout().coordinates, names.coordinates[j]),
                              find_index(hand.layout().actuators, names.muscles[m])),
                  pull.R(static_cast<int>(m), static_cast<int>(j)), 1e-15);
  EXPECT_TRUE(actuation.lower.isZero(0));
  EXPECT_TRUE((actuation.upper.array() == 100).all());
  EXPECT_LT(actuation.tau_0.norm(), 1e-12);
}

// What passive moments do without tension is that of the skeleton, and applied with any tension.
TEST(TendonHand, CountsPassiveMoments) {
  const Subject subject = sample::subject("mirakhorlo2016");
  const Skeleton bones = build_skeleton(subject, {{"index"}, still_wrist()});
  const TendonHand hand(bones, tendons_of(subject, {"index"}));
  const Eigen::Vector4d q(0.8, 0.1, 0.6, 0.3);
  EXPECT_GT(passive_torque(bones, q).norm(), 0.05);  // [N m]
  EXPECT_TRUE(matrix_near(hand.actuation(q).tau_0, passive_torque(bones, q), 1e-15));
  const Eigen::VectorXd t = Eigen::VectorXd::Constant(hand.max_force().size(), 3);
  const TendonHand bare(build_skeleton(tendons_alone(), {{"index"}, still_wrist()}),
                        tendons_of(tendons_alone(), {"index"}));
  EXPECT_TRUE(matrix_near(hand.applied_torque(q, t).tau,
                          bare.applied_torque(q, t).tau + passive_torque(bones, q), 1e-15));
}

// The first dorsal interosseus runs from the thumb's metacarpal to the index finger.
TEST(TendonHand, HasOneActuatorForAMuscleOfTwoDigits) {
  const Subject subject = sample::subject("mirakhorlo2016");
  const TendonHand hand(build_skeleton(subject, {{"thumb", "index"}, still_wrist()}),
                        tendons_of(subject, {"thumb", "index"}));
  const HandLayout& layout = hand.layout();
  EXPECT_EQ(std::count(layout.actuators.begin(), layout.actuators.end(), "DI1_MC1"), 1);
  const Eigen::MatrixXd B = hand.actuation(Eigen::VectorXd::Zero(8)).B;
  const int muscle = find_index(layout.actuators, "DI1_MC1");
  EXPECT_NE(B(find_index(layout.coordinates, "MCP2_AA"), muscle), 0);
  EXPECT_NE(B(find_index(layout.coordinates, "CMC1_FE"), muscle), 0);
}

/// The middle finger with a net, up to so much a muscle; actuation() is taken at 0.3 of it.
/// @param most  [N]
TendonHand net_hand(double most = 50) {
  const Subject subject = tendons_alone();
  const NetDescription net = read_net(THENAR_DATA_DIR "/nets/winslow.toml");
  HandTendons tendons;
  tendons.digits.push_back(
      build_digit_tendons(subject, "middle", {Path::kViaPoint, Hood::kFloatingNet}, &net));
  for (const std::string& name : tendons.digits[0]->digit().names.muscles)
    tendons.max_force[name] = most;
  tendons.working_share = 0.3;
  return {build_skeleton(subject, {{"middle"}, still_wrist()}), std::move(tendons)};
}

const Eigen::Vector4d kBent(0.3, 0, 0.4, 0.2);

/// What `thenar tendon solve` says of the joint torque.
Eigen::VectorXd solved(const TendonHand& hand, const Eigen::VectorXd& q, const Eigen::VectorXd& t) {
  return sweep_digit(*hand.digits()[0], {q}, t).front().pull.tau;
}

TEST(TendonHand, TakesNetsByASecantThatIsRightAtNoTensionAndAtWork) {
  const TendonHand hand = net_hand(20);  // under 15 N each the terminal band strains too far
  const Actuation actuation = hand.actuation(kBent);
  const Eigen::VectorXd t = Eigen::VectorXd::Constant(hand.max_force().size(), 6);
  EXPECT_EQ(actuation.status, ActuationStatus::kLinearised);
  EXPECT_TRUE(matrix_near(Eigen::VectorXd(actuation.B * t + actuation.tau_0),
                          solved(hand, kBent, t), 1e-9));
  EXPECT_TRUE(matrix_near(actuation.tau_0, solved(hand, kBent, 0 * t), 1e-9));
  // Slack tendons do nothing, where the tangent's offset was up to 178 N mm.
  EXPECT_LT(actuation.tau_0.cwiseAbs().maxCoeff(), 1e-3);  // [N m]
}

// All over the fingers' ranges and loads: the effort of a hand is what solving its digit says.
TEST(TendonHand, HasTheEffortThatSolvingTellsOf) {
  const TendonHand hand = net_hand();
  sample::Draw draw(5);
  for (int k = 0; k < 6; ++k) {
    const Eigen::VectorXd q = Eigen::Vector4d(draw.number(0, 1.2), draw.number(-0.2, 0.2),
                                              draw.number(0, 1.2), draw.number(0, 0.8));
    const Eigen::VectorXd t = draw.numbers(hand.max_force().size(), 0, 30);
    const AppliedTorque applied = hand.applied_torque(q, t);
    EXPECT_TRUE(matrix_near(applied.tau, solved(hand, q, t), 1e-9)) << k;
  }
}

// A hand in motion ends where a hand that is put there ends, and says how it would go on.
TEST(HandActuator, GoesOnFromItsState) {
  const TendonHand hand = net_hand();
  HandActuator actuator(hand);
  const Eigen::VectorXd u = Eigen::VectorXd::Constant(hand.max_force().size(), 5);
  for (int k = 0; k <= 10; ++k) (void)actuator.act(0.1 * k * kBent, u);
  const HandAction& action = actuator.act(kBent, u);
  const AppliedTorque applied = hand.applied_torque(kBent, u);
  EXPECT_EQ(action.status, TendonStatus::kValid);
  EXPECT_TRUE(action.slopes);
  EXPECT_FALSE(action.snapped);
  EXPECT_TRUE(matrix_near(action.tau, applied.tau, 1e-7));
  EXPECT_TRUE(matrix_near(action.B, applied.B, 1e-6));
  EXPECT_EQ(action.length.size(), u.size());
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
