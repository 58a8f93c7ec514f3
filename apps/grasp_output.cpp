#include "apps/grasp_output.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "apps/grasp_measures.h"
#include "apps/grasp_report.h"
#include "apps/grasp_robustness.h"
#include "report/answers/grasp_words.h"
#include "report/table.h"

namespace thenar {
namespace {

/// One number where both bounds show as the same.
std::string bounds_text(const Epsilon& e) {
  const std::string lower = fmt::format("{:.6g}", without_rounding(e.lower));
  const std::string upper = fmt::format("{:.6g}", without_rounding(e.upper));
  return lower == upper ? lower : fmt::format("between {} and {}", lower, upper);
}

std::string quality_text(const Epsilon& e) {
  std::string text = fmt::format("  {:<18}{}\n", "force closure", e.force_closure ? "yes" : "no");
  text += fmt::format("  {:<18}{}{}\n", "epsilon", bounds_text(e),
                      e.converged ? "" : " (gave up early)");
  if (e.has_missing_direction)
    text += fmt::format("  {:<18}{}\n", "cannot make", direction_words(e.missing_direction));
  return text + fmt::format("  {:<18}{}\n",
                            e.has_missing_direction ? "not withstood" : "withstood least",
                            direction_words(e.worst_wrench));
}

/// Up to what tells one warning of a kind from the next.
std::string kind_of(const std::string& warning) {
  return warning.substr(0, warning.find_first_of(",:"));
}

std::string measures_text(const std::vector<MeasureRow>& rows) {
  std::string text;
  for (const MeasureRow& each : rows)
    text += fmt::format("  {:<28}{}{}\n", each.name, each.value,
                        each.note.empty() ? "" : " (" + each.note + ")");
  return text;
}

std::string starts_text(const GraspQuestion& question, const GraspAnswer& answer) {
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < kOutcomes.size(); ++i)
    if (answer.outcomes[i] > 0)
      parts.push_back(fmt::format("{} {}", answer.outcomes[i], name_of(kOutcomes[i])));
  return fmt::format("  {:<18}{} of seed {}: {}; {} with force closure\n", "starts",
                     answer.started(), question.seed, fmt::join(parts, ", "), answer.closures);
}

}  // namespace

std::vector<std::string> folded(const std::vector<std::string>& warnings) {
  std::vector<std::string> kinds, lines;
  std::vector<int> counts;
  for (const std::string& warning : warnings) {
    const auto found = std::find(kinds.begin(), kinds.end(), kind_of(warning));
    if (found != kinds.end()) {
      ++counts[static_cast<std::size_t>(found - kinds.begin())];
      continue;
    }
    kinds.push_back(kind_of(warning));
    lines.push_back(warning);
    counts.push_back(1);
  }
  for (std::size_t i = 0; i < lines.size(); ++i)
    if (counts[i] > 1) lines[i] += fmt::format(" (and {} more of the kind)", counts[i] - 1);
  return lines;
}

std::string grasp_text(const GraspQuestion& question, const CollisionHand& touching,
                       const GraspAnswer& answer) {
  const Grasp& grasp = answer.grasp;
  std::string text = fmt::format("{} and {}: {}\n", question.hand.named.name,
                                 question.scene.object.name, explanation(question, answer));
  if (question.starts > 0) text += starts_text(question, answer);
  if (grasp.outcome == GraspOutcome::kGrasped) text += quality_text(grasp.quality);
  if (answer.measures) text += "\n" + measures_text(measure_rows(*answer.measures));
  if (answer.robustness) text += measures_text(robustness_rows(*answer.robustness));
  Table joints{{"coordinate", "value", "stopped by"}, {}};
  for (const JointRow& row : joint_rows(question, touching, answer))
    joints.rows.push_back({row.name, row.shown, row.why});
  if (!joints.rows.empty()) text += "\n" + aligned(joints);
  if (!grasp.contacts.empty()) text += "\n" + aligned(contact_table(touching, grasp.contacts));
  for (const std::string& warning : folded(warnings_of(question, answer)))
    text += fmt::format("warning: {}\n", warning);
  return text;
}

}  // namespace thenar
