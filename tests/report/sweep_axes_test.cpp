// Tests for report/sweep_axes.cpp.

#include "report/sweep_axes.h"

#include <gtest/gtest.h>

#include "base/units.h"

namespace thenar {
namespace {

/// Two joints, 2 x 3 postures.
SweepAxes axes() {
  PostureGrid grid;
  grid.varied = {1, 0};
  grid.row = 3;
  for (const double a : {0, 10})
    for (const double b : {5, 6, 7}) grid.postures.emplace_back(kDegree * Eigen::Vector2d(b, a));
  return axes_of(grid, {"DIP", "PIP"}, 6);
}

TEST(SweepAxes, NameTheRow) {
  EXPECT_EQ(header_of(axes()), (std::vector<std::string>{"PIP_deg", "DIP_deg"}));
  EXPECT_EQ(cells_of(axes(), 4), (std::vector<std::string>{"10", "6"}));
  EXPECT_EQ(title_of(axes(), 0), "PIP = 0 deg, DIP = 5 deg");
}

TEST(SweepAxes, MakeAFamilyOfCurves) {
  Curve curve{"size", Eigen::VectorXd::LinSpaced(6, 0, 5)};
  curve.y(1) = 2e-12;  // rounding is shown as 0
  const Json chart = curve_chart(axes(), "c", "y", {curve});
  ASSERT_EQ(chart["series"].size(), 2u);
  EXPECT_EQ(chart["series"][1]["name"], "size, PIP = 10 deg");
  EXPECT_EQ(chart["series"][0]["y"], Json::array({0.0, 0.0, 2.0}));
  EXPECT_EQ(chart["x_label"], "DIP [deg]");
}

TEST(SweepAxes, DrawTheFirstAndTheLastRow) {
  EXPECT_EQ(drawn_rows(10, 3), (std::vector<std::size_t>{0, 5, 9}));
  EXPECT_EQ(drawn_rows(2, 5), (std::vector<std::size_t>{0, 1}));
}

}  // namespace
}  // namespace thenar
