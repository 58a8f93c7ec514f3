// Tests for server/method.cpp: tables of methods.

#include "server/method.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/numbers.h"
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

// Keys that had no unit in earlier versions are there with and without it, others with it alone.
TEST(ReplyJson, EndsKeysInTheirUnits) {
  const Fields point{{"gap", units::kMetreBare, 0.25}, {"beyond", units::kDegree, 0.5}};
  const OrderedJson reply = reply_json({{"t", units::kSecondBare, 2.0},
                                        {"name", "cube"},
                                        {"first", point},
                                        {"points", std::vector<Fields>{point}},
                                        {"unknown", units::kJouleBare, kNaN}});
  const std::string part = R"({"gap":0.25,"gap_m":0.25,"beyond_rad":0.5})";
  EXPECT_EQ(json_text(reply, -1), R"({"t":2.0,"t_s":2.0,"name":"cube","first":)" + part +
                                      R"(,"points":[)" + part +
                                      R"(],"unknown":null,"unknown_J":null})");
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
