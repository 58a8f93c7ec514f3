#include "grasp/robot/closing_options.h"

#include <algorithm>
#include <cmath>

namespace thenar {
namespace {

constexpr double kUndecidedRange = 0.1;  // Smaller differences of ranges are no evidence [1]
constexpr double kHardlyNear = 1e-3;     // Smaller differences of nearness are no evidence [1]
constexpr double kAgainstWeight = 0.4;   // weight of evidence against a way of closing [1]
// Larger differences of nearness count with their whole weight [1]
constexpr double kNearDifference = 0.1;
// Largest sum of evidence against a way, less than a trial can give for it [1]
constexpr double kMostAgainst = 0.6;
constexpr double kDoubtfulRange = 0.35;  // difference of ranges up to which both ways are tried [1]
constexpr double kClearlyNear = 0.05;    // difference of nearness that leaves no doubt [1]

/// Signed evidence for the sense of one group, each -1 to 1.
struct SenseEvidence {
  double range = 0;     // how much farther its motors go in its own sense
  double nearness = 0;  // how much nearer the tips come in its own sense
};

SenseEvidence evidence_of(int group, const HandLayout& layout, const Eigen::VectorXd& rest,
                          const DriveGroups& groups,
                          const std::function<double(const std::vector<double>&)>& apart) {
  // Ranges of its motors in both senses, of those that turn.
  double up = 0, down = 0;
  std::vector<double> closing(layout.drives.size(), 0), opening(layout.drives.size(), 0);
  for (std::size_t d = 0; d < layout.drives.size(); ++d) {
    if (groups.group[d] != group) continue;
    closing[d] = groups.orientation[d];
    opening[d] = -groups.orientation[d];
    if (!groups.slides.empty() && groups.slides[d]) continue;
    const DrivenCoordinate& first = layout.drives[d].moves.front();
    const double r = groups.orientation[d] * first.ratio, at = rest[first.coordinate];
    const double above = (layout.upper[first.coordinate] - at) / std::abs(r),
                 below = (at - layout.lower[first.coordinate]) / std::abs(r);
    up += r > 0 ? above : below;
    down += r > 0 ? below : above;
  }
  // How near the tips come in both.
  const double near = apart(closing), far = apart(opening);
  return {up + down > 0 ? (up - down) / (up + down) : 0,
          near + far > 0 ? (far - near) / (far + near) : 0};
}

double sense_of(double evidence) { return evidence < 0 ? -1 : 1; }

/// Senses of all groups that are worth a try, some of them twice.
std::vector<std::vector<double>> candidate_senses(const std::vector<SenseEvidence>& evidence) {
  // Decide by ranges and by nearness; evidence that says nothing yields to the other.
  std::vector<double> by_range, by_nearness;
  for (const auto& [range, nearness] : evidence) {
    const bool range_speaks = std::abs(range) > kUndecidedRange,
               nearness_speaks = std::abs(nearness) > kHardlyNear;
    by_range.push_back(sense_of(range_speaks || !nearness_speaks ? range : nearness));
    by_nearness.push_back(sense_of(nearness_speaks || !range_speaks ? nearness : range));
  }
  // Both decisions, doubtful groups reversed, and everything reversed.
  std::vector<std::vector<double>> senses{by_range, by_nearness};
  for (std::size_t g = 0; g < evidence.size(); ++g) {
    if (std::abs(evidence[g].range) > kDoubtfulRange ||
        std::abs(evidence[g].nearness) > kClearlyNear)
      continue;
    senses.push_back(by_range);
    senses.back()[g] *= -1;
  }
  if (evidence.size() > 1) {
    senses.push_back(by_range);
    for (double& sense : senses.back()) sense *= -1;
  }
  return senses;
}

}  // namespace

std::vector<SenseOption> closing_options(
    const HandLayout& layout, const Eigen::VectorXd& rest, const DriveGroups& groups,
    const std::function<double(const std::vector<double>& senses)>& apart) {
  const std::vector<Drive>& drives = layout.drives;
  const int count =
      groups.group.empty() ? 0 : *std::max_element(groups.group.begin(), groups.group.end()) + 1;
  std::vector<SenseEvidence> evidence;
  evidence.reserve(static_cast<std::size_t>(count));
  for (int g = 0; g < count; ++g) evidence.push_back(evidence_of(g, layout, rest, groups, apart));
  // Stated speeds keep their magnitudes.
  const bool paced = std::any_of(drives.begin(), drives.end(),
                                 [](const Drive& drive) { return drive.speed != 0; });
  // Each candidate once, with the ranges and the nearness that speak against it.
  std::vector<SenseOption> options;
  std::vector<std::vector<double>> had;
  for (const std::vector<double>& senses : candidate_senses(evidence)) {
    if (std::find(had.begin(), had.end(), senses) != had.end()) continue;
    had.push_back(senses);
    SenseOption option;
    for (std::size_t g = 0; g < senses.size(); ++g) {
      if (senses[g] * evidence[g].range < 0)
        option.against += kAgainstWeight * std::abs(evidence[g].range);
      if (senses[g] * evidence[g].nearness < 0)
        option.against +=
            kAgainstWeight * std::min(1.0, std::abs(evidence[g].nearness) / kNearDifference);
    }
    option.against = std::min(option.against, kMostAgainst);
    for (std::size_t d = 0; d < drives.size(); ++d)
      option.speed.push_back(groups.group[d] < 0
                                 ? 0
                                 : groups.orientation[d] *
                                       senses[static_cast<std::size_t>(groups.group[d])] *
                                       (paced ? std::abs(drives[d].speed) : 1));
    options.push_back(std::move(option));
  }
  if (options.empty()) options.push_back({std::vector<double>(drives.size(), 0), 0});
  return options;
}

}  // namespace thenar
