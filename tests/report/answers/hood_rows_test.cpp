// Tests for report/answers/hood_rows.cpp.

#include "report/answers/hood_rows.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "kinematics_fit/hood_rows.h"
#include "report/answers/fit.h"
#include "tests/api/small_fit.h"

namespace thenar {
namespace {

using HoodRowAnswer = sample::SmallFit;

TEST_F(HoodRowAnswer, SetsANetBesideFractionsWhereSomethingIsLeftOut) {
  FitRequest request;
  request.sources = sources();
  EXPECT_EQ(hood_row_text(fit_digit(request)), "");

  // The net's own settings: none of its numbers moves.
  std::ofstream(path("cell.toml")) << "source = 'Synek2019'\n"
                                      "[[parameter]]\nmatch = 'sensor/*'\nstate = 'free'\n"
                                      "sd_deg = 0\nbetween_sd_deg = 4\n";
  request.sources.settings = path("cell.toml");
  request.sources.net = "extensor_hood";
  request.leave_out = {LeaveOut::kPosture};
  const FitResult result = fit_digit(request);
  ASSERT_TRUE(result.fractions.has_value());
  EXPECT_FALSE(result.fractions->fit.inputs.net.has_value());

  // Rows in sample and left out, in words and numbers alike.
  const OrderedJson json = json_of(hood_row_fields(result), UnitSystem::kPrinted);
  ASSERT_EQ(json["rows"].size(), 2U);
  const std::vector<std::string> muscles{"EDC", "RI", "LU", "UI"};
  const double with_net =
      hood_row_errors(result.left_out[0].experiments[0], muscles)->total.relative;
  const double with_fractions =
      hood_row_errors(result.fractions->left_out[0].experiments[0], muscles)->total.relative;
  EXPECT_NE(with_net, with_fractions);
  EXPECT_EQ(json["rows"][1]["relative_error"]["together"], with_net);
  EXPECT_EQ(json["rows"][1]["relative_error_with_fractions"]["together"], with_fractions);
  EXPECT_EQ(json["fits"][0]["hood"], "net extensor_hood");
  EXPECT_EQ(json["fits"][1]["free_coordinates_of_hood"], 0);
  const std::string text = text_of(result);
  EXPECT_NE(text.find(fmt::format("all {:.3f} / {:.3f}", with_net, with_fractions)),
            std::string::npos)
      << text;
  EXPECT_EQ(hood_row_table(result).header.size(), 2U + 2 * 5);
}

}  // namespace
}  // namespace thenar
