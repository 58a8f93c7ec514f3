#include "grasp/compare/closure_counts.h"

#include <algorithm>

namespace thenar {
namespace {

constexpr double kChance = 0.05;  // of a mark though two hands are equal [1]

}  // namespace

double ClosureCount::share() const {
  return approaches > 0 ? static_cast<double>(closures) / approaches : 0;
}

ConfidenceInterval ClosureCount::interval() const { return wilson_interval(closures, approaches); }

ClosureCount count_closures(const Comparison& comparison, const std::string& hand) {
  ClosureCount count;
  for (const HandOnObject& cell : comparison.cells) {
    if (cell.hand != hand) continue;
    count.closures += cell.closures;
    count.approaches += cell.approaches;
  }
  return count;
}

std::string hand_of_most_closures(const Comparison& comparison) {
  const auto count = [&](const std::string& hand) { return count_closures(comparison, hand); };
  const auto& hands = comparison.hands;
  if (!comparison.complete || hands.size() < 2) return "";
  const std::string first = *std::max_element(
      hands.begin(), hands.end(),
      [&](const auto& a, const auto& b) { return count(a).share() < count(b).share(); });
  const ClosureCount most = count(first);
  const bool beats_all = std::all_of(hands.begin(), hands.end(), [&](const std::string& hand) {
    const ClosureCount other = count(hand);
    return hand == first || (most.approaches > 0 && other.approaches > 0 &&
                             fisher_exact_p({most.closures, most.approaches},
                                            {other.closures, other.approaches}) < kChance);
  });
  return beats_all ? first : "";
}

}  // namespace thenar
