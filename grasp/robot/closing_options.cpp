#include "grasp/robot/closing_options.h"

#include <algorithm>
#include <cmath>

#include "base/lists.h"

namespace thenar {
namespace {

// Difference of ranges up to which they are no evidence, over their sum [1]
constexpr double kMinRangeEvidence = 0.1;
// Difference of tip separations up to which they are no evidence, over their sum [1]
constexpr double kMinSeparationEvidence = 1e-3;
constexpr double kEvidenceWeight = 0.4;  // weight of each kind of evidence in the penalty [1]
// Difference of tip separations from which they count with their full weight [1]
constexpr double kFullSeparationEvidence = 0.1;
// Maximum penalty, less than the score that a trial can give [1]
constexpr double kMaxPenalty = 0.6;
constexpr double kDoubtfulRange = 0.35;    // difference of ranges up to which both are tried [1]
constexpr double kClearSeparation = 0.05;  // difference of separations that is conclusive [1]

/// Signed evidence for the closing direction of one group, each -1 to 1.
struct SenseEvidence {
  double range = 0;       // difference of its motor ranges in both directions, over their sum
  double separation = 0;  // difference of tip separations in both directions, over their sum
};

SenseEvidence evidence_of(int group, const HandLayout& layout, const Eigen::VectorXd& rest,
                          const DriveGroups& groups,
                          const std::function<double(const std::vector<double>&)>& separation) {
  // Ranges of the rotating motors of the group in both directions.
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
  // Separation of the tips in both directions.
  const double when_closed = separation(closing), when_opened = separation(opening);
  return {up + down > 0 ? (up - down) / (up + down) : 0,
          when_closed + when_opened > 0 ? (when_opened - when_closed) / (when_opened + when_closed)
                                        : 0};
}

double sense_of(double evidence) { return evidence < 0 ? -1 : 1; }

/// Returns closing directions of all groups that are worth a trial, some of them twice.
std::vector<std::vector<double>> candidate_senses(const std::vector<SenseEvidence>& evidence) {
  // Decide by ranges and by separations; where one is no evidence, the other decides.
  std::vector<double> by_range, by_separation;
  for (const auto& [range, separation] : evidence) {
    const bool range_counts = std::abs(range) > kMinRangeEvidence,
               separation_counts = std::abs(separation) > kMinSeparationEvidence;
    by_range.push_back(sense_of(range_counts || !separation_counts ? range : separation));
    by_separation.push_back(sense_of(separation_counts || !range_counts ? separation : range));
  }
  // Candidates: both decisions, doubtful groups reversed, and all groups reversed.
  std::vector<std::vector<double>> senses{by_range, by_separation};
  for (std::size_t g = 0; g < evidence.size(); ++g) {
    if (std::abs(evidence[g].range) > kDoubtfulRange ||
        std::abs(evidence[g].separation) > kClearSeparation)
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
    const std::function<double(const std::vector<double>& senses)>& separation) {
  const std::vector<Drive>& drives = layout.drives;
  const int count =
      groups.group.empty() ? 0 : *std::max_element(groups.group.begin(), groups.group.end()) + 1;
  // Evidence of each group.
  std::vector<SenseEvidence> evidence;
  evidence.reserve(static_cast<std::size_t>(count));
  for (int g = 0; g < count; ++g)
    evidence.push_back(evidence_of(g, layout, rest, groups, separation));
  // Stated speeds keep their magnitudes.
  const bool has_speeds = any_of(drives, [](const Drive& drive) { return drive.speed != 0; });
  // Each distinct candidate, with the evidence against it as its penalty.
  std::vector<SenseOption> options;
  std::vector<std::vector<double>> seen;
  for (const std::vector<double>& senses : candidate_senses(evidence)) {
    if (contains(seen, senses)) continue;
    seen.push_back(senses);
    SenseOption option;
    for (std::size_t g = 0; g < senses.size(); ++g) {
      if (senses[g] * evidence[g].range < 0)
        option.penalty += kEvidenceWeight * std::abs(evidence[g].range);
      if (senses[g] * evidence[g].separation < 0)
        option.penalty += kEvidenceWeight *
                          std::min(1.0, std::abs(evidence[g].separation) / kFullSeparationEvidence);
    }
    option.penalty = std::min(option.penalty, kMaxPenalty);
    for (std::size_t d = 0; d < drives.size(); ++d)
      option.speed.push_back(groups.group[d] < 0
                                 ? 0
                                 : groups.orientation[d] * senses[groups.group[d]] *
                                       (has_speeds ? std::abs(drives[d].speed) : 1));
    options.push_back(std::move(option));
  }
  if (options.empty()) options.push_back({std::vector<double>(drives.size(), 0), 0});
  return options;
}

}  // namespace thenar
