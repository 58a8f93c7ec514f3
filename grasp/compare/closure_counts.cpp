#include "grasp/compare/closure_counts.h"

#include <algorithm>

#include "base/lists.h"

namespace thenar {
namespace {

constexpr double kSignificance = 0.05;  // p-value below which two hands differ [1]

}  // namespace

double ClosureCount::success_rate() const {
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
  const std::vector<ClosureCount> counts = transformed(
      comparison.hands, [&](const std::string& hand) { return count_closures(comparison, hand); });
  const auto best = std::max_element(counts.begin(), counts.end(),
                                     [](const ClosureCount& a, const ClosureCount& b) {
                                       return a.success_rate() < b.success_rate();
                                     });
  // The best hand must differ significantly from each other hand.
  for (auto other = counts.begin(); other != counts.end(); ++other) {
    if (other == best) continue;
    if (best->approaches == 0 || other->approaches == 0 ||
        fisher_exact_p({best->closures, best->approaches}, {other->closures, other->approaches}) >=
            kSignificance)
      return "";
  }
  return comparison.hands[best - counts.begin()];
}

}  // namespace thenar
