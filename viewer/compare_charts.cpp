#include <cmath>

#include <fmt/format.h>

#include "viewer/compare_tables.h"

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

Json chart(const Comparison& comparison, const std::string& object, const std::string& caption,
           const std::string& label, Json (*row)(const HandOnObject&)) {
  Json rows = Json::array();
  for (const HandOnObject& cell : comparison.cells)
    if (cell.object == object) rows.push_back(row(cell));
  return {{"type", "interval"},
          {"caption", caption},
          {"x_label", label},
          {"key", kKey},
          {"rows", std::move(rows)}};
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
