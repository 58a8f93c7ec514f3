#pragma once

/// A fit from input files to its result, and its result file.

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

/// All inputs of a fit; the result file keeps their texts, so that the fit can be repeated.
struct FitInputs {
  SourceText subject;
  SourceText settings;
  std::vector<SourceText> experiments;
  std::vector<std::string> also_free;   // globs that free further parameters
  std::optional<SourceText> net = {};   // of the extensor mechanism, in place of the subject's hood
  Scaling scaling = Scaling::kSubject;  // size of the digit of each specimen
};

/// All texts that a fit reads: subject, settings, net, experiments.
[[nodiscard]] std::vector<SourceText> sources_of(const FitInputs& inputs);

/// A finished fit.
struct Fit {
  FitInputs inputs;
  FitProblem problem;
  LeastSquaresMethod method;
  unsigned seed;
  Solution solution;
  Covariance covariance;
  RunRecord run = {};  // of the command that fitted it; empty in a program, and in older files
};

/// The built-in settings for a digit: data/fits/thumb.toml or data/fits/finger.toml.
[[nodiscard]] SourceText built_in_settings(const std::string& digit);

/// The problem that the inputs describe.
/// @throws DataError or InputError as the readers and builders do.
[[nodiscard]] FitProblem build_problem(const FitInputs& inputs);

/// Builds the problem, solves it, its prior scales being inferred, and computes the covariance. The
/// settings of the fit have the scales' factors. A stop request still gives a valid (unconverged)
/// fit.
[[nodiscard]] Fit run_fit(const FitInputs& inputs, const SolveOptions& options = {});

/// Inputs whose settings have the factors of prior scales that their forces make likeliest.
[[nodiscard]] FitInputs with_inferred_scales(const FitInputs& inputs,
                                             const SolveOptions& options = {});

/// Fitted parameters in display units, see display_unit().
struct FittedValues {
  Eigen::VectorXd value;  // [mm], [deg], [1] or [1/rad] (all parameters)
  Eigen::VectorXd sd;     // posterior sd, 0 where fixed; units as above (all parameters)
};

/// @param specimen  index in fit.problem.specimens(), or kPopulation
[[nodiscard]] FittedValues fitted_values(const Fit& fit, int specimen);

/// Writes inputs, estimate, covariance, predictions and provenance with the record of the run; see
/// docs/data_format.md.
void write_fit(const Fit& fit, const std::string& path);

/// @throws DataError if the file is not a fit.
[[nodiscard]] Fit read_fit(const std::string& path);

}  // namespace thenar
