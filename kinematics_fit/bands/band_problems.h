#pragma once

/// Fits of one net with any part of the bands that are in question: everything else that a fit may
/// move stays free in each of them, with the same priors.

#include <string>
#include <vector>

#include "data/io/fit_settings.h"
#include "kinematics_fit/fit_problem.h"
#include "tendons/topology/fitted_nets.h"

namespace thenar {

/// Names of the passive bands of a net that a glob matches, in its order; without globs all.
/// @throws InputError if a glob matches no passive band.
[[nodiscard]] std::vector<std::string> bands_matching(const Net& net,
                                                      const std::vector<std::string>& globs);

/// Builds the fits. What a parameter is called does not depend on which bands exist.
class BandProblems {
 public:
  /// @param all        the fit with every band; one specimen
  /// @param settings   by which its parameters were chosen,
  /// @param also_free  and what was freed beyond them
  /// @param bands      in question, passive
  /// @throws InputError if the fit has no net or several specimens, or the net has no such band.
  BandProblems(FitProblem all, FitSettings settings, std::vector<std::string> also_free,
               std::vector<std::string> bands);

  /// The fit with these bands, of those in question (bands). Those that are absent have no
  /// parameters.
  [[nodiscard]] FitProblem with(const Topology& present) const;

  [[nodiscard]] const FitProblem& all() const { return all_; }
  [[nodiscard]] const std::vector<std::string>& bands() const { return bands_; }

 private:
  FitProblem all_;
  FitSettings settings_;
  std::vector<std::string> also_free_;
  std::vector<std::string> bands_;
};

/// A point of another fit of the same net: entries of the same name; 0 elsewhere, and within the
/// bounds of `to` (its size).
/// @param names, z  of the other fit's coordinates, and where they are
[[nodiscard]] Eigen::VectorXd carried_over(const std::vector<std::string>& names,
                                           const Eigen::VectorXd& z, const FitProblem& to);

}  // namespace thenar
