// Tests for tendons/tendon_model.cpp on the normative middle finger.

#include "tendons/tendon_model.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/units.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

Subject an_chao_finger() {
  return read_subject(std::string(THENAR_DATA_DIR) + "/subjects/an_chao_middle.toml");
}

Subject specimen() {
  return read_subject(std::string(THENAR_DATA_DIR) + "/subjects/mirakhorlo2016.toml");
}

int index_of(const std::vector<std::string>& names, const std::string& name) {
  return static_cast<int>(std::find(names.begin(), names.end(), name) - names.begin());
}

JointAxis& joint_of(Subject& subject, const std::string& name) {
  return *std::find_if(subject.joints.begin(), subject.joints.end(),
                       [&](const JointAxis& joint) { return joint.name == name; });
}

// Moment arms are minus the derivative of length: central differences of every path.
TEST(TendonModel, StrandArmsAreMinusLengthDerivatives) {
  const TendonDigit digit = build_tendon_digit(an_chao_finger(), "middle");
  const Eigen::Vector4d q(0.6, 0.1, 0.8, 0.4);
  const TreeState<double> state = pose_tree(digit.model.tree, q);
  const Eigen::MatrixXd R = strand_arms<double>(digit.model, state, q);
  constexpr double kStep = 1e-6;  // [rad]
  for (int j = 0; j < 4; ++j) {
    const Eigen::Vector4d h = kStep * Eigen::Vector4d::Unit(j);
    const auto ahead = pose_tree(digit.model.tree, Eigen::Vector4d(q + h));
    const auto behind = pose_tree(digit.model.tree, Eigen::Vector4d(q - h));
    for (std::size_t s = 0; s < digit.model.paths.size(); ++s) {
      const auto& path = digit.model.paths[s];
      const double slope = (path_length(ahead, path) - path_length(behind, path)) / (2 * kStep);
      EXPECT_NEAR(R(static_cast<Eigen::Index>(s), j), -slope, 1e-9) << digit.names.strands[s];
    }
  }
}

// Virtual work: muscle power equals the power of the torques it makes, hood and all.
TEST(TendonModel, MuscleArmsConservePowerThroughTheHood) {
  const TendonDigit digit = build_tendon_digit(an_chao_finger(), "middle");
  const Eigen::VectorXd q = Eigen::Vector4d(0.6, 0.1, 0.8, 0.4);
  const Eigen::Vector4d q_dot(0.3, -0.2, 0.5, 0.7);
  const TreeState<double> state = pose_tree(digit.model.tree, q);
  const Eigen::VectorXd t = Eigen::VectorXd::LinSpaced(6, 1, 6);
  const Eigen::VectorXd strand_tension = strand_matrix<double>(digit.model, q) * t;
  const Eigen::VectorXd shortening = strand_arms<double>(digit.model, state, q) * q_dot;
  const Eigen::VectorXd torque = muscle_arms<double>(digit.model, state, q).transpose() * t;
  EXPECT_NEAR(torque.dot(q_dot), strand_tension.dot(shortening), 1e-12);  // [W]
}

// By hand: EDC enters the hood whole and halves; each band takes half of the lateral half, and the
// terminal slip carries both bands.
TEST(TendonModel, HoodHalvesTheExtensor) {
  const TendonDigit digit = build_tendon_digit(an_chao_finger(), "middle");
  const Eigen::VectorXd q = Eigen::Vector4d::Zero();
  const Eigen::MatrixXd S = strand_matrix<double>(digit.model, q);
  const auto share = [&](const char* strand) {
    return S(index_of(digit.names.strands, strand), index_of(digit.names.muscles, "EDC"));
  };
  EXPECT_NEAR(share("LE"), 1, 1e-15);
  EXPECT_NEAR(share("ES"), 0.5, 1e-15);
  EXPECT_NEAR(share("RB"), 0.25, 1e-15);
  EXPECT_NEAR(share("UB"), 0.25, 1e-15);
  EXPECT_NEAR(share("TE"), 0.5, 1e-15);
}

// A ladder: without its hood every muscle pulls its own strand and nothing else.
TEST(TendonModel, SeparateTendonsLeaveTheHoodSlack) {
  TendonOptions options;
  options.hood = Hood::kSeparate;
  const TendonDigit digit = build_tendon_digit(an_chao_finger(), "middle", options);
  const Eigen::VectorXd q = Eigen::Vector4d::Zero();
  const Eigen::MatrixXd S = strand_matrix<double>(digit.model, q);
  EXPECT_EQ(S.sum(), static_cast<double>(digit.names.muscles.size()));
  EXPECT_EQ(digit.fidelity.hood, Hood::kSeparate);
}

// Freezing a joint that a band crosses alone keeps the band: its tension still reaches others.
TEST(TendonModel, FrozenDistalJointKeepsTheHood) {
  TendonOptions options;
  options.frozen = {{"DIP3", 0.4}};
  const TendonDigit frozen = build_tendon_digit(an_chao_finger(), "middle", options);
  const TendonDigit whole = build_tendon_digit(an_chao_finger(), "middle");
  const Eigen::VectorXd q3 = Eigen::Vector3d(0.6, 0.1, 0.8);
  const Eigen::VectorXd q4 = Eigen::Vector4d(0.6, 0.1, 0.8, 0.4);
  EXPECT_TRUE(matrix_near(tip_statics(frozen, q3).R, tip_statics(whole, q4).R.leftCols(3), 1e-12));
}

TEST(TendonModel, FrozenKnuckleKeepsTheInterosseiInTheHood) {
  TendonOptions options;
  options.frozen = {{"MCP3_FE", 0.6}, {"MCP3_AA", 0.1}};
  const TendonDigit frozen = build_tendon_digit(an_chao_finger(), "middle", options);
  EXPECT_EQ(frozen.names.muscles.size(), 6U);
}

/// A finger whose end joint turns by 0.7 of its middle joint and 5 degrees.
Subject coupled_finger() {
  Subject subject = an_chao_finger();
  joint_of(subject, "DIP3").coupling = Coupling{"PIP3", 0.7, 5 * kDegree};
  return subject;
}

// By hand: while the middle joint turns by 1 the end joint turns by 0.7, so 8 + 0.7 x 5 = 11.5 mm.
TEST(TendonModel, ConstantArmsAtACoupledJointCountAtItsLeader) {
  Subject subject = coupled_finger();
  for (Strand& strand : subject.strands) strand.arms = {{"PIP3", 0.008}, {"DIP3", 0.005}};
  TendonOptions options;
  options.path = Path::kConstant;
  for (const Hood hood : {Hood::kSeparate, Hood::kFractions}) {
    options.hood = hood;
    const TendonDigit digit = build_tendon_digit(subject, "middle", options);
    ASSERT_EQ(digit.model.coordinates, 3);
    for (Eigen::Index s = 0; s < digit.model.constant_arms.rows(); ++s)
      EXPECT_TRUE(
          matrix_near(digit.model.constant_arms.row(s), Eigen::RowVector3d(0, 0, 0.0115), 1e-16));
  }
}

TEST(TendonModel, AStrandOfACoupledJointAloneIsKept) {
  Subject subject = coupled_finger();
  for (Strand& strand : subject.strands) strand.arms = {{"DIP3", -0.004}};
  TendonOptions options;
  options.path = Path::kConstant;
  options.hood = Hood::kSeparate;
  const TendonDigit digit = build_tendon_digit(subject, "middle", options);
  ASSERT_EQ(digit.names.strands.size(), subject.strands.size());
  EXPECT_TRUE(matrix_near(digit.model.constant_arms.col(2),
                          Eigen::VectorXd::Constant(digit.model.constant_arms.rows(), -0.0028),
                          1e-16));
}

// Welded joints turn by nothing: their arms do not count, whether welded by name or by their
// leader.
TEST(TendonModel, ConstantArmsAtAWeldedFollowerDoNotCount) {
  Subject subject = coupled_finger();
  for (Strand& strand : subject.strands) strand.arms = {{"MCP3_FE", 0.01}, {"DIP3", 0.005}};
  TendonOptions options;
  options.path = Path::kConstant;
  options.frozen = {{"PIP3", 0.3}};
  const TendonDigit digit = build_tendon_digit(subject, "middle", options);
  EXPECT_TRUE(matrix_near(digit.model.constant_arms.row(0), Eigen::RowVector2d(0.01, 0), 1e-16));
}

TEST(TendonModel, WristIsWeldedForAQuestionOfOneFingertip) {
  const TendonDigit welded = build_tendon_digit(specimen(), "thumb");
  TendonOptions options;
  options.wrist_mode = WristMode::kFree;
  const TendonDigit free = build_tendon_digit(specimen(), "thumb", options);
  EXPECT_EQ(free.model.coordinates, welded.model.coordinates + 2);
  EXPECT_GT(free.names.muscles.size(), welded.names.muscles.size());
}

// Euler's belt: a tendon over a bend of 1 rad with mu = 0.5 keeps exp(-0.5) of its tension; the
// bend is smoothed by 0.01 rad in quadrature.
TEST(TendonModel, FrictionFollowsEulersBelt) {
  TendonDigit digit = build_tendon_digit(an_chao_finger(), "middle");
  const Eigen::VectorXd q = Eigen::Vector4d(1, 0, 1, 0);
  const Eigen::VectorXd left = remaining_tension<double>(digit.model, q, 0.5);
  const double bend = std::sqrt(1 + 1e-4);
  EXPECT_NEAR(left[0], 1, 1e-15);
  EXPECT_NEAR(left[1], 1, 1e-15);
  EXPECT_NEAR(left[2], std::exp(-0.5 * bend), 1e-15);
  EXPECT_NEAR(left[3], std::exp(-0.5 * 2 * bend), 1e-15);
}

TEST(TendonModel, FrozenBendsCountForFriction) {
  TendonOptions options;
  options.frozen = {{"MCP3_FE", 1}};
  const TendonDigit digit = build_tendon_digit(an_chao_finger(), "middle", options);
  const Eigen::VectorXd q = Eigen::Vector3d(0, 1, 0);  // MCP3_AA, PIP3, DIP3
  const Eigen::VectorXd left = remaining_tension<double>(digit.model, q, 0.5);
  const double bend = std::sqrt(1 + 1e-4);  // a frozen one needs no smoothing
  EXPECT_NEAR(left[0], 1, 1e-15);
  EXPECT_NEAR(left[1], std::exp(-0.5), 1e-15);
  EXPECT_NEAR(left[2], std::exp(-0.5 * (1 + bend)), 1e-15);
}

// PIP3 follows MCP3 by half and 0.1 rad; DIP3 lies beyond both bends.
TEST(TendonModel, CoupledBendsCountForFriction) {
  Subject subject = an_chao_finger();
  joint_of(subject, "PIP3").coupling = Coupling{"MCP3_FE", 0.5, 0.1};
  const TendonDigit digit = build_tendon_digit(subject, "middle");
  const Eigen::VectorXd q = Eigen::Vector3d(1, 0, 0);  // MCP3_FE, MCP3_AA, DIP3
  const Eigen::VectorXd left = remaining_tension<double>(digit.model, q, 0.5);
  EXPECT_NEAR(left[1], 1, 1e-15);
  EXPECT_NEAR(left[2], std::exp(-0.5 * (std::sqrt(1 + 1e-4) + std::sqrt(0.36 + 1e-4))), 1e-15);
}

/// Share of EDC in the central slip at posture q, with a slope of 2 per radian.
double central_share(TendonDigit digit, const Eigen::VectorXd& q) {
  for (HoodShare<double>& share : digit.model.hood_shares) share.slope = 2;
  const Eigen::MatrixXd S = strand_matrix<double>(digit.model, q);
  return S(index_of(digit.names.strands, "ES"), index_of(digit.names.muscles, "EDC"));
}

// By hand: logistic(2 (0.7 - 0.33)), for a share of one half at 0.33 rad.
const double kShareAt07 = 1 / (1 + std::exp(-2 * (0.7 - 0.33)));

TEST(TendonModel, HoodFollowsTheKnuckle) {
  const TendonDigit digit = build_tendon_digit(an_chao_finger(), "middle");
  EXPECT_NEAR(central_share(digit, Eigen::Vector4d(0.7, 0.1, 0.9, 0.4)), kShareAt07, 1e-15);
}

TEST(TendonModel, HoodFollowsTheKnuckleBesideACoupledTip) {
  Subject subject = an_chao_finger();
  joint_of(subject, "DIP3").coupling = Coupling{"PIP3", 0.7, 0};
  const TendonDigit digit = build_tendon_digit(subject, "middle");
  EXPECT_NEAR(central_share(digit, Eigen::Vector3d(0.7, 0.1, 0.9)), kShareAt07, 1e-15);
}

TEST(TendonModel, HoodFollowsACoupledKnuckle) {
  Subject subject = an_chao_finger();
  const auto at = std::find_if(subject.joints.begin(), subject.joints.end(),
                               [](const JointAxis& joint) { return joint.name == "MCP3_FE"; });
  at->coupling = Coupling{"lead", 0.5, 0.2};
  JointAxis lead = *at;
  lead.name = "lead";
  lead.child = "lead_link";
  lead.direction = Eigen::Vector3d::UnitX();  // along the finger: no flexion
  lead.coupling.reset();
  at->parent = "lead_link";
  subject.joints.insert(at, lead);
  const TendonDigit digit = build_tendon_digit(subject, "middle");
  EXPECT_NEAR(central_share(digit, Eigen::Vector4d(1, 0.1, 0.9, 0.4)), kShareAt07, 1e-15);
}

TEST(TendonModel, HoodKeepsTheAngleOfAFrozenKnuckle) {
  TendonOptions options;
  options.frozen = {{"MCP3_FE", 0.7}};
  const TendonDigit digit = build_tendon_digit(an_chao_finger(), "middle", options);
  EXPECT_NEAR(central_share(digit, Eigen::Vector3d(0.1, 0.9, 0.4)), kShareAt07, 1e-15);
}

TEST(TendonModel, HoodFollowsFlexionAboutAReversedAxis) {
  Subject subject = an_chao_finger();
  joint_of(subject, "MCP3_FE").direction *= -1;
  const TendonDigit digit = build_tendon_digit(subject, "middle");
  EXPECT_NEAR(central_share(digit, Eigen::Vector4d(-0.7, 0.1, 0.9, 0.4)), kShareAt07, 1e-15);
}

// A left hand's radial direction is the other one, but it flexes the same way.
TEST(TendonModel, HoodFollowsTheKnuckleOfALeftHand) {
  Subject subject = an_chao_finger();
  subject.digits[0].radial *= -1;
  const TendonDigit digit = build_tendon_digit(subject, "middle");
  EXPECT_NEAR(central_share(digit, Eigen::Vector4d(0.7, 0.1, 0.9, 0.4)), kShareAt07, 1e-15);
}

TEST(TendonModel, ShiftOfAFractionIsLogistic) {
  EXPECT_NEAR(shift_fraction(0.25, std::log(3.0)), 0.5, 1e-15);
  EXPECT_EQ(shift_fraction(0.0, 5.0), 0);
  EXPECT_EQ(shift_fraction(1.0, -5.0), 1);
}

// A stated zero takes the muscle out; only a muscle without a number has no limit.
TEST(TendonModel, ZeroForceIsNotAnUnknownForce) {
  Subject subject = an_chao_finger();
  subject.muscles[0].max_force = 0;
  subject.muscles[1].max_force.reset();
  const TendonDigit digit = build_tendon_digit(subject, "middle");
  const auto limit = [&](std::size_t i) {
    return digit.max_tension[index_of(digit.names.muscles, subject.muscles[i].name)];
  };
  EXPECT_EQ(limit(0), 0);
  EXPECT_TRUE(std::isinf(limit(1)));
}

TEST(TendonModel, NamesTheDigitItHasNot) {
  try {
    (void)build_tendon_digit(an_chao_finger(), "ring");
    FAIL() << "expected InputError";
  } catch (const InputError& e) {
    EXPECT_STREQ(e.what(), "subject 'an_chao_middle' has no digit 'ring'; there are middle");
  }
}

}  // namespace
}  // namespace thenar
