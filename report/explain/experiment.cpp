// Explanation of an experiment: its protocol and measurements.

#include <cmath>
#include <map>
#include <set>

#include <fmt/format.h>

#include "base/units.h"
#include "report/explain/explanation.h"
#include "report/words.h"

namespace thenar {
namespace {

/// "1 proximal, 2 dorsal, 3 radial"
std::string components_in_words(const Experiment& experiment) {
  std::string words;
  for (int i = 0; i < experiment.components; ++i)
    words += fmt::format("{}{} {}", i > 0 ? ", " : "", i + 1,
                         direction_word(experiment.axes_of_digit.row(i)));
  return experiment.components == 3
             ? words
             : words + "; the force across the plane of flexion is not fitted";
}

/// Counts trials measured elsewhere than at the tip, by the segment of the load cell, in words.
std::vector<std::string> sites_in_words(const Experiment& experiment) {
  std::map<std::string, std::pair<int, std::string>> sites;  // trials, and axes of the force
  for (const Trial& trial : experiment.trials)
    if (trial.site) {
      auto& [trials, axes] = sites[trial.site->at];
      ++trials;
      axes = trial.site->axes;
    }
  return transformed(sites, [&](const auto& each) {
    const auto& [at, site] = each;
    return fmt::format("{} of {} trials: the load cell was at {}, forces in its axes of {}",
                       site.first, experiment.trials.size(), at, site.second);
  });
}

Section explain_protocol(const Experiment& experiment) {
  Section section{"protocol", "Protocol"};
  section.lines = {
      experiment.description,
      fmt::format("{} of specimen {} ({}); source {}", experiment.digit, experiment.specimen,
                  experiment.species, experiment.source),
      experiment.hold == TipConstraint::kRigid
          ? "hold rigid: the tip was clamped to the load cell, which took forces and moments"
          : "hold pinned: the tip touched the load cell at a point, which took forces only",
      fmt::format("forces are of the tip on the world, in axes fixed in {}: {}",
                  experiment.force_segment, components_in_words(experiment))};
  append_all(section.lines, sites_in_words(experiment));
  section.lines.push_back(
      experiment.sd_floor > 0
          ? fmt::format("noise of each component: sd^2 = ({:.3g} N)^2 + ({:.3g} % of |force|)^2",
                        experiment.sd_floor, 100 * experiment.sd_relative)
          : "noise: stated for each trial");
  return section;
}

Section explain_postures(const Experiment& experiment) {
  std::set<std::string> joints;
  for (const PostureRecord& posture : experiment.postures)
    for (const auto& [joint, angle] : posture.angles) joints.insert(joint);
  Section section{"postures", "Postures", {{"posture", "trials"}}};
  for (const std::string& joint : joints) section.table.header.push_back(joint + "_deg");
  for (const PostureRecord& posture : experiment.postures) {
    std::size_t trials = 0;
    for (const Trial& trial : experiment.trials) trials += trial.posture == posture.name ? 1 : 0;
    std::vector<std::string> cells{posture.name, std::to_string(trials)};
    for (const std::string& joint : joints) {
      const auto angle = posture.angles.find(joint);
      cells.push_back(shown(angle == posture.angles.end() ? 0 : angle->second / kDegree, 1));
    }
    section.table.add(cells);
  }
  return section;
}

struct Spread {
  std::size_t trials = 0;
  double least_tension = HUGE_VAL, most_tension = 0;  // [N]
  double least_force = HUGE_VAL, most_force = 0;      // [N]
};

/// Trials by the muscles they load: "FDS+EDC".
Section explain_trials(const Experiment& experiment) {
  // Collect ranges of tension and force for each set of loaded muscles.
  std::map<std::string, Spread> loads;
  for (const Trial& trial : experiment.trials) {
    std::string name;
    double tension = 0;
    for (const auto& [muscle, pull] : trial.tension) {
      name += (name.empty() ? "" : "+") + muscle;
      tension += pull;
    }
    Spread& spread = loads[name];
    ++spread.trials;
    spread.least_tension = std::min(spread.least_tension, tension);
    spread.most_tension = std::max(spread.most_tension, tension);
    spread.least_force = std::min(spread.least_force, trial.force.norm());
    spread.most_force = std::max(spread.most_force, trial.force.norm());
  }
  Section section{
      "trials",
      "Trials by loaded tendons; tensions are summed, after pulley losses",
      {{"loaded", "trials", "tension_from_N", "tension_to_N", "force_from_N", "force_to_N"}}};
  for (const auto& [name, spread] : loads)
    section.table.add({name, std::to_string(spread.trials), shown(spread.least_tension, 3),
                       shown(spread.most_tension, 3), shown(spread.least_force, 3),
                       shown(spread.most_force, 3)});
  return section;
}

}  // namespace

Explanation explain(const Experiment& experiment) {
  const Section header{"experiment", fmt::format("experiment '{}'", experiment.name)};
  return {header, explain_protocol(experiment), explain_postures(experiment),
          explain_trials(experiment)};
}

}  // namespace thenar
