#include "questions/schema.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/error.h"

namespace thenar {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

Schema place() {
  return object_schema({{"name", text_schema(10), "Whose.", true, nullptr},
                        {"position", vector_schema("m"), "Where.", true, nullptr},
                        {"rotation", rotation_schema(), "How.", false, {1, 0, 0, 0}},
                        {"joints", map_schema(number_schema("rad", -4, 4)), "Angles."},
                        {"norm", word_schema({"l1", "linf"}), "Which.", false, "l1"}});
}

/// What a value is refused with; "" if it is not.
std::string refusal(const Json& value) {
  try {
    (void)validated(place(), value, "params");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Schema, FillsInWhatIsLeftOut) {
  const Json out =
      validated(place(), Json::parse(R"({"name": "mug", "position": [1, 2.5, 0]})"), "params");
  EXPECT_EQ(out, Json::parse(R"({"name": "mug", "position": [1, 2.5, 0],
                                 "rotation": [1, 0, 0, 0], "norm": "l1"})"));
}

TEST(Schema, TakesNoControlCharactersInNames) {
  Json given = Json::parse(R"({"name": "mug", "position": [0, 0, 0]})");
  for (const std::string& name : {std::string("a\0b", 3), std::string("a\nb"),
                                  std::string("\x1b[2J"), std::string("\xC2\x9B")}) {
    given["name"] = name;
    EXPECT_THAT(refusal(given), HasSubstr("params.name: wanted a name or a path, got one with a "
                                          "control character at byte "));
  }
  given["name"] = "m\xC3\xBCg \xE2\x98\x83";  // other letters are welcome
  EXPECT_EQ(refusal(given), "");
  given["joints"] = {{"a\nb", 1}};
  EXPECT_THAT(refusal(given), HasSubstr("params.joints: "));
  EXPECT_NO_THROW((void)validated(content_schema(10), "a\nb", "params"));
  for (const char* file : {"../x", "/x", ".x", "a/.x/y", "a/", ""})
    EXPECT_THROW((void)validated(saved_file_schema(), file, "params"), InputError) << file;
}

TEST(Schema, SaysWhereWhatWasWantedAndWhatCame) {
  const auto with = [](const char* member, const Json& value) {
    Json given = Json::parse(R"({"name": "mug", "position": [0, 0, 0]})");
    given[member] = value;
    return given;
  };
  EXPECT_EQ(refusal(with("position", {0, 0, "x"})),
            R"(params.position.2: wanted a number [m], got "x")");
  EXPECT_EQ(refusal(with("position", {0, 0})),
            "params.position: wanted a list of 3, got a list of 2");
  EXPECT_EQ(refusal(with("joints", {{"PIP2", 5}})),
            "params.joints.PIP2: wanted a number from -4 to 4 [rad], got 5");
  EXPECT_EQ(refusal(with("norm", "l2")), R"(params.norm: wanted one of l1, linf, got "l2")");
  EXPECT_EQ(refusal(with("name", std::string(11, 'x'))),
            R"(params.name: wanted a text of 0 to 10 bytes, got "xxxxxxxxxxx")");
  EXPECT_THAT(refusal(with("rotation", {0.5, 0.5, 0, 0})), HasSubstr("length 1, got length 0.707"));
  EXPECT_THAT(refusal(with("positon", 1)), HasSubstr("did you mean 'position'"));
  EXPECT_EQ(refusal(Json::parse(R"({"name": "mug"})")),
            "params: 'position' is missing, wanted a list of 3");
  EXPECT_EQ(refusal(Json::array()), "params: wanted an object, got a list of 0");
}

TEST(Schema, LetsNoNumberThroughThatIsNone) {
  const Schema schema = number_schema("N");
  for (const Json& value : {Json(nullptr), Json("1"), Json(true), Json::array({1}),
                            Json(std::numeric_limits<double>::infinity())})
    EXPECT_THROW((void)validated(schema, value, "x"), InputError) << value;
  EXPECT_THROW((void)validated(integer_schema(0, 9), 1.5, "x"), InputError);
  EXPECT_EQ(validated(integer_schema(0, 9), 2.0, "x"), Json(2.0));
}

TEST(Schema, IsWrittenAsJsonSchema) {
  const OrderedJson out = json_schema(place());
  EXPECT_EQ(out["type"], "object");
  EXPECT_EQ(out["additionalProperties"], false);
  EXPECT_EQ(out["required"], OrderedJson({"name", "position"}));
  EXPECT_EQ(out["properties"]["position"]["items"]["x-unit"], "m");
  EXPECT_EQ(out["properties"]["norm"]["default"], "l1");
  EXPECT_EQ(out["properties"]["norm"]["enum"], OrderedJson({"l1", "linf"}));
}

}  // namespace
}  // namespace thenar
