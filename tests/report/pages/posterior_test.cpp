// Tests for report/pages/posterior.cpp, posterior_charts.cpp, mode_table.cpp, predictive_block.cpp.

#include "report/pages/posterior.h"

#include <cstdio>
#include <limits>

#include <gtest/gtest.h>

#include "base/error.h"
#include "report/page.h"
#include "tests/report/quantity_samples.h"

namespace thenar {
namespace {

using sample::quantity;

TEST(ConvergenceBanner, CannotBeOverlookedIfChainsDisagree) {
  Convergence convergence;
  convergence.warnings = {"R-hat of a is 1.2, wanted at most 1.01"};
  const Json banner = convergence_banner(convergence, "nuts, 4 chains");
  EXPECT_EQ(banner["ok"], false);
  EXPECT_EQ(banner["title"], "This run has NOT converged");
  EXPECT_EQ(banner["reasons"][0], convergence.warnings[0]);
}

TEST(ConvergenceBanner, IsQuietIfTheyAgree) {
  Convergence convergence;
  convergence.worst_r_hat = 1.0042;
  const Json banner = convergence_banner(convergence, "");
  EXPECT_EQ(banner["ok"], true);
  EXPECT_NE(banner["text"].get<std::string>().find("1.0042"), std::string::npos);
}

TEST(ConvergenceBanner, IsYellowForAFewDivergentDraws) {
  Convergence convergence;
  convergence.cautions = {"2 of 4000 draws ended a divergent trajectory"};
  const Json banner = convergence_banner(convergence, "");
  EXPECT_EQ(banner["ok"], true);
  EXPECT_EQ(banner["caution"], true);
  EXPECT_EQ(banner["reasons"][0], convergence.cautions[0]);
}

/// One trial whose replicates are 0, 1 .. 100 in every component.
PredictedForces one_trial(const Eigen::Vector3d& measured) {
  PredictedForces predicted;
  predicted.what = "H01";
  Trial trial;
  trial.posture = "Hook";
  trial.tension = {{"EDC", 0.0}, {"FDP", 10.0}};
  trial.force = measured;
  predicted.experiment.trials = {trial};
  predicted.replicated = Eigen::RowVectorXd::LinSpaced(101, 0, 100).replicate(3, 1);
  return predicted;
}

TEST(PredictiveBlock, CountsWhatLiesWithin) {
  // 60 lies within 50 %, 90 within 95 %, 99 beyond.
  const Json block = predictive_block(one_trial({60, 90, 99}));
  const std::string caption = block["caption"];
  EXPECT_NE(caption.find("Of 3 components 1 lie within 50 %, 2 within 95 %"), std::string::npos)
      << caption;
  const Json& row = block["groups"][0]["rows"][0];
  EXPECT_EQ(row["name"], "FDP");
  EXPECT_EQ(row["values"][0]["low"], 2.5);
  EXPECT_EQ(row["values"][0]["inner_high"], 75);
}

TEST(PredictiveBlock, GathersTrialsByPosture) {
  PredictedForces predicted = one_trial({60, 90, 99});
  predicted.experiment.trials.resize(3, predicted.experiment.trials.front());
  predicted.experiment.trials[1].posture = "Straight";
  predicted.replicated = predicted.replicated.replicate(3, 1).eval();
  const Json groups = predictive_block(predicted)["groups"];
  ASSERT_EQ(groups.size(), 2U);
  EXPECT_EQ(groups[0]["name"], "Hook");
  EXPECT_EQ(groups[0]["rows"].size(), 2U);
}

TEST(PredictiveBlock, NamesComponentsAsTheExperimentTurnsThem) {
  PredictedForces predicted = one_trial({0, 0, 0});
  predicted.experiment.axes_of_digit << 0, -1, 0, 0, 0, 1, -1, 0, 0;
  EXPECT_EQ(predictive_block(predicted)["components"], Json({"palmar", "radial", "distal"}));
}

TEST(PredictiveBlock, RefusesForcesOfOtherTrials) {
  PredictedForces predicted = one_trial({0, 0, 0});
  predicted.replicated.conservativeResize(2, Eigen::NoChange);
  EXPECT_THROW((void)predictive_block(predicted), InputError);
}

TEST(ParetoChart, NamesWhatIsNotToBeTrusted) {
  LeftOutObservations left_out;
  left_out.result.good_k = 0.7;
  left_out.result.k = Eigen::Vector4d(0.2, 0.9, 0.7, std::numeric_limits<double>::quiet_NaN());
  left_out.observations = {"a", "b", "c", "d"};
  const Json series = pareto_chart(left_out)["series"];
  ASSERT_EQ(series.size(), 2U);
  EXPECT_EQ(series[0]["hints"], Json({"a", "c"}));
  EXPECT_EQ(series[1]["labels"], Json({"b", "d"}));
  left_out.observations.pop_back();
  EXPECT_THROW((void)pareto_chart(left_out), InputError);
}

// 99 draws: ranks 0 .. 99, one of each, are as uniform as can be; all ranks zero are not.
TEST(CalibrationChart, NamesTheCurvesThatLeaveTheBand) {
  CalibrationRanks calibration;
  calibration.names = {"even", "low"};
  calibration.draws = 99;
  calibration.rank = Eigen::MatrixXi::Zero(2, 100);
  calibration.rank.row(0) = Eigen::RowVectorXi::LinSpaced(100, 0, 99);
  const Json series = calibration_chart(calibration)["series"];
  ASSERT_EQ(series.size(), 3U);
  EXPECT_EQ(series[0]["name"], "95 % band");
  EXPECT_EQ(series[1]["name"], "within the band");
  EXPECT_EQ(series[1]["hints"][0], "even");
  EXPECT_EQ(series[2]["name"], "low");
  for (const Json& y : series[1]["y"]) EXPECT_NEAR(y.get<double>(), 0, 1e-12);
  // The first point counts all ranks below x: 1 - x.
  EXPECT_NEAR(series[2]["y"][0].get<double>(), 1 - series[2]["x"][0].get<double>(), 1e-3);
}

/// Two chains, each all its life in one mode.
ModeTable two_modes(Eigen::Index draws) {
  ModeTable table;
  table.of_draw = Eigen::MatrixXi::Zero(draws, 2);
  table.of_draw.col(1).setOnes();
  for (int m = 0; m < 2; ++m) {
    ModeMass mode;
    mode.mass = 0.5;
    mode.visits = Eigen::Vector2d::Unit(m);
    table.modes.push_back(mode);
  }
  return table;
}

TEST(ModeTable, TellsModesApartByWhatDiffersMost) {
  Quantity same = quantity("same", 0, 1, 1, {50, 2}), other = same;
  other.name = "other";
  other.draws.col(0).setConstant(-3);
  other.draws.col(1).setConstant(7);
  const Json table = mode_table(two_modes(50), {same, other}, 1);
  EXPECT_EQ(table["columns"].back()["name"], "other");
  EXPECT_EQ(table["rows"][0].back(), -3);
  EXPECT_EQ(table["rows"][1].back(), 7);
  EXPECT_EQ(table["rows"][1][1], 50);
  EXPECT_EQ(table["rows"][1][3], "0, 100");
}

TEST(ModeTable, RefusesQuantitiesOfOtherDraws) {
  EXPECT_THROW((void)mode_table(two_modes(50), {quantity("a", 0, 1, 1, {49, 2})}), InputError);
}

TEST(SamplerChart, HasOneLineEach) {
  const Json chart = sampler_chart({{"nuts", {1, 2}, {0.1, 0.05}}, {"dream-zs", {1}, {0.7}}});
  EXPECT_EQ(chart["series"].size(), 2U);
  EXPECT_EQ(chart["log_x"], true);
  EXPECT_EQ(chart["log_y"], true);
}

TEST(PosteriorSections, LeaveOutWhatIsNotThere) {
  PosteriorPicture picture;
  const Json sections = posterior_sections(picture);
  ASSERT_EQ(sections.size(), 1U);
  EXPECT_EQ(sections[0]["id"], "convergence");
  EXPECT_EQ(sections[0]["blocks"][0]["type"], "banner");
}

TEST(PosteriorSections, PutDoubtsBeforeTheirNumbers) {
  PosteriorPicture picture;
  picture.modes = two_modes(50);
  picture.modes->warnings = {"chains cross 0 times"};
  const Json section = posterior_sections(picture)[1];
  EXPECT_EQ(section["id"], "modes");
  EXPECT_EQ(section["blocks"][0]["type"], "banner");
  EXPECT_EQ(section["blocks"][1]["type"], "table");
}

TEST(PosteriorSections, AllSayThatTheRunHasNotConverged) {
  PosteriorPicture picture;
  picture.convergence.warnings = {"R-hat of a is 1.2, wanted at most 1.01"};
  picture.quantities = {quantity("a", 0, 1, 1.2), quantity("b", 0, 1, 1)};
  const Json sections = posterior_sections(picture);
  ASSERT_EQ(sections.size(), 2U);
  for (const Json& section : sections) {
    EXPECT_EQ(section["blocks"][0]["type"], "banner");
    EXPECT_EQ(section["blocks"][0]["title"], "This run has NOT converged");
  }
}

// A report of 60 quantities, 4 chains and 1000 draws is sent by mail; THENAR_PAGE keeps it.
TEST(PosteriorSections, AreOfASizeToBeSent) {
  PosteriorPicture picture;
  for (unsigned i = 0; i < 60; ++i)
    picture.quantities.push_back(
        quantity(fmt::format("axis/MCP3_FE/direction/{}", i), i, 0.3, 1.001, {1000, 4, i}));
  const Json report{{"title", "Posterior"}, {"sections", posterior_sections(picture)}};
  const std::string page = report_page(report);
  EXPECT_LT(page.size(), 5000000U);
  RecordProperty("bytes", static_cast<int>(page.size()));
  if (const char* path = std::getenv("THENAR_PAGE")) write_report(report, path);
}

}  // namespace
}  // namespace thenar
