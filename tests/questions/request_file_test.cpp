#include "questions/request_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"

namespace thenar {
namespace {

TEST(RequestFile, IsReadBackAsItWasWritten) {
  const OrderedJson request{{"subject", "a \"quoted\" name"},
                            {"tension_N", {{"FDP", 1.0 / 3}, {"LU 2", 4.0}}},
                            {"direction", {0.1, -1.0, 2e-9}},
                            {"whole_set", true},
                            {"count", 3}};
  const RequestFile read = parse_request(request_text("tip_force", request), "r.toml");
  EXPECT_EQ(read.question->name, "tip_force");
  EXPECT_EQ(read.request, Json::parse(json_text(request, -1)));
  EXPECT_EQ(read.lines.at("direction"), 4);
}

std::string refusal_of_file(const std::string& text) {
  try {
    (void)parse_request(text, "r.toml").ask({});
  } catch (const Error& error) {
    return error.what();
  }
  return "nothing";
}

TEST(RequestFile, TellsTheLineOfWhatIsWrong) {
  EXPECT_EQ(refusal_of_file("subject = \"synek2019_middle\"\n"),
            "r.toml:1: wanted question = \"..\": which question is asked");
  EXPECT_EQ(refusal_of_file("question = \"tip_forces\"\n").substr(0, 64),
            "r.toml:1: no question 'tip_forces', did you mean 'tip_force'? th");
  EXPECT_EQ(refusal_of_file("question = \"tip_force\"\nsubject = \"synek2019_middle\"\n\n"
                            "tension_N = {FDP = -1}\n"),
            "r.toml:4: wanted a tension >= 0 of 'FDP', got -1 N");
  EXPECT_EQ(refusal_of_file("question = \"tip_force\"\nsubject = \"synek2019_middle\"\n"
                            "tension_N = {FDP = 10}\nhold_length_mm = 0\nhold = \"rigid\"\n"),
            "r.toml:4: wanted a hold length above 0, up to 1000 mm, got 0 mm");
  EXPECT_EQ(refusal_of_file("question = \"tip_force\"\nsubject = 2026-01-01\n"),
            "r.toml:2: no parameter is a date");
  const std::string finger = "question = \"tip_force\"\nsubject = \"synek2019_middle\"\n";
  EXPECT_EQ(refusal_of_file(finger + "tension_N = {FDP = nan}\n"), "r.toml:3: no parameter is nan");
  EXPECT_EQ(refusal_of_file(finger + "tension_N = 10\n"),
            "r.toml:3: tension_N: wanted a table of at most 1000 members, got 10");
  EXPECT_EQ(refusal_of_file(finger + "tension_N = {FDP = 10}\nvary_deg = {joint = \"PIP3\"}\n"),
            "r.toml:4: vary_deg: wanted a list of 0 to 100 entries, got a table");
}

TEST(RequestFile, OfATemplateShowsTheFormsOfValues) {
  const std::string text = request_template(question_named("tip_force"));
  for (const char* line : {"# digit = \"..\"\n", "# frozen_deg = {NAME = ..}\n",
                           "# vary_deg = [{joint = \"..\", from = .., to = .., step = ..}]\n"})
    EXPECT_NE(text.find(line), std::string::npos) << line;
}

TEST(RequestFile, TellsTheLineOfAnUnknownName) {
  using testing::StartsWith;
  const std::string start = "question = \"tip_force\"\nsubject = \"synek2019_middle\"\n";
  // A joint, whose posture has its unit in the key.
  for (const std::string key : {"posture_deg", "posture_rad", "frozen_deg", "frozen_rad"})
    EXPECT_THAT(
        refusal_of_file(start + "tension_N = {FDP = 1}\n" + key + " = {PIP9 = 0.1}\n"),
        StartsWith(key[0] == 'p' ? "r.toml:4: no free joint 'PIP9'" : "r.toml:4: no joint 'PIP9'"));
  EXPECT_THAT(
      refusal_of_file(start + "tension_N = {FDP = 1}\nvary_deg = [{joint = \"PIP9\", from = 0, "
                              "to = 1, step = 1}]\n"),
      StartsWith("r.toml:4: no free joint 'PIP9'"));
  EXPECT_THAT(refusal_of_file(start + "\ntension_N = {FPD = 1}\n"),
              StartsWith("r.toml:4: no muscle 'FPD', did you mean 'FDP'?"));
  EXPECT_THAT(refusal_of_file(start + "tension_N = {FDP = 1}\ndigit = \"thumb\"\n"),
              StartsWith("r.toml:4: subject 'synek2019_middle' has no digit 'thumb'"));
}

TEST(RequestFile, TellsTheLineOfAMissingFile) {
  using testing::StartsWith;
  EXPECT_THAT(
      refusal_of_file("question = \"tip_force\"\n\nsubject = \"nobody\"\ntension_N = {FDP = 1}\n"),
      StartsWith("r.toml:3: there is no subject 'nobody'"));
  EXPECT_THAT(
      refusal_of_file("question = \"pose\"\nposture_deg = {PIP3 = 1}\nmodel = \"nobody\"\n"),
      StartsWith("r.toml:3: there is no subject 'nobody'"));
  EXPECT_THAT(refusal_of_file("question = \"press\"\ndepth_mm = 0.5\npad = \"none\"\n"),
              StartsWith("r.toml:3: there is no pad 'none'"));
}

TEST(RequestFile, TellsTheLineOfANumberOutOfRange) {
  using testing::StartsWith;
  const std::string start =
      "question = \"feasible_force\"\nsubject = \"an_chao_index\"\ndirection = [0, 0, 1]\n";
  EXPECT_THAT(refusal_of_file(start + "tolerance_deg = 90\n"),
              StartsWith("r.toml:4: wanted a tolerance of 0 deg to below 90 deg"));
  EXPECT_THAT(refusal_of_file(start + "posture_deg = {PIP2 = 400}\n"),
              StartsWith("r.toml:4: wanted an angle of 'PIP2' between -360 and 360 deg"));
  EXPECT_THAT(
      refusal_of_file(start + "vary_deg = [{joint = \"PIP2\", from = 0, to = 10, step = -1}]\n"),
      StartsWith("r.toml:4: steps of -1 deg do not lead from 0 to 10 deg"));
  EXPECT_THAT(refusal_of_file("question = \"feasible_force\"\nsubject = \"an_chao_index\"\n\n"
                              "direction = [0, 0, 0]\n"),
              StartsWith("r.toml:4: "));
}

TEST(RequestFile, OfATemplateAsksTheExample) {
  for (const Question& question : questions()) {
    const RequestFile read = parse_request(request_template(question), question.name + ".toml");
    EXPECT_EQ(read.question, &question);
    EXPECT_EQ(read.request, Json::parse(question.example)) << question.name;
  }
}

}  // namespace
}  // namespace thenar
