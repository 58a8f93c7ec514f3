// Tests for report/answers/tendon_solve.cpp.

#include "report/answers/tendon_solve.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace thenar {
namespace {

TendonRequest netted_finger() {
  TendonRequest request;
  request.digit.subject = THENAR_DATA_DIR "/subjects/synek2019_middle.toml";
  request.digit.net = "chao_an";
  request.digit.posture.named = {{"PIP3", 0.5}};
  request.tension = {{"EDC", 2.9}, {"LU", 0.4}};
  return request;
}

TEST(TendonAnswer, HasUnitsAndNames) {
  const TendonSolveResult solution = solve_tendons(netted_finger());
  const OrderedJson json = json_of(solution);
  EXPECT_EQ(json["net"], "chao_an");
  EXPECT_EQ(json["tension_N"]["EDC"], 2.9);
  EXPECT_NEAR(json["posture_deg"]["PIP3"].get<double>(), 0.5 * 180 / M_PI, 1e-12);
  EXPECT_EQ(tensions_in_words(solution.loaded), "EDC=2.9 LU=0.4");
  // Radial and ulnar bands feed the terminal slip of Chao and An.
  const auto slip = [&](const char* name) { return json["slips_N"][name].get<double>(); };
  EXPECT_NEAR(slip("radial") + slip("ulnar"), slip("terminal"), 1e-6);
}

// 1 N mm is 1e-3 N m.
TEST(TendonAnswer, GivesTorquesInNewtonMillimetres) {
  TendonSolveResult solution = solve_tendons(netted_finger());
  solution.point.pull.tau.setConstant(0.25);
  const OrderedJson json = json_of(solution);
  for (const auto& torque : json["torque_N_mm"]) EXPECT_NEAR(torque.get<double>(), 250, 1e-9);
}

TEST(TendonAnswer, SaysZeroOfASlackBand) {
  TendonSolveResult solution = solve_tendons(netted_finger());
  solution.point.rest.tension.setConstant(2.1e-12);
  solution.point.pull.slips = {2.1e-12, 0, 0, 1};
  const std::string text = text_of(solution);
  EXPECT_EQ(text.find("e-12"), std::string::npos);
  EXPECT_NE(text.find("slack"), std::string::npos);
  EXPECT_TRUE(json_of(solution)["terminal_to_central"].is_null());  // nothing to divide by
  // So does the warning of slips that no publication knows.
  const std::vector<std::string> told = tendon_warnings(solution.loaded, solution.point);
  EXPECT_TRUE(std::any_of(told.begin(), told.end(), [](const std::string& caution) {
    return caution.find("terminal slip 1 N, central slip 0 N;") != std::string::npos;
  }));
}

TEST(TendonAnswer, RefusesTendonsThatAreNotToBeTrusted) {
  TendonSolveResult solution = solve_tendons(netted_finger());
  EXPECT_EQ(refusal_of(solution), "");
  solution.point.pull.status = TendonStatus::kUnbalanced;
  solution.point.pull.warning = "too far";
  EXPECT_EQ(refusal_of(solution), "the tendons are not to be trusted here (unbalanced): too far");
}

// A row a posture, a cell a column, and the same columns as members of the JSON.
TEST(TendonAnswer, HasOneTableForAllForms) {
  TendonRequest request = netted_finger();
  request.digit.vary = {{"PIP3", 0, 0.2, 0.1}};
  const TendonSweepResult sweep = sweep_tendons(request);
  const Table table = table_of(sweep);
  ASSERT_EQ(table.rows.size(), 3U);
  const OrderedJson json = json_of(sweep);
  for (const std::string& column : table.header) {
    ASSERT_TRUE(json.contains(column)) << column;
    EXPECT_EQ(json[column].size(), 3U);
  }
  for (const std::vector<std::string>& row : table.rows) EXPECT_EQ(row.size(), table.header.size());
  EXPECT_EQ(table_of(solve_tendons(netted_finger())).header, table.header);
  EXPECT_NE(text_of(sweep).find("3 postures, from PIP3=0"), std::string::npos) << text_of(sweep);
}

TEST(TendonAnswer, WarnsOfAStraightFinger) {
  TipForce tip;
  tip.rank = 3;
  tip.condition = 1;
  EXPECT_EQ(tip_note(tip), "");
  tip.condition = 1e6;
  EXPECT_NE(tip_note(tip).find("nearly singular posture"), std::string::npos);
}

}  // namespace
}  // namespace thenar
