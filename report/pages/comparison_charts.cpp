#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "report/pages/comparison_tables.h"

namespace thenar {
namespace {

constexpr const char* kKey = "median, middle half (thick), all (thin)";

/// What stands in place of a chart's row.
Json empty_row(const std::string& hand, const std::string& why) {
  return {
      {"name", hand}, {"estimate", Json()}, {"low", Json()}, {"high", Json()}, {"display", why}};
}

/// Quantiles of ascending values. @param of  how many there could be
Json quantile_row(const std::string& hand, const Eigen::VectorXd& values, int of) {
  const double middle = quantile_of(values, 0.5);
  const std::string count =
      values.size() == of ? fmt::format("{}", of) : fmt::format("{} of {}", values.size(), of);
  return {{"name", hand},
          {"estimate", middle},
          {"low", quantile_of(values, 0)},
          {"high", quantile_of(values, 1)},
          {"inner_low", quantile_of(values, 0.25)},
          {"inner_high", quantile_of(values, 0.75)},
          {"display", fmt::format("{:.3g}, n = {}", middle, count)}};
}

Json geometric_row(const HandOnObject& cell) {
  if (cell.closures == 0)
    return empty_row(cell.hand, fmt::format("no closure in {}", cell.approaches));
  return quantile_row(cell.hand, cell.epsilon, cell.closures);
}

Json limited_row(const HandOnObject& cell) {
  if (cell.closures == 0)
    return empty_row(cell.hand, fmt::format("no closure in {}", cell.approaches));
  if (cell.hand_epsilon.size() == 0) return empty_row(cell.hand, "efforts unknown");
  return quantile_row(cell.hand, cell.hand_epsilon, cell.closures);
}

/// Where the axis ends, if a few rows would stretch it so that the others could not be read: rows
/// that reach beyond thrice the median of all ends are cut; infinite: none is.
double end_of_axis(const Json& rows) {
  std::vector<double> ends;
  for (const Json& row : rows)
    if (row["high"].is_number()) ends.push_back(row["high"]);
  if (ends.empty()) return INFINITY;
  std::sort(ends.begin(), ends.end());
  const double fair = 3 * ends[ends.size() / 2];
  if (fair <= 0 || ends.back() <= fair) return INFINITY;
  return 1.1 * *(std::upper_bound(ends.begin(), ends.end(), fair) - 1);
}

/// Cuts the axis of a chart where that is needed, and says so.
Json readable(Json chart) {
  const double end = end_of_axis(chart["rows"]);
  if (std::isinf(end)) return chart;
  chart["x_most"] = end;
  chart["caption"] =
      chart["caption"].get<std::string>() + " The axis is cut: arrowheads go on beyond it.";
  return chart;
}

Json chart(const Comparison& comparison, const std::string& object, const std::string& caption,
           const std::string& label, Json (*row)(const HandOnObject&)) {
  Json rows = Json::array();
  for (const HandOnObject& cell : comparison.cells)
    if (cell.object == object) rows.push_back(row(cell));
  return readable({{"type", "interval"},
                   {"caption", caption},
                   {"x_label", label},
                   {"key", kKey},
                   {"rows", std::move(rows)}});
}

}  // namespace

Json distribution_section(const Comparison& comparison) {
  Json pairs = Json::array();
  for (const std::string& object : comparison.objects)
    pairs.push_back(row_block(Json::array(
        {chart(comparison, object, fmt::format("On {}: geometry alone.", object), "epsilon [1]",
               geometric_row),
         chart(comparison, object, fmt::format("On {}: with the hand's own efforts.", object),
               "epsilon of the hand [N]", limited_row)})));
  return section("quality", "How good the grasps are",
                 "Of the grasps with force closure: the smallest of all "
                 "disturbances that break "
                 "it, by geometry and friction alone (left) and with what "
                 "drives the hand (right). "
                 "n counts grasps.",
                 pairs);
}

}  // namespace thenar
