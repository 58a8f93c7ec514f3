// Tests for report/pads/laws_answer.cpp and laws_page.cpp.

#include "report/pads/laws_answer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "report/page.h"
#include "tests/api/pads/small_presses.h"

namespace thenar {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// Two presses and laws as they might be: the words need no press.
PadLaws some_pad_laws() {
  PadLaws found;
  found.pad.spec = parse_pad(sample::pad_text(20, 0.7), "pad.toml");
  found.pad.path = "pad.toml";
  found.depths = {0.5e-3, 1e-3};
  found.press_s = 12.34;
  MeasuredPress press;
  press.trial = "ball of 5 mm";
  press.gap = {100, 100};
  press.depth = 1e-3;
  press.force = 0.5;
  press.area = 20e-6;
  press.arm = 1.5e-3;
  press.force_error = 0.03;
  press.shear = 2000;
  found.presses = {{true, press, LawForces{0.4, 0.45, 0.55, 21e-6, 1.4e-3}},
                   {false, press, LawForces{0.4, 0.45, 0.55, 21e-6, 1.4e-3}}};
  found.calibration.status = Status::kSolved;
  CalibratedLaws& laws = found.calibration.laws;
  laws.pad_digest = "ab";
  laws.evidence = {1, 1, 1e-3, 0.5, 0.03};
  laws.soft_finger_error.force = {0.1, 0.125};
  laws.bed_error.shear = {0.3, 0.5};
  laws.foundation.thickness = 5e-3;
  found.outcome.warnings = {"a doubt"};
  return found;
}

TEST(LawsAnswer, TellsErrorsInPercent) {
  const Table table = table_of(some_pad_laws());
  ASSERT_EQ(table.rows.size(), 8U);
  EXPECT_THAT(table.rows[2], ElementsAre("soft finger", "rms", "10.0", "0.0", "0.0", "0.0", "0.0"));
  EXPECT_THAT(table.rows[3],
              ElementsAre("soft finger", "worst", "12.5", "0.0", "0.0", "0.0", "0.0"));
  EXPECT_EQ(table.rows[7].back(), "50.0");
}

TEST(LawsAnswer, TellsWhatLawsSayOfEachPress) {
  const PadLaws found = some_pad_laws();
  const Table table = press_table(found);
  ASSERT_EQ(table.rows.size(), 2U);
  EXPECT_EQ(table.rows[0].size(), table.header.size());
  EXPECT_EQ(table.rows[0][1], "fit");
  EXPECT_EQ(table.rows[1][1], "check");
  EXPECT_EQ(table.rows[0][9], "0.4");
  const std::string text = text_of(found);
  EXPECT_THAT(text, testing::StartsWith("pad: laws fitted to presses (1), checked on others (1)\n"
                                        "pressed to 0.5, 1 mm; solved; presses 12.3 s"));
  EXPECT_THAT(text, HasSubstr("Errors at given depths"));
}

TEST(LawsAnswer, JsonHasErrorsConstantsAndPresses) {
  const OrderedJson json = json_of(some_pad_laws());
  EXPECT_EQ(json["status"], "solved");
  EXPECT_EQ(json["pad_digest"], "ab");
  EXPECT_EQ(json["errors"]["soft_finger"]["force"]["worst"], 0.125);
  EXPECT_EQ(json["laws"]["elastic_foundation"]["thickness_m"], 5e-3);
  EXPECT_EQ(json["presses"][1]["fitted"], false);
  EXPECT_DOUBLE_EQ(json["presses"][0]["shear_N_per_mm"], 2);
  EXPECT_EQ(json["warnings"][0], "a doubt");
}

TEST(LawsAnswer, WithoutLawsThereAreNoErrors) {
  PadLaws stopped = some_pad_laws();
  stopped.calibration = {};
  stopped.calibration.status = stopped.outcome.status = Status::kStopped;
  stopped.presses.resize(1);
  stopped.presses[0].laws.reset();
  EXPECT_TRUE(table_of(stopped).rows.empty());
  EXPECT_EQ(press_table(stopped).rows.at(0).back(), "-");
  EXPECT_TRUE(json_of(stopped)["errors"].is_null());
  EXPECT_THAT(text_of(stopped), HasSubstr("pad: no laws; presses of its elements"));
  EXPECT_THAT(report_page(page_of(stopped)), HasSubstr("The calibration was stopped"));
}

TEST(LawsAnswer, PageHasChartsOfForces) {
  const std::string html = report_page(page_of(some_pad_laws()));
  EXPECT_THAT(html, HasSubstr("force by law [N]"));
  EXPECT_THAT(html, HasSubstr("a doubt"));
}

}  // namespace
}  // namespace thenar
