// Tests for server/remote_docs.cpp: a small table as a document.

#include "server/remote_docs.h"

#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "server/methods/method_table.h"
#include "tests/server/small_model.h"

namespace thenar {
namespace {

using testing::HasSubstr;

/// The document of one method with one parameter.
std::string document_of(const SchemaMember& member, const std::string& returns = "nothing") {
  MethodTable table;
  table.add({"hand.close", "Closes.", object_schema({member}), returns, "{}",
             [](Session&, const Json&, const Progress&) { return OrderedJson::object(); }});
  return methods_markdown(table);
}

TEST(RemoteDocs, SaysTypesUnitsAndRanges) {
  EXPECT_THAT(document_of({"speed", number_schema("m/s", 0, 2), "How fast.", true}),
              HasSubstr("| `speed` | number [m/s], 0 to 2 | required | How fast. |"));
  EXPECT_THAT(document_of({"count", integer_schema(1, 9), "How often.", false, 3}),
              HasSubstr("| `count` | whole number, 1 to 9 | `3` | How often. |"));
  EXPECT_THAT(document_of({"load", number_schema("N", 0), "How much."}),
              HasSubstr("| `load` | number [N], at least 0 |  | How much. |"));
  EXPECT_THAT(document_of({"place", vector_schema("m"), "Where."}),
              HasSubstr("list of 3: number [m]"));
  EXPECT_THAT(document_of({"grip", word_schema({"palm", "tip"}), "How."}),
              HasSubstr("one of `palm`, `tip`"));
}

// A bar in a cell would end it.
TEST(RemoteDocs, EscapesBarsInCells) {
  EXPECT_THAT(document_of({"a", text_schema(), "Either a|b."}), HasSubstr("Either a\\|b."));
}

TEST(RemoteDocs, EndsSentencesOnce) {
  const SchemaMember member{"a", text_schema(), "Which."};
  EXPECT_THAT(document_of(member, "its name"), HasSubstr("Returns its name.\n"));
  EXPECT_THAT(document_of(member, "its name. Or none."), HasSubstr("Returns its name. Or none.\n"));
}

// One section for each group of the table and one for each method, in their order.
TEST(RemoteDocs, HasASectionForEveryMethod) {
  const std::string text = methods_markdown(small_table());
  std::size_t at = 0;
  for (const char* heading : {"## small.*", "### small.open", "### small.lift", "### small.wait",
                              "## motion.*", "### motion.step", "### motion.pause"}) {
    const std::size_t found = text.find(std::string(heading) + "\n", at);
    ASSERT_NE(found, std::string::npos) << heading;
    at = found;
  }
  EXPECT_THAT(
      text,
      HasSubstr(R"(    {"jsonrpc":"2.0","id":1,"method":"small.lift","params":{"height":0.1}})"));
}

// Of all methods of a server: lines that are no row of a table end at column 140.
TEST(RemoteDocs, LinesEndAtColumn140) {
  std::istringstream lines(methods_markdown(method_table()));
  for (std::string line; std::getline(lines, line);)
    if (line.empty() || line[0] != '|') {
      EXPECT_LE(line.size(), 140U) << line;
    }
}

}  // namespace
}  // namespace thenar
