#include "data/io/fit_settings.h"

#include <array>

#include "data/io/toml_table.h"

namespace thenar {
namespace {

constexpr std::array kDimensions{Dimension::kLength, Dimension::kAngle, Dimension::kNumber};

/// Reads `<base>_mm`, `<base>_deg` or plain `<base>`; all numbers of a row have the same dimension.
std::optional<double> read_number(TomlTable& table, const std::string& base, Range range,
                                  ParameterRule& rule, bool& seen) {
  for (const Dimension dimension : kDimensions) {
    if (!table.has(dimension, base)) continue;
    if (seen && dimension != rule.dimension)
      table.fail(fmt::format("'{}' is {}, but an earlier key of the row is {}", base,
                             dimension_name(dimension), dimension_name(rule.dimension)));
    rule.dimension = dimension;
    seen = true;
    return table.number(dimension, base, range);
  }
  return {};
}

void read_tie(TomlTable& table, ParameterRule& rule) {
  rule.tie_to = table.text("tie_to");
  rule.tie_ratio = table.number_or(Dimension::kNumber, "tie_ratio", 1);
}

ParameterRule read_rule(TomlTable& table) {
  // Which parameters the row is about.
  ParameterRule rule;
  rule.line = table.line();
  rule.match = table.text("match");
  rule.nonzero = table.has("nonzero") && table.choice("nonzero", {"yes", "no"}) == "yes";
  rule.optional = table.has("optional") && table.choice("optional", {"yes", "no"}) == "yes";
  // Free, fixed or tied.
  if (table.has("state")) {
    const std::string state = table.choice("state", {"free", "fixed", "tied"});
    rule.state = state == "free"    ? ParameterState::kFree
                 : state == "fixed" ? ParameterState::kFixed
                                    : ParameterState::kTied;
    if (state == "tied") read_tie(table, rule);
  }
  // Prior and bounds, all of one dimension.
  bool seen = false;
  rule.mean = read_number(table, "mean", Range::kAny, rule, seen);
  rule.sd = read_number(table, "sd", Range::kNotNegative, rule, seen);
  rule.between_sd = read_number(table, "between_sd", Range::kNotNegative, rule, seen);
  rule.range = read_number(table, "range", Range::kPositive, rule, seen);
  rule.lower = read_number(table, "lower", Range::kAny, rule, seen);
  rule.upper = read_number(table, "upper", Range::kAny, rule, seen);
  table.done();
  return rule;
}

AxisDistance read_axis_distance(TomlTable& table) {
  const std::vector<std::string> joints = table.texts("joints");
  if (joints.size() != 2) table.fail(fmt::format("wanted 2 'joints', got {}", joints.size()));
  const std::vector<double> range =
      table.numbers(Dimension::kLength, "range", 2, Range::kNotNegative);
  if (range[0] > range[1]) table.fail("'range' must go from the lower bound to the upper");
  table.done();
  return {joints[0], joints[1], range[0], range[1]};
}

PosteriorPriors read_posterior(TomlTable& table) {
  PosteriorPriors beliefs;
  beliefs.noise_sd =
      table.number_or(Dimension::kNumber, "noise_sd", beliefs.noise_sd, Range::kNotNegative);
  beliefs.specimen_scale_sd = table.number_or(Dimension::kNumber, "spread_sd",
                                              beliefs.specimen_scale_sd, Range::kNotNegative);
  if (table.has("directions"))
    beliefs.sphere_priors = table.choice("directions", {"sphere", "normal"}) == "sphere";
  table.done();
  return beliefs;
}

}  // namespace

FitSettings parse_fit_settings(const std::string& text, const std::string& path) {
  const TomlFile file(text, path);
  TomlTable top = file.top();
  FitSettings settings;
  settings.path = path;
  (void)top.text_or("name", "");
  // Name and description are for people only.
  (void)top.text_or("description", "");
  settings.robust_scale = top.number_or(Dimension::kNumber, "robust_scale", 0, Range::kNotNegative);
  settings.misfit = top.number_or(Dimension::kNumber, "misfit", 0, Range::kNotNegative);
  // Rules stay in the order of the file: later ones win.
  for (TomlTable& row : top.tables("parameter")) settings.rules.push_back(read_rule(row));
  for (TomlTable& row : top.tables("axis_distance"))
    settings.axis_distances.push_back(read_axis_distance(row));
  if (std::optional<TomlTable> table = top.table("posterior"))
    settings.posterior = read_posterior(*table);
  top.done();
  return settings;
}

FitSettings read_fit_settings(const std::string& path) {
  return parse_fit_settings(read_text_file(path), path);
}

}  // namespace thenar
