#include "report/answers/comparison.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "api/named/hands.h"
#include "data/io/robot/import_robot.h"
#include "grasp/compare/closure_counts.h"
#include "grasp/compare/comparison_file.h"
#include "report/words.h"

namespace thenar {
namespace {

/// Descriptions of the versions of a human hand, as build_human_hand() makes them.
constexpr std::array kVersionWords{
    EnumName{
        HumanVersion::kOrthogonalThumb,
        "hard contacts; axes of the thumb at right angles; every joint has a strength of its own"},
    EnumName{HumanVersion::kSkewedThumb,
             "hard contacts; axes of the thumb skewed as measured; every joint has a strength of "
             "its own"},
    EnumName{HumanVersion::kSoftPads,
             "soft pads, whose contacts also resist twisting; axes of the thumb skewed as "
             "measured; every joint has a strength of its own"},
    EnumName{
        HumanVersion::kTendonNet,
        "soft pads, whose contacts also resist twisting; axes of the thumb skewed as measured; "
        "tendons in place of strengths: joints share muscles through the net, and the hand closes "
        "as its flexors run in"}};

constexpr const char* kEpsilon = "epsilon";  // key in BestGrasp::reasons

constexpr std::array kOutcomeWords{
    EnumName{GraspOutcome::kGrasped, "touched without force closure"},
    EnumName{GraspOutcome::kOverlaps, "began in something"},
    EnumName{GraspOutcome::kMissed, "missed the object"},
    EnumName{GraspOutcome::kBlocked, "blocked by an obstacle"},
    EnumName{GraspOutcome::kTooLong, "did not end closing"},
    EnumName{GraspOutcome::kEmpty, "closed without touching"}};

/// Returns the reason of the first load that is unknown and has a reason.
std::string why_unknown(const HandOnObject& cell) {
  for (const BestGrasp& best : cell.best)
    for (const auto& [load, reason] : best.reasons)
      if (std::isnan(load == kEpsilon ? best.hand_epsilon : best.margin.at(load))) return reason;
  return "";
}

/// A number, or that it is not known.
template <typename... Digits>
std::string number_or_dash(double value, Digits... digits) {
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
                               number_or_dash(cell.quantile(0.5), 3),
                               number_or_dash(cell.quantile(1), 3),
                               number_or_dash(cell.best_hand_epsilon().max),
                               number_or_dash(cell.min_grasp_force())};
  for (const GraspTask task : loads) {
    row.push_back(number_or_dash(cell.load(task).max));
    row.push_back(number_or_dash(cell.load_with_structure(task).max));
  }
  return row;
}

Table cell_table(const Comparison& comparison) {
  Table table{{"hand", "object", "closed_percent", "from", "to", "epsilon_median", "epsilon_best",
               "hand_epsilon_N", "squeeze_6_ways_N"}};
  const std::vector<GraspTask> loads = loads_of(comparison);
  for (const GraspTask task : loads) {
    table.header.push_back(load_key(task));
    table.header.push_back(structure_key(task));
  }
  for (const HandOnObject& cell : comparison.cells) table.add(cell_row(cell, loads));
  // Add this column only if it has content.
  std::vector<std::string> unknown;
  for (const HandOnObject& cell : comparison.cells)
    unknown.push_back(unknown_words(cell, comparison.tasks));
  if (all_of(unknown, [](const auto& each) { return each.empty(); })) return table;
  table.header.emplace_back("not_known");
  for (std::size_t i = 0; i < unknown.size(); ++i) table.rows[i].push_back(unknown[i]);
  return table;
}

Table outcome_table(const Comparison& comparison) {
  Table table{{"hand", "object", "approaches"}};
  for (const HandOnObject& cell : comparison.cells)
    if (cell.closures == 0) table.add({cell.hand, cell.object, describe_outcome(cell)});
  return table;
}

Table hand_table(const Comparison& comparison) {
  // Two scales, two columns: Kapandji's places of a human thumb, and tips that any thumb meets.
  Table table{{"hand", "kapandji_of_10", "tips_met_percent", "met", "overlap_cm3", "grasp_types",
               "closing_force_N"}};
  for (const HandAbilities& hand : comparison.abilities) {
    double force = NAN;
    for (const DigitAbility& digit : hand.digits) force = std::fmax(force, digit.closing_force);
    const bool places = is_kapandji(hand);
    const std::optional<std::size_t> types = count_grasp_types(hand);
    table.add({hand.hand, places ? number_or_dash(hand.opposition, 1) : "-",
               places ? "-" : number_or_dash(10 * hand.opposition, 0),
               std::to_string(hand.reached.size()),
               number_or_dash(1e6 * in_two_digits(hand.overlap), 0),
               types ? std::to_string(*types) : "-", number_or_dash(force)});
  }
  return table;
}

/// Returns a sentence about the hand with the most force closures, if the difference is more than
/// chance.
std::string most_closures_words(const Comparison& comparison) {
  if (!comparison.complete || comparison.hands.size() < 2) return "";
  const std::string hand = hand_of_most_closures(comparison);
  if (hand.empty())
    return "Over all objects no hand has more force closures than each other one beyond chance "
           "(Fisher's exact\ntest, 95 %).\n\n";
  const ClosureCount count = count_closures(comparison, hand);
  return fmt::format(
      "Over all objects {} has more force closures than each other hand, beyond chance (Fisher's "
      "exact\ntest, 95 %): {} of {} approaches.\n\n",
      hand, count.closures, count.approaches);
}

/// The tree with members in the order of the file.
OrderedJson ordered(const JsonNode& node) {  // NOLINT(misc-no-recursion): as deep as the tree
  switch (node.kind) {
    case JsonKind::kNull:
      return {};
    case JsonKind::kFlag:
      return node.flag;
    case JsonKind::kNumber:
      return node.whole ? OrderedJson(static_cast<long>(node.number)) : OrderedJson(node.number);
    case JsonKind::kText:
      return node.text;
    case JsonKind::kArray:
    case JsonKind::kObject:
      break;
  }
  const bool list = node.kind == JsonKind::kArray;
  OrderedJson json = list ? OrderedJson::array() : OrderedJson::object();
  for (std::size_t i = 0; i < node.items.size(); ++i)
    if (list)
      json.push_back(ordered(node.items[i]));
    else
      json[node.names[i]] = ordered(node.items[i]);
  return json;
}

}  // namespace

std::vector<std::string> version_lines(const Comparison& comparison) {
  std::vector<std::string> lines;
  for (const auto& [version, words] : kVersionWords) {
    const std::string ending = ":" + name_in(kHumanVersionNames, version);
    for (const std::string& hand : comparison.hands)
      if (version_of_hand(hand).rfind(ending, 0) == 0)
        lines.push_back(fmt::format("{}: {}.", hand, words));
  }
  return lines;
}

std::string load_rule() {
  return "Each load is the best of any grasp (the largest, of squeezes the least), so two of one "
         "row may be of different grasps. Epsilon within hand limits is computed for all that "
         "closed, "
         "other loads for those with the largest epsilon, --best of each pair.";
}

std::string unknown_words(const HandOnObject& cell, const std::vector<std::string>& tasks) {
  std::vector<std::string> parts;
  bool any = false;  // at least one load is known
  const auto tell = [&](const std::string& name, const LoadFound& load) {
    any = any || load.known > 0;
    if (load.known < load.total)
      parts.push_back(fmt::format("{} {} of {}", name, load.total - load.known, load.total));
  };
  tell(kEpsilon, cell.best_hand_epsilon());
  for (const std::string& task : tasks) tell(task, cell.load(grasp_task(task)));
  if (parts.empty()) return "";
  const std::string why = why_unknown(cell);
  return fmt::format("{}{}{}", any ? fmt::format("{}", fmt::join(parts, ", ")) : "all",
                     why.empty() ? "" : ": ", why);
}

std::string describe_outcome(const HandOnObject& cell) {
  std::vector<std::pair<int, std::string>> ways;
  for (const auto& [outcome, name] : kGraspOutcomeNames) {
    int count = nth(cell.outcomes, outcome);
    if (outcome == GraspOutcome::kGrasped) count -= cell.closures + cell.between_two;
    if (count > 0) ways.emplace_back(count, name_in(kOutcomeWords, outcome));
  }
  if (cell.between_two > 0) ways.emplace_back(cell.between_two, "held between 2 hard points");
  std::stable_sort(ways.begin(), ways.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  return each_in_words(ways,
                       [](const auto& way) { return fmt::format("{} {}", way.first, way.second); });
}

double rounded_to(double value, double error) {
  if (!(error > 0)) return value;
  const double place = std::pow(10.0, std::floor(std::log10(error)));
  return place * std::round(value / place);
}

double in_two_digits(double value) { return rounded_to(value, std::abs(value) / 10); }

std::string reading_words(const Comparison& comparison) {
  return fmt::format(
      "Force closure: whatever the disturbance, some contact forces within friction balance it. "
      "Epsilon: the largest disturbance that is balanced from whatever direction, in units of the "
      "contacts' own forces (their normal forces sum up to 1), torques divided by the object's "
      "reach; 0 is the edge of slipping. More friction, soft pads or more contacts may raise it; "
      "the strength of the hand, and a size that object and contacts share, do not.\n\nEpsilon "
      "within hand limits: the same disturbance in newtons, with the forces that the hand's own "
      "motors or tendons, stops and drives that do not run back can make at that posture. A grasp "
      "of good geometry may have none: a joint that nothing holds gives way. Stops, such drives "
      "and palms press by no force of their own: they push back what motors or tendons press, and "
      "carry what the load presses on them without friction. No source states their strength: no "
      "limit means that they alone carry the load, and not that the hand would. Loads are given "
      "twice: by efforts and friction alone, and with structure, within the same limits.\n\nn/a "
      "appears where nothing was measured or an effort is unknown. Approaches are random: shares "
      "have the interval that is given with them, and the best of few approaches is not the best "
      "there is.\n\nSeed {}, {} approaches, objects {}.",
      comparison.seed, comparison.approaches,
      comparison.normalise_size ? "scaled with the reach of the hand" : "in their own size");
}

std::string text_of(const CompareResult& result) {
  const Comparison& comparison = result.comparison;
  // Put serious warnings before the numbers, all others after them.
  std::string text;
  for (const std::string& warning : comparison.warnings)
    if (is_serious(warning)) text += fmt::format("warning: {}\n", warning);
  text += titled("Grasps: share with force closure, its 95 % interval, and loads",
                 cell_table(comparison));
  text += load_rule() +
          "\nhand_epsilon_N: at least so much, and at most 5 % more.\nsqueeze_6_ways_N: least "
          "grasp force for the weight in the worst of 6 directions, each axis of the\nobject both "
          "ways; `thenar grasp` asks in the present orientation of the object.\n-: nothing closed, "
          "or not known. 0: nothing is carried; the page and JSON say why.\nwith_structure: what "
          "palm, joint limits and drives that do not run back carry as well, whose strength\nno "
          "source states. inf: they alone carry it.\n\n";
  text += most_closures_words(comparison);
  // Explain hands without closures, then hands by themselves.
  text += titled("Where nothing closed: how the approaches ended", outcome_table(comparison));
  text += titled(
      "Hands by themselves; closing_force: of the strongest tip; grasp_types: - where no "
      "approach pinched",
      hand_table(comparison));
  for (const std::string& warning : comparison.warnings)
    if (!is_serious(warning)) text += fmt::format("warning: {}\n", warning);
  return text;
}

Fields fields_of(const CompareResult& result) {
  Fields fields;
  const JsonNode file = comparison_node(result.comparison);
  for (std::size_t i = 0; i < file.items.size(); ++i)
    fields.add(file.names[i], ordered(file.items[i]));
  const std::string hand = hand_of_most_closures(result.comparison);
  fields.add("most_closures", hand.empty() ? OrderedJson() : OrderedJson(hand));
  return fields;
}

Table table_of(const CompareResult& result) { return cell_table(result.comparison); }

}  // namespace thenar
