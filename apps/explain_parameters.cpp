// Every number that a fit may move, and what is believed of it beforehand.

#include <fmt/format.h>

#include "apps/explanation.h"
#include "base/error.h"

namespace thenar {
namespace {

/// "free", "fixed", or "tied to 0.5 friction/FDP".
std::string state_of(const FitParameters& fit, std::size_t p) {
  const int coordinate = fit.coordinate[p];
  if (coordinate < 0) return "fixed";
  const int leader = fit.leader[static_cast<std::size_t>(coordinate)];
  if (leader == static_cast<int>(p)) return "free";
  const std::string ratio = fit.ratio[p] == 1 ? "" : shown(fit.ratio[p]) + " ";
  return fmt::format("tied to {}{}", ratio, fit.all[static_cast<std::size_t>(leader)].name);
}

}  // namespace

Section explain_parameters(const TendonDigit& built, const SourceText& settings) {
  Section section{"parameters", "Parameters of a fit, under settings " + settings.path, {}, {}};
  // An experiment gives each of its postures an error of its own; one stands for all here.
  constexpr const char* kPosture = "<posture>";
  FitParameters fit;
  try {
    fit = choose_parameters(built, {kPosture}, parse_fit_settings(settings.text, settings.path));
  } catch (const InputError& e) {
    section.lines = {fmt::format("these settings do not suit this digit: {}", e.what()),
                     "without them, all are fixed and have these priors:"};
    fit = choose_parameters(built, {kPosture}, {});
  }
  section.lines.push_back(
      fmt::format("{} parameters, {} coordinates; '{}' stands for each posture of an "
                  "experiment",
                  fit.all.size(), fit.coordinates(), kPosture));
  section.lines.push_back(
      "sd: of the population's mean; between_sd: from one specimen to the next");
  section.table.header = {"parameter",  "unit",  "prior_mean", "sd",
                          "between_sd", "lower", "upper",      "state"};
  for (std::size_t p = 0; p < fit.all.size(); ++p) {
    const Parameter& parameter = fit.all[p];
    const double scale = display_scale(parameter);
    std::vector<std::string> cells{parameter.name, display_unit(parameter)};
    for (const double value :
         {parameter.mean, parameter.sd, parameter.between_sd, parameter.lower, parameter.upper})
      cells.push_back(shown(value * scale));
    cells.push_back(state_of(fit, p));
    section.table.rows.push_back(cells);
  }
  return section;
}

}  // namespace thenar
