// Tests for server/methods/method_table.cpp: what holds of every method that a server offers.

#include "server/methods/method_table.h"

#include <set>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "questions/question.h"

namespace thenar {
namespace {

/// "hand" of "hand.close".
std::string group_of(const RpcMethod& method) {
  return method.name.substr(0, method.name.find('.'));
}

// Methods of a group stand together, so that documents have one section for each.
TEST(AllMethods, StandTogetherByGroup) {
  std::set<std::string> ended;
  std::string group;
  const MethodTable table = method_table();
  for (const RpcMethod& method : table.methods()) {
    ASSERT_NE(method.name.find('.'), std::string::npos) << method.name;
    if (group_of(method) == group) continue;
    EXPECT_TRUE(ended.insert(group).second) << group;
    group = group_of(method);
    EXPECT_EQ(ended.count(group), 0U) << group << " begins again at " << method.name;
  }
}

// Each example is what its method takes.
TEST(AllMethods, TakeTheirExamples) {
  const MethodTable table = method_table();
  for (const RpcMethod& method : table.methods()) {
    EXPECT_NO_THROW((void)validated(method.params, Json::parse(method.example), "params"))
        << method.name;
    EXPECT_TRUE(method.handler != nullptr) << method.name;
    EXPECT_EQ(method.description.back(), '.') << method.name;
    EXPECT_FALSE(method.returns.empty()) << method.name;
  }
}

// What is answered at once is asked by its name, what lasts is a job.
TEST(AllMethods, AskEveryQuestionThatIsAnsweredAtOnce) {
  const MethodTable table = method_table();
  for (const Question& question : questions())
    EXPECT_EQ(table.has_method("ask." + question.name), question.pace == QuestionPace::kAtOnce)
        << question.name;
  EXPECT_TRUE(table.has_method("job.start"));
}

}  // namespace
}  // namespace thenar
