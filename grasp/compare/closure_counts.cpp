#include "grasp/compare/closure_counts.h"

#include <algorithm>

namespace thenar {
namespace {

constexpr double kMarkChance = 0.05;  // Chance of a mark although two hands are equal [1]

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
  if (!comparison.complete || comparison.hands.size() < 2) return "";
  std::vector<ClosureCount> counts;
  for (const std::string& hand : comparison.hands)
    counts.push_back(count_closures(comparison, hand));
  const auto most = std::max_element(
      counts.begin(), counts.end(),
      [](const ClosureCount& a, const ClosureCount& b) { return a.share() < b.share(); });
  for (auto other = counts.begin(); other != counts.end(); ++other) {
    if (other == most) continue;
    if (most->approaches == 0 || other->approaches == 0 ||
        fisher_exact_p({most->closures, most->approaches}, {other->closures, other->approaches}) >=
            kMarkChance)
      return "";
  }
  return comparison.hands[static_cast<std::size_t>(most - counts.begin())];
}

}  // namespace thenar
