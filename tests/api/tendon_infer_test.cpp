// Tests for api/tendon_infer.cpp.

#include "api/tendon_infer.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/data_folder.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

InferNetRequest measured_finger() {
  InferNetRequest request;
  request.experiment = "synek2019_H01";
  request.subject = "synek2019_middle";
  request.net = "chao_an";
  request.data = kData;
  return request;
}

TEST(InferNet, NamesItsMethods) {
  for (const InferMethod method : {InferMethod::kSparse, InferMethod::kExplore})
    EXPECT_EQ(infer_method_named(name_of(method)), method);
  EXPECT_EQ(message_of([] { (void)infer_method_named("sparce"); }),
            "no method 'sparce', did you mean 'sparse'? there are sparse, explore");
}

TEST(InferNet, GuessesTheNameOfAnExperiment) {
  InferNetRequest request = measured_finger();
  request.experiment = "synek2019_H1";
  EXPECT_NE(message_of([&] { (void)infer_net(request); }).find("synek2019_H01"), std::string::npos);
}

TEST(InferNet, JudgesEveryBandAndProposesTests) {
  InferNetRequest request = measured_finger();
  request.propose = 2;
  const InferNetResult inference = infer_net(request);
  ASSERT_TRUE(inference.inferred.found);
  EXPECT_FALSE(inference.outcome.stopped());
  EXPECT_EQ(inference.experiment, "synek2019_H01");
  EXPECT_EQ(inference.ends.size(), inference.inferred.verdicts.size());
  EXPECT_EQ(inference.sources.size(), 3U);
  ASSERT_LE(inference.next.size(), 2U);
  if (inference.next.size() == 2) {
    EXPECT_GE(inference.next[0].disagreement, inference.next[1].disagreement);
  }
}

TEST(InferNet, SaysThatItWasStopped) {
  Progress progress;
  progress.stop_requested = [] { return true; };
  EXPECT_TRUE(infer_net(measured_finger(), progress).outcome.stopped());
}

TEST(InferNet, KnowsWhatWordsFree) {
  EXPECT_EQ(parameter_globs("slack"), std::vector<std::string>{"net/*/slack"});
  EXPECT_EQ(parameter_globs("net/DIP_dorsum/radius"),
            std::vector<std::string>{"net/DIP_dorsum/radius"});
  EXPECT_NE(message_of([] { (void)parameter_globs("slacks"); }).find("got 'slacks'"),
            std::string::npos);
}

TEST(InferNet, NeedsSomethingFreeForBandsInQuestion) {
  InferNetRequest request = measured_finger();
  request.bands = {"terminal"};
  EXPECT_NE(message_of([&] { (void)infer_net(request); }).find("frees something"),
            std::string::npos);
}

// One band of measured forces, with a small budget of draws.
TEST(InferNet, GivesProbabilitiesWithSlackLengthsFree) {
  InferNetRequest request = measured_finger();
  request.subject = "an_chao_middle";
  request.net = "extensor_hood";
  request.free = {"net/triangular/slack"};
  request.bands = {"triangular"};
  request.propose = 2;
  request.sets.evidence.draws = 8;
  const InferNetResult inference = infer_net(request);
  ASSERT_TRUE(inference.free && inference.free->posterior.found);
  EXPECT_EQ(inference.ends.size(), 1U);
  EXPECT_EQ(inference.sources.size(), 4U);  // settings too
  EXPECT_EQ(inference.free->numbers, 72);
  const BandBelief& band = inference.free->posterior.bands[0];
  ASSERT_TRUE(band.slack);
  EXPECT_NEAR(band.slack->prior_sd / band.slack->length, std::hypot(0.01, 0.01), 1e-3);
  ASSERT_EQ(inference.free->next.size(), 2U);
  EXPECT_GE(inference.free->next[0].information, inference.free->next[1].information);
  EXPECT_GT(inference.free->pool, 20U);
}

}  // namespace
}  // namespace thenar
