// Tests for report/explain/scene.cpp: what a scene that moves is said to be.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "report/explain/explanation.h"
#include "tests/data_folder.h"

namespace thenar {
namespace {

using testing::HasSubstr;

ThingExplained explained(const std::string& scene) {
  ExplainRequest request;
  request.thing = scene;
  request.data = kData;
  return explain_thing(request);
}

TEST(ExplainScene, SaysWhichPadsMeetWhatAndWhatIsAssumedOfThem) {
  const OrderedJson json = json_of(explained("pencil_pinch"));
  const OrderedJson& pads = json["pads"]["rows"];
  ASSERT_EQ(pads.size(), 2U);
  EXPECT_EQ(pads[1]["on"], "human:skewed/DP2");
  EXPECT_EQ(pads[1]["against"], "pencil");
  EXPECT_EQ(pads[1]["rung"], "soft-finger");
  EXPECT_EQ(pads[1]["pad"], "index_pad");
  EXPECT_EQ(pads[1]["laws"], "index_pad");
  EXPECT_TRUE(pads[1]["scale"].is_null()) << "that of the fingertip";
  EXPECT_EQ(pads[1]["force_error"], 0.05);
  // The pad and its laws are the same twice, and told once.
  const OrderedJson& notes = json["pad_constants"]["notes"];
  ASSERT_EQ(notes.size(), 3U);
  EXPECT_THAT(notes[0], HasSubstr("10 of its numbers assumed"));
  EXPECT_THAT(notes[1], HasSubstr("shear_modulus_kPa of [pulp]"));
  EXPECT_THAT(notes[2], HasSubstr("laws of pad 'index_pad'"));
}

TEST(ExplainScene, HasBodiesAndHandsAndNothingOfPadsThatAreNotThere) {
  const ThingExplained pinch = explained("pinch");
  const OrderedJson json = json_of(pinch);
  EXPECT_EQ(json["bodies"]["rows"].size(), std::get<SceneSpec>(pinch.thing).bodies.size());
  EXPECT_TRUE(json["pads"]["rows"].empty());
  EXPECT_EQ(text_of(pinch).find("ads"), std::string::npos);
}

}  // namespace
}  // namespace thenar
