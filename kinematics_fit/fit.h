#pragma once

/// Fit from input files to its result, and its result file.

#include <optional>
#include <string>
#include <vector>

#include "base/provenance.h"
#include "base/run_record.h"
#include "data/io/result_file.h"
#include "kinematics_fit/covariance.h"
#include "kinematics_fit/fit_problem.h"
#include "solvers/least_squares.h"

namespace thenar {

/// Inputs of a fit; the result file keeps their texts, so that the fit can be repeated.
struct FitInputs {
  SourceText subject;
  SourceText settings;
  std::vector<SourceText> experiments;
  std::vector<std::string> also_free;  // glob patterns of further parameters to free
  std::optional<SourceText> net = {};  // net of the extensor mechanism, replaces the subject's hood
  Scaling scaling = Scaling::kSubject;  // size of the digit of each specimen
};

/// Returns all texts that a fit reads: subject, settings, net, experiments.
[[nodiscard]] std::vector<SourceText> sources_of(const FitInputs& inputs);

/// Completed fit.
struct Fit {
  FitInputs inputs;
  FitProblem problem;
  LeastSquaresMethod method;
  unsigned seed = 0;
  Solution solution;
  Covariance covariance;
  /// Record of the command that fitted it; empty for library calls and in older files.
  RunRecord run = {};
};

/// Returns the built-in settings for a digit: data/fits/thumb.toml or data/fits/finger.toml.
[[nodiscard]] SourceText built_in_settings(const std::string& digit);

/// Builds the problem that the inputs describe.
/// @throws DataError or InputError as the readers and builders do.
[[nodiscard]] FitProblem build_problem(const FitInputs& inputs);

/// Builds the problem, solves it with inferred prior scales, and computes the covariance. The
/// settings of the fit include the factors of the scales. A stop request still gives a valid
/// (unconverged) fit.
[[nodiscard]] Fit run_fit(const FitInputs& inputs, const SolveOptions& options = {});

/// Returns inputs whose settings have the most likely factors of the prior scales.
[[nodiscard]] FitInputs with_inferred_scales(const FitInputs& inputs,
                                             const SolveOptions& options = {});

/// Fitted parameters in display units, see display_unit().
struct FittedValues {
  Eigen::VectorXd value;  // [mm], [deg], [1] or [1/rad] (all parameters)
  Eigen::VectorXd sd;     // posterior sd, 0 where fixed; units as above (all parameters)
};

/// Computes the fitted parameters.
/// @param specimen  index in fit.problem.specimens(), or kPopulation
[[nodiscard]] FittedValues fitted_values(const Fit& fit, int specimen);

/// Writes inputs, estimate, covariance, predictions and provenance with the record of the run; see
/// docs/data_format.md.
void write_fit(const Fit& fit, const std::string& path);

/// Reads a fit. @throws DataError if the file is not a fit.
[[nodiscard]] Fit read_fit(const std::string& path);

}  // namespace thenar
