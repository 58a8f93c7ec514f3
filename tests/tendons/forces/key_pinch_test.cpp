// Tests for tendons/forces/key_pinch.cpp.

#include "tendons/forces/key_pinch.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/units.h"
#include "data/io/toml_node.h"
#include "tests/data_folder.h"
#include "tests/matrix_near.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

TendonDigit five_axis_thumb() {
  return build_tendon_digit(
      read_subject(std::string(THENAR_DATA_DIR) + "/subjects/arms_five_axis_thumb.toml"), "thumb");
}

PinchLosses published() { return read_pinch_losses(kData + "/studies/key_pinch_blocks.toml"); }

const NerveBlock& block(const PinchLosses& losses, const std::string& nerve) {
  return *std::find_if(losses.blocks.begin(), losses.blocks.end(),
                       [&](const NerveBlock& one) { return one.nerve == nerve; });
}

// Ulnar 77 %, median 60 %, both 85 % [Kozin1999]; radial 33 % [RadialBlock].
TEST(KeyPinch, LossesAreThePublishedOnes) {
  const PinchLosses losses = published();
  ASSERT_EQ(losses.blocks.size(), 4u);
  EXPECT_EQ(block(losses, "ulnar").loss, 0.77);
  EXPECT_EQ(block(losses, "median").loss, 0.60);
  EXPECT_EQ(block(losses, "ulnar and median").loss, 0.85);
  EXPECT_EQ(block(losses, "radial").loss, 0.33);
  EXPECT_NEAR(losses.posture.angles.at("IP1"), 30 * kDegree, 1e-15);
  EXPECT_NEAR(losses.tolerance, 20 * kDegree, 1e-15);
  for (const NerveBlock& one : losses.blocks) {
    EXPECT_EQ(one.assumed.front(), "sd") << one.nerve;
    EXPECT_NE(one.source.find(one.nerve == "radial" ? "RadialBlock" : "Kozin1999"),
              std::string::npos);
  }
}

/// A digit of one hinge about z with the tip 40 mm away along -x, palmar -y: one flexor of 10 mm
/// and 100 N, and an extensor.
TendonDigit hinge() {
  return build_tendon_digit(parse_subject(R"(
name = "hinge"
side = "right"
base = "A"
source = "Own"
[sources]
Own = "Made up"
[[segment]]
name = "A"
[[segment]]
name = "B"
[[joint]]
name = "J"
parent = "A"
child = "B"
direction = [0, 0, 1]
point_mm = [0, 0, 0]
[[strand]]
name = "F"
arms_mm = {J = 10}
[[strand]]
name = "E"
arms_mm = {J = -5}
[[muscle]]
name = "F"
max_force_N = 100
[[muscle]]
name = "E"
max_force_N = 50
[[digit]]
name = "thumb"
tip_segment = "B"
tip_mm = [-40, 0, 0]
proximal = [1, 0, 0]
dorsal = [0, 1, 0]
)",
                                          "hinge"),
                            "thumb");
}

/// A pinch of that digit, straight.
PinchLosses pinch_of_hinge(const std::map<std::string, double>& left) {
  PinchLosses losses;
  losses.digit = "thumb";
  losses.posture = {"straight", {}};
  losses.blocks = {{"flexor's", left, 0.5, 0.1, "", {}}};
  return losses;
}

// 100 N at 10 mm are 1 N m: 25 N at a tip 40 mm away; a flexor at a quarter gives a quarter.
TEST(KeyPinch, IsTorqueOverLeverByHand) {
  // The tip goes towards palmar as the hinge turns by +: J = z x (-40 mm, 0, 0) = (0, -40 mm, 0).
  const PinchStrength pinch = measure_pinch(hinge(), pinch_of_hinge({{"F", 0.25}}));
  EXPECT_NEAR(pinch.intact, 25, 1e-9);
  ASSERT_EQ(pinch.loss.size(), 1);
  EXPECT_NEAR(pinch.loss[0], 0.75, 1e-9);
  EXPECT_NEAR(measure_pinch(hinge(), pinch_of_hinge({{"F", 0}})).loss[0], 1, 1e-9);
  EXPECT_NEAR(measure_pinch(hinge(), pinch_of_hinge({{"E", 0}})).loss[0], 0, 1e-9);
}

TEST(KeyPinch, OfAThumbThatCannotPressNothingIsLost) {
  TendonDigit digit = hinge();
  digit.max_tension[0] = 0;
  const PinchStrength pinch = measure_pinch(digit, pinch_of_hinge({{"E", 0}}));
  EXPECT_LT(pinch.intact, kMinPinchForce);
  EXPECT_TRUE(std::isnan(pinch.loss[0]));
}

// A straight finger carries any force along itself: no number is the largest one, and nothing is
// known of what is lost of it.
TEST(KeyPinch, UnboundedPinchIsUndecidedAndCounted) {
  PinchLosses losses = pinch_of_hinge({{"E", 0}});
  losses.direction = {-1, 0, 0};
  const PinchStrength pinch = measure_pinch(hinge(), losses);
  EXPECT_TRUE(std::isnan(pinch.intact));
  EXPECT_TRUE(std::isnan(pinch.loss[0]));
  EXPECT_EQ(pinch.undecided, 1);
  EXPECT_EQ(measure_pinch(hinge(), pinch_of_hinge({{"E", 0}})).undecided, 0);
}

TEST(KeyPinch, NamesAMuscleThatIsNotThere) {
  EXPECT_EQ(message_of<InputError>([] {
              (void)measure_pinch(hinge(), pinch_of_hinge({{"ADP", 0}}));
            }),
            "the block of the flexor's nerve weakens 'ADP', which the digit has not");
}

// What does not fit the digit is named where it stands in the file.
TEST(KeyPinch, RefusesJointsAndDigitsThatAreNotThere) {
  PinchLosses losses = pinch_of_hinge({{"E", 0}});
  losses.posture.angles = {{"K", 0.1}};
  const auto told = [&] { (void)measure_pinch(hinge(), losses); };
  EXPECT_EQ(message_of<InputError>(told), "no joint 'K' to pose; there are J");
  losses.path = "pinch.toml";
  losses.of_pinch = 22;
  EXPECT_EQ(message_of<DataError>(told), "pinch.toml:22: no joint 'K' to pose; there are J");
  losses.digit = "index";
  losses.line = 1;
  EXPECT_EQ(message_of<DataError>(told),
            "pinch.toml:1: losses of pinch are of the index, but the digit built is the thumb");
  // Lines are those of the file.
  const std::string text = read_text_file(kData + "/studies/key_pinch_blocks.toml");
  const auto line_of = [&](const char* what) {
    return 1 + std::count(text.begin(), text.begin() + text.find(what), '\n');
  };
  EXPECT_EQ(published().of_pinch, line_of("\n[pinch]") + 1);
  EXPECT_EQ(block(published(), "ulnar").line, line_of("\n[[block]]") + 1);
}

// The shipped thumb presses, and what both blocks take is no less than what either does.
TEST(KeyPinch, BothBlocksTakeNoLessThanEither) {
  const PinchLosses losses = published();
  const PinchStrength pinch = measure_pinch(five_axis_thumb(), losses);
  EXPECT_GT(pinch.intact, kMinPinchForce);
  EXPECT_GE(pinch.loss[2], pinch.loss[0] - 1e-9);
  EXPECT_GE(pinch.loss[2], pinch.loss[1] - 1e-9);
  EXPECT_TRUE((pinch.loss.array() >= 0).all() && (pinch.loss.array() <= 1).all());
}

// Axes, arms and Jacobian by hand in numpy, the cone as 1440 planes, solved by
// scipy.optimize.linprog (HiGHS), the shipped thumb. In the published pinch the ulnar block takes
// all while the MCP joint is abducted by 0 to 6 deg, and 0.43, 0.15 and 0.11 at 7, 8 and 10: a
// cliff.
TEST(KeyPinch, LossesAreThoseOfAnIndependentProgram) {
  struct Posture {
    double cmc_abduction, mcp_flexion, mcp_abduction, ip;  // [deg]
    double intact;                                         // [N]
    Eigen::Vector4d loss;                                  // ulnar, median, both, radial [1]
  };
  for (const Posture& of : {Posture{-10, 20, 0, 30, 50.3365, {1, 0, 1, 0}},
                            Posture{-10, 20, 5, 30, 50.3365, {1, 0, 1, 0}},
                            Posture{-10, 20, 7, 30, 50.3365, {0.4337, 0, 1, 0}},
                            Posture{-10, 20, 10, 30, 50.3365, {0.1095, 0, 0.2743, 0}},
                            Posture{0, 0, 10, 0, 34.5809, {0.6382, 0.4725, 1, 0.3561}}}) {
    PinchLosses losses = published();
    losses.posture.angles = {{"CMC1_AA", of.cmc_abduction * kDegree},
                             {"MCP1_FE", of.mcp_flexion * kDegree},
                             {"MCP1_AA", of.mcp_abduction * kDegree},
                             {"IP1", of.ip * kDegree}};
    const PinchStrength pinch = measure_pinch(five_axis_thumb(), losses);
    EXPECT_NEAR(pinch.intact, of.intact, 1e-3);
    EXPECT_TRUE(matrix_near(pinch.loss, of.loss, 1e-4));
  }
}

TEST(KeyPinch, FilesAreChecked) {
  std::string text = read_text_file(kData + "/studies/key_pinch_blocks.toml");
  text.replace(text.find("loss = 0.77"), 11, "loss = 7.70");
  EXPECT_THROW((void)parse_pinch_losses(text, "text"), DataError);
  EXPECT_THROW((void)parse_pinch_losses("name = \"x\"\ndigit = \"thumb\"\n", "text"), DataError);
}

}  // namespace
}  // namespace thenar
