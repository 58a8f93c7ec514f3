// Tests for report/picture/color_ramp.cpp.

#include "report/picture/color_ramp.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/file_io.h"
#include "tests/data_folder.h"

namespace thenar {
namespace {

// The scale below a picture is drawn by the browser: the same stops, in the same order.
TEST(ColorRamp, HasTheStopsOfTheViewer) {
  const std::string script = read_file(kData + "/../viewer/picture/color_scale.js", 1'000'000);
  const std::size_t from = script.find("const STOPS"), to = script.find(';', from);
  std::vector<MeshColor> stops;
  for (std::size_t at = script.find('#', from); at < to; at = script.find('#', at + 1))
    stops.push_back(color_of_hex(script.substr(at, 7)));
  ASSERT_EQ(stops.size(), 7U);
  for (std::size_t i = 0; i < stops.size(); ++i)
    EXPECT_EQ(ramp_color(static_cast<double>(i) / 6), stops[i]) << i;
}

TEST(ColorRamp, MixesBetweenAndStaysBeyond) {
  // Half way from #4c02a1 to #7e03a8: (0x4c + 0x7e) / 2 = 0x65, 2.5 and 164.5 rounded up.
  EXPECT_EQ(ramp_color(1.0 / 12), MeshColor(0x65, 3, 165));
  EXPECT_EQ(ramp_color(-1), ramp_color(0));
  EXPECT_EQ(ramp_color(2), ramp_color(1));
}

TEST(ColorRamp, LeavesZeroInTheColourOfNone) {
  const MeshColor none(1, 2, 3);
  const std::vector<MeshColor> colors = ramp_colors(Eigen::Vector3d(0, 2, 4), 4, none);
  EXPECT_EQ(colors[0], none);
  EXPECT_EQ(colors[1], ramp_color(0.5));
  EXPECT_EQ(colors[2], ramp_color(1));
  EXPECT_EQ(ramp_colors(Eigen::Vector3d(0, 0, 0), 0, none)[1], none);
}

TEST(ColorRamp, RefusesWhatIsNoColour) {
  for (const char* text : {"", "red", "#12345", "#12345g", "1234567"})
    EXPECT_THROW((void)color_of_hex(text), InputError) << text;
}

}  // namespace
}  // namespace thenar
