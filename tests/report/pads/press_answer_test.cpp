// Tests for report/pads/press_answer.cpp and press_page.cpp.

#include "report/pads/press_answer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "report/page.h"
#include "tests/data_folder.h"

namespace thenar {
namespace {

using testing::HasSubstr;

/// Rough and quick.
const PressResult& pressed() {
  static const PressResult done = [] {
    PressRequest request;
    request.pad.pad = kData + "/pads/index_pad.toml";
    request.depth = 1e-3;
    request.rate = 0.1;
    request.hold = 1;
    request.points = 2;
    request.hold_points = 2;
    request.force_error = 0.3;
    request.friction = 0;
    return press_pad(request);
  }();
  return done;
}

TEST(PressAnswer, HasUnitsAndTheLastInstant) {
  const OrderedJson json = json_of(pressed());
  EXPECT_EQ(json["pad"], "index_pad");
  EXPECT_EQ(json["status"], "solved");
  EXPECT_EQ(json["rate_mm_s"], 100);
  EXPECT_NEAR(json["depth_mm"].get<double>(), 1, 1e-9);
  EXPECT_NEAR(json["time_s"].get<double>(), 1.01, 1e-9);
  ASSERT_EQ(json["instants"].size(), 4U);
  EXPECT_EQ(json["instants"][3]["force_N"], json["force_N"]);
  EXPECT_EQ(json["instants"][1]["phase"], "way");
  // Nodes of the patch press as the whole: a plane, straight on.
  double sum = 0;
  for (const auto& node : json["patch"]) sum += node["normal_N"].get<double>();
  EXPECT_NEAR(sum, json["force_N"].get<double>(), 1e-6);
}

TEST(PressAnswer, HasOneTableForAllForms) {
  const Table table = table_of(pressed());
  ASSERT_EQ(table.rows.size(), 4U);
  for (const auto& row : table.rows) EXPECT_EQ(row.size(), table.header.size());
  const std::string text = text_of(pressed());
  EXPECT_THAT(text, HasSubstr("index_pad under a plane: "));
  EXPECT_THAT(text, HasSubstr("at 100 mm/s, then held for 1 s; neo-hookean, Q1P0"));
  EXPECT_THAT(text, HasSubstr("largest_pressure_kPa"));
}

TEST(PressAnswer, SaysWhereAPressEndedEarly) {
  EXPECT_EQ(refusal_of(pressed()), "");
  PressResult failed = pressed();
  failed.outcome.status = Status::kLimit;
  failed.message = "too many iterations";
  failed.instants.resize(1);
  EXPECT_THAT(refusal_of(failed),
              HasSubstr("the press ended early (limit: too many iterations); it got to "));
  EXPECT_THAT(refusal_of(failed), HasSubstr(" at 0.5 mm"));
  failed.instants.clear();
  EXPECT_THAT(refusal_of(failed), HasSubstr("no step was solved"));
  EXPECT_THAT(text_of(failed), HasSubstr("not pressed"));
  EXPECT_TRUE(json_of(failed)["instants"].empty());
  failed.outcome.status = Status::kStopped;
  EXPECT_EQ(refusal_of(failed), "");
}

TEST(PressAnswer, TellsRungsOnceTheyAreThere) {
  PressResult compared = pressed();
  compared.rungs = {
      {"Q1", "144 even cells", false, 144, 0.3, 0.25, 0.1, false, "", false, {}, {}, ""},
      {"F-bar",
       "144 even cells",
       false,
       144,
       0,
       0,
       0.1,
       false,
       "too many iterations",
       false,
       {},
       {},
       ""},
      {"Q1P0", "refined to 1 %", true, 3000, 0.4, 0, 5, true, "", false, {}, {}, ""},
      {"soft finger", "law", false, 0, 0.5, 0.25, 1e-6, false, "", true, 2e-5, 3e-3, "for 'pad'"},
      {"hard point", "law", false, 0, 0, 0, 0, false, "rigid", true, {}, {}, ""}};
  EXPECT_THAT(text_of(compared), HasSubstr("the finest"));
  const OrderedJson json = json_of(compared);
  EXPECT_EQ(json["rungs"][0]["error"], 0.25);
  EXPECT_TRUE(json["rungs"][1]["force_N"].is_null());
  EXPECT_NEAR(json["rungs"][3]["area_mm2"].get<double>(), 20, 1e-9);
  EXPECT_NEAR(json["rungs"][3]["torsion_mm"].get<double>(), 3, 1e-9);
  EXPECT_TRUE(json["rungs"][4]["cpu_s"].is_null());
  EXPECT_EQ(rung_table(compared).rows[3].back(), "for 'pad'");
  EXPECT_EQ(rung_table(compared).rows[4].back(), "rigid");
  const Json page = page_of(compared);
  const Json& section = page["sections"].back();
  EXPECT_EQ(section["id"], "rungs");
  EXPECT_EQ(section["blocks"][0]["series"].size(), 2U);  // those that failed have no point
  EXPECT_EQ(section["blocks"][0]["series"][1]["labels"][0], "soft finger");
}

TEST(PressPage, ShowsPadMapsCurvesAndRelaxation) {
  const Json page = page_of(pressed());
  std::vector<std::string> ids;
  for (const Json& each : page["sections"]) ids.push_back(each["id"]);
  EXPECT_THAT(ids, testing::ElementsAre("pad", "curves", "relaxation"));
  const Json& blocks = page["sections"][0]["blocks"];
  EXPECT_TRUE(blocks[0]["caution"]);  // of the assumed numbers
  EXPECT_EQ(blocks[1]["type"], "scene");
  EXPECT_NEAR(blocks[1]["color_scale"]["high"].get<double>(),
              1e-3 * pressed().skin.pressure.maxCoeff(), 1e-12);
  EXPECT_EQ(blocks[2]["blocks"].size(), 2U);
  EXPECT_GE(page["meshes"].size(), 5U);  // skin, bone, object, two maps
  EXPECT_FALSE(report_page(page).empty());
}

TEST(PressPage, OfNothingThatWasSolvedSaysSo) {
  PressResult failed = pressed();
  failed.instants.clear();
  failed.outcome.status = Status::kLimit;
  failed.skin = {};
  const Json page = page_of(failed);
  EXPECT_EQ(page["sections"].size(), 1U);
  EXPECT_FALSE(page["sections"][0]["blocks"][0]["ok"]);
}

}  // namespace
}  // namespace thenar
