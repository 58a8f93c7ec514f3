#include "apps/compare_print.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "apps/compare_file.h"
#include "report/answers/comparison.h"
#include "report/table.h"

namespace thenar {
namespace {

/// A number, or that it is not known.
template <typename... Digits>
std::string known(double value, Digits... digits) {
  return std::isnan(value) ? "-" : shown(value, digits...);
}

std::vector<GraspTask> loads_of(const Comparison& comparison) {
  std::vector<GraspTask> loads;
  for (const std::string& task : comparison.tasks)
    if (grasp_task(task) != GraspTask::kForceClosure) loads.push_back(grasp_task(task));
  return loads;
}

std::vector<std::string> cell_row(const HandOnObject& cell, const std::vector<GraspTask>& loads) {
  std::vector<std::string> row{cell.hand,
                               cell.object,
                               shown(100 * cell.success, 0),
                               shown(100 * cell.interval.lower, 0),
                               shown(100 * cell.interval.upper, 0),
                               known(cell.quantile(0.5), 3),
                               known(cell.quantile(1), 3),
                               known(cell.best_hand_epsilon().max),
                               known(cell.min_grasp_force())};
  for (const GraspTask task : loads) row.push_back(known(cell.load(task).max));
  return row;
}

Table cell_table(const Comparison& comparison) {
  Table table{{"hand", "object", "closed_percent", "from", "to", "epsilon_median", "epsilon_best",
               "hand_epsilon_N", "squeeze_N"},
              {}};
  const std::vector<GraspTask> loads = loads_of(comparison);
  for (const GraspTask task : loads) table.header.push_back(load_key(task));
  for (const HandOnObject& cell : comparison.cells) table.rows.push_back(cell_row(cell, loads));
  // Seldom needed: a column only where there is something to tell.
  std::vector<std::string> unknown;
  for (const HandOnObject& cell : comparison.cells)
    unknown.push_back(unknown_words(cell, comparison.tasks));
  if (std::all_of(unknown.begin(), unknown.end(), [](const auto& each) { return each.empty(); }))
    return table;
  table.header.emplace_back("not_known");
  for (std::size_t i = 0; i < unknown.size(); ++i) table.rows[i].push_back(unknown[i]);
  return table;
}

Table outcome_table(const Comparison& comparison) {
  Table table{{"hand", "object", "approaches"}, {}};
  for (const HandOnObject& cell : comparison.cells)
    if (cell.closures == 0) table.rows.push_back({cell.hand, cell.object, outcome_words(cell)});
  return table;
}

Table hand_table(const Comparison& comparison) {
  // Two scales, two columns: Kapandji's places of a human thumb, and tips that any thumb meets.
  Table table{{"hand", "kapandji_of_10", "tips_met_percent", "met", "overlap_cm3", "grasp_types",
               "closing_force_N"},
              {}};
  for (const HandAbilities& hand : comparison.abilities) {
    double force = NAN;
    for (const DigitAbility& digit : hand.digits) force = std::fmax(force, digit.closing_force);
    const bool places = is_kapandji(hand);
    table.rows.push_back({hand.hand, places ? known(hand.opposition, 1) : "-",
                          places ? "-" : known(10 * hand.opposition, 0),
                          std::to_string(hand.reached.size()),
                          shown(1e6 * in_two_digits(hand.overlap), 0),
                          std::to_string(hand.types.size()), known(force)});
  }
  return table;
}

}  // namespace

void print_comparison(const Comparison& comparison) {
  fmt::print("{}", titled("Grasps: share with force closure, its 95 % interval, and loads",
                          cell_table(comparison)));
  fmt::print("{}\n", load_rule());
  fmt::print(
      "-: nothing closed, or not known. 0: nothing is borne, why is in the page and in "
      "JSON.\ninf: stops or drives that hold bear it.\n\n");
  fmt::print("{}",
             titled("Where nothing closed: how the approaches ended", outcome_table(comparison)));
  fmt::print("{}", titled("Hands by themselves; closing_force: of the strongest tip",
                          hand_table(comparison)));
  for (const std::string& warning : comparison.warnings) fmt::print("warning: {}\n", warning);
}

}  // namespace thenar
