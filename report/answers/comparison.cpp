#include "report/answers/comparison.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "api/hands.h"

namespace thenar {
namespace {

/// What each version is, as build_human_hand() makes them.
constexpr std::array<const char*, 4> kVersions{
    "hard contacts; axes of the thumb at right angles; every joint has a strength of its own",
    "hard contacts; axes of the thumb skewed as measured; every joint has a strength of its own",
    "soft pads, whose contacts also resist twisting; axes of the thumb skewed as measured; every "
    "joint has a strength of its own",
    "soft pads, whose contacts also resist twisting; axes of the thumb skewed as measured; tendons "
    "in place of strengths: joints share muscles through the net, and the hand closes as its "
    "flexors run in"};

constexpr const char* kEpsilon = "epsilon";  // as BestGrasp::reasons has it

const char* words_of(GraspOutcome outcome) {
  switch (outcome) {
    case GraspOutcome::kGrasped:
      return "touched without force closure";
    case GraspOutcome::kOverlaps:
      return "began in something";
    case GraspOutcome::kMissed:
      return "missed the object";
    case GraspOutcome::kBlocked:
      return "blocked by an obstacle";
    case GraspOutcome::kTooLong:
      return "did not end closing";
    case GraspOutcome::kEmpty:
      break;
  }
  return "closed without touching";
}

/// Of the first load that is not known and says why.
std::string why_unknown(const HandOnObject& cell) {
  for (const BestGrasp& best : cell.best)
    for (const auto& [load, reason] : best.reasons)
      if (std::isnan(load == kEpsilon ? best.hand_epsilon : best.margin.at(load))) return reason;
  return "";
}

}  // namespace

std::vector<std::string> version_lines(const Comparison& comparison) {
  std::vector<std::string> lines;
  for (std::size_t version = 0; version < kVersions.size(); ++version) {
    const std::string ending = ":" + human_versions()[version];
    for (const std::string& hand : comparison.hands)
      if (version_of_hand(hand).rfind(ending, 0) == 0)
        lines.push_back(fmt::format("{}: {}.", hand, kVersions[version]));
  }
  return lines;
}

std::string load_rule() {
  return "Each load is the best of any grasp (the largest, of squeezes the least), so two of one "
         "row may be of different grasps. Epsilon of the hand is asked of all that closed, other "
         "loads of those with the largest epsilon, --best of each pair.";
}

std::string unknown_words(const HandOnObject& cell, const std::vector<std::string>& tasks) {
  std::vector<std::string> parts;
  bool any = false;  // is known
  const auto tell = [&](const std::string& name, const LoadFound& load) {
    any = any || load.known > 0;
    if (load.known < load.asked)
      parts.push_back(fmt::format("{} {} of {}", name, load.asked - load.known, load.asked));
  };
  tell(kEpsilon, cell.best_hand_epsilon());
  for (const std::string& task : tasks) tell(task, cell.load(grasp_task(task)));
  if (parts.empty()) return "";
  const std::string why = why_unknown(cell);
  return fmt::format("{}{}{}", any ? fmt::format("{}", fmt::join(parts, ", ")) : "all",
                     why.empty() ? "" : ": ", why);
}

std::string outcome_words(const HandOnObject& cell) {
  std::vector<std::pair<int, std::string>> ways;
  for (std::size_t i = 0; i < cell.outcomes.size(); ++i) {
    const auto outcome = static_cast<GraspOutcome>(i);
    const int count = cell.outcomes[i] - (outcome == GraspOutcome::kGrasped ? cell.closures : 0);
    if (count > 0) ways.emplace_back(count, words_of(outcome));
  }
  std::stable_sort(ways.begin(), ways.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<std::string> parts;
  for (const auto& [count, words] : ways) parts.push_back(fmt::format("{} {}", count, words));
  return fmt::format("{}", fmt::join(parts, ", "));
}

double rounded_to(double value, double error) {
  if (!(error > 0)) return value;
  const double place = std::pow(10.0, std::floor(std::log10(error)));
  return place * std::round(value / place);
}

double in_two_digits(double value) { return rounded_to(value, std::abs(value) / 10); }

std::string reading_words(const Comparison& comparison) {
  return fmt::format(
      "Force closure: whatever the disturbance, some contact forces within friction "
      "balance it. Epsilon: the largest disturbance that is balanced from whatever "
      "direction, in units of the contacts' own forces (their normal forces sum up to 1), "
      "torques divided by the object's reach; 0 is the edge of slipping. More friction, "
      "soft pads or more contacts may raise it; the strength of the hand, and a size that "
      "object and contacts share, do not.\n\nEpsilon of the hand: the same disturbance in newtons, with the forces that "
      "the hand's own motors or tendons, stops and drives that do not run back can make at "
      "that posture. A grasp of good geometry may have none: a joint that nothing holds "
      "gives way. Stops, such drives and palms press by no force of their own: they push "
      "back what motors or tendons press, and bear what the load presses on them without "
      "friction. No source states their strength: no limit means that they alone bear the "
      "load, and not that the hand would. Loads are limited alike.\n\nn/a stands where nothing was "
      "measured or an effort is unknown. Approaches are random: shares have the interval "
      "that is given with them, and the best of few approaches is not the best there "
      "is.\n\nSeed {}, {} approaches, objects {}.",
      comparison.seed, comparison.approaches,
      comparison.normalise_size ? "scaled with the reach of the hand" : "in their own size");
}

bool is_kapandji(const HandAbilities& abilities) {
  return abilities.opposition_scale.rfind("Kapandji", 0) == 0;
}

}  // namespace thenar
