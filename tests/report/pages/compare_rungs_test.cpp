// Tests for report/pages/compare_rungs.cpp and the words of the same answer.

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "report/pages/compare_rungs.h"
#include "tests/data_folder.h"

namespace thenar {
namespace {

using testing::HasSubstr;

RungComparison compared(const std::string& scene, const std::vector<std::string>& rungs) {
  SceneRequest request;
  request.scene = kData + "/scenes/" + scene + ".toml";
  request.seconds = 0.04;
  return compare_rungs(request, rungs);
}

TEST(RungComparisonPage, ShowsEachRungAndItsError) {
  const RungComparison pencil = compared("pencil_pinch", {"soft-finger", "hard-point"});
  const Json page = page_of(pencil);
  const Json& charts = page["sections"][0]["blocks"][1]["blocks"];
  ASSERT_EQ(charts.size(), 2u);
  // The finest has no error to be drawn on a logarithmic axis.
  ASSERT_EQ(charts[0]["series"].size(), 1u);
  EXPECT_EQ(charts[0]["series"][0]["name"], "hard-point");
  EXPECT_NEAR(charts[0]["series"][0]["y"][0].get<double>(), 100 * pencil.runs[1].error.force_end,
              1e-9);
  EXPECT_EQ(page["sections"].size(), 4u);
  const OrderedJson json = json_of(pencil);
  EXPECT_EQ(json["finest"], "soft-finger");
  EXPECT_EQ(json["runs"][1]["force_error_end"], pencil.runs[1].error.force_end);
  EXPECT_EQ(table_of(pencil).rows.size(), 2u);
}

TEST(RungComparisonPage, TellsOfRunsThatWereNotSolved) {
  const RungComparison coin = compared("coin_draw", {"soft-finger", "hard-point"});
  EXPECT_EQ(refusal_of(coin), "");
  EXPECT_THAT(coin.outcome.warnings, testing::Contains(HasSubstr("on soft-finger: ")));
  EXPECT_THAT(text_of(coin), HasSubstr("Errors are against hard-point"));
  // It has no point on the chart.
  EXPECT_EQ(page_of(coin)["sections"][0]["blocks"][1]["blocks"][0]["series"].size(), 0u);
}

}  // namespace
}  // namespace thenar
