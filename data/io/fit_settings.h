#pragma once

/// Fit settings: free parameters, their bounds and their priors.

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "base/enum_names.h"
#include "data/io/units.h"

namespace thenar {

/// State of a parameter in a fit.
enum class ParameterState { kFree, kFixed, kTied };
inline constexpr std::array kParameterStateNames{EnumName{ParameterState::kFree, "free"},
                                                 EnumName{ParameterState::kFixed, "fixed"},
                                                 EnumName{ParameterState::kTied, "tied"}};

/// Rule for every parameter whose name matches; later rules win. Numbers are SI; the reader
/// converts them from the unit of the key.
struct ParameterRule {
  std::string match;                    // glob on parameter names: "path/*/dorsal"
  bool optional = false;                // no error if nothing matches
  bool nonzero = false;                 // matches no parameter whose mean is 0
  std::optional<ParameterState> state;  // absent: as an earlier rule says
  std::optional<double> mean;           // prior mean, replaces the subject's value [SI]
  std::optional<double> sd;             // prior sd of the population mean [SI]
  std::optional<double> between_sd;     // sd between specimens [SI]
  double sd_factor = 1,
         between_sd_factor = 1;        // factors on the sds of the row or of an earlier one [1]
  std::optional<double> range;         // bounds: mean -+ range [SI]
  std::optional<double> lower, upper;  // absolute bounds [SI]
  std::string tie_to;                  // kTied: it is `tie_ratio` times this parameter
  double tie_ratio = 1;                // [1]
  Dimension dimension = Dimension::kNumber;  // dimension of the numbers above, if there are any
  int line = 0;                              // line in the file, for messages
};

/// An anatomical bound on the distance between two joint axes (common normal).
struct AxisDistance {
  std::string joint_a, joint_b;
  double lower = 0, upper = 0;  // [m]
};

/// Additional priors of a posterior; a least-squares fit does not use them.
struct PosteriorPriors {
  double noise_sd = 0.5;  // sd of the logarithm of a factor on the stated noise; 0: no factor [1]
  double specimen_scale_sd = 0.5;  // sd of the logarithm of factors on between_sd; 0: no factor [1]
  bool sphere_priors = true;       // von Mises-Fisher on axis directions instead of normal tilts
};

/// Kind of number that a choice sets.
enum class ChoiceKey { kSd, kBetweenSd, kSdFactor, kBetweenSdFactor, kMisfit, kRobustScale };

/// Number of the settings that is chosen by left-out data, see choose_settings(). It is applied
/// after all rules.
struct SettingChoice {
  std::string name;                // description: "tendon paths of people at large"
  std::vector<std::string> match;  // globs on parameter names; none: a number of the whole fit
  ChoiceKey key = ChoiceKey::kSd;
  std::vector<double> values;  // values in the order of the file [SI]
  std::size_t chosen = 0;      // index of the value in force
  Dimension dimension = Dimension::kNumber;
  int line = 0;  // line of its table, for messages

  [[nodiscard]] double value() const { return values[chosen]; }  // [SI]
};

/// Parameters whose prior sds share a factor that a fit estimates, see fit_with_scales(). It is
/// applied after all rules and choices.
struct PriorScale {
  std::string name;                // description: "load cell"
  std::vector<std::string> match;  // globs on parameter names; globs without a match are allowed
  double likeliest = 1;            // prior mode of the factor, where forces contradict 1 [1]
  double spread = std::numeric_limits<double>::infinity();  // sd of the logarithm of the factor
                                                            // about it; infinite: all alike [1]
  double largest = 1;                                       // bound of the factor [1]
  double factor = 1;  // factor in force: as a fit has left it [1]
  int line = 0;       // line of its table, for messages
};

/// Settings of one kind of fit.
struct FitSettings {
  std::string path;  // path of the file, for messages
  std::vector<ParameterRule> rules;
  std::vector<AxisDistance> axis_distances;  // used by the constrained solver
  double robust_scale = 0;                   // Cauchy scale in noise sds; 0: plain squares [1]
  double misfit = 0;                         // sd of the model error of a force, per tension [1]
  double superposition =
      0;  // sd of the deviation of combined loads from their sum, per tension [1]
  double linearity =
      0;  // sd of the change of force per tension for a load e times a measured one [1]
  PosteriorPriors posterior;
  std::vector<SettingChoice> choices;
  std::vector<PriorScale> scales;
};

/// Selects another value of a choice.
/// @param at  index in choices, and `value` in its values
void set_choice(FitSettings& settings, std::size_t at, std::size_t value);

/// Returns the text of a settings file with these choices: only its `chosen` keys change.
/// @param text  text from which `settings` was parsed
[[nodiscard]] std::string with_choices(const std::string& text, const FitSettings& settings);

/// Returns the text of a settings file with other factors of the prior scales: only their `factor`
/// keys change.
/// @param factors  factor of each of settings.scales [1]
[[nodiscard]] std::string with_scale_factors(const std::string& text, const FitSettings& settings,
                                             const std::vector<double>& factors);

/// Reads fit settings from TOML; the format is in docs/data_format.md.
/// @throws DataError  `path:line: what was wanted, what came`.
[[nodiscard]] FitSettings read_fit_settings(const std::string& path);

/// Parses fit settings from text already in memory; `path` only names it in messages.
[[nodiscard]] FitSettings parse_fit_settings(const std::string& text, const std::string& path);

}  // namespace thenar
