// Tests for server/method.cpp: tables of methods.

#include "server/method.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

RpcMethod method_named(const std::string& name) {
  return {name,
          "Does it.",
          object_schema({}),
          "nothing",
          "{}",
          [name](Session&, const Json&, const Progress&) -> OrderedJson {
            return {{"did", name}};
          }};
}

TEST(MethodTable, KeepsTheOrderInWhichMethodsWereAdded) {
  MethodTable table;
  for (const char* name : {"world.new", "hand.close", "a.first"}) table.add(method_named(name));
  ASSERT_EQ(table.methods().size(), 3U);
  EXPECT_EQ(table.methods()[0].name, "world.new");
  EXPECT_EQ(table.methods()[2].name, "a.first");
  EXPECT_TRUE(table.has_method("hand.close"));
  EXPECT_FALSE(table.has_method("hand"));
  EXPECT_EQ(table.method_named("hand.close").name, "hand.close");
}

TEST(MethodTable, RefusesASecondMethodOfAName) {
  MethodTable table;
  table.add(method_named("hand.close"));
  EXPECT_EQ(message_of([&] { table.add(method_named("hand.close")); }),
            "there are two methods 'hand.close'");
  EXPECT_EQ(table.methods().size(), 1U);
}

TEST(MethodTable, NamesTheNearestMethod) {
  MethodTable table;
  table.add(method_named("hand.close"));
  table.add(method_named("world.new"));
  EXPECT_EQ(message_of([&] { (void)table.method_named("hand.clos"); }),
            "no method 'hand.clos', did you mean 'hand.close'? session.methods lists all");
  EXPECT_EQ(message_of([&] { (void)table.method_named("quite something else"); }),
            "no method 'quite something else'; session.methods lists all");
}

TEST(MethodTable, ReadsNumbersByName) {
  const Json params = Json::parse(R"({"joints": {"MCP2": 0.25, "PIP2": -1}})");
  EXPECT_EQ(named_numbers(params, "joints"),
            (std::map<std::string, double>{{"MCP2", 0.25}, {"PIP2", -1}}));
  EXPECT_TRUE(named_numbers(params, "tendons").empty());
}

}  // namespace
}  // namespace thenar
