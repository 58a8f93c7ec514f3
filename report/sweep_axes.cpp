#include "report/sweep_axes.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/units.h"
#include "report/blocks.h"

namespace thenar {
namespace {

constexpr double kValueRounding = 1e-9;  // Rounding of a value, in display units

std::string value_text(const SweepAxes& axes, std::size_t row, std::size_t k) {
  const double value = axes.values(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(k));
  return shown(std::abs(value) < kValueRounding ? 0 : value);
}

/// The values of the first `count` of those that vary.
std::string title_of_first(const SweepAxes& axes, std::size_t row, std::size_t count) {
  std::string text;
  for (std::size_t k = 0; k < count; ++k)
    text += fmt::format("{}{} = {} {}", k == 0 ? "" : ", ", axes.names[k], value_text(axes, row, k),
                        axes.units[k]);
  return text;
}

Json cleaned(double value) {
  return std::isfinite(value) ? Json(std::abs(value) < kValueRounding ? 0 : value) : Json();
}

}  // namespace

SweepAxes axes_of(const PostureGrid& grid, const std::vector<std::string>& joints,
                  std::size_t done) {
  SweepAxes axes;
  axes.row_length = grid.row;
  axes.values.resize(static_cast<Eigen::Index>(done),
                     static_cast<Eigen::Index>(grid.varied.size()));
  for (std::size_t k = 0; k < grid.varied.size(); ++k) {
    axes.names.push_back(nth(joints, grid.varied[k]));
    axes.units.emplace_back("deg");
    for (std::size_t i = 0; i < done; ++i)
      axes.values(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) =
          grid.postures[i][grid.varied[k]] / kDegree;
  }
  return axes;
}

std::vector<std::string> header_of(const SweepAxes& axes) {
  std::vector<std::string> header;
  for (std::size_t k = 0; k < axes.names.size(); ++k)
    header.push_back(axes.names[k] + "_" + axes.units[k]);
  return header;
}

std::vector<std::string> cells_of(const SweepAxes& axes, std::size_t row) {
  std::vector<std::string> cells;
  for (std::size_t k = 0; k < axes.names.size(); ++k) cells.push_back(value_text(axes, row, k));
  return cells;
}

std::string title_of(const SweepAxes& axes, std::size_t row) {
  return title_of_first(axes, row, axes.names.size());
}

Json curve_chart(const SweepAxes& axes, const std::string& caption, const std::string& y_label,
                 const std::vector<Curve>& curves) {
  // A line for each row of the sweep, over the angle that varies fastest.
  Json series = Json::array();
  const Eigen::Index last = axes.values.cols() - 1;
  const auto count = static_cast<std::size_t>(axes.values.rows());
  for (const Curve& curve : curves)
    for (std::size_t begin = 0; begin < count; begin += axes.row_length) {
      Json x = Json::array(), y = Json::array();
      for (std::size_t i = begin; i < std::min(begin + axes.row_length, count); ++i) {
        x.push_back(axes.values(static_cast<Eigen::Index>(i), last));
        y.push_back(cleaned(curve.y(static_cast<Eigen::Index>(i))));
      }
      const std::string family = title_of_first(axes, begin, axes.names.size() - 1);
      series.push_back(curve_json(curve.name + (family.empty() ? "" : ", " + family), x, y,
                                  axes.row_length < 2 ? "points" : "lines"));
    }
  return lines_block(caption, axes.names.back() + " [" + axes.units.back() + "]", y_label,
                     std::move(series));
}

std::vector<std::size_t> drawn_rows(std::size_t count, std::size_t most) {
  std::vector<std::size_t> rows;
  const std::size_t wanted = std::min(count, most);
  for (std::size_t k = 0; k < wanted; ++k)
    rows.push_back(wanted == 1 ? 0 : (k * (count - 1) + (wanted - 1) / 2) / (wanted - 1));
  return rows;
}

}  // namespace thenar
