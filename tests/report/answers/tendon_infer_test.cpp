// Tests for report/answers/tendon_infer.cpp.

#include "report/answers/tendon_infer.h"

#include <limits>

#include <gtest/gtest.h>

namespace thenar {
namespace {

/// A band that the forces need, one whose stiffness they leave open, and one that is not there.
InferNetResult three_bands() {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  InferNetResult inference;
  inference.experiment = "E1";
  inference.net = "hood";
  inference.inferred.found = true;
  inference.inferred.verdicts = {{"central", Verdict::kYes, kInfinite, true, 500, 0.2, true},
                                 {"radial", Verdict::kUndecided, 1.25, true, 90, kInfinite, false},
                                 {"oblique", Verdict::kNo, -8, false, 0, kInfinite, false}};
  inference.inferred.groups = {{{1, 2}, {{1}, {2}}}};
  inference.ends = {{"a", "b"}, {"b", "c"}, {"c", "d"}};
  inference.next = {{"Hook EDC=3 RI=5", 2.5}};
  return inference;
}

TEST(InferenceAnswer, LeavesOutWhatTheDataDoNotDecide) {
  const OrderedJson bands = json_of(three_bands())["bands"];
  ASSERT_EQ(bands.size(), 3U);
  EXPECT_TRUE(bands[0]["evidence"].is_null());  // infinite
  EXPECT_EQ(bands[0]["EA_N"], 500);
  EXPECT_EQ(bands[1]["evidence"], 1.25);
  EXPECT_TRUE(bands[1]["EA_N"].is_null());
  EXPECT_TRUE(bands[1]["sd_of_log_EA"].is_null());
  EXPECT_EQ(bands[2]["EA_N"], 0);
}

TEST(InferenceAnswer, HasARowABand) {
  EXPECT_EQ(csv(table_of(three_bands())),
            "band,from,to,verdict,evidence,EA_N,sd_of_log_EA,converged\n"
            "central,a,b,yes,inf,500,0.2,1\n"
            "radial,b,c,undecided,1.25,,inf,1\n"
            "oblique,c,d,no,-8,0,inf,0\n");
}

TEST(InferenceAnswer, NamesBandsThatCannotBeToldApart) {
  EXPECT_EQ(groups_in_words(three_bands().inferred).front(),
            "The data cannot tell apart: radial, oblique (2 ways to have them).");
}

TEST(InferenceAnswer, SaysWhetherATestWouldTell) {
  InferNetResult inference = three_bands();
  EXPECT_NE(next_in_words(inference).find("disagree most"), std::string::npos);
  inference.next[0].disagreement = 0.01;
  EXPECT_NE(next_in_words(inference).find("No test of this rig"), std::string::npos);
}

TEST(InferenceAnswer, RefusesWhereNoNetCarriesTheLoads) {
  InferNetResult inference = three_bands();
  EXPECT_EQ(refusal_of(inference), "");
  inference.inferred.found = false;
  EXPECT_EQ(refusal_of(inference), "no set of bands of net hood carries the loads of E1");
}

}  // namespace
}  // namespace thenar
