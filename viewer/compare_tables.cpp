#include "viewer/compare_tables.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include <fmt/format.h>

namespace thenar {
namespace {

using Cells = std::vector<const HandOnObject*>;

Cells cells_of(const Comparison& comparison, const std::string& hand) {
  Cells cells;
  for (const HandOnObject& cell : comparison.cells)
    if (cell.hand == hand) cells.push_back(&cell);
  return cells;
}

const HandOnObject* cell_of(const Comparison& comparison, const std::string& hand,
                            const std::string& object) {
  for (const HandOnObject& cell : comparison.cells)
    if (cell.hand == hand && cell.object == object) return &cell;
  return nullptr;
}

/// A number as the page has it; none of what is not finite.
Json finite(double value) { return std::isfinite(value) ? Json(value) : Json(); }

double best_margin(const HandOnObject& cell, const std::string& task) {
  double best = NAN;
  for (const BestGrasp& grasp : cell.best) {
    const auto found = grasp.margin.find(task);
    if (found != grasp.margin.end() && !(best >= found->second)) best = found->second;
  }
  return best;
}

/// Of the finite numbers among some; NaN of none.
double median(std::vector<double> values) {
  values.erase(std::remove_if(values.begin(), values.end(),
                              [](double value) { return !std::isfinite(value); }),
               values.end());
  if (values.empty()) return NAN;
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

const HandAbilities* abilities_of(const Comparison& comparison, const std::string& hand) {
  for (const HandAbilities& each : comparison.abilities)
    if (each.hand == hand) return &each;
  return nullptr;
}

Json glance_row(const Comparison& comparison, const std::string& hand) {
  std::vector<double> best;
  int closures = 0, approaches = 0, held = 0;
  for (const HandOnObject* cell : cells_of(comparison, hand)) {
    closures += cell->closures;
    approaches += cell->approaches;
    held += cell->closures > 0 ? 1 : 0;
    best.push_back(cell->best.empty() ? NAN : cell->best.front().epsilon);
  }
  const HandAbilities* abilities = abilities_of(comparison, hand);
  return {hand,
          approaches > 0 ? Json(100.0 * closures / approaches) : Json(),
          held,
          finite(median(best)),
          abilities == nullptr ? Json() : finite(abilities->opposition),
          abilities == nullptr ? Json() : Json(abilities->types.size())};
}

Json banner(const Comparison& comparison) {
  const std::string title =
      comparison.complete
          ? fmt::format("{} hands on {} objects, {} approaches each", comparison.hands.size(),
                        comparison.objects.size(), comparison.approaches)
          : fmt::format("Not finished: {} of {} cells", comparison.cells.size(),
                        comparison.hands.size() * comparison.objects.size());
  return {{"type", "banner"}, {"ok", comparison.complete}, {"title", title}};
}

/// Hands down, objects across.
Json matrix(const Comparison& comparison, const std::string& caption, int digits,
            const std::function<Json(const HandOnObject&)>& value) {
  std::vector<Column> columns{{"hand", "", -1}};
  for (const std::string& object : comparison.objects) columns.push_back({object, "", digits});
  Json rows = Json::array();
  for (const std::string& hand : comparison.hands) {
    Json row = Json::array({hand});
    for (const std::string& object : comparison.objects) {
      const HandOnObject* cell = cell_of(comparison, hand, object);
      row.push_back(cell == nullptr ? Json() : value(*cell));
    }
    rows.push_back(std::move(row));
  }
  return table_block(caption, columns, rows);
}

Json success_row(const HandOnObject& cell, const std::vector<std::string>& tasks) {
  Json row = Json::array({cell.hand, cell.object, 100 * cell.success, 100 * cell.interval.lower,
                          100 * cell.interval.upper, finite(cell.quantile(0.5)),
                          cell.best.empty() ? Json() : finite(cell.best.front().epsilon),
                          cell.best.empty() ? Json() : finite(cell.best.front().hold)});
  for (const std::string& task : tasks)
    if (task != "force-closure") row.push_back(finite(best_margin(cell, task)));
  return row;
}

Json all_cells(const Comparison& comparison) {
  std::vector<Column> columns{{"hand", "", -1},        {"object", "", -1},
                              {"closed", "%", 0},      {"from", "%", 0},
                              {"to", "%", 0},          {"median epsilon", "", 3},
                              {"best epsilon", "", 3}, {"squeeze to hold", "N", 2}};
  for (const std::string& task : comparison.tasks)
    if (task != "force-closure")
      columns.push_back({task,
                         task == "hold-weight" ? "weights"
                         : task == "pull"      ? "N"
                                               : "N m",
                         -1});
  Json rows = Json::array();
  for (const HandOnObject& cell : comparison.cells)
    rows.push_back(success_row(cell, comparison.tasks));
  Json table = table_block(
      "Every hand on every object. From, to: 95 % interval of the share. Squeeze: least sum of "
      "normal forces by which friction alone holds the weight, of the best grasp. Other loads: "
      "the largest that the hand's own actuators withstand.",
      columns, rows);
  table["search"] = true;
  return table;
}

Json quantile_row(const HandOnObject& cell) {
  const double middle = cell.quantile(0.5);
  if (!std::isfinite(middle))
    return {{"name", cell.hand}, {"estimate", Json()}, {"low", Json()},
            {"high", Json()},    {"null", true},       {"display", "no force closure"}};
  return {{"name", cell.hand},
          {"estimate", middle},
          {"low", cell.quantile(0)},
          {"high", cell.quantile(1)},
          {"inner_low", cell.quantile(0.25)},
          {"inner_high", cell.quantile(0.75)},
          {"display", fmt::format("{:.3f} of {}", middle, cell.closures)}};
}

Json digit_rows(const Comparison& comparison) {
  Json rows = Json::array();
  for (const HandAbilities& hand : comparison.abilities)
    for (const DigitAbility& digit : hand.digits)
      rows.push_back({hand.hand, digit.digit, digit.dimension,
                      digit.dimension == 3 ? finite(1e6 * digit.workspace) : Json(),
                      digit.dimension == 3 ? finite(1e6 * digit.workspace_error) : Json(),
                      finite(digit.closing_force), finite(digit.largest_force)});
  return rows;
}

Json ability_rows(const Comparison& comparison) {
  Json rows = Json::array();
  for (const HandAbilities& hand : comparison.abilities) {
    double strongest = NAN;
    for (const DigitAbility& digit : hand.digits)
      strongest = std::fmax(strongest, digit.largest_force);
    rows.push_back({hand.hand, 1000 * hand.reach, finite(hand.opposition), hand.opposition_scale,
                    hand.reached.size(), 1e6 * hand.overlap, finite(strongest), hand.types.size()});
  }
  return rows;
}

Json type_rows(const Comparison& comparison) {
  Json rows = Json::array();
  for (const HandAbilities& hand : comparison.abilities) {
    std::map<std::string, int> counts;
    for (const HandOnObject* cell : cells_of(comparison, hand.hand))
      for (const auto& [type, count] : cell->types) counts[type] += count;
    for (const auto& [type, count] : counts) rows.push_back({hand.hand, type, count});
  }
  return rows;
}

}  // namespace

Json glance_section(const Comparison& comparison) {
  Json rows = Json::array();
  for (const std::string& hand : comparison.hands) rows.push_back(glance_row(comparison, hand));
  Json table = table_block("Over all objects.",
                           {{"hand", "", -1},
                            {"force closure", "%", 1},
                            {"objects held", "", 0},
                            {"median of best epsilon", "", 3},
                            {"opposition", "of 10", 1},
                            {"types of grasp", "", 0}},
                           rows);
  table["highlight_best"] = 1;
  table["best"] = "highest";
  return section("glance", "At a glance",
                 "Every hand went at every object in the same drawn directions, closed until it "
                 "could close no farther, and its contacts were measured.",
                 Json::array({banner(comparison), table}));
}

Json cells_section(const Comparison& comparison) {
  const auto success = [](const HandOnObject& cell) { return Json(100 * cell.success); };
  const auto best = [](const HandOnObject& cell) {
    return cell.best.empty() ? Json() : finite(cell.best.front().epsilon);
  };
  return section(
      "grasps", "Hands by objects", "",
      Json::array({matrix(comparison, "Approaches that end in force closure [%].", 0, success),
                   matrix(comparison, "Largest epsilon reached; n/a: no force closure.", 3, best),
                   all_cells(comparison)}));
}

Json distribution_section(const Comparison& comparison) {
  Json blocks = Json::array();
  for (const std::string& object : comparison.objects) {
    Json rows = Json::array();
    for (const std::string& hand : comparison.hands)
      if (const HandOnObject* cell = cell_of(comparison, hand, object); cell != nullptr)
        rows.push_back(quantile_row(*cell));
    blocks.push_back({{"type", "interval"},
                      {"caption", "On " + object + "."},
                      {"x_label", "epsilon [1]"},
                      {"rows", rows}});
  }
  Json pairs = Json::array();
  for (std::size_t i = 0; i < blocks.size(); i += 2) {
    Json pair = Json::array({blocks[i]});
    if (i + 1 < blocks.size()) pair.push_back(blocks[i + 1]);
    pairs.push_back(row_block(std::move(pair)));
  }
  return section("quality", "How good the grasps are",
                 "Of the grasps with force closure: median, middle half (thick) and the whole "
                 "range of epsilon. At the right the median and how many there are.",
                 pairs);
}

Json abilities_section(const Comparison& comparison) {
  Json blocks = Json::array();
  blocks.push_back(table_block("What each hand can do without an object.",
                               {{"hand", "", -1},
                                {"reach", "mm", 0},
                                {"opposition", "of 10", 1},
                                {"scale", "", -1},
                                {"places met", "", 0},
                                {"shared workspace", "cm\u00b3", 1},
                                {"strongest tip", "N", 1},
                                {"types of grasp", "", 0}},
                               ability_rows(comparison)));
  blocks.push_back(
      table_block("Digits. Workspaces of tips that move in a plane or on a curve have "
                  "no volume.",
                  {{"hand", "", -1},
                   {"digit", "", -1},
                   {"dimension", "", 0},
                   {"workspace", "cm\u00b3", 1},
                   {"error", "cm\u00b3", 1},
                   {"force in closing", "N", 1},
                   {"largest force", "N", 1}},
                  digit_rows(comparison)));
  const Json types = type_rows(comparison);
  if (!types.empty())
    blocks.push_back(table_block("Types of the grasps with force closure, over all objects.",
                                 {{"hand", "", -1}, {"type", "", -1}, {"grasps", "", 0}}, types));
  return section("abilities", "What the hands can do", "", blocks);
}

Json reading_section(const Comparison& comparison) {
  std::string text =
      "Force closure: whatever the disturbance, some contact forces within friction balance it. "
      "Epsilon: the largest disturbance that is balanced from whatever direction, in units of the "
      "contacts' own forces (their normal forces sum up to 1), torques divided by the object's "
      "reach; 0 is the edge of slipping. A larger object, softer pads or more contacts raise it; "
      "the strength of the hand does not. That is in the loads: there the actuators' limits "
      "count.\n\nWhere n/a stands nothing was measured, or an effort is unknown. Approaches are "
      "random: shares have the interval that is given with them, and the best of few approaches "
      "is not the best there is.";
  text += fmt::format(
      "\n\nSeed {}, {} approaches, objects {}.", comparison.seed, comparison.approaches,
      comparison.normalise_size ? "scaled with the reach of the hand" : "in their own size");
  Json blocks = Json::array();
  if (!comparison.warnings.empty()) {
    Json rows = Json::array();
    for (const std::string& warning : comparison.warnings) rows.push_back(Json::array({warning}));
    blocks.push_back(table_block("Warnings.", {{"warning", "", -1}}, rows));
  }
  return section("reading", "How to read this", text, blocks);
}

}  // namespace thenar
