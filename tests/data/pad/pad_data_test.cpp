// Tests for data/io/pad/pad_data.cpp and pad_toml.cpp.

#include "data/io/pad/pad_data.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "data/io/pad/pad.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::HasSubstr;

// [[constant]] stands on line 6, [[press]] on line 9, its data on line 13.
const std::string kPressedPad = R"(title = "Presses"
pad = "index_pad"
source = "Me"
[sources]
Me = "Own measurement"
[[constant]]
constant = "shear_modulus"
prior_factor = 2
[[press]]
name = "wall"
object = "plane"
imposed = "force"
[[press.data]]
force_N = [0.5, 2]
indentation_mm = [1.2, 2.1]
sd_indentation_mm = [0.1, 0.2]
)";
const std::string kParts = R"([[press.data]]
force_N = [1]
part_of = "area"
part = [0.6]
sd_part = [0.05]
at_force_N = 5
)";

std::string complaint_of(const std::string& text) {
  return message_of<DataError>([&] { (void)parse_pad_data(text, "data.toml"); });
}
std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST(PadData, IsReadInSi) {
  const PadData data = parse_pad_data(kPressedPad + kParts, "data.toml");
  EXPECT_EQ(data.pad, "index_pad");
  ASSERT_EQ(data.constants.size(), 1U);
  EXPECT_EQ(data.constants[0].layer, 0);
  EXPECT_EQ(data.constants[0].prior_factor, 2);
  ASSERT_EQ(data.presses.size(), 1U);
  const PadDataPress& press = data.presses[0];
  EXPECT_TRUE(press.by_force);
  EXPECT_EQ(press.ramp, 0);
  ASSERT_EQ(press.rows.size(), 2U);
  EXPECT_THAT(press.rows[0].loads, ElementsAre(0.5, 2));
  EXPECT_THAT(press.rows[0].values,
              ElementsAre(DoubleNear(1.2e-3, 1e-17), DoubleNear(2.1e-3, 1e-17)));
  EXPECT_THAT(press.rows[0].sds, ElementsAre(DoubleNear(1e-4, 1e-18), DoubleNear(2e-4, 1e-18)));
  EXPECT_EQ(press.rows[0].source, "Me");
  EXPECT_EQ(press.rows[1].quantity, "area");
  EXPECT_EQ(press.rows[1].part_at, 5);
  EXPECT_THAT(press.rows[1].values, ElementsAre(0.6));
}

TEST(PadData, PacesAndObjectsAreRead) {
  const std::string ball = replaced(kPressedPad, "object = \"plane\"",
                                    "object = \"sphere\"\nradius_mm = 6\nangle_deg = 30\n"
                                    "pace = \"ramp\"\nramp_s = 0.5");
  const PadDataPress press = parse_pad_data(ball, "data.toml").presses[0];
  EXPECT_NEAR(press.radius, 6e-3, 1e-18);
  EXPECT_NEAR(press.angle, std::acos(-1.0) / 6, 1e-15);
  EXPECT_EQ(press.ramp, 0.5);
  const std::string slow = replaced(kPressedPad, "imposed", "pace = \"relaxed\"\nimposed");
  EXPECT_TRUE(std::isinf(parse_pad_data(slow, "data.toml").presses[0].ramp));
}

TEST(PadData, ErrorsNameTheirLine) {
  const auto with = [](const std::string& from, const std::string& to) {
    return complaint_of(replaced(kPressedPad, from, to));
  };
  EXPECT_EQ(with("prior_factor = 2", "prior_factor = 1"),
            "data.toml:8: wanted 'prior_factor' above 1, got 1");
  EXPECT_EQ(with("indentation_mm = [1.2, 2.1]", "indentation_mm = [1.2]"),
            "data.toml:15: wanted 2 numbers in 'indentation_mm', got 1");
  EXPECT_THAT(with("[0.1, 0.2]", "[0.1, 0]"), HasSubstr("data.toml:16: "));
  EXPECT_THAT(with("[0.5, 2]", "[0.5, -2]"), HasSubstr("data.toml:14: "));
  EXPECT_THAT(with("[0.5, 2]", "[0.5, nan]"), HasSubstr("data.toml:14: "));
  EXPECT_THAT(with("[0.5, 2]", "[]"), HasSubstr("data.toml:14: "));
  EXPECT_THAT(with("sd_indentation_mm = [0.1, 0.2]", ""),
              HasSubstr("data.toml:13: a [[press.data]] needs what was measured with its sd"));
  EXPECT_THAT(with("imposed = \"force\"", "imposed = \"heat\""), HasSubstr("data.toml:12: "));
  EXPECT_THAT(with("object = \"plane\"", "object = \"plane\"\nradius_mm = 3"),
              HasSubstr("unknown key 'radius_mm'"));
  EXPECT_THAT(with("shear_modulus", "thickness"), HasSubstr("wanted the 'layer' of skin"));
  EXPECT_THAT(complaint_of("title = \"x\"\npad = \"y\"\n"),
              HasSubstr("a fit needs a [[constant]] that is free"));
  EXPECT_THAT(complaint_of(kPressedPad + replaced(kParts, "force_N = [1]", "force_N = [5]")),
              HasSubstr("cannot be among the loads"));
  // Indentations cannot be imposed and measured.
  EXPECT_THAT(complaint_of(replaced(
                  replaced(kPressedPad, "imposed = \"force\"", "imposed = \"indentation\""),
                  "force_N = [0.5, 2]\n", "")),
              HasSubstr("indentation is imposed in this press"));
}

TEST(PadText, ReadsBack) {
  PadSpec pad;
  pad.name = "mine";
  pad.length = 23.7e-3;
  pad.width = 16e-3;
  pad.height = 10e-3;
  pad.bone_length = 14e-3;
  pad.bone_width = 7e-3;
  pad.bone_height = 4.5e-3;
  pad.shape_source = "Me";
  pad.shape_assumed = {"length_m", "bone_height_mm"};
  pad.pulp.law = "veronda-westmann";
  pad.pulp.shear_modulus = 903.9;
  pad.pulp.exponent = 2.7;
  pad.pulp.poisson_ratio = 0.499;
  pad.pulp.relaxation_share = {0.3};
  pad.pulp.relaxation_time = {0.07};
  pad.pulp.source = "Me";
  pad.layers.push_back(pad.pulp);
  pad.layers[0].thickness = 0.15e-3;
  pad.own_sources = {{"Me", "Own measurement"}};
  const std::string text = pad_toml(pad, "Two\nlines");
  EXPECT_EQ(text.rfind("# Two\n# lines\n", 0), 0U);
  const PadSpec back = parse_pad(text, "pad.toml");
  EXPECT_NEAR(back.length, pad.length, 1e-17);
  EXPECT_NEAR(back.pulp.shear_modulus, 903.9, 1e-12);
  EXPECT_EQ(back.pulp.exponent, 2.7);
  EXPECT_THAT(back.pulp.relaxation_time, ElementsAre(0.07));
  EXPECT_THAT(back.shape_assumed, ElementsAre("length_mm", "bone_height_mm"));
  ASSERT_EQ(back.layers.size(), 1U);
  EXPECT_NEAR(back.layers[0].thickness, 0.15e-3, 1e-18);
  EXPECT_EQ(back.own_sources, pad.own_sources);
  EXPECT_EQ(pad_toml(back, "Two\nlines"), text);
}

}  // namespace
}  // namespace thenar
