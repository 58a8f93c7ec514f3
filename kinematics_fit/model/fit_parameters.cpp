#include "kinematics_fit/model/fit_parameters.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "base/error.h"
#include "base/lists.h"

namespace thenar {
namespace {

/// Choice of the state of a parameter while rules are applied.
struct Choice {
  ParameterState state = ParameterState::kFixed;
  std::string tie_to;
  double tie_ratio = 1;
  bool optional =
      false;  // true if the parameter becomes free by its own sds when its leader is missing
};

/// Checks that a rule has the dimension of a parameter. @throws InputError if it differs.
void require_dimension(const ParameterRule& rule, const std::string& file, const Parameter& p) {
  // Accept a row without numbers, which has no dimension.
  const bool numbers =
      rule.mean || rule.sd || rule.between_sd || rule.range || rule.lower || rule.upper;
  const std::string unit = display_unit(p);
  const Dimension wanted = unit == "mm"    ? Dimension::kLength
                           : unit == "deg" ? Dimension::kAngle
                                           : Dimension::kNumber;
  require(!numbers || rule.dimension == wanted, "{}:{}: '{}' is {}, the row states {}", file,
          rule.line, p.name, dimension_name(wanted), dimension_name(rule.dimension));
}

void apply_belief(const ParameterRule& rule, Parameter& p) {
  // Shift the bounds with a new mean.
  const double range_low = p.mean - p.lower, range_high = p.upper - p.mean;
  if (rule.mean) {
    p.mean = *rule.mean;
    p.lower = p.mean - range_low;
    p.upper = p.mean + range_high;
  }
  // Set sds, and bounds, relative to the mean or absolute.
  if (rule.sd) p.sd = *rule.sd;
  if (rule.between_sd) p.between_sd = *rule.between_sd;
  p.sd *= rule.sd_factor;
  p.between_sd *= rule.between_sd_factor;
  if (rule.range) {
    p.lower = p.mean - *rule.range;
    p.upper = p.mean + *rule.range;
  }
  if (rule.lower) p.lower = *rule.lower;
  if (rule.upper) p.upper = *rule.upper;
  require(p.lower <= p.mean && p.mean <= p.upper, "prior mean {} of '{}' is outside {} .. {} [SI]",
          p.mean, p.name, p.lower, p.upper);
}

void apply_rule(const ParameterRule& rule, const std::string& file, std::vector<Parameter>& all,
                std::vector<Choice>& choices) {
  bool matched = false;
  for (std::size_t p = 0; p < all.size(); ++p) {
    // Apply the rule to all parameters that match; later rules override earlier ones.
    if (!matches_glob(rule.match, all[p].name)) continue;
    if (rule.nonzero && all[p].mean == 0) continue;
    matched = true;
    require_dimension(rule, file, all[p]);
    apply_belief(rule, all[p]);
    if (rule.state) choices[p] = {*rule.state, rule.tie_to, rule.tie_ratio, rule.optional};
  }
  // Reject a rule that matches nothing.
  const std::string where = rule.line > 0 ? fmt::format("{}:{}", file, rule.line) : file;
  require_field(rule.line > 0 ? "" : "free", matched || rule.optional,
                "{}: no parameter matches '{}'; list them with `thenar explain`", where,
                rule.match);
}

/// Returns the rules of a choice, one for each glob; those without a match are no error.
std::vector<ParameterRule> rules_of(const SettingChoice& choice) {
  std::vector<ParameterRule> rules;
  for (const std::string& glob : choice.match) {
    ParameterRule rule;
    rule.match = glob;
    rule.optional = true;
    rule.line = choice.line;
    rule.dimension = choice.dimension;
    if (choice.key == ChoiceKey::kSd) rule.sd = choice.value();
    if (choice.key == ChoiceKey::kBetweenSd) rule.between_sd = choice.value();
    if (choice.key == ChoiceKey::kSdFactor) rule.sd_factor = choice.value();
    if (choice.key == ChoiceKey::kBetweenSdFactor) rule.between_sd_factor = choice.value();
    rules.push_back(std::move(rule));
  }
  return rules;
}

/// Records the scale of each parameter, the last that matches, and applies the factors.
void apply_scales(const std::vector<PriorScale>& scales, FitParameters& fit) {
  fit.scale.assign(fit.all.size(), -1);
  std::vector<double> factors;
  for (std::size_t s = 0; s < scales.size(); ++s) {
    fit.scales.push_back(
        {scales[s].name, scales[s].likeliest, scales[s].spread, scales[s].largest});
    factors.push_back(scales[s].factor);
    for (std::size_t p = 0; p < fit.all.size(); ++p)
      for (const std::string& glob : scales[s].match)
        if (matches_glob(glob, fit.all[p].name)) fit.scale[p] = static_cast<int>(s);
  }
  fit = with_scale_factors(std::move(fit), factors);
}

/// Narrows the bounds of a leader, so that tied parameters stay within their own.
void bound_leader(const Parameter& tied, double ratio, Parameter& leader) {
  if (ratio == 0) return;
  const double a = leader.mean + (tied.lower - tied.mean) / ratio;
  const double b = leader.mean + (tied.upper - tied.mean) / ratio;
  leader.lower = std::max(leader.lower, std::min(a, b));
  leader.upper = std::min(leader.upper, std::max(a, b));
}

/// Checks that no weight of out-of-plane moments is free at zero: forces are even in it, so that no
/// fit can move it from there. @throws InputError
void require_movable(const FitParameters& fit) {
  for (std::size_t p = 0; p < fit.all.size(); ++p)
    require(fit.all[p].kind != ParameterKind::kOutOfPlane || fit.coordinate[p] < 0 ||
                fit.all[p].mean != 0,
            "'{}' is free with mean 0, from where no fit can move it: give it a mean",
            fit.all[p].name);
}

/// Checks that no bone length is free with a net, whose bands would not grow with the bones.
/// @throws InputError
void require_laid(const TendonDigit& digit, const FitParameters& fit) {
  for (std::size_t p = 0; p < fit.all.size(); ++p)
    require(!digit.net || fit.all[p].kind != ParameterKind::kLength || fit.coordinate[p] < 0,
            "'{}' cannot be free with a net, whose slack lengths are laid for the subject's bones",
            fit.all[p].name);
}

/// Frees optional tied parameters whose leader does not exist, such as friction of FDS where the
/// subject has no FDP. If fixed, their error would be absorbed by other parameters without notice.
void free_without_leader(const FitParameters& fit, std::vector<Choice>& choices) {
  for (Choice& choice : choices) {
    if (choice.state != ParameterState::kTied || !choice.optional) continue;
    if (find_named(fit.all, choice.tie_to) == nullptr) choice.state = ParameterState::kFree;
  }
}

/// Numbers the coordinates of free parameters, then assigns tied ones to theirs.
void number_coordinates(const std::vector<Choice>& choices, FitParameters& fit) {
  // Give each free parameter a coordinate, which it leads.
  for (std::size_t p = 0; p < fit.all.size(); ++p) {
    // Skip a parameter without prior variance, which cannot move.
    const bool moves = fit.all[p].sd > 0 || fit.all[p].between_sd > 0;
    if (choices[p].state != ParameterState::kFree || !moves) continue;
    fit.coordinate[p] = fit.coordinates();
    fit.leader.push_back(static_cast<int>(p));
  }
  for (std::size_t p = 0; p < fit.all.size(); ++p) {
    // Assign tied parameters to the coordinates of their leaders, and narrow these leaders' bounds.
    if (choices[p].state != ParameterState::kTied) continue;
    const auto leader = std::find_if(fit.leader.begin(), fit.leader.end(),
                                     [&](int q) { return fit.all[q].name == choices[p].tie_to; });
    if (leader == fit.leader.end() && choices[p].optional) continue;
    require(leader != fit.leader.end(), "'{}' is tied to '{}', which is not a free parameter",
            fit.all[p].name, choices[p].tie_to);
    fit.coordinate[p] = static_cast<int>(leader - fit.leader.begin());
    fit.ratio[p] = choices[p].tie_ratio;
    bound_leader(fit.all[p], fit.ratio[p], fit.all[*leader]);
  }
}

}  // namespace

FitParameters choose_parameters(const TendonDigit& digit, const std::vector<std::string>& postures,
                                const FitSettings& settings,
                                const std::vector<std::string>& also_free) {
  // Apply the rules of the file and of its choices, then the globs of the caller.
  FitParameters fit;
  fit.postures = postures;
  fit.misfit = settings.misfit;
  fit.superposition = settings.superposition;
  fit.linearity = settings.linearity;
  std::vector<Parameter> all = list_parameters(digit, postures);
  std::vector<Choice> choices(all.size());
  for (const ParameterRule& rule : settings.rules) apply_rule(rule, settings.path, all, choices);
  for (const SettingChoice& choice : settings.choices)
    for (const ParameterRule& rule : rules_of(choice))
      apply_rule(rule, settings.path, all, choices);
  for (const std::string& glob : also_free) {
    ParameterRule rule;
    rule.match = glob;
    rule.state = ParameterState::kFree;
    apply_rule(rule, "to be free", all, choices);
  }

  // Number the coordinates of parameters that are free or tied; all others stay fixed.
  fit.coordinate.assign(all.size(), -1);
  fit.ratio.assign(all.size(), 1);
  fit.all = std::move(all);
  apply_scales(settings.scales, fit);
  free_without_leader(fit, choices);
  number_coordinates(choices, fit);
  require_laid(digit, fit);
  require_movable(fit);
  return fit;
}

FitParameters with_scale_factors(FitParameters parameters, const std::vector<double>& factors) {
  for (std::size_t p = 0; p < parameters.all.size(); ++p) {
    if (parameters.scale[p] < 0) continue;
    const auto at = static_cast<std::size_t>(parameters.scale[p]);
    const double change = factors.at(at) / parameters.scales[at].factor;
    parameters.all[p].sd *= change;
    parameters.all[p].between_sd *= change;
  }
  for (std::size_t s = 0; s < parameters.scales.size(); ++s)
    parameters.scales[s].factor = factors.at(s);
  return parameters;
}

FitParameters with_fitted_tensions(FitParameters parameters,
                                   const std::vector<Experiment>& experiments) {
  parameters.fitted_tension.clear();
  for (const Experiment& experiment : experiments)
    for (const Trial& trial : experiment.trials)
      for (const auto& [muscle, tension] : trial.tension)
        if (tension > 0) parameters.fitted_tension[muscle].insert(tension);
  return parameters;
}

double missed_force_sd(const FitParameters& parameters,
                       const std::map<std::string, double>& tension) {
  // Sum all tensions, and the distances of each muscle's load from the fitted ones.
  double sum = 0, squared_excess = 0;
  int pulling = 0;
  for (const auto& [muscle, t] : tension) {
    if (t <= 0) continue;
    sum += t;
    ++pulling;
    const auto fitted = parameters.fitted_tension.find(muscle);
    if (fitted == parameters.fitted_tension.end()) continue;
    double log_distance =
        std::numeric_limits<double>::infinity();  // log distance from the nearest fitted tension
    for (const double b : fitted->second)
      log_distance = std::min(log_distance, std::abs(std::log(t / b)));
    squared_excess += std::pow(t * log_distance, 2);
  }
  const double superposition = pulling > 1 ? parameters.superposition : 0;
  return std::hypot(sum * std::hypot(parameters.misfit, superposition),
                    parameters.linearity * std::sqrt(squared_excess));
}

std::vector<double> values_with(const FitParameters& parameters, const std::vector<int>& moving,
                                const Eigen::Ref<const Eigen::VectorXd>& values) {
  require(static_cast<Eigen::Index>(moving.size()) == values.size(),
          "{} parameters move, but there are values of {}", moving.size(), values.size());
  std::vector<double> all = transformed(parameters.all, &Parameter::mean);
  for (std::size_t k = 0; k < moving.size(); ++k) all[moving[k]] = values[k];
  return all;
}

std::vector<std::string> fixed_geometry_warnings(const FitParameters& parameters) {
  // Count moment arms and tendon points, and check whether any of them moves.
  int arms = 0, points = 0;
  bool arms_move = false, points_move = false;
  for (std::size_t p = 0; p < parameters.all.size(); ++p) {
    const Parameter& parameter = parameters.all[p];
    const bool moves = parameters.coordinate[p] >= 0;
    if (parameter.kind == ParameterKind::kArm) {
      arms += parameter.mean != 0 ? 1 : 0;
      arms_move = arms_move || moves;
    } else if (parameter.kind == ParameterKind::kPathPoint) {
      points +=
          parameter.component == 0 ? 1 : 0;  // count each point once, not its three coordinates
      points_move = points_move || moves;
    }
  }
  // Warn of a kind that is present but fixed.
  std::vector<std::string> warnings;
  const auto warn = [&](int count, const char* what, const char* glob) {
    warnings.push_back(
        fmt::format("none of the {} {} of the subject may move under these settings: freeing "
                    "'{}' lets them",
                    count, what, glob));
  };
  if (arms > 0 && !arms_move) warn(arms, "moment arms", "arm/*");
  if (points > 0 && !points_move) warn(points, "tendon points", "path/*");
  return warnings;
}

}  // namespace thenar
