// The page of a pad that was fitted to measured presses.

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "base/units.h"
#include "data/io/toml_text.h"
#include "report/blocks.h"
#include "report/pads/fit_answer.h"
#include "report/pads/press_answer.h"
#include "report/provenance.h"

namespace thenar {
namespace {

/// A measured number on a chart, with the sd of one of its coordinates.
struct ChartDatum {
  double x = 0, y = 0, sd_x = 0, sd_y = 0;
};

/// Returns the response of the fitted pad to a load of the data.
const PressPoint& point_at(const FittedCurve& curve, const PressLoad& load) {
  const double imposed = load.force.value_or(load.indentation);
  const auto found = std::find(curve.loads.begin(), curve.loads.end(), imposed);
  return curve.points.at(static_cast<std::size_t>(found - curve.loads.begin()));
}

double shown_quantity(PressQuantity quantity, const PressPoint& point) {
  return quantity == PressQuantity::kIndentation ? point.indentation / kMm
         : quantity == PressQuantity::kForce     ? point.force
                                                 : point.area / kSquareMm;
}

/// The areas of a press, or all else, on the chart where they belong. Parts are drawn of what the
/// fitted pad has at the load that they are parts at, areas at the force that it has.
std::vector<ChartDatum> chart_data(const PressRecord& record, const FittedCurve& curve,
                                   bool areas) {
  std::vector<ChartDatum> out;
  // Data that are shares of another datum are scaled by the pad's own value there.
  for (const PressDatum& datum : record.data) {
    if ((datum.quantity == PressQuantity::kArea) != areas) continue;
    const PressLoad& load = nth(record.course.loads, datum.load);
    const PressPoint& pad = point_at(curve, load);
    double scale = display_unit(datum).per_si;
    if (datum.over)
      scale =
          shown_quantity(datum.quantity, point_at(curve, nth(record.course.loads, *datum.over)));
    const double value = scale * datum.value, sd = scale * datum.sd;
    // Areas stand over force, indentations and forces over each other.
    if (areas)
      out.push_back({pad.force, value, 0, sd});
    else if (datum.quantity == PressQuantity::kIndentation)
      out.push_back({value, *load.force, sd, 0});
    else
      out.push_back({load.indentation / kMm, value, 0, sd});
  }
  return out;
}

/// The pad's curve, and the data with a bar of one sd to either side.
Json curve_chart(const std::string& caption, const std::vector<std::string>& labels,
                 Json curve_series, const std::vector<ChartDatum>& data) {
  Json series = Json::array({std::move(curve_series)});
  if (!data.empty())
    series.push_back(
        curve_of_each("measured, 1 sd", data, &ChartDatum::x, &ChartDatum::y, "points"));
  for (const ChartDatum& each : data)
    series.push_back(curve_json("measured, 1 sd",
                                {std::max(0.0, each.x - each.sd_x), each.x + each.sd_x},
                                {std::max(0.0, each.y - each.sd_y), each.y + each.sd_y}, "lines"));
  return lines_block(caption, labels[0], labels[1], std::move(series));
}

/// Force by depth and area by force of a press.
Json press_charts(const PressRecord& record, const FittedCurve& curve) {
  const auto depth = [](const PressPoint& point) { return point.indentation / kMm; };
  const auto area = [](const PressPoint& point) { return point.area / kSquareMm; };
  return row_block(
      {curve_chart(fmt::format("Force over depth, press '{}'", record.name),
                   {"depth [mm]", "force [N]"},
                   curve_of_each("fitted pad", curve.points, depth, &PressPoint::force, "lines"),
                   chart_data(record, curve, false)),
       curve_chart(fmt::format("Contact area over force, press '{}'", record.name),
                   {"force [N]", "area [mm2]"},
                   curve_of_each("fitted pad", curve.points, &PressPoint::force, area, "lines"),
                   chart_data(record, curve, true))});
}

Json data_section(const FittedPad& fitted) {
  Json blocks = Json::array();
  for (std::size_t i = 0; i < fitted.curves.size(); ++i)
    if (!fitted.curves[i].points.empty())
      blocks.push_back(press_charts(fitted.problem.records[i], fitted.curves[i]));
  blocks.push_back(table_block("Measured and predicted", data_table(fitted)));
  return section(
      "data", "The data and what the pad makes of them",
      "Bars are one stated sd. A part of a quantity at another load is drawn as that "
      "part of what the fitted pad has there, an area at the force that the fitted pad "
      "has under its load. At small forces, where few nodes touch, a curve is that of the "
      "mesh: it may begin below a depth of 0.",
      std::move(blocks));
}

/// Returns a section with the meaning of the citation keys in the data.
Json source_section(const FittedPad& fitted) {
  std::set<std::string> keys;
  for (const PressRecord& record : fitted.problem.records)
    for (const PressDatum& datum : record.data)
      for (const std::string& key : keys_in(datum.source)) keys.insert(key);
  Json rows = Json::array();
  for (const std::string& key : keys) {
    const auto own = fitted.data.own_sources.find(key);
    rows.push_back({key, own == fitted.data.own_sources.end() ? "data/sources.bib" : own->second});
  }
  return section("sources", "Sources of the data", "",
                 Json::array({table_block("What citation keys stand for", {"key", "source"},
                                          std::move(rows))}));
}

}  // namespace

Json page_of(const FittedPad& fitted) {
  // Constants and their doubts first; without estimates there is nothing else.
  const char* const title =
      fitted.outcome.stopped()          ? "The search was stopped: this is the best pad by then"
      : fitted.fit.solution.converged() ? "The search has converged"
                                        : "The search has NOT converged, which was allowed";
  Json blocks = Json::array({refusal_banner(refusal_of(fitted), fitted.outcome.warnings,
                                            "The search has NOT converged", title)});
  if (!fitted.fit.estimates.empty()) {
    blocks.push_back(table_block("Constants", table_of(fitted)));
    blocks.push_back(text_block(constants_note(fitted)));
  }
  Json sections =
      Json::array({section("constants", "The constants of the pad", "", std::move(blocks))});
  if (!fitted.fit.estimates.empty()) {
    sections.push_back(data_section(fitted));
    if (const Table together = correlation_table(fitted); !together.rows.empty())
      sections.push_back(section("correlations", "What is known only together",
                                 "Correlations of the logarithms, priors included.",
                                 Json::array({table_block("Correlations", together)})));
    sections.push_back(source_section(fitted));
  }
  return {{"title", title_of(fitted)},
          {"subtitle", conditions_of(fitted)},
          {"provenance", provenance_json(files_of(fitted))},
          {"sections", std::move(sections)}};
}

}  // namespace thenar
