// Tests for api/explain.cpp.

#include "api/explain.h"

#include <gtest/gtest.h>

#include "tests/data_folder.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

ExplainRequest request_for(const std::string& thing, const std::string& digit = "") {
  ExplainRequest request;
  request.thing = thing;
  request.digit = digit;
  request.data = kData;
  return request;
}

TEST(ExplainThing, BuildsAndTimesTheDigitOfASubject) {
  const ThingExplained found = explain_thing(request_for("an_chao_index"));
  ASSERT_TRUE(found.digit.has_value());
  EXPECT_EQ(found.digit->digit, "index");
  EXPECT_EQ(found.digit->parts.joints.size(), 4U);  // MCP has two axes, PIP and DIP one each
  for (const QuestionCost& cost : found.digit->costs) EXPECT_GT(cost.seconds, 0) << cost.question;
  EXPECT_GT(found.digit->parameters.coordinates(), 0);
  EXPECT_TRUE(found.digit->settings_message.empty());
}

// A name, as a fit takes it, and the file of that name are the same settings.
TEST(ExplainThing, TakesSettingsByName) {
  ExplainRequest request = request_for("an_chao_index");
  request.settings = "finger_arms";
  const ThingExplained by_name = explain_thing(request);
  request.settings = kData + "/fits/finger_arms.toml";
  const ThingExplained by_file = explain_thing(request);
  EXPECT_EQ(by_name.digit->settings, by_file.digit->settings);
  EXPECT_EQ(by_name.digit->parameters.coordinates(), by_file.digit->parameters.coordinates());
  EXPECT_NE(by_name.digit->parameters.coordinates(),
            explain_thing(request_for("an_chao_index")).digit->parameters.coordinates());
}

TEST(ExplainThing, BuildsTheDefaultPathsOfTheSubject) {
  const auto path_of = [](const std::string& subject) {
    return explain_thing(request_for(subject, "index")).digit->tendons->digit().fidelity.path;
  };
  EXPECT_EQ(path_of("mirakhorlo2016"), Path::kWrapped);
  EXPECT_EQ(path_of("an_chao_index"), Path::kViaPoint);
}

TEST(ExplainThing, LeavesMapsWithoutBones) {
  const ThingExplained found = explain_thing(request_for("valero_cuevas_index"));
  EXPECT_EQ(found.digit->tendons, nullptr);
}

TEST(ExplainThing, TakesADigitOfSubjectsOnly) {
  const std::string path = kData + "/nets/winslow.toml";
  EXPECT_EQ(message_of([] { (void)explain_thing(request_for("winslow", "index")); }),
            "a digit, settings and paths explain subjects; '" + path + "' is of kind: net");
}

}  // namespace
}  // namespace thenar
