#pragma once

/// One fit from files to result, and its result file.

#include <string>
#include <vector>

#include "data/io/result_file.h"
#include "kinematics_fit/covariance.h"
#include "kinematics_fit/fit_problem.h"

namespace thenar {

/// A text and where it came from.
struct SourceText {
  std::string path;
  std::string text;
};

/// Everything a fit depends on; kept whole in the result file, so that it can be run again.
struct FitInputs {
  SourceText subject;
  SourceText settings;
  std::vector<SourceText> experiments;
  std::vector<std::string> also_free;  // globs that free further parameters
};

/// A finished fit.
struct Fit {
  FitInputs inputs;
  FitProblem problem;
  LeastSquaresMethod method;
  unsigned seed;
  Solution solution;
  Covariance covariance;
};

/// The built-in settings for a digit: data/fits/thumb.toml or data/fits/finger.toml.
[[nodiscard]] SourceText built_in_settings(const std::string& digit);

/// The problem that the inputs describe.
/// @throws DataError or InputError as the readers and builders do.
[[nodiscard]] FitProblem build_problem(const FitInputs& inputs);

/// Builds and solves. A stop request still gives a valid (unconverged) fit.
[[nodiscard]] Fit run_fit(const FitInputs& inputs, const SolveOptions& options = {});

/// Parameters as fitted, in the units that people read (display_unit()).
struct FittedValues {
  Eigen::VectorXd value;  // (all parameters)
  Eigen::VectorXd sd;     // afterwards; 0 where fixed (all parameters)
};

/// @param specimen  index in fit.problem.specimens(), or -1: the population
[[nodiscard]] FittedValues fitted_values(const Fit& fit, int specimen);

/// Writes inputs, estimate, covariance, predictions and provenance; see docs/data_format.md.
void write_fit(const Fit& fit, const std::string& path);

/// @throws DataError if the file is not a fit.
[[nodiscard]] Fit read_fit(const std::string& path);

}  // namespace thenar
