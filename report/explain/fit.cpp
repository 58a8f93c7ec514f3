// Explanation of a fit: its data, its status, and its information gain.

#include <fmt/format.h>

#include "base/nearest_name.h"
#include "base/provenance.h"
#include "base/units.h"
#include "base/words.h"
#include "report/explain/explanation.h"
#include "report/parameter_words.h"

namespace thenar {
namespace {

Section explain_status(const Fit& fit) {
  const Solution& found = fit.solution;
  return {
      "status",
      fmt::format("Fit of the {}", fit.problem.experiments().front().digit),
      {},
      {fmt::format("{} by {}: {}", convergence_word(found), name_of(fit.method), found.message),
       fmt::format("cost {:.5g} after {} evaluations in {:.2g} s; seed {}", found.cost,
                   found.evaluations, found.seconds, fit.seed),
       fmt::format("{}, worth {:.3g} parameters that the data determine",
                   counted(fit.problem.size(), "coordinate"), fit.covariance.effective_parameters),
       fmt::format("model: {}", describe(fit.problem.digit().fidelity))}};
}

Section explain_error(const FitExplained& found) {
  Section section{"error",
                  "Error of the trials that were fitted",
                  {{"experiment", "trials", "rms_N", "relative_percent", "flexion_plane_percent",
                    "direction_deg"}}};
  for (const Prediction& at : found.predictions) {
    if (at.trials.empty()) continue;  // rows of activations alone
    section.table.add({at.experiment, std::to_string(at.trials.size()), shown(at.error.rms, 4),
                       shown(100 * at.error.relative, 1), shown(100 * at.error.relative_flexion, 1),
                       shown(at.error.direction / kDegree, 1)});
  }
  return section;
}

/// Best known coordinates first.
Section explain_learnt(const Fit& fit) {
  Section section{"learnt",
                  "What the data taught, in units of the prior's sd; sd_after 1: nothing",
                  {{"coordinate", "estimate", "sd_after", "not_identifiable_share", "means"}}};
  for (const int i : sorted_by_sd(fit.covariance)) {
    const CoordinateEstimate& learnt = nth(fit.covariance.learnt, i);
    section.table.add({learnt.name, shown(learnt.z, 3), shown(learnt.sd, 3),
                       shown(learnt.null_share, 3),
                       or_dash(meaning_of(learnt.name, fit.problem.digit()))});
  }
  section.lines = transformed(fit.covariance.null_directions, &NullDirection::text);
  return section;
}

/// Free parameters of the population, or of one specimen, in their own units.
Section explain_values(const Fit& fit, const FittedValues& fitted, int specimen) {
  const std::string of = specimen < 0 ? "population" : nth(fit.problem.specimens(), specimen);
  Section section{
      "values_" + of,
      specimen < 0 ? "Free parameters of the population" : "Free parameters of specimen " + of,
      {{"parameter", "unit", "before", "after", "sd_after", "means"}}};
  const FitParameters& parameters = fit.problem.parameters();
  for (std::size_t p = 0; p < parameters.all.size(); ++p) {
    const Parameter& parameter = parameters.all[p];
    const auto at = static_cast<Eigen::Index>(p);
    if (parameters.coordinate[p] < 0 || (specimen < 0 && parameter.sd == 0)) continue;
    section.table.add({parameter.name, display_unit(parameter),
                       shown(display_scale(parameter) * parameter.mean), shown(fitted.value[at]),
                       shown(fitted.sd[at]),
                       or_dash(meaning_of(parameter.name, fit.problem.digit()))});
  }
  return section;
}

Section explain_provenance(const Fit& fit) {
  Section section{"provenance", "Inputs, kept whole in the file", {{"input", "sha256"}}};
  for (const SourceText& source : sources_of(fit.inputs))
    section.table.add({source.path, sha256(source.text)});
  if (!fit.run.arguments.empty())
    section.lines.push_back(fmt::format("written by: {}, in {}, on {}, by commit {}",
                                        command_line(fit.run), fit.run.folder, fit.run.date,
                                        or_dash(fit.run.commit)));
  if (!fit.inputs.also_free.empty())
    section.lines.push_back("also freed: " + listed(fit.inputs.also_free));
  return section;
}

Section explain_writers(const FitExplained& found) {
  Section section{"versions", "Written by", {{"program", "version"}}};
  for (const auto& [program, version] : found.written_by) section.table.add({program, version});
  return section;
}

}  // namespace

Explanation explain(const Fit& fit, const FitExplained& found) {
  Explanation sections{explain_status(fit), explain_error(found), explain_provenance(fit)};
  for (std::size_t v = 0; v < found.values.size(); ++v)  // the population is the first
    sections.push_back(explain_values(fit, found.values[v], static_cast<int>(v) - 1));
  sections.push_back(explain_learnt(fit));
  sections.push_back(explain_writers(found));
  return sections;
}

}  // namespace thenar
