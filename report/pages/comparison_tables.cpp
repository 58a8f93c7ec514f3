#include "report/pages/comparison_tables.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "data/io/robot/import_robot.h"
#include "grasp/compare/closure_counts.h"
#include "report/answers/comparison.h"
#include "sampling/diagnostics/order_statistics.h"

namespace thenar {
namespace {

using Cells = std::vector<const HandOnObject*>;

Cells cells_of(const Comparison& comparison, const std::string& hand) {
  Cells cells;
  for (const HandOnObject& cell : comparison.cells)
    if (cell.hand == hand) cells.push_back(&cell);
  return cells;
}

/// A load, which may be borne without limit.
Json load(double value) { return std::isinf(value) ? Json("no limit") : number_or_null(value); }

/// Computes the median of the finite values; NaN if there are none.
double median(std::vector<double> values) {
  erase_where(values, [](double value) { return !std::isfinite(value); });
  if (values.empty()) return NAN;
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

const HandAbilities* abilities_of(const Comparison& comparison, const std::string& hand) {
  return find_where(comparison.abilities, [&](const auto& each) { return each.hand == hand; });
}

/// "22 to 78" [%].
std::string percent_words(const ConfidenceInterval& interval) {
  return fmt::format("{:.0f} to {:.0f}", 100 * interval.lower, 100 * interval.upper);
}

Json type_count(const HandAbilities& hand) {
  const std::optional<std::size_t> count = count_grasp_types(hand);
  return count ? Json(*count) : Json();
}

Json glance_row(const Comparison& comparison, const std::string& hand) {
  // Best epsilon on each object, then the median over objects.
  std::vector<double> best, limited;
  int held = 0;
  for (const HandOnObject* cell : cells_of(comparison, hand)) {
    held += cell->closures > 0 ? 1 : 0;
    best.push_back(cell->quantile(1));
    limited.push_back(cell->best_hand_epsilon().max);
  }
  const HandAbilities* abilities = abilities_of(comparison, hand);
  // Pool the approaches to all objects for the share of closures and its interval.
  const ClosureCount count = count_closures(comparison, hand);
  return {hand,
          count.approaches > 0 ? Json(100 * count.success_rate()) : Json(),
          count.approaches > 0 ? Json(percent_words(count.interval())) : Json(),
          held,
          number_or_null(median(best)),
          number_or_null(median(limited)),
          abilities == nullptr ? Json() : type_count(*abilities)};
}

Json banner(const Comparison& comparison) {
  const std::string title =
      comparison.complete
          ? fmt::format("{} hands on {} objects, {} approaches each", comparison.hands.size(),
                        comparison.objects.size(), comparison.approaches)
          : fmt::format("Not finished: {} of {} cells", comparison.cells.size(),
                        comparison.hands.size() * comparison.objects.size());
  std::vector<std::string> grave;
  std::copy_if(comparison.warnings.begin(), comparison.warnings.end(), std::back_inserter(grave),
               is_serious);
  return banner_block(title, grave, comparison.complete && grave.empty());
}

/// Hands down, objects across.
Json matrix(const Comparison& comparison, const std::string& caption, int digits,
            const std::function<Json(const HandOnObject&)>& value) {
  std::vector<BlockColumn> columns{"hand"};
  for (const std::string& object : comparison.objects) columns.push_back({object, "", digits});
  Json rows = Json::array();
  for (const std::string& hand : comparison.hands) {
    Json row = Json::array({hand});
    for (const std::string& object : comparison.objects) {
      const HandOnObject* cell = find_cell(comparison.cells, hand, object);
      row.push_back(cell == nullptr ? Json() : value(*cell));
    }
    rows.push_back(std::move(row));
  }
  return table_block(caption, columns, rows);
}

/// Returns two columns for each task with a load: the load by efforts, then the load with
/// structure.
std::vector<BlockColumn> load_columns(const Comparison& comparison) {
  std::vector<BlockColumn> columns;
  const auto add = [&](const std::string& name, const char* unit, int digits) {
    columns.push_back({name, unit, digits});
    columns.push_back({name + " with structure", unit, digits});
  };
  for (const std::string& name : comparison.tasks) {
    const GraspTask task = grasp_task(name);
    if (task == GraspTask::kHoldWeight) add(name, "weights", 1);
    if (task == GraspTask::kPull) add(name, "N", 2);
    if (task == GraspTask::kTurn) add(name, "N m", 3);
  }
  return columns;
}

Json success_row(const HandOnObject& cell, const std::vector<std::string>& tasks) {
  Json row = Json::array({cell.hand, cell.object, 100 * cell.success, percent_words(cell.interval),
                          number_or_null(cell.quantile(0.5)), number_or_null(cell.quantile(1)),
                          number_or_null(cell.best_hand_epsilon().max),
                          number_or_null(cell.min_grasp_force()),
                          number_or_null(cell.standing_grasp_force())});
  for (const std::string& name : tasks) {
    const GraspTask task = grasp_task(name);
    if (task == GraspTask::kForceClosure) continue;
    row.push_back(load(cell.load(task).max));
    row.push_back(load(cell.load_with_structure(task).max));
  }
  return row;
}

Json all_cells(const Comparison& comparison) {
  std::vector<BlockColumn> columns{"hand",
                                   "object",
                                   "force closure [%]:0",
                                   "95 % interval [%]",
                                   "epsilon, median:3",
                                   "epsilon, best:3",
                                   "epsilon within hand limits, best [N]:2",
                                   "grasp force, worst of 6 directions [N]:2",
                                   "grasp force, standing [N]:2"};
  const std::vector<BlockColumn> loads = load_columns(comparison);
  columns.insert(columns.end(), loads.begin(), loads.end());
  // One row for each hand on each object.
  Json rows = Json::array();
  for (const HandOnObject& cell : comparison.cells)
    rows.push_back(success_row(cell, comparison.tasks));
  return with(
      table_block(
          "Every hand on every object. Force closure: share of approaches that end in it. Epsilon "
          "of these grasps: by their contacts alone, and within hand limits: with the efforts of "
          "motors or tendons and the hand's rigid structure. Grasp force: least sum of normal "
          "forces by which friction alone holds the weight, in the worst of 6 directions of "
          "gravity (each axis of the object, both ways), and in its present orientation, z up, "
          "which is what `thenar grasp` states. Loads after it: supported by efforts and friction "
          "alone, and with the rigid structure, whose strength no source states. " +
              load_rule(),
          columns, rows),
      {{"search", true}});
}

/// Returns the outcomes of approaches, for each hand and object without a closure.
Json outcome_rows(const Comparison& comparison) {
  Json rows = Json::array();
  for (const HandOnObject& cell : comparison.cells)
    if (cell.closures == 0) rows.push_back({cell.hand, cell.object, describe_outcome(cell)});
  return rows;
}

/// Pairs with loads that are not known.
Json unknown_rows(const Comparison& comparison) {
  Json rows = Json::array();
  for (const HandOnObject& cell : comparison.cells)
    if (const std::string words = unknown_words(cell, comparison.tasks); !words.empty())
      rows.push_back({cell.hand, cell.object, words});
  return rows;
}

/// Returns the reasons why loads of the best grasps are zero or unknown, with their numbers.
Json reason_rows(const Comparison& comparison) {
  Json rows = Json::array();
  for (const std::string& hand : comparison.hands) {
    std::map<std::pair<std::string, std::string>, int> counts;
    for (const HandOnObject* cell : cells_of(comparison, hand))
      for (const BestGrasp& best : cell->best)
        for (const auto& [load, reason] : best.reasons) ++counts[{load, reason}];
    for (const auto& [why, count] : counts)
      rows.push_back({hand, why.first == "epsilon" ? "epsilon within hand limits" : why.first,
                      why.second, count});
  }
  return rows;
}

Json digit_rows(const Comparison& comparison) {
  Json rows = Json::array();
  for (const HandAbilities& hand : comparison.abilities)
    for (const DigitAbility& digit : hand.digits) {
      const double error = 1e6 * digit.workspace_error;  // [cm^3]
      const bool solid = digit.dimension == 3;
      rows.push_back({hand.hand, digit.digit, digit.dimension,
                      solid ? number_or_null(rounded_to(1e6 * digit.workspace, error)) : Json(),
                      solid ? number_or_null(rounded_to(error, error)) : Json(),
                      number_or_null(digit.closing_force), number_or_null(digit.max_tip_force)});
    }
  return rows;
}

Json ability_rows(const Comparison& comparison) {
  // Abilities belong to the hand alone, without an object.
  Json rows = Json::array();
  for (const HandAbilities& hand : comparison.abilities) {
    double strongest = NAN;
    for (const DigitAbility& digit : hand.digits)
      strongest = std::fmax(strongest, digit.closing_force);
    // Kapandji's places exist on human hands; robots count fingertips that the thumb meets.
    const bool kapandji = is_kapandji(hand);
    const std::string met = kapandji
                                ? fmt::format("{} of 10 places", hand.reached.size())
                                : fmt::format("{} of {} tips", hand.reached.size(),
                                              std::max<std::size_t>(hand.digits.size(), 1) - 1);
    rows.push_back({hand.hand, 1000 * hand.reach,
                    kapandji ? number_or_null(hand.opposition) : Json(), met,
                    number_or_null(in_two_digits(1e6 * hand.overlap)), number_or_null(strongest),
                    type_count(hand)});
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

// ---- charts

constexpr const char* kKey = "median, middle half (thick), all (thin)";

/// Returns a row of a chart that shows a reason instead of values.
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

/// Computes the end of the axis, so that a few long rows do not make the others unreadable: rows
/// that reach beyond thrice the median of all ends are cut; infinite if none is cut.
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
  return readable(with(interval_block(caption, label, std::move(rows)), {{"key", kKey}}));
}

}  // namespace

double quantile_of(const Eigen::VectorXd& ascending, double p) {
  return ascending.size() == 0 ? NAN : quantile(ascending, p);
}

Json glance_section(const Comparison& comparison) {
  // One row for each hand, over all objects.
  Json rows = Json::array();
  for (const std::string& hand : comparison.hands) rows.push_back(glance_row(comparison, hand));
  Json table = table_block(
      "Over all objects. Force closure: share of approaches whose contacts balance every small "
      "disturbance. Epsilon: the largest disturbance that they balance whatever its direction, per "
      "unit of contact force; within hand limits: the same in newtons, with the efforts of the "
      "hand's motors or tendons and its rigid structure. Both are of the best grasp of each "
      "object, and of these the median. Bold: more force closures than those of each other hand, "
      "beyond chance (Fisher's exact test, p < 0.05; intervals may overlap all the same). Types "
      "of grasp: n/a where no approach ended in a pinch, as none was offered.",
      {"hand", "force closure [%]:1", "95 % interval [%]", "objects grasped:0", "epsilon:3",
       "epsilon within hand limits [N]:2", "types of grasp:0"},
      rows);
  // Highlight a hand only if its lead is beyond chance.
  if (!hand_of_most_closures(comparison).empty()) {
    table["highlight_best"] = 1;
    table["best"] = "highest";
  }
  Json blocks = Json::array({banner(comparison), table});
  for (const std::string& line : version_lines(comparison)) blocks.push_back(text_block(line));
  return section(
      "glance", "At a glance",
      "Every hand approaches every object from the same random directions and closes until "
      "no digit can close further; then its contacts are measured. More force closures: the "
      "hand need not be aimed so well. A larger epsilon: the grasp resists more before it "
      "slips.",
      std::move(blocks));
}

Json cells_section(const Comparison& comparison) {
  // Three matrices of hands by objects: closures, epsilon by contacts, and within limits.
  const auto success = [](const HandOnObject& cell) { return Json(100 * cell.success); };
  const auto best = [](const HandOnObject& cell) { return number_or_null(cell.quantile(1)); };
  const auto limited = [](const HandOnObject& cell) {
    return number_or_null(cell.best_hand_epsilon().max);
  };
  Json blocks = Json::array(
      {matrix(comparison, "Share of approaches that end in force closure [%].", 0, success),
       matrix(comparison,
              "Epsilon of the best grasp, by its contacts alone; n/a: no force closure.", 3, best),
       matrix(comparison,
              "Epsilon of the best grasp within hand limits [N]; n/a: no force closure, "
              "or efforts unknown.",
              2, limited),
       all_cells(comparison)});
  // Explain cells without a closure, then loads that are unknown or zero.
  const Json outcomes = outcome_rows(comparison);
  if (!outcomes.empty())
    blocks.push_back(table_block("Where no approach ended in force closure: how they ended.",
                                 {"hand", "object", "approaches"}, outcomes));
  const Json unknown = unknown_rows(comparison);
  if (!unknown.empty())
    blocks.push_back(table_block(
        "Loads that are not known, of how many grasps; the numbers above are of the others.",
        {"hand", "object", "not known"}, unknown));
  const Json reasons = reason_rows(comparison);
  if (!reasons.empty())
    blocks.push_back(table_block("Why loads of the best grasps are zero or unknown.",
                                 {"hand", "load", "why", "grasps:0"}, reasons));
  return section("grasps", "Hands by objects", "", std::move(blocks));
}

Json distribution_section(const Comparison& comparison) {
  const Json pairs = list_of_each(comparison.objects, [&](const std::string& object) {
    return row_block(
        Json::array({chart(comparison, object, fmt::format("On {}: contacts alone.", object),
                           "epsilon [1]", geometric_row),
                     chart(comparison, object, fmt::format("On {}: within hand limits.", object),
                           "epsilon within hand limits [N]", limited_row)}));
  });
  return section(
      "quality", "How good the grasps are",
      "Epsilon of all grasps with force closure: by geometry and friction alone (left), and "
      "with what drives the hand (right). It is the largest disturbance that the grasp "
      "withstands whatever its direction. n counts grasps.",
      pairs);
}

Json abilities_section(const Comparison& comparison) {
  // Abilities of hands, then of each digit.
  Json blocks = Json::array();
  blocks.push_back(table_block(
      "What each hand can do without an object. Kapandji: the highest of ten places on the hand "
      "that the pad of the thumb meets. Robots have no such places: for them only the fingertips "
      "count that the thumb meets, or the digit that meets most. Workspace shared: volume that the "
      "opposing tip and any other tip reach, to two digits. Strongest tip: its force in the "
      "direction of closing, digits half bent. Types of grasp: n/a where no approach ended in a "
      "pinch.",
      {"hand", "reach [mm]:0", "Kapandji [of 10]:0", "thumb meets", "workspace shared [cm\u00b3]:0",
       "strongest tip [N]:1", "types of grasp:0"},
      ability_rows(comparison)));
  blocks.push_back(
      table_block("Digits. Workspaces of tips that move in a plane or on a curve have "
                  "no volume.",
                  {"hand", "digit", "dimension:0", "workspace [cm\u00b3]", "error [cm\u00b3]",
                   "force in closing [N]:1", "largest force [N]:1"},
                  digit_rows(comparison)));
  // Types of grasp over all objects.
  const Json types = type_rows(comparison);
  if (!types.empty())
    blocks.push_back(table_block("Types of the grasps with force closure, over all objects.",
                                 {"hand", "type", "grasps:0"}, types));
  return section("abilities", "What the hands can do", "", blocks);
}

Json reading_section(const Comparison& comparison) {
  Json blocks = Json::array();
  if (!comparison.warnings.empty()) {
    const auto row = [](const std::string& warning) { return Json::array({warning}); };
    blocks.push_back(table_block("Warnings.", {"warning"}, list_of_each(comparison.warnings, row)));
  }
  return section("reading", "How to read this", reading_words(comparison), blocks);
}

}  // namespace thenar
