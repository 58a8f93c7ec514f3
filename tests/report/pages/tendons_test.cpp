// Tests for report/pages/tendons.cpp, motion.cpp and tendon_infer.cpp.

#include "report/pages/tendons.h"

#include <set>

#include <gtest/gtest.h>

namespace thenar {
namespace {

DigitMotionResult short_motion() {
  DigitMotionRequest request;
  request.digit.subject = THENAR_DATA_DIR "/subjects/an_chao_index.toml";
  request.excitation = {{"FDP", 0.1}};
  request.seconds = 0.1;
  request.sample = 1e-3;  // 101 instants
  return simulate_digit(request);
}

// Dorsal is +y in the frame of An's and Chao's subjects.
TEST(MotionPage, PlaysInstantsWithTheBackOfTheDigitUp) {
  const Json page = page_of(short_motion());
  const Json& scene = page["sections"][0]["blocks"][0];
  ASSERT_EQ(scene["type"], "scene");
  EXPECT_EQ(scene["up"], Json::array({0.0, 1.0, 0.0}));
  std::set<double> instants;
  for (const Json& layer : scene["layers"])
    if (layer.contains("time")) instants.insert(layer["time"].get<double>());
  EXPECT_GE(instants.size(), 30U);
  EXPECT_LE(instants.size(), 60U);
  EXPECT_EQ(*instants.begin(), 0);
  EXPECT_NEAR(*instants.rbegin(), 0.1, 1e-12);
}

TendonRequest pulled_finger() {
  TendonRequest request;
  request.digit.subject = THENAR_DATA_DIR "/subjects/synek2019_middle.toml";
  request.digit.net = "winslow";
  request.tension = {{"EDC", 2.9}, {"LU", 0.4}};
  return request;
}

std::vector<std::string> ids_of(const Json& page) {
  std::vector<std::string> ids;
  for (const Json& section : page["sections"]) ids.push_back(section["id"]);
  return ids;
}

TEST(TendonPage, HasChartsOfASweepOnly) {
  TendonRequest request = pulled_finger();
  EXPECT_EQ(ids_of(page_of(solve_tendons(request))), std::vector<std::string>{"net"});
  request.digit.vary = {{"PIP3", 0, 0.4, 0.2}};
  EXPECT_EQ(ids_of(page_of(sweep_tendons(request))),
            (std::vector<std::string>{"net", "arms", "tip"}));
}

TEST(TendonPage, RecordsSubjectAndNet) {
  const Json page = page_of(solve_tendons(pulled_finger()));
  EXPECT_EQ(page["provenance"]["net"], "winslow");
  EXPECT_EQ(page["provenance"]["tensions"], "EDC=2.9 LU=0.4 N");
}

TEST(InferencePage, BeginsWithDoubts) {
  InferNetResult inference;
  inference.inferred.found = true;
  inference.inferred.verdicts = {{"central", Verdict::kYes, 9, true, 500, 0.2, true}};
  inference.ends = {{"a", "b"}};
  const auto first = [&] { return page_of(inference)["sections"][0]["blocks"][0]; };
  EXPECT_EQ(first()["type"], "table");
  inference.outcome.warnings = {"the fit of the best net did not converge"};
  EXPECT_EQ(first()["type"], "banner");
}

TEST(InferencePage, ShowsProbabilitiesWhereSomethingIsFree) {
  InferNetResult inference;
  inference.ends = {{"a", "b"}};
  FreeInference free;
  free.freed = {"slack"};
  BandBelief band;
  band.name = "central";
  band.probability = 0.97;
  band.verdict = Verdict::kYes;
  free.posterior.bands = {band};
  free.posterior.sets.resize(1);
  inference.free = free;
  const Json page = page_of(inference);
  EXPECT_EQ(page["provenance"]["method"], "slack free, seed 1");
  EXPECT_EQ(page["sections"][0]["blocks"][0]["rows"][0][4], "0.970");
}

}  // namespace
}  // namespace thenar
