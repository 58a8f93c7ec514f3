#include "questions/request_table.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/numbers.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

enum class Grip { kPalm, kTip };
constexpr std::array kGripNames{EnumName{Grip::kPalm, "palm"}, EnumName{Grip::kTip, "tip"}};

struct Squeeze {
  std::string object;
  Grip grip = Grip::kTip;
  double width = 0.02;                  // [m]
  std::optional<double> angle;          // [rad]
  std::map<std::string, double> force;  // [N]
  int count = 3;
  bool twice = false;
  std::vector<Grip> next;  // grips that follow
};

RequestTable<Squeeze> squeeze_table() {
  RequestTable<Squeeze> table;
  table.add("object", text_schema(), &Squeeze::object, "Which.").member.required = true;
  table.add_word("grip", kGripNames, &Squeeze::grip, "How.");
  table.add("width", units::kMillimetre, number_schema("", 0, 0.1), &Squeeze::width, "How wide.");
  table.add("angle", units::kDegree, number_schema(""), &Squeeze::angle, "From where.");
  table.add("force", units::kNewton, map_schema(infinite_number_schema("", 0)), &Squeeze::force,
            "Of whom.");
  table.add("count", integer_schema(1, 9), &Squeeze::count, "How often.");
  table.add("twice", flag_schema(), &Squeeze::twice, "Whether.");
  table.add_words("next", list_schema(text_schema(), 0, 9), "grip", kGripNames, &Squeeze::next,
                  "What follows.");
  return table;
}

std::string refusal(const std::string& json) {
  return message_of([&] { (void)squeeze_table().read(Json::parse(json)); });
}

TEST(RequestTable, ReadsEitherUnit) {
  const RequestTable<Squeeze> table = squeeze_table();
  const Squeeze si =
      table.read(Json::parse(R"({"object": "can", "width_m": 0.03, "angle_rad": 0.5})"));
  EXPECT_EQ(si.width, 0.03);
  EXPECT_EQ(*si.angle, 0.5);
  const Squeeze printed =
      table.read(Json::parse(R"({"object": "can", "width_mm": 30, "angle_deg": 90})"));
  EXPECT_EQ(printed.width, 30 * 1e-3);
  EXPECT_NEAR(*printed.angle, kPi / 2, 1e-15);
}

TEST(RequestTable, WritesWhatItReadsToTheBit) {
  const RequestTable<Squeeze> table = squeeze_table();
  Squeeze squeeze;
  squeeze.object = "can";
  squeeze.grip = Grip::kPalm;
  squeeze.width = 0.1 / 3;
  squeeze.force = {{"FDP", 1.0 / 7}, {"EDC", kInfinity}};
  squeeze.twice = true;
  const OrderedJson written = table.write(squeeze);
  EXPECT_EQ(json_text(written, -1),
            R"({"object":"can","grip":"palm","width_m":0.03333333333333333,)"
            R"("force_N":{"EDC":"inf","FDP":0.14285714285714285},"count":3,"twice":true})");
  const Squeeze read = table.read(Json::parse(json_text(written, -1)));
  EXPECT_EQ(read.width, squeeze.width);
  EXPECT_EQ(read.force, squeeze.force);
  EXPECT_EQ(read.grip, squeeze.grip);
  EXPECT_TRUE(read.twice);
}

TEST(RequestTable, SaysWhatIsWrongInTheUnitThatCame) {
  EXPECT_EQ(refusal(R"({"object": "can", "width_mm": 200})"),
            "width_mm: wanted a number from 0 to 100 [mm], got 200");
  EXPECT_EQ(refusal(R"({"object": "can", "width_m": 200})"),
            "width_m: wanted a number from 0 to 0.1 [m], got 200");
  EXPECT_EQ(refusal(R"({"object": "can", "width_m": 0.1, "width_mm": 30})"),
            "'width' is given twice, in two units");
  EXPECT_EQ(refusal(R"({"width_m": 0.1})"), "'object' is missing: Which.");
  EXPECT_EQ(refusal(R"({"object": "can", "grip": "tipp"})"),
            "grip: wanted one of palm, tip, got \"tipp\"");
  EXPECT_EQ(refusal(R"({"object": "can", "with_m": 0.1})").substr(0, 46),
            "no parameter 'with_m', did you mean 'width_m'?");
}

TEST(RequestTable, NamesTheFieldThatIsWrong) {
  try {
    (void)squeeze_table().read(Json::parse(R"({"object": "can", "width_mm": -1})"));
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.field(), "width");
  }
}

TEST(RequestTable, ReadsAndWritesListsOfWords) {
  const RequestTable<Squeeze> table = squeeze_table();
  const Squeeze read =
      table.read(Json::parse(R"({"object": "can", "next": ["tip", "palm", "tip"]})"));
  EXPECT_EQ(read.next, (std::vector<Grip>{Grip::kTip, Grip::kPalm, Grip::kTip}));
  EXPECT_EQ(table.write(read)["next"], OrderedJson::parse(R"(["tip", "palm", "tip"])"));
  EXPECT_FALSE(table.write(Squeeze()).contains("next"));
  EXPECT_EQ(refusal(R"({"object": "can", "next": ["tpi"]})"),
            "no grip 'tpi', did you mean 'tip'? there are palm, tip");
}

TEST(RequestTable, IsASchemaInSi) {
  const OrderedJson schema =
      json_schema(schema_of(squeeze_table().params(), ParamScope::kAnywhere));
  EXPECT_EQ(schema["properties"]["width_m"]["x-unit"], "m");
  EXPECT_EQ(schema["properties"]["width_m"]["maximum"], 0.1);
  EXPECT_EQ(schema["required"], OrderedJson::array({"object"}));
}

}  // namespace
}  // namespace thenar
