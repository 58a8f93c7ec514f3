#include "sampling/diagnostics/simulation_based_calibration.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/error.h"
#include "base/special_functions.h"

namespace thenar {
namespace {

/// Chi-square statistic with its p-value.
struct ChiSquare {
  double value, p;
};

/// Computes the chi-square of ranks counted in equal bins of 0 .. L.
ChiSquare chi_square_of(const Eigen::VectorXi& rank, int draws, int bins) {
  const auto edge = [&](int bin) { return int(long(bin) * (draws + 1) / bins); };
  double value = 0;
  for (int bin = 0; bin < bins; ++bin) {
    // Compare expected and counted ranks of the bin.
    const int from = edge(bin), to = edge(bin + 1);
    const double expected = double(rank.size()) * (to - from) / (draws + 1);
    const double count = double((rank.array() >= from && rank.array() < to).count());
    value += (count - expected) * (count - expected) / expected;
  }
  return {value, bins > 1 ? chi_square_tail(value, bins - 1) : 1};
}

/// Describes the larger of shift and spread of the ranks, each over its sd for uniform ranks.
std::string shape_of(const Eigen::VectorXi& rank, int draws) {
  const Eigen::ArrayXd u = (rank.cast<double>().array() + 0.5) / (draws + 1);
  const auto n = double(u.size());
  // A uniform u has mean 1/2 and variance 1/12; (u - 1/2)^2 has variance 1/180.
  const double shift = (u.mean() - 0.5) * std::sqrt(12 * n);
  const double spread = ((u - 0.5).square().mean() - 1.0 / 12) * std::sqrt(180 * n);
  if (std::abs(shift) > std::abs(spread)) return shift > 0 ? "too low" : "too high";
  return spread > 0 ? "too narrow" : "too wide";
}

}  // namespace

int rank_of_truth(double truth, const Eigen::Ref<const Eigen::VectorXd>& draws) {
  require(std::isfinite(truth) && draws.allFinite(), "truth and draws must be finite");
  const double equal = double((draws.array() == truth).count());
  return int((draws.array() < truth).count()) + int(std::nearbyint(equal / 2));
}

int rank_of_truth(double truth, const Eigen::Ref<const Eigen::MatrixXd>& x, int draws) {
  require(draws > 0 && x.size() >= draws, "there are {} draws, not {}", x.size(), draws);
  const Eigen::VectorXd all = x.reshaped();
  const double step = double(all.size()) / draws;
  return rank_of_truth(truth, Eigen::VectorXd::NullaryExpr(draws, [&](Eigen::Index i) {
                         return all[Eigen::Index((double(i) + 0.5) * step)];
                       }));
}

RankCalibration judge_calibration(const std::vector<std::string>& names,
                                  const Eigen::Ref<const Eigen::MatrixXi>& rank, int draws,
                                  const CalibrationOptions& options) {
  require(Eigen::Index(names.size()) == rank.rows() && rank.size() > 0,
          "{} names for {} x {} ranks", names.size(), rank.rows(), rank.cols());
  // Choose the tests for this number of runs; they share alpha.
  const int points = std::min(options.points, draws);
  const int bins = std::clamp(std::min(options.bins, int(rank.cols()) / 5), 1, draws + 1);
  const double max_p = options.alpha / (2 * double(names.size()));

  RankCalibration all;
  for (std::size_t i = 0; i < names.size(); ++i) {
    // Test one parameter by band and chi-square.
    const Eigen::VectorXi parameter_rank = rank.row(Eigen::Index(i)).transpose();
    ParameterCalibration judged;
    judged.name = names[i];
    judged.band_p = uniform_rank_p(parameter_rank, draws, points);
    const ChiSquare counts = chi_square_of(parameter_rank, draws, bins);
    judged.chi_square = counts.value;
    judged.chi_square_p = counts.p;
    // Report the smaller p-value.
    if (const double p = std::min(judged.band_p, judged.chi_square_p); p < max_p) {
      judged.shape = shape_of(parameter_rank, draws);
      all.warnings.push_back(
          fmt::format("ranks of {} are not uniform (p = {:.2g}, below {:.2g}): its posterior is {}",
                      names[i], p, max_p, judged.shape));
    }
    all.parameters.push_back(judged);
  }
  return all;
}

}  // namespace thenar
