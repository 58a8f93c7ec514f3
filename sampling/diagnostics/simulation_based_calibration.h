#pragma once

/// Simulation-based calibration: tests whether draws come from the correct posterior.

#include <string>
#include <vector>

#include <Eigen/Core>

#include "sampling/diagnostics/uniform_ranks.h"

namespace thenar {

/// Returns the rank of the truth among L draws: the number of draws below it, 0 .. L; each equal
/// draw adds half a rank, rounded to even. Draws must be nearly independent: thin them first.
[[nodiscard]] int rank_of_truth(double truth, const Eigen::Ref<const Eigen::VectorXd>& draws);

/// Returns the rank of the truth among L draws taken evenly from all chains.
/// @param x      at least L entries (draws, chains)
/// @param draws  L
[[nodiscard]] int rank_of_truth(double truth, const Eigen::Ref<const Eigen::MatrixXd>& x,
                                int draws);

/// Tests of one parameter's ranks over all runs.
struct ParameterCalibration {
  std::string name;
  double band_p =
      0;  // p-value of the largest deviation of the cumulative ranks from the diagonal [1]
  double chi_square = 0;    // chi-square of the counts in bins [1]
  double chi_square_p = 0;  // p-value of the chi-square [1]
  std::string shape;        // "too narrow", "too wide", "too low", "too high", or empty
};

/// Tests of all parameters; without warnings the ranks agree with a uniform distribution.
struct RankCalibration {
  std::vector<ParameterCalibration> parameters;
  std::vector<std::string> warnings;  // sentences with the figure and its limit
};

/// Options of judge_calibration().
struct CalibrationOptions {
  double alpha = 0.01;  // probability of a false alarm in all tests together [1]
  int points = 50;      // number of points of the cumulative count; at most L [1]
  int bins = 20;  // number of bins of the chi-square test; at most L + 1, and 5 runs per bin [1]
};

/// Tests whether ranks are uniform. If truths are drawn from the prior, data from the model, and
/// draws from the posterior, the rank of the truth among L independent draws is uniform on 0 .. L.
/// Each parameter is tested by the exact band of its cumulative ranks and by chi-square; all tests
/// share alpha by Bonferroni.
///
/// A posterior that is "too narrow" has ranks at both ends, one that is "too wide" in the middle;
/// one that is "too low" lies below the truth.
/// @param rank   rank of each parameter in each run (parameters, runs)
/// @param draws  L
/// @throws InputError if the number of names differs, or a rank is out of range.
/// Source: [Talts2018] theorem 1; [Sailynoja2022].
[[nodiscard]] RankCalibration judge_calibration(const std::vector<std::string>& names,
                                                const Eigen::Ref<const Eigen::MatrixXi>& rank,
                                                int draws, const CalibrationOptions& options = {});

}  // namespace thenar
