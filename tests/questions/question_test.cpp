// Tests for questions/question.cpp: the table by names, and records of requests.

#include "questions/question.h"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

// Names, and commands that ask, lead to one question each; each example is one that it takes.
TEST(Question, NamesLeadToOneQuestionEach) {
  std::set<std::string> names;
  for (const Question& each : questions()) {
    EXPECT_TRUE(names.insert(each.name).second) << each.name;
    EXPECT_EQ(&question_named(each.name), &each);
    EXPECT_NO_THROW((void)request_in_si(each.params, Json::parse(each.example))) << each.name;
  }
  EXPECT_EQ(question_names().size(), names.size());
}

TEST(Question, KeepsTheOrderOfItsGroups) {
  const std::vector<std::string> names = question_names();
  const auto place = [&](const std::string& name) {
    return std::find(names.begin(), names.end(), name) - names.begin();
  };
  EXPECT_LT(place("tip_force"), place("fit"));
  EXPECT_LT(place("fit"), place("contacts"));
  EXPECT_LT(place("contacts"), place("compare"));
  EXPECT_LT(place("compare"), static_cast<std::ptrdiff_t>(names.size()));
}

TEST(Question, NamesTheNearestWhereThereIsNone) {
  const std::string message = message_of([] { (void)question_named("tip_forces"); });
  EXPECT_EQ(message.find("no question 'tip_forces', did you mean 'tip_force'?"), 0U) << message;
}

// One evaluation cannot certify a minimum.
TEST(Question, RefusesTheAnswerOfAFitThatHasNotConverged) {
  const Json request{
      {"experiments", {"synek2019_H01"}}, {"subject", "an_chao_middle"}, {"max_evaluations", 1}};
  const Answer answer = question_named("fit").ask(request, THENAR_DATA_DIR, {});
  EXPECT_EQ(answer.refusal.find("the fit has NOT converged"), 0U) << answer.refusal;
  EXPECT_EQ(answer.refusal.find("--"), std::string::npos) << answer.refusal;
}

// A record is one line, the question first, then the request in its own order.
TEST(Question, RecordsTheQuestionFirst) {
  const OrderedJson request{{"world", "jaw_box"}, {"seed", 3}, {"approach", true}};
  EXPECT_EQ(request_record("grasp", request),
            R"({"question":"grasp","world":"jaw_box","seed":3,"approach":true})");
}

// A request refuses keys that no parameter has, at every question.
TEST(Question, RefusesUnknownParametersEverywhere) {
  for (const Question& each : questions()) {
    Json request = Json::parse(each.example);
    request["no_such_key"] = 1;
    const std::string message = message_of([&] { (void)each.ask(request, THENAR_DATA_DIR, {}); });
    EXPECT_EQ(message.find("no parameter 'no_such_key'"), 0U) << each.name << ": " << message;
  }
}

}  // namespace
}  // namespace thenar
