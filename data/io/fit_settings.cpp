#include "data/io/fit_settings.h"

#include <cmath>
#include <map>
#include <sstream>
#include <string_view>

#include "data/io/toml_table.h"

namespace thenar {
namespace {

// Dimensions that the key of a setting may have
constexpr std::array kKeyDimensions{Dimension::kLength, Dimension::kAngle, Dimension::kNumber};

/// Reads `<base>_mm`, `<base>_deg` or plain `<base>`; all numbers of a row have the same dimension.
std::optional<double> read_number(TomlTable& table, const std::string& base, Range range,
                                  ParameterRule& rule, bool& seen) {
  for (const Dimension dimension : kKeyDimensions) {
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

ParameterRule read_rule(TomlTable& table) {
  // Which parameters the row is about.
  ParameterRule rule;
  rule.line = table.line();
  rule.match = table.text("match");
  rule.nonzero = table.has("nonzero") && table.choice("nonzero", {"yes", "no"}) == "yes";
  rule.optional = table.has("optional") && table.choice("optional", {"yes", "no"}) == "yes";
  // Free, fixed or tied.
  if (table.has("state")) {
    rule.state = table.choice("state", kParameterStateNames);
    if (rule.state == ParameterState::kTied) {
      rule.tie_to = table.text("tie_to");
      rule.tie_ratio = table.number_or(Dimension::kNumber, "tie_ratio", 1);
    }
  }
  // Prior and bounds, all of one dimension.
  bool seen = false;
  rule.mean = read_number(table, "mean", Range::kAny, rule, seen);
  rule.sd = read_number(table, "sd", Range::kNotNegative, rule, seen);
  rule.between_sd = read_number(table, "between_sd", Range::kNotNegative, rule, seen);
  rule.range = read_number(table, "range", Range::kPositive, rule, seen);
  rule.lower = read_number(table, "lower", Range::kAny, rule, seen);
  rule.upper = read_number(table, "upper", Range::kAny, rule, seen);
  return rule;
}

/// Keys of a choice, those about parameters first.
struct ChoiceWord {
  const char* word;
  ChoiceKey key;
  bool matches;    // is about parameters
  bool dimension;  // has that of its parameters
};
constexpr ChoiceWord kChoiceWords[] = {
    {"sd", ChoiceKey::kSd, true, true},
    {"between_sd", ChoiceKey::kBetweenSd, true, true},
    {"sd_factor", ChoiceKey::kSdFactor, true, false},
    {"between_sd_factor", ChoiceKey::kBetweenSdFactor, true, false},
    {"misfit", ChoiceKey::kMisfit, false, false},
    {"robust_scale", ChoiceKey::kRobustScale, false, false}};

/// Returns the index of the value in force, from 0; the file counts from 1.
std::size_t chosen_value(TomlTable& table, std::size_t values) {
  const double chosen = table.number_or(Dimension::kNumber, "chosen", 1, Range::kPositive);
  const auto count = static_cast<double>(values);
  if (chosen != std::floor(chosen) || chosen > count)
    table.fail(fmt::format("wanted a place in the list, 1 to {}, got {}", count, chosen), "chosen");
  return static_cast<std::size_t>(chosen) - 1;
}

SettingChoice read_choice(TomlTable& table) {
  SettingChoice choice;
  choice.line = table.line();
  choice.name = table.text("name");
  // The one key that has the values to try.
  for (const ChoiceWord& word : kChoiceWords)
    for (const Dimension dimension : kKeyDimensions) {
      if (!word.dimension && dimension != Dimension::kNumber) continue;
      if (!table.has(dimension, word.word)) continue;
      if (!choice.values.empty()) table.fail("wanted one list of values, got a second one");
      choice.values = table.numbers(dimension, word.word, 0, Range::kNotNegative);
      if (choice.values.empty()) table.fail("wanted at least one value", word.word);
      choice.key = word.key;
      choice.dimension = dimension;
      if (word.matches) choice.match = table.texts("match");
    }
  if (choice.values.empty())
    table.fail(
        "wanted a list of values: sd_.., between_sd_.., sd_factor, between_sd_factor, misfit or "
        "robust_scale");
  choice.chosen = chosen_value(table, choice.values.size());
  table.done();
  return choice;
}

PriorScale read_prior_scale(TomlTable& table) {
  PriorScale scale;
  scale.line = table.line();
  scale.name = table.text("name");
  scale.match = table.texts("match");
  const auto number = [&](const char* key, double otherwise) {
    return table.number_or(Dimension::kNumber, key, otherwise, Range::kPositive);
  };
  scale.likeliest = number("likeliest", scale.likeliest);
  scale.spread = number("spread", scale.spread);
  scale.largest = number("largest", scale.largest);
  scale.factor = number("factor", scale.factor);
  return scale;
}

AxisDistance read_axis_distance(TomlTable& table) {
  const std::vector<std::string> joints = table.texts("joints");
  if (joints.size() != 2) table.fail(fmt::format("wanted 2 'joints', got {}", joints.size()));
  const std::vector<double> range =
      table.numbers(Dimension::kLength, "range", 2, Range::kNotNegative);
  if (range[0] > range[1]) table.fail("'range' must go from the lower bound to the upper");
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
  settings.superposition =
      top.number_or(Dimension::kNumber, "superposition", 0, Range::kNotNegative);
  settings.linearity = top.number_or(Dimension::kNumber, "linearity", 0, Range::kNotNegative);
  // Rules stay in the order of the file: later ones win.
  read_each(top, "parameter", settings.rules, read_rule);
  read_each(top, "axis_distance", settings.axis_distances, read_axis_distance);
  if (std::optional<TomlTable> table = top.table("posterior"))
    settings.posterior = read_posterior(*table);
  for (TomlTable& row : top.tables("choose")) {
    settings.choices.push_back(read_choice(row));
    set_choice(settings, settings.choices.size() - 1, settings.choices.back().chosen);
  }
  read_each(top, "prior_scale", settings.scales, read_prior_scale);
  top.done();
  return settings;
}

void set_choice(FitSettings& settings, std::size_t at, std::size_t value) {
  SettingChoice& choice = settings.choices.at(at);
  choice.chosen = value;
  if (choice.key == ChoiceKey::kMisfit) settings.misfit = choice.values.at(value);
  if (choice.key == ChoiceKey::kRobustScale) settings.robust_scale = choice.values.at(value);
}

namespace {

/// Text in which the tables that begin in these lines have a key of this value, in place of an old
/// one.
std::string with_key(const std::string& text, const std::string& key,
                     const std::map<int, std::string>& values) {
  std::istringstream in(text);
  std::string out, line;
  bool inside = false;  // such a table, where the old key goes
  for (int number = 1; std::getline(in, line); ++number) {
    const std::size_t first = line.find_first_not_of(" \t");
    const std::string_view rest =
        first == std::string::npos ? std::string_view() : std::string_view(line).substr(first);
    if (!rest.empty() && rest.front() == '[') inside = false;
    const bool old = inside && rest.rfind(key, 0) == 0;
    if (!old) out += line + "\n";
    const auto found = values.find(number);
    if (found == values.end()) continue;
    out += fmt::format("{} = {}\n", key, found->second);
    inside = true;
  }
  return out;
}

}  // namespace

std::string with_choices(const std::string& text, const FitSettings& settings) {
  std::map<int, std::string> chosen;
  for (const SettingChoice& choice : settings.choices)
    chosen[choice.line] = fmt::format("{}", choice.chosen + 1);
  return with_key(text, "chosen", chosen);
}

std::string with_scale_factors(const std::string& text, const FitSettings& settings,
                               const std::vector<double>& factors) {
  std::map<int, std::string> values;
  for (std::size_t i = 0; i < settings.scales.size(); ++i)
    values[settings.scales[i].line] = fmt::format("{}", factors.at(i));
  return with_key(text, "factor", values);
}

FitSettings read_fit_settings(const std::string& path) {
  return parse_fit_settings(read_text_file(path), path);
}

}  // namespace thenar
