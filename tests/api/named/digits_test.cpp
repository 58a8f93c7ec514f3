// Tests for api/named/digits.cpp.

#include "api/named/digits.h"

#include <gtest/gtest.h>

#include "base/file_io.h"
#include "base/lists.h"
#include "data/io/toml_node.h"
#include "tendons/forces/tip_force.h"
#include "tests/data_folder.h"
#include "tests/matrix_near.h"
#include "tests/message_of.h"
#include "tests/temporary_folder.h"

namespace thenar {
namespace {

DigitRequest middle_finger() {
  DigitRequest request;
  request.subject = kData + "/subjects/synek2019_middle.toml";
  return request;
}

TEST(BuildDigit, FindsASubjectByItsName) {
  DigitRequest request;
  request.subject = "synek2019_middle";
  request.data = kData;
  EXPECT_EQ(build_digit(request, Hood::kFractions).digit, "middle");
}

TEST(BuildDigit, SaysWhatAnotherNameStandsFor) {
  DigitRequest request;
  request.subject = "barrett";
  request.data = kData;
  EXPECT_EQ(message_of([&] { (void)build_digit(request, Hood::kFractions); }),
            "there is no subject 'barrett'; it is a hand");
}

TEST(BuildDigit, BuildsANetWhereOneIsNamed) {
  DigitRequest request = middle_finger();
  EXPECT_EQ(build_digit(request, Hood::kFractions).net, nullptr);
  request.net = "winslow";
  const DigitCase at = build_digit(request, Hood::kFractions);
  ASSERT_NE(at.net, nullptr);
  EXPECT_EQ(at.sources.back().path, "built-in winslow.toml");
  request.hood = Hood::kSeparate;
  EXPECT_THROW((void)build_digit(request, Hood::kFractions), InputError);
}

// From its exit a muscle of a net runs straight to its origin, which is fixed, on any paths.
TEST(BuildDigit, WarnsOfOriginsThatDoNotRideUnderANet) {
  const std::string told = "LU1: its origin rides on FDP2 only without a net";
  DigitRequest request;
  request.subject = "mirakhorlo2016";
  request.digit = "index";
  request.data = kData;
  EXPECT_FALSE(contains(build_digit(request, Hood::kSeparate).warnings, told));
  request.net = "winslow";
  EXPECT_TRUE(contains(build_digit(request, Hood::kSeparate).warnings, told));
  request.path = Path::kViaPoint;
  EXPECT_FALSE(contains(build_digit(request, Hood::kSeparate).warnings, told));
}

TEST(BuildDigit, KeepsTheRungThatTheSubjectChose) {
  DigitRequest request;
  request.subject = "mirakhorlo2016";
  request.digit = "index";
  request.data = kData;
  EXPECT_EQ(build_digit(request, Hood::kFractions).rungs.path, Path::kWrapped);
  request.path = Path::kViaPoint;
  EXPECT_EQ(build_digit(request, Hood::kFractions).rungs.path, Path::kViaPoint);
  EXPECT_EQ(build_digit(middle_finger(), Hood::kFractions).rungs.path, Path::kViaPoint);
}

using DigitFile = TemporaryFolder;

// A point of the extensor inside the knuckle's cylinder: no path, and no other in its place.
TEST_F(DigitFile, RefusesPathsThatCannotWrapAndNamesOthers) {
  std::string text = read_text_file(kData + "/subjects/mirakhorlo2016.toml");
  const std::string radius = "radius_mm = 12.53";
  text.replace(text.find(radius), radius.size(), "radius_mm = 20");
  write_file(path("thick.toml"), text);
  DigitRequest request;
  request.subject = path("thick.toml");
  request.digit = "index";
  const std::string refusal = message_of([&] { (void)build_digit(request, Hood::kFractions); });
  EXPECT_NE(refusal.find("MCP2_head"), std::string::npos) << refusal;
  EXPECT_NE(refusal.find("straight ones, 'via', leave them out"), std::string::npos) << refusal;
  request.path = Path::kViaPoint;
  EXPECT_EQ(build_digit(request, Hood::kFractions).rungs.path, Path::kViaPoint);
}

TEST(BuildDigit, HasNoPathsInAMapButStraightOnes) {
  DigitRequest request;
  request.subject = "valero_cuevas_index";
  request.data = kData;
  request.path = Path::kViaPoint;
  EXPECT_FALSE(build_digit(request, Hood::kFractions).map.empty());
  request.path = Path::kWrapped;
  EXPECT_THROW((void)build_digit(request, Hood::kFractions), InputError);
}

// Torque of the tendons and of the tip's force are the two sides of one balance:  J' f + left = R'
// t.
TEST(DigitAt, BalancesTorques) {
  DigitRequest request = middle_finger();
  request.posture.in_order = {0, 0.5, 0.7, 0.3};
  const DigitCase digit = build_digit(request, Hood::kSeparate);
  const DigitAtPosture at = digit_at(digit, digit.grid.postures.front());
  const Eigen::VectorXd t = tensions(digit, {{at.statics.muscles.front(), 10}});
  const TipForce tip = tip_force(at.statics, t);
  const Eigen::VectorXd torque = at.statics.R.transpose() * t + at.statics.tau_0;
  EXPECT_TRUE(matrix_near(at.statics.J.transpose() * tip.f_W + tip.tau_residual, torque, 1e-12));
}

TEST(Tensions, RefusesAPushAndGuessesANames) {
  const DigitCase digit = build_digit(middle_finger(), Hood::kSeparate);
  EXPECT_NE(message_of([&] {
              (void)tensions(digit, {{"FDP", -1}});
            }).find("tension >= 0"),
            std::string::npos);
  EXPECT_NE(message_of([&] {
              (void)tensions(digit, {{"FPD", 1}});
            }).find("no muscle 'FPD', did you mean 'FDP'?"),
            std::string::npos);
}

TEST(Tensions, RefuseAMuscleThatCrossesNoFreeJoint) {
  DigitCase digit = build_digit(middle_finger(), Hood::kSeparate);
  digit.subject.muscles.push_back(digit.subject.muscles.front());
  digit.subject.muscles.back().name = "FPL";
  EXPECT_EQ(message_of([&] {
              (void)tensions(digit, {{"FPL", 1}});
            }),
            "'FPL' crosses no free joint of the digit");
}

TEST(NetMeant, FollowsTheHood) {
  EXPECT_EQ(requested_net(Hood::kFloatingNet, ""), "extensor_hood");
  EXPECT_EQ(requested_net(Hood::kFractions, ""), "");
  EXPECT_EQ(requested_net(std::nullopt, "chao_an"), "chao_an");
  EXPECT_THROW((void)requested_net(Hood::kSeparate, "chao_an"), InputError);
}

TEST(NetSource, GuessesAName) {
  EXPECT_NE(message_of([] { (void)net_source("winslo"); }).find("did you mean 'winslow'?"),
            std::string::npos);
}

}  // namespace
}  // namespace thenar
