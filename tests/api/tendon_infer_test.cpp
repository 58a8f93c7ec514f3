// Tests for api/tendon_infer.cpp.

#include "api/tendon_infer.h"

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
            "method must be sparse or explore, got 'sparce'");
}

TEST(InferNet, GuessesTheNameOfAnExperiment) {
  InferNetRequest request = measured_finger();
  request.experiment = "synek2019_H1";
  EXPECT_NE(message_of([&] { (void)infer_net(request); }).find("synek2019_H01"), std::string::npos);
}

TEST(InferNet, JudgesEveryBandAndProposesTests) {
  InferNetRequest request = measured_finger();
  request.propose = 2;
  const NetInference inference = infer_net(request);
  ASSERT_TRUE(inference.inferred.found);
  EXPECT_FALSE(inference.stopped);
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
  EXPECT_TRUE(infer_net(measured_finger(), progress).stopped);
}

}  // namespace
}  // namespace thenar
