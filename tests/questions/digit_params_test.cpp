// Tests for questions/digit_params.cpp: postures and what varies, in either unit.

#include "questions/digit_params.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

DigitRequest digit_from(const std::string& json) {
  return linear_digit_params().read(Json::parse(json));
}

TEST(DigitParams, PosturesAreByNameOrInOrder) {
  const DigitRequest named =
      digit_from(R"({"subject": "an_chao_index", "posture_deg": {"PIP2": 30}})");
  EXPECT_EQ(named.posture.unit, PostureUnit::kTyped);
  EXPECT_EQ(named.posture.named, (std::map<std::string, double>{{"PIP2", 30}}));
  EXPECT_TRUE(named.posture.in_order.empty());
  const DigitRequest listed =
      digit_from(R"({"subject": "an_chao_index", "posture_rad": [0.1, 0, 0.3]})");
  EXPECT_EQ(listed.posture.unit, PostureUnit::kSI);
  EXPECT_EQ(listed.posture.in_order, (std::vector<double>{0.1, 0, 0.3}));
  EXPECT_TRUE(digit_from(R"({"subject": "an_chao_index"})").posture.empty());
}

// The second unit would replace the first without a word.
TEST(DigitParams, RefuseOnePostureInTwoUnits) {
  const auto refusal = [](const std::string& postures) {
    return message_of(
        [&] { (void)digit_from(R"({"subject": "an_chao_index", )" + postures + "}"); });
  };
  EXPECT_EQ(refusal(R"("posture_deg": {"PIP2": 30}, "posture_rad": {"DIP2": 0.1})"),
            "'posture' is given twice, in two units");
  EXPECT_EQ(refusal(R"("posture_rad": [0.1, 0, 0.3], "posture_deg": [1, 2, 3])"),
            "'posture' is given twice, in two units");
  EXPECT_EQ(refusal(R"("frozen_deg": {"PIP2": 30}, "frozen_rad": {"PIP2": 0.1})"),
            "'frozen' is given twice, in two units");
  const std::string grid = R"([{"joint": "PIP2", "from": 0, "to": 1, "step": 1}])";
  EXPECT_EQ(refusal("\"vary_deg\": " + grid + ", \"vary_rad\": " + grid),
            "'vary' is given twice, in two units");
}

// A request is written in the unit in which it came, and read again as it was.
TEST(DigitParams, WritesThePostureInItsOwnUnit) {
  const std::string text =
      R"({"subject": "an_chao_index", "posture_deg": {"PIP2": 30},
          "vary_deg": [{"joint": "DIP2", "from": 0, "to": 20, "step": 5}]})";
  const OrderedJson written = linear_digit_params().write(digit_from(text));
  EXPECT_TRUE(written.contains("posture_deg"));
  EXPECT_FALSE(written.contains("posture_rad"));
  EXPECT_TRUE(written.contains("vary_deg"));
  const DigitRequest again = linear_digit_params().read(Json::parse(json_text(written, -1)));
  EXPECT_EQ(again.posture.named.at("PIP2"), 30);
  ASSERT_EQ(again.vary.size(), 1U);
  EXPECT_EQ(again.vary[0].joint, "DIP2");
  EXPECT_EQ(again.vary[0].to, 20);
  EXPECT_EQ(again.vary[0].step, 5);
}

TEST(DigitParams, RefusesTwoUnitsAtOnce) {
  EXPECT_EQ(message_of([] {
              (void)digit_from(R"({"subject": "an_chao_index", "posture_deg": {"PIP2": 30},
                  "vary_rad": [{"joint": "DIP2", "from": 0, "to": 1, "step": 0.5}]})");
            }),
            "wanted a posture and what varies in one unit");
}

// What varies needs all of its members.
TEST(DigitParams, RefusesAGridWithoutAStep) {
  const std::string message = message_of([] {
    (void)digit_from(R"({"subject": "an_chao_index",
        "vary_deg": [{"joint": "DIP2", "from": 0, "to": 20}]})");
  });
  EXPECT_NE(message.find("step"), std::string::npos) << message;
}

// Tip maps are of linear tendons alone, nets of tendons alone.
TEST(DigitParams, MapsAndNetsExcludeEachOther) {
  EXPECT_EQ(digit_from(R"({"subject": "an_chao_index", "map": "a_map"})").map, "a_map");
  const std::string net =
      message_of([] { (void)digit_from(R"({"subject": "an_chao_index", "net": "chao_an"})"); });
  EXPECT_EQ(net.find("no parameter 'net'"), 0U) << net;
  const std::string map = message_of([] {
    (void)tendon_params("net").read(Json::parse(R"({"subject": "an_chao_index", "map": "a_map"})"));
  });
  EXPECT_EQ(map.find("no parameter 'map'"), 0U) << map;
}

}  // namespace
}  // namespace thenar
