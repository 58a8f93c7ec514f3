// Tests for tendons/explain_digit.cpp.

#include "tendons/explain_digit.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "data/io/subject.h"

namespace thenar {
namespace {

DigitExplanation explained(const std::string& file, const std::string& digit,
                           const TendonOptions& options = {}) {
  const Subject subject = read_subject(std::string(THENAR_DATA_DIR "/subjects/") + file);
  return explain_digit(subject, digit, options, build_tendon_digit(subject, digit, options));
}

/// Why a part was dropped; empty if it was not.
std::string why(const DigitExplanation& says, const std::string& name) {
  for (const DroppedPart& part : says.dropped)
    if (part.name == name) return part.reason;
  return "";
}

TEST(ExplainDigit, KeepsAllOfASubjectThatIsOneDigit) {
  const DigitExplanation says = explained("an_chao_middle.toml", "middle");
  EXPECT_TRUE(says.dropped.empty());
  EXPECT_EQ(says.joints.size(), 4u);
  EXPECT_EQ(says.hood, "EDC, RI, LU, UI feed central slip ES, bands RB and UB, terminal slip TE");
}

TEST(ExplainDigit, SaysWhyPartsOfOtherDigitsAreDropped) {
  const DigitExplanation says = explained("mirakhorlo2016.toml", "index");
  EXPECT_EQ(why(says, "PP1"), "not between wrist and index tip");
  EXPECT_EQ(why(says, "IP1"), "moves a segment that is dropped");
  EXPECT_EQ(why(says, "WRIST_FE"), "welded: other digits share it, and the question is of one tip");
  EXPECT_EQ(why(says, "FDP2"), "");
}

TEST(ExplainDigit, SaysWhatFreezingWelds) {
  TendonOptions options;
  options.frozen["DIP2"] = 0.1;
  const DigitExplanation says = explained("mirakhorlo2016.toml", "index", options);
  EXPECT_EQ(why(says, "DIP2"), "frozen: MP2 and DP2 are welded");
}

TEST(ExplainDigit, SaysThatTheHoodWasCut) {
  TendonOptions options;
  options.hood = Hood::kSeparate;
  const DigitExplanation says = explained("an_chao_middle.toml", "middle", options);
  EXPECT_EQ(why(says, "middle"), "separate tendons were asked for");
}

}  // namespace
}  // namespace thenar
