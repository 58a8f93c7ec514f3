// Tests for report/answers/{digit_words,tip_force,moment_arms,feasible_force,pose}.cpp.

#include <gtest/gtest.h>

#include "base/units.h"
#include "report/answers/digit_words.h"
#include "report/answers/feasible_force.h"
#include "report/answers/moment_arms.h"
#include "report/answers/pose.h"
#include "report/answers/tip_force.h"
#include "tests/data_folder.h"

namespace thenar {
namespace {

DigitRequest middle_finger() {
  DigitRequest request;
  request.subject = "synek2019_middle";
  request.data = kData;
  request.posture = {{{"MCP3_FE", 20}, {"PIP3", 30}, {"DIP3", 15}}, {}, PostureUnit::kTyped};
  return request;
}

TEST(DigitWords, ShowNoRoundingAsAChange) {
  EXPECT_EQ(change_line({"a", "b"}, Eigen::Vector2d(1e-14, 2) / kDegree),
            "N per degree of posture: b 2, a 0");
}

TEST(DigitWords, GiveAListOfPostures) {
  TipForceRequest request{middle_finger(), {{"FDP", 10}}};
  EXPECT_TRUE(json_of(ask_tip_force(request)).contains("posture_deg"));
  request.digit.vary = {{"PIP3", 10, 30, 10}};
  const TipForceAnswer answer = ask_tip_force(request);
  const OrderedJson json = json_of(answer);
  ASSERT_EQ(json["postures"].size(), 3u);
  EXPECT_DOUBLE_EQ(json["postures"][1]["posture_deg"]["PIP3"], 20);
  EXPECT_EQ(table_of(answer).rows.size(), 3u);
}

TEST(MomentArmWords, SayWhichSenseIsPositive) {
  EXPECT_EQ(sign_words({"MCP3_FE", "MCP3_AA", "PIP3"}),
            "flexion positive at MCP3_FE, PIP3; abduction positive at MCP3_AA");
  const OrderedJson json = json_of(ask_moment_arms(middle_finger()));
  EXPECT_FALSE(json["arms_mm"]["FDS"].contains("DIP3"));
  EXPECT_GT(json["arms_mm"]["FDP"]["DIP3"], 0);
}

// What the sentence says is what the table says.
TEST(FeasibleForceWords, SayWhatLimits) {
  FeasibleForceRequest request;
  request.digit = middle_finger();
  request.direction = Eigen::Vector3d(0, -1, 0);
  request.frame = DirectionFrame::kTip;
  const FeasibleForceAnswer answer = ask_feasible_force(request);
  const OrderedJson json = json_of(answer);
  ASSERT_FALSE(json["limited_by"].empty());
  const std::string dearest = json["limited_by"][0]["muscle"];
  EXPECT_EQ(limit_words(answer, answer.points.front()).rfind("limited by " + dearest, 0), 0u);
  const Table table = limit_table(answer, answer.points.front());
  EXPECT_EQ(table.header.back(), "N_per_N_of_F0");
}

TEST(PoseWords, TellOfEveryTip) {
  PoseRequest request;
  request.model = "synek2019_middle";
  request.data = kData;
  request.posture.unit = PostureUnit::kTyped;
  request.vary = {{"PIP3", 0, 20, 10}};
  const auto poses = std::get<SubjectPoses>(ask_pose(request));
  EXPECT_EQ(table_of(poses).rows.size(), 3u);
  EXPECT_EQ(json_of(poses)["postures"].size(), 3u);
  EXPECT_NE(text_of(poses).find("middle_x_mm"), std::string::npos);
}

}  // namespace
}  // namespace thenar
