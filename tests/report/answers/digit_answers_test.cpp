// Tests for report/answers/{digit_words,tip_force,moment_arms,feasible_force,pose}.cpp.

#include <algorithm>
#include <limits>

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
            "per degree of joint rotation [N/deg]: b 2, a 0");
}

// A singular posture has no derivative, which is not the same as none.
TEST(DigitWords, SayThatAChangeIsUnknown) {
  const double infinite = std::numeric_limits<double>::infinity();
  EXPECT_EQ(change_line({"a", "b"}, Eigen::Vector2d(infinite, 2 / kDegree), "N"),
            "per degree of joint rotation [N/deg]: a unknown, b 2");
  EXPECT_EQ(change_line({"a", "b"}, Eigen::Vector2d::Constant(infinite), "N"),
            "per degree of joint rotation [N/deg]: a unknown, b unknown");
}

TEST(DigitWords, GiveAListOfPostures) {
  TipForceRequest request{middle_finger(), {{"FDP", 10}}};
  EXPECT_TRUE(json_of(compute_tip_force(request)).contains("posture_deg"));
  request.digit.vary = {{"PIP3", 10, 30, 10}};
  const TipForceResult answer = compute_tip_force(request);
  const OrderedJson json = json_of(answer);
  ASSERT_EQ(json["postures"].size(), 3u);
  EXPECT_DOUBLE_EQ(json["postures"][1]["posture_deg"]["PIP3"], 20);
  EXPECT_EQ(table_of(answer).rows.size(), 3u);
}

TEST(MomentArmWords, SayWhichSenseIsPositive) {
  EXPECT_EQ(sign_words({"MCP3_FE", "MCP3_AA", "PIP3"}),
            "flexion positive at MCP3_FE, PIP3; abduction positive at MCP3_AA");
  const OrderedJson json = json_of(compute_moment_arms(middle_finger()));
  EXPECT_FALSE(json["arms_mm"]["FDS"].contains("DIP3"));
  EXPECT_GT(json["arms_mm"]["FDP"]["DIP3"], 0);
}

// What the sentence says is what the table says.
TEST(FeasibleForceWords, SayWhatLimits) {
  FeasibleForceRequest request;
  request.digit = middle_finger();
  request.direction = Eigen::Vector3d(0, -1, 0);
  request.frame = DirectionFrame::kTip;
  const FeasibleForceResult answer = compute_feasible_force(request);
  const OrderedJson json = json_of(answer);
  ASSERT_FALSE(json["limited_by"].empty());
  const std::string dearest = json["limited_by"][0]["muscle"];
  EXPECT_EQ(limit_words(answer, answer.points.front()).rfind("limited by " + dearest, 0), 0u);
  const Table table = limit_table(answer, answer.points.front());
  EXPECT_EQ(table.header.back(), "N_per_N_of_F0");
}

TEST(FeasibleForceWords, TellWhatAParalysisCosts) {
  FeasibleForceRequest request;
  request.digit = middle_finger();
  request.direction = Eigen::Vector3d(0, -1, 0);
  request.frame = DirectionFrame::kTip;
  request.without = {"FDP"};  // the only flexor of DIP
  const FeasibleForceResult answer = compute_feasible_force(request);
  EXPECT_NE(text_of(answer).find("Without FDP: 100.0 % of 33.760 N (all muscles)"), std::string::npos);
  const OrderedJson json = json_of(answer);
  EXPECT_EQ(json["without"][0], "FDP");
  EXPECT_DOUBLE_EQ(json["paralysis"]["loss"], 1);
  EXPECT_EQ(table_of(answer).rows[0].size(), table_of(answer).header.size());
  request.weakened = {{"FDS", 12.5}};
  EXPECT_EQ(weak_words(compute_feasible_force(request)), "Without FDP, with 12.5 N of FDS");
}

// A published map has no joints whose balance could forbid a force.
TEST(FeasibleForceWords, AMapIsNotExplainedByJoints) {
  FeasibleForceRequest request;
  request.digit.subject = "valero_cuevas_index";
  request.digit.data = kData;
  request.digit.map = "cadaver_hand4";
  request.direction = Eigen::Vector3d(0, 0, 1);
  request.without = {"FDP", "FDS"};
  const std::string text = text_of(compute_feasible_force(request));
  EXPECT_NE(text.find("no combination of tensions produces a force in this direction by this map"),
            std::string::npos);
  EXPECT_EQ(text.find("joint"), std::string::npos);
}

FeasibleForceResult palmar_forces_over_pip() {
  FeasibleForceRequest request;
  request.digit.subject = "an_chao_index";
  request.digit.data = kData;
  request.digit.posture = {{{"MCP2_FE", 30}, {"DIP2", 20}}, {}, PostureUnit::kTyped};
  request.digit.passive = PassiveMoments::kOff;
  request.digit.vary = {{"PIP2", 0, 60, 30}};
  request.direction = Eigen::Vector3d(0, -1, 0);
  request.frame = DirectionFrame::kTip;
  return compute_feasible_force(request);
}

// One number, one unit: a moment is in N m wherever it stands, and the force beside it in N.
TEST(FeasibleForceWords, MomentsAreInNewtonMetres) {
  FeasibleForceRequest request;
  request.digit = middle_finger();
  request.load = TipLoad::kMoment;
  request.direction = Eigen::Vector3d(0, 0, 1);
  request.frame = DirectionFrame::kTip;
  request.max_other = 5;
  const FeasibleForceResult answer = compute_feasible_force(request);
  const OrderedJson json = json_of(answer);
  for (const char* key : {"moment_Nm", "component_Nm", "force_N", "most_forces_N"})
    EXPECT_TRUE(json.contains(key)) << key;
  EXPECT_FALSE(json.contains("component_N"));
  EXPECT_TRUE(json["certificate"].contains("gap_Nm"));
  EXPECT_NEAR(json["moment_Nm"][2], json["component_Nm"], 1e-9);
  EXPECT_EQ(limit_table(answer, answer.points.front()).header.back(), "Nm_per_N_of_F0");
  EXPECT_NE(text_of(answer).find("N m along the direction"), std::string::npos);
  EXPECT_NE(text_of(answer).find("forces of at most 5 N along each axis"), std::string::npos);
}

// Straight at PIP no tensions press to the palm alone, see the tutorial; bent they do. A zero would
// be drawn as a force.
TEST(FeasibleForceWords, NoForceIsNoZero) {
  const FeasibleForceResult answer = palmar_forces_over_pip();
  ASSERT_EQ(answer.points.size(), 3U);
  EXPECT_FALSE(makes_force(answer.points[0]));
  EXPECT_TRUE(makes_force(answer.points[1]));
  const OrderedJson json = json_of(answer)["postures"];
  EXPECT_EQ(json[0]["status"], "no force");
  EXPECT_TRUE(json[0]["component_N"].is_null());
  EXPECT_TRUE(json[0]["tension_N"].is_null());
  EXPECT_EQ(json[0]["note"],
            "no combination of tensions produces a force in this direction with every "
            "joint in equilibrium");
  EXPECT_EQ(json[1]["status"], "solved");
  const Table table = table_of(answer);
  const auto cell = [&](std::size_t row, const std::string& name) {
    const auto at = std::find(table.header.begin(), table.header.end(), name);
    return table.rows[row].at(static_cast<std::size_t>(at - table.header.begin()));
  };
  EXPECT_EQ(cell(0, "component_N"), "");
  EXPECT_EQ(cell(0, "FDP_activation"), "");
  EXPECT_EQ(cell(0, "limited_by"), "");
  EXPECT_EQ(cell(1, "limited_by"), "FDP");
  EXPECT_GT(std::stod(cell(1, "component_N")), 30);
}

// EDC and EIP of this finger pull the same strand.
TEST(FeasibleForceWords, NameMusclesOfWhichOnlyTheSumIsTold) {
  const FeasibleForceResult answer = palmar_forces_over_pip();
  const FeasibleForcePoint& point = answer.points[1];
  ASSERT_EQ(point.alike.size(), 1U);
  std::vector<std::string> names;
  double pulled = 0;
  for (const int i : point.alike[0]) {
    names.push_back(answer.muscles[static_cast<std::size_t>(i)]);
    pulled += point.largest->tension[i];
  }
  std::sort(names.begin(), names.end());
  EXPECT_EQ(names, (std::vector<std::string>{"EDC", "EIP"}));
  EXPECT_EQ(note_of(answer, point).find("have the same moment arms") != std::string::npos,
            pulled > kNoTipForce);
}

TEST(PoseWords, TellOfEveryTip) {
  PoseRequest request;
  request.model = "synek2019_middle";
  request.data = kData;
  request.posture.unit = PostureUnit::kTyped;
  request.vary = {{"PIP3", 0, 20, 10}};
  const auto poses = std::get<SubjectPoses>(compute_poses(request));
  EXPECT_EQ(table_of(poses).rows.size(), 3u);
  EXPECT_EQ(json_of(poses)["postures"].size(), 3u);
  EXPECT_NE(text_of(poses).find("middle_x_mm"), std::string::npos);
}

}  // namespace
}  // namespace thenar
