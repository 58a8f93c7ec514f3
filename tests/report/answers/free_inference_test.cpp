// Tests for report/answers/free_inference.cpp.

#include "report/answers/tendon_infer.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "report/answers/tendon_infer.h"

namespace thenar {
namespace {

/// A band that exists, one that is slack throughout, and one without which no net holds.
InferNetResult three_beliefs() {
  InferNetResult inference;
  inference.experiment = "E1";
  inference.subject = "S1";
  inference.net = "hood";
  inference.ends = {{"a", "b"}, {"b", "c"}, {"c", "d"}};
  FreeInference free;
  free.freed = {"slack", "paths"};
  free.settings = "finger.toml";
  free.parameters = 9;
  free.numbers = 48;
  BandPosterior& posterior = free.posterior;
  posterior.found = posterior.enumerated = true;
  posterior.fitted = 8;
  posterior.failed = 4;
  posterior.noise = 1.1;
  posterior.entropy = 1;
  BandBelief yes, slack, needed;
  yes.name = "central";
  yes.probability = 0.99;
  yes.log_odds = 4.6;
  yes.verdict = Verdict::kYes;
  yes.misfit_change = 12;
  yes.effective_change = 1.5;
  yes.tension = 2;
  yes.slack = SlackRange{0.0175, 0.0001, 0.00025, false};
  slack.name = "triangular";
  slack.probability = 0.5;
  slack.error = 0.02;
  slack.why = UndecidedReason::kSlack;
  needed.name = "lateral";
  needed.probability = 1;
  needed.log_odds = std::numeric_limits<double>::infinity();
  needed.verdict = Verdict::kYes;
  needed.misfit_change = std::numeric_limits<double>::quiet_NaN();
  needed.doubtful = true;
  posterior.bands = {yes, slack, needed};
  BandSet set;
  set.bands = {true, false, true};
  set.probability = 1;
  posterior.sets = {set};
  RankedTrial trial;
  trial.name = "Hook EDC=3";
  trial.information = 0.25;
  trial.most_informed_band = "triangular";
  free.next = {trial};
  free.pool = 4;
  free.next_mean = 0.1;
  inference.free = free;
  return inference;
}

TEST(FreeInferenceAnswer, SaysWhyABandCannotBeTold) {
  const std::string text = text_of(three_beliefs());
  EXPECT_NE(text.find("undetermined: slack throughout"), std::string::npos);
  EXPECT_NE(text.find("1 (no set without it) ?"), std::string::npos);
  EXPECT_NE(text.find("0.500 +- 0.020"), std::string::npos);
  EXPECT_NE(text.find("17.50 +- 0.10"), std::string::npos);
  EXPECT_NE(text.find("4 do not carry the loads"), std::string::npos);
}

TEST(FreeInferenceAnswer, HasNumbersOrNull) {
  const OrderedJson answer = json_of(three_beliefs());
  ASSERT_EQ(answer["bands"].size(), 3U);
  EXPECT_EQ(answer["bands"][0]["probability"], 0.99);
  EXPECT_NEAR(answer["bands"][0]["slack"]["sd_mm"].get<double>(), 0.1, 1e-12);
  EXPECT_EQ(answer["bands"][1]["verdict"], "undecided");
  EXPECT_TRUE(answer["bands"][1]["slack"].is_null());
  EXPECT_TRUE(answer["bands"][2]["log_bayes_factor"].is_null());
  EXPECT_TRUE(answer["bands"][2]["chi2_without"].is_null());
  EXPECT_EQ(answer["sets"][0]["without"], (OrderedJson::array({"triangular"})));
  EXPECT_EQ(answer["next_tests"][0]["information_bit"], 0.25);
}

TEST(FreeInferenceAnswer, HasARowABand) {
  EXPECT_EQ(
      csv(table_of(three_beliefs())),
      "band,from,to,verdict,probability,probability_error,log_bayes_factor,tension_N,slack_mm,"
      "slack_sd_mm,slack_prior_sd_mm,doubtful\n"
      "central,a,b,yes,0.99,0,4.6,2,17.5,0.1,0.25,0\n"
      "triangular,b,c,undecided,0.5,0.02,0,0,,,,0\n"
      "lateral,c,d,yes,1,0,inf,0,,,,1\n");
}

TEST(FreeInferenceAnswer, RefusesWhereNoSetCarriesTheLoads) {
  InferNetResult inference = three_beliefs();
  EXPECT_EQ(refusal_of(inference), "");
  inference.free->posterior.found = false;
  EXPECT_EQ(refusal_of(inference), "no set of bands of net hood carries the loads of E1");
}

}  // namespace
}  // namespace thenar
