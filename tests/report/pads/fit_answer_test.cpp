// Tests for report/pads/fit_answer.cpp and fit_page.cpp.

#include "report/pads/fit_answer.h"

#include <fstream>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "report/page.h"
#include "tests/api/pads/small_presses.h"
#include "tests/temporary_folder.h"

namespace thenar {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// Estimates and curves as they might be: the words need no fit.
class FitAnswer : public TemporaryFolder {
 protected:
  FitAnswer() {
    std::ofstream(path("presses.toml"))
        << sample::kPressesHead << sample::press_text({1, 2, 3}, {50, 90});
    fitted.data = read_pad_data(path("presses.toml"));
    fitted.pad.spec = fitted.spec = parse_pad(sample::pad_text(20, 0.7), "pad.toml");
    fitted.problem = pad_fit_problem(fitted.data, fitted.spec);
    fitted.problem.constants[1].prior_factor = 2;
    fitted.fit.solution.status = Status::kSolved;
    fitted.fit.solution.evaluations = 7;
    fitted.fit.estimates.resize(2);
    fitted.fit.estimates[0] = {8e3, std::log(1.1), std::log(1.2), true, false, 0.1};
    fitted.fit.estimates[1] = {1.5,   std::log(2.0), std::numeric_limits<double>::infinity(),
                               false, true,          0};
    fitted.fit.correlations = Eigen::Matrix2d{{1, -0.5}, {-0.5, 1}};
    fitted.fit.predictions = {
        {{1.05e-3, {}}, {1.9e-3, 2e-3}, {3e-3, {}}, {45e-6, {}}, {90e-6, {}}}};
    fitted.fit.misfit = 2.5;
    fitted.fit.degrees_of_freedom = 4;
    fitted.curves = {
        {{0.2, 0.6, 1, 3},
         {{1.05e-3, 0.2, 30e-6}, {1.9e-3, 0.6, 45e-6}, {2e-3, 1, 50e-6}, {3e-3, 3, 90e-6}}}};
    fitted.outcome.warnings = {"a doubt"};
  }
  FittedPad fitted;
};

TEST_F(FitAnswer, TellsConstantsAndWhoKnowsThem) {
  EXPECT_EQ(title_of(fitted), "pad fitted to 'Two presses': 2 constants, 5 data");
  EXPECT_EQ(conditions_of(fitted),
            "search converged after 7 evaluations; misfit 2.5 with 4 degrees of freedom");
  const Table table = table_of(fitted);
  ASSERT_EQ(table.rows.size(), 2U);
  EXPECT_THAT(table.rows[0], ElementsAre("pulp: shear modulus", "kPa", "20", "8", "1.1", "1.2", "-",
                                         "data", "1.105"));
  EXPECT_THAT(table.rows[1], ElementsAre("pulp: exponent", "-", "0.7", "1.5", "2", "any", "2",
                                         "prior, at a bound", "1"));
  fitted.problem.constants[1].prior_factor.reset();
  EXPECT_EQ(table_of(fitted).rows[1][7], "nothing, at a bound");
  fitted.fit.predictions[0][1].finer.reset();  // nothing was pressed on finer cells
  EXPECT_EQ(table_of(fitted).rows[0][8], "-");
  EXPECT_TRUE(json_of(fitted)["constants"][0]["finer_cells_factor"].is_null());
}

TEST_F(FitAnswer, TellsDataInSdsOfTheirOwn) {
  const Table table = data_table(fitted);
  ASSERT_EQ(table.rows.size(), 5U);
  EXPECT_THAT(table.rows[1], ElementsAre("flat", "0.6 N", "indentation", "mm", "2", "0.1", "1.9",
                                         "-1.00", "2", "Own"));
  EXPECT_THAT(table.rows[3],
              ElementsAre("flat", "0.6 N", "area", "mm2", "50", "2.5", "45", "-2.00", "-", "Own"));
  for (const auto& row : table.rows) EXPECT_EQ(row.size(), table.header.size());
}

TEST_F(FitAnswer, JsonHasNullForWhatIsInfinite) {
  const OrderedJson json = json_of(fitted);
  EXPECT_EQ(json["search"], "converged");
  EXPECT_NEAR(json["constants"][0]["sd_factor"].get<double>(), 1.1, 1e-12);
  EXPECT_TRUE(json["constants"][1]["sd_factor_by_data"].is_null());
  EXPECT_NEAR(json["data"][4]["measured"].get<double>(), 90, 1e-9);
  EXPECT_TRUE(json["data"][0]["finer_cells"].is_null());
  EXPECT_EQ(json["correlations"][0][1], -0.5);
  EXPECT_EQ(json["curves"][0]["points"].size(), 4U);
  EXPECT_EQ(json["sources"]["Own"], "Own measurement");
  const std::string text = text_of(fitted);
  for (const char* word : {"Constants", "Data", "Correlations", "sd_factor_by_data"})
    EXPECT_THAT(text, HasSubstr(word));
}

TEST_F(FitAnswer, WhatMayHaveAnyValueHasNoCorrelations) {
  EXPECT_EQ(correlation_table(fitted).rows.size(), 2U);
  fitted.fit.estimates[1].sd = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(correlation_table(fitted).rows.empty());
  EXPECT_TRUE(json_of(fitted)["correlations"].is_null());
  EXPECT_EQ(page_of(fitted)["sections"].size(), 3U);
}

TEST_F(FitAnswer, PageDrawsDataOverTheCurve) {
  const Json page = page_of(fitted);
  std::vector<std::string> ids;
  for (const Json& part : page["sections"]) ids.push_back(part["id"]);
  EXPECT_THAT(ids, ElementsAre("constants", "data", "correlations", "sources"));
  const Json& charts = page["sections"][1]["blocks"][0]["blocks"];
  // Measured depths lie across, measured areas upright.
  EXPECT_EQ(charts[0]["series"][1]["x"], Json({1, 2, 3}));
  EXPECT_EQ(charts[0]["series"][1]["y"], Json({0.2, 0.6, 3}));
  EXPECT_NEAR(charts[0]["series"][2]["x"][1].get<double>(), 1.05, 1e-12);
  EXPECT_EQ(charts[1]["series"][1]["x"], Json({0.6, 3}));
  EXPECT_NEAR(charts[1]["series"][2]["y"][0].get<double>(), 47.5, 1e-12);
  EXPECT_TRUE(page["sections"][0]["blocks"][0]["ok"].get<bool>());
  EXPECT_THAT(report_page(page), HasSubstr("thenar-report"));
}

TEST_F(FitAnswer, APartIsDrawnOfWhatThePadHasThere) {
  PressDatum& datum = fitted.problem.records[0].data[0];
  datum.over = 2;
  datum.value = 0.5;
  datum.sd = 0.1;
  EXPECT_EQ(data_table(fitted).rows[0][1], "0.2 N over 3 N");
  const Json charts = page_of(fitted)["sections"][1]["blocks"][0]["blocks"];
  EXPECT_NEAR(charts[0]["series"][1]["x"][0].get<double>(), 1.5, 1e-12);  // half of 3 mm
}

TEST_F(FitAnswer, WhatWasStoppedOrRefusedIsTold) {
  fitted.fit.solution.status = Status::kStalled;
  EXPECT_FALSE(page_of(fitted)["sections"][0]["blocks"][0]["ok"].get<bool>());
  FittedPad stopped;
  stopped.data = fitted.data;
  stopped.problem = fitted.problem;
  stopped.fit.solution.status = stopped.outcome.status = Status::kStopped;
  EXPECT_THAT(text_of(stopped), HasSubstr("stopped before there was an estimate"));
  EXPECT_EQ(page_of(stopped)["sections"].size(), 1U);
  EXPECT_TRUE(json_of(stopped)["constants"].empty());
}

}  // namespace
}  // namespace thenar
