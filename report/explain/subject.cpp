// Explanation of a subject's digit: its parts, and possible questions.

#include <cmath>

#include <fmt/format.h>

#include "base/nearest_name.h"
#include "base/units.h"
#include "report/explain/explanation.h"
#include "report/parameter_words.h"
#include "tendons/neighbouring_axes.h"

namespace thenar {
namespace {

Section explain_kept(const DigitExplanation& says) {
  Section section{"kept", "Kept", {{"part", "count", "names"}}};
  const auto add = [&](const std::string& part, const std::vector<std::string>& names) {
    section.table.add({part, std::to_string(names.size()), listed(names)});
  };
  add("segments", says.segments);
  add("joints", says.joints);
  add("strands", says.strands);
  add("muscles", says.muscles);
  section.table.add({"hood", says.hood.compare(0, 4, "none") == 0 ? "0" : "1", says.hood});
  return section;
}

/// Parts dropped for the same reason share a row.
Section explain_dropped(const DigitExplanation& says) {
  Section section{"dropped", "Dropped", {{"part", "count", "why", "names"}}};
  std::vector<std::vector<std::string>> names;
  auto& rows = section.table.rows;
  for (const DroppedPart& part : says.dropped) {
    if (rows.empty() || rows.back()[0] != part.what || rows.back()[2] != part.reason) {
      rows.push_back({part.what, "", part.reason, ""});
      names.emplace_back();
    }
    names.back().push_back(part.name);
    rows.back()[1] = std::to_string(names.back().size());
    rows.back()[3] = listed(names.back());
  }
  if (rows.empty()) section.lines.emplace_back("nothing: this digit uses all of the subject");
  return section;
}

Section explain_rungs(const Fidelity& fidelity) {
  Section section{
      "fidelity", "Assumptions of the model that is built", {{"ladder", "rung", "assumes"}}};
  for (const RungWords& words : explain(fidelity))
    section.table.add({words.ladder, words.rung, words.assumes});
  return section;
}

/// Tabulates angles and distances between neighbouring joint axes.
Section explain_axes(const TendonDigit& built) {
  Section section{
      "axes",
      "Neighbouring joint axes at the reference posture",
      {{"first", "second", "angle_deg", "distance_mm", "second_distal_mm"}},
      {"distance: length of their common normal; second_distal: how far along the digit "
       "it leads from the first axis to the second, below 0 where the second lies "
       "proximal"}};
  for (const NeighbouringAxes& axes : neighbouring_axes(built)) {
    const AxisOffset offset = axis_offset(built.model, axes);
    section.table.add({nth(built.names.hinges, axes.first), nth(built.names.hinges, axes.second),
                       shown(degrees(offset.angle), 1), shown(1e3 * offset.distance, 2),
                       shown(1e3 * offset.beyond, 2)});
  }
  return section;
}

std::vector<std::string> without_limit(const TendonDigit& built) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < built.names.muscles.size(); ++i)
    if (std::isinf(built.max_tension[static_cast<Eigen::Index>(i)]))
      names.push_back(built.names.muscles[i]);
  return names;
}

Section explain_questions(const TendonDigit& built) {
  // Questions about tendons need muscles, those about limits also their largest forces.
  const bool pulled = !built.names.muscles.empty();
  const std::vector<std::string> unlimited = without_limit(built);
  const std::string tendons = pulled ? "yes" : "no: no muscle crosses a joint of this digit";
  const std::string limits = !pulled             ? tendons
                             : unlimited.empty() ? "yes"
                                                 : "no: F0 unknown of " + listed(unlimited);
  return {
      "questions",
      "Questions",
      {{"question", "needs", "possible"},
       {{"pose", "posed, hinge axes", "yes"},
        {"tip-force", "static, constant moment arms or richer", tendons},
        {"feasible-force", "static, constant moment arms or richer, F0 of every muscle", limits},
        {"fit, predict",
         built.fidelity.path < Path::kFitted
             ? "static, constant moment arms or richer, an experiment"
             : "static, constant moment arms or via points, on which they stay, an experiment",
         tendons}}}};
}

Section explain_muscles(const Subject& subject, const std::vector<std::string>& kept) {
  Section section{"muscles", "Muscles", {{"muscle", "strand", "F0_N"}}};
  for (const std::string& name : kept)
    for (const MuscleUnit& muscle : subject.muscles)
      if (muscle.name == name)
        section.table.add({name, muscle.strand.empty() ? "-" : muscle.strand,
                           muscle.max_force ? fmt::format("{:g}", *muscle.max_force) : "unknown"});
  return section;
}

Section explain_costs(const std::vector<QuestionCost>& costs) {
  Section section{"cost",
                  "Cost of one evaluation: medians, one thread, this machine, now",
                  {{"question", "rung", "median_us", "per_second"}}};
  for (const QuestionCost& cost : costs)
    section.table.add(
        {cost.question, cost.rung, shown(1e6 * cost.seconds), shown(1 / cost.seconds)});
  return section;
}

/// "free", "fixed", or "tied to 0.5 friction/FDP".
std::string state_of(const FitParameters& fit, std::size_t p) {
  const int coordinate = fit.coordinate[p];
  if (coordinate < 0) return "fixed";
  const int leader = nth(fit.leader, coordinate);
  if (leader == static_cast<int>(p)) return "free";
  const std::string ratio = fit.ratio[p] == 1 ? "" : shown(fit.ratio[p]) + " ";
  return fmt::format("tied to {}{}", ratio, nth(fit.all, leader).name);
}

/// Tabulates every free parameter of a fit with its prior.
Section explain_parameters(const DigitExplained& digit) {
  Section section{"parameters", "Parameters of a fit, under settings " + digit.settings};
  const FitParameters& fit = digit.parameters;
  // Settings of another digit may name parameters that this one lacks.
  if (!digit.settings_message.empty())
    section.lines = {
        fmt::format("these settings do not suit this digit: {}", digit.settings_message),
        "without them, all are fixed and have these priors:"};
  section.lines.push_back(
      fmt::format("{} parameters, {} coordinates; '{}' stands for each posture of an "
                  "experiment",
                  fit.all.size(), fit.coordinates(), kEachPosture));
  section.lines.emplace_back(
      "sd: of the population's mean; between_sd: from one specimen to the next");
  section.table.header = {"parameter", "unit",  "prior_mean", "sd",   "between_sd",
                          "lower",     "upper", "state",      "means"};
  // Priors in display units, with what the fit does to each parameter.
  for (std::size_t p = 0; p < fit.all.size(); ++p) {
    const Parameter& parameter = fit.all[p];
    const double scale = display_scale(parameter);
    std::vector<std::string> cells{parameter.name, display_unit(parameter)};
    for (const double value :
         {parameter.mean, parameter.sd, parameter.between_sd, parameter.lower, parameter.upper})
      cells.push_back(shown(value * scale));
    cells.push_back(state_of(fit, p));
    cells.push_back(or_dash(meaning_of(parameter.name, digit.tendons->digit())));
    section.table.add(cells);
  }
  return section;
}

/// A digit of which nothing but published maps is known.
Explanation explain_maps(const Subject& subject, const std::string& digit) {
  Section maps{"tip_maps",
               "Published maps from tendon tensions to the tip's wrench",
               {{"map", "rows", "muscles"}}};
  std::vector<std::string> muscles;
  for (const TipMap& map : subject.tip_maps)
    if (map.digit == digit) {
      maps.table.add({map.name, listed(map.rows), listed(map.muscles)});
      muscles = map.muscles;
    }
  maps.lines = {"a map is for one posture; the first is used unless another is named",
                "there are no bones: joints, postures and fits cannot be asked about"};
  return {maps, explain_muscles(subject, muscles)};
}

}  // namespace

Explanation explain(const Subject& subject, const DigitExplained& says) {
  Section header{"subject", fmt::format("{} of subject '{}'", says.digit, subject.name)};
  header.lines = {subject.description,
                  fmt::format("{} hand; the base, {}, does not move", subject.side, subject.base)};
  if (subject.base.empty()) header.lines.back() = subject.side + " hand";
  if (says.tendons == nullptr) {
    Explanation maps = explain_maps(subject, says.digit);
    maps.insert(maps.begin(), header);
    return maps;
  }
  const TendonDigit& built = says.tendons->digit();
  return {header,
          explain_kept(says.parts),
          explain_dropped(says.parts),
          explain_axes(built),
          explain_muscles(subject, says.parts.muscles),
          explain_rungs(built.fidelity),
          explain_questions(built),
          explain_costs(says.costs),
          explain_parameters(says)};
}

}  // namespace thenar
