#pragma once

/// Fit settings: which parameters a fit may move, how far, and their priors.

#include <optional>
#include <string>
#include <vector>

#include "data/io/units.h"

namespace thenar {

/// Whether a fit moves a parameter.
enum class ParameterState { kFree, kFixed, kTied };

/// Rule for every parameter whose name matches; later rules win. Numbers are SI; the reader
/// converts them from the unit of the key.
struct ParameterRule {
  std::string match;                         // glob on parameter names: "path/*/dorsal"
  bool optional = false;                     // no error if nothing matches
  bool nonzero = false;                      // matches no parameter whose mean is 0
  std::optional<ParameterState> state;       // absent: as an earlier rule says
  std::optional<double> mean;                // prior mean, replaces the subject's value [SI]
  std::optional<double> sd;                  // prior sd of the population mean [SI]
  std::optional<double> between_sd;          // sd between specimens [SI]
  std::optional<double> range;               // bounds: mean -+ range [SI]
  std::optional<double> lower, upper;        // absolute bounds [SI]
  std::string tie_to;                        // kTied: it is `tie_ratio` times this parameter
  double tie_ratio = 1;                      // [1]
  Dimension dimension = Dimension::kNumber;  // of the numbers above, if there are any
  int line = 0;                              // of the file, for messages
};

/// An anatomical bound on the distance between two joint axes (common normal).
struct AxisDistance {
  std::string joint_a, joint_b;
  double lower = 0, upper = 0;  // [m]
};

/// Additional priors of a posterior; a least-squares fit does not use them.
struct PosteriorPriors {
  double noise_sd = 0.5;  // of the logarithm of a factor on the stated noise; 0: no factor [1]
  double specimen_scale_sd = 0.5;  // of the logarithm of factors on between_sd; 0: no factor [1]
  bool sphere_priors = true;       // von Mises-Fisher on axis directions instead of normal tilts
};

/// Settings of one kind of fit.
struct FitSettings {
  std::string path;  // of the file, for messages
  std::vector<ParameterRule> rules;
  std::vector<AxisDistance> axis_distances;  // used by the constrained solver
  double robust_scale = 0;                   // Cauchy scale in noise sds; 0: plain squares [1]
  double misfit = 0;                         // sd of a force that the model misses, per tension [1]
  PosteriorPriors posterior;
};

/// Reads fit settings from TOML; the format is in docs/data_format.md.
/// @throws DataError  `path:line: what was wanted, what came`.
[[nodiscard]] FitSettings read_fit_settings(const std::string& path);

/// The same from text already in memory; `path` only names it in messages.
[[nodiscard]] FitSettings parse_fit_settings(const std::string& text, const std::string& path);

}  // namespace thenar
