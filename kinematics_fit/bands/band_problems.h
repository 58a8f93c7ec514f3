#pragma once

/// Fits of one net with any subset of the bands in question. All other parameters stay free in each
/// of them, with the same priors.

#include <string>
#include <vector>

#include "data/io/fit_settings.h"
#include "kinematics_fit/fit_problem.h"
#include "tendons/topology/fitted_nets.h"

namespace thenar {

/// Returns the names of the passive bands of a net that match a glob, in its order; all without
/// globs.
/// @throws InputError if a glob matches no passive band.
[[nodiscard]] std::vector<std::string> bands_matching(const Net& net,
                                                      const std::vector<std::string>& globs);

/// Builder of the fits. Names of parameters do not depend on which bands exist.
class BandProblems {
 public:
  /// @param all        fit with every band, of one specimen
  /// @param settings   settings by which its parameters were chosen
  /// @param also_free  glob patterns of parameters freed in addition
  /// @param bands      passive bands in question
  /// @throws InputError if the fit has no net or several specimens, or the net has no such band.
  BandProblems(FitProblem all, FitSettings settings, std::vector<std::string> also_free,
               std::vector<std::string> bands);

  /// Returns the fit with the given ones of the bands in question (bands). Absent bands have no
  /// parameters.
  [[nodiscard]] FitProblem problem_with(const Topology& present) const;

  /// Returns the fit with every band.
  [[nodiscard]] const FitProblem& full_problem() const { return all_; }
  [[nodiscard]] const std::vector<std::string>& bands() const { return bands_; }

 private:
  FitProblem all_;
  FitSettings settings_;
  std::vector<std::string> also_free_;
  std::vector<std::string> bands_;
};

/// Transfers a point of another fit of the same net: entries of equal names are copied and clipped
/// to the bounds of `to`; others are 0 (size of `to`).
/// @param names, z  names and values of the other fit's entries
[[nodiscard]] Eigen::VectorXd transfer_point(const std::vector<std::string>& names,
                                             const Eigen::VectorXd& z, const FitProblem& to);

}  // namespace thenar
