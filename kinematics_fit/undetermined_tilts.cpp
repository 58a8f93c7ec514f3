#include "kinematics_fit/undetermined_tilts.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/lists.h"
#include "base/words.h"
#include "kinematics_fit/fit_residuals.h"
#include "kinematics_fit/prior_scales.h"

namespace thenar {
namespace {

// Magnitude of a correlation above which two estimates trade against each other [1]
constexpr double kTradeCorrelation = 0.8;

/// Returns the entries of a specimen, the population's and its own, that move parameters of one
/// kind.
std::vector<int> entries_of_kind(const FitCoordinates& coordinates, ParameterKind kind) {
  const FitParameters& parameters = coordinates.parameters();
  std::vector<int> found;
  for (int c = 0; c < parameters.coordinates(); ++c) {
    if (parameters.all[parameters.leader[c]].kind != kind) continue;
    const CoordinateEntries& coordinate = coordinates.entries(c);
    if (coordinate.population >= 0) found.push_back(coordinate.population);
    if (coordinate.deviation >= 0) found.push_back(coordinate.deviation);
  }
  return found;
}

/// Returns the correlations of a specimen's entries in the posterior of its own forces, with prior
/// scales of 1 for the load cell's tilts.
Eigen::MatrixXd correlations(const FitProblem& problem, const Eigen::VectorXd& z, int specimen,
                             const std::vector<int>& cell) {
  const std::vector<ScaledPriors>& scales = problem.parameters().scales;
  const std::vector<int> scale = scale_of_entries(problem.coordinates());
  Eigen::MatrixXd J = specimen_residuals(problem, z, specimen).J;
  for (const int k : cell)
    if (scale[k] >= 0) J.col(k) /= scales[scale[k]].factor;
  const Eigen::MatrixXd C = (J.transpose() * J + Eigen::MatrixXd::Identity(J.cols(), J.cols()))
                                .llt()
                                .solve(Eigen::MatrixXd::Identity(J.cols(), J.cols()));
  const Eigen::VectorXd inverse_sd = C.diagonal().cwiseSqrt().cwiseInverse();
  return inverse_sd.asDiagonal() * C * inverse_sd.asDiagonal();
}

}  // namespace

UndeterminedTilts find_undetermined_tilts(const FitProblem& problem, const Eigen::VectorXd& z,
                                          const Covariance& covariance) {
  const FitCoordinates& coordinates = problem.coordinates();
  const std::vector<int> axes = entries_of_kind(coordinates, ParameterKind::kAxisDirection);
  const std::vector<int> cell = entries_of_kind(coordinates, ParameterKind::kSensorTilt);
  const std::vector<std::string> names = coordinates.names();
  UndeterminedTilts out;
  for (int specimen = 0; specimen < static_cast<int>(problem.specimens().size()); ++specimen) {
    const std::vector<int> entries = coordinates.entries_of_specimen(specimen);
    const auto entry = [&](int k) { return static_cast<std::size_t>(entries[k]); };
    // List tilts that keep their priors; count those of the population only once.
    for (const int k : axes) {
      if (specimen > 0 && k < coordinates.population_entries()) continue;
      ++out.tilt_count;
      const CoordinateEstimate& learnt = covariance.learnt[entry(k)];
      if (learnt.sd > kUndecidedShare) out.undecided.push_back(learnt);
    }
    if (axes.empty() || cell.empty()) continue;
    // Find tilts of axes and of the load cell that have the same effect on forces.
    const Eigen::MatrixXd correlation = correlations(problem, z, specimen, cell);
    for (const int a : axes)
      for (const int b : cell)
        if (std::abs(correlation(a, b)) > kTradeCorrelation)
          out.correlated.push_back({names[entry(a)], names[entry(b)], correlation(a, b)});
  }
  std::sort(out.correlated.begin(), out.correlated.end(),
            [](const CorrelatedTilts& a, const CorrelatedTilts& b) {
              return std::abs(a.correlation) > std::abs(b.correlation);
            });
  return out;
}

std::vector<std::string> describe(const UndeterminedTilts& tilts) {
  std::vector<std::string> warnings;
  if (!tilts.undecided.empty()) {
    warnings.push_back(
        fmt::format("{} of {} tilts of axes are not determined by the forces: they keep more than "
                    "{:.1f} of their prior sd: {}",
                    tilts.undecided.size(), tilts.tilt_count, kUndecidedShare,
                    some_of(names_of(tilts.undecided))));
  }
  if (!tilts.correlated.empty()) {
    std::vector<std::string> pairs;
    for (const CorrelatedTilts& pair : tilts.correlated)
      pairs.push_back(fmt::format("{} and {} ({:+.2f})", pair.axis, pair.cell, pair.correlation));
    warnings.push_back(fmt::format(
        "an axis and the load cell trade places where both may tilt as far as the settings say, "
        "in brackets their posterior correlation: {}",
        some_of(pairs)));
  }
  return warnings;
}

}  // namespace thenar
