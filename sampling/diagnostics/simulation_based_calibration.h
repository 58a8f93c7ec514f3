#pragma once

/// Simulation-based calibration: does the sampler draw from the posterior that it claims?

#include <string>
#include <vector>

#include <Eigen/Core>

#include "sampling/diagnostics/uniform_ranks.h"

namespace thenar {

/// Rank of the truth among L draws: how many lie below it, 0 .. L; of an equal draw, half a rank
/// more, rounded to even. Draws must be nearly independent: thin them first.
[[nodiscard]] int rank_of_truth(double truth, const Eigen::Ref<const Eigen::VectorXd>& draws);

/// The same among L of the draws of some chains, evenly spread over them all.
/// @param x      (draws, chains), at least L entries
/// @param draws  L
[[nodiscard]] int rank_of_truth(double truth, const Eigen::Ref<const Eigen::MatrixXd>& x,
                                int draws);

/// Ranks of one parameter over all runs.
struct ParameterCalibration {
  std::string name;
  double band_p = 0;        // that uniform ranks stray so far from the diagonal [1]
  double chi_square = 0;    // of counts in bins [1]
  double chi_square_p = 0;  // that uniform ranks give more [1]
  std::string shape;        // "too narrow", "too wide", "too low", "too high", or empty
};

/// Ranks are uniform as far as anyone can tell if `warnings` is empty.
struct RankCalibration {
  std::vector<ParameterCalibration> parameters;
  std::vector<std::string> warnings;  // sentences with the figure and its limit
};

struct CalibrationOptions {
  double alpha = 0.01;  // probability of a false alarm in all tests together [1]
  int points = 50;      // of the cumulative count; at most L [1]
  int bins = 20;        // of the chi-square test; at most L + 1, and 5 runs a bin [1]
};

/// If truths are drawn from the prior, data from the model, and draws from the posterior, the rank
/// of the truth among L independent draws is uniform on 0 .. L. Each parameter is judged by the
/// exact band of its cumulative ranks and by chi-square; both share alpha by Bonferroni.
///
/// "Too narrow" posteriors have ranks at both ends, "too wide" ones in the middle; "too low" ones
/// lie below the truth.
/// @param rank   (parameters, runs)
/// @param draws  L
/// @throws InputError if names do not fit, or a rank is out of range.
/// Source: [Talts2018] theorem 1; [Sailynoja2022].
[[nodiscard]] RankCalibration judge_calibration(const std::vector<std::string>& names,
                                                const Eigen::Ref<const Eigen::MatrixXi>& rank,
                                                int draws, const CalibrationOptions& options = {});

}  // namespace thenar
