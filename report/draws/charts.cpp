#include "report/draws/charts.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/error.h"
#include "report/blocks.h"
#include "sampling/diagnostics/uniform_ranks.h"

namespace thenar {
namespace {

constexpr int kRankPoints = 50;  // number of points of calibration curves [1]

/// Observations that are to be trusted, or not, as one series of points; NaN is not.
Json k_series(const LeftOutObservations& left_out, bool trusted) {
  Json x = Json::array(), y = Json::array(), names = Json::array();
  for (std::size_t i = 0; i < left_out.observations.size(); ++i) {
    const double k = left_out.result.k[static_cast<Eigen::Index>(i)];
    if ((k <= left_out.result.good_k) != trusted) continue;
    x.push_back(i + 1);
    y.push_back(std::round(1000 * k) / 1000);
    names.push_back(left_out.observations[i]);
  }
  return with(curve_json(trusted ? "trusted" : "not to be trusted", x, y, "points"),
              {{trusted ? "hints" : "labels", names}});
}

/// One curve; faint and nameless if it stays within the band.
Json curve_of(const std::string& name, const RankBand& band, const Eigen::VectorXi& count,
              const Eigen::VectorXd& uniform, double simulations) {
  const bool within =
      (count.array() >= band.low.array()).all() && (count.array() <= band.high.array()).all();
  const Eigen::VectorXd difference = count.cast<double>() / simulations - uniform;
  const Json x = rounded(uniform, 1), y = rounded(difference, 0.1);
  if (!within) return curve_json(name, x, y);
  return with(curve_json("within the band", x, y),
              {{"faint", true}, {"hints", std::vector<std::string>(x.size(), name)}});
}

Json band_of(const RankBand& band, const Eigen::VectorXd& uniform, double simulations) {
  const auto edge = [&](const Eigen::VectorXi& count) {
    return rounded(count.cast<double>() / simulations - uniform, 0.1);
  };
  const Json x = rounded(uniform, 1);
  return with(curve_json("95 % band", x, std::vector<double>(x.size(), 0.0)),
              {{"band_low", edge(band.low)}, {"band_high", edge(band.high)}, {"faint", true}});
}

}  // namespace

Json pareto_chart(const LeftOutObservations& left_out) {
  const LeaveOneOut& loo = left_out.result;
  require(static_cast<Eigen::Index>(left_out.observations.size()) == loo.k.size(),
          "{} names for {} observations", left_out.observations.size(), loo.k.size());
  // Observations with a large Pareto k are a series of their own.
  Json series = Json::array({k_series(left_out, true)});
  Json bad = k_series(left_out, false);
  const std::size_t doubtful = bad["x"].size();
  if (doubtful > 0) series.push_back(std::move(bad));
  return with(
      lines_block(fmt::format("Pareto k of each of {} observations left out in turn: {} not within "
                              "{:.2g}. Expected log predictive density {:.1f} \u00b1 {:.1f}, "
                              "effective number of parameters {:.1f}",
                              loo.k.size(), doubtful, loo.good_k, loo.elpd, loo.se,
                              loo.effective_parameters),
                  "observation", "Pareto k [1]", series),
      {{"reference_lines",
        Json::array({{{"value", loo.good_k},
                      {"label", fmt::format("{:.2g}: above, not to be trusted", loo.good_k)}}})}});
}

Json calibration_chart(const CalibrationRanks& calibration) {
  const auto count = static_cast<Eigen::Index>(calibration.names.size());
  require(count == calibration.rank.rows() && calibration.rank.cols() > 0,
          "{} names for {} x {} ranks", count, calibration.rank.rows(), calibration.rank.cols());
  const int simulations = static_cast<int>(calibration.rank.cols());
  // Compare with the band in which ranks of a calibrated sampler lie.
  const RankBand band =
      uniform_rank_band(simulations, calibration.draws, std::min(kRankPoints, calibration.draws));
  const Eigen::VectorXd uniform = band.below.cast<double>() / (calibration.draws + 1);
  Json series = Json::array({band_of(band, uniform, simulations)}), outside = Json::array();
  for (Eigen::Index i = 0; i < count; ++i) {
    Json line = curve_of(nth(calibration.names, i), band,
                         count_below(calibration.rank.row(i).transpose(), band.below), uniform,
                         simulations);
    (line.contains("faint") ? series : outside).push_back(std::move(line));
  }
  for (const Json& line : outside) series.push_back(line);
  return lines_block(
      fmt::format("Calibration by {} simulated experiments: empirical distribution of the "
                  "true values' ranks among {} draws, less the uniform one. {} of {} curves "
                  "leave the band, as one in twenty does by chance",
                  simulations, calibration.draws, outside.size(), count),
      "rank of the true value, as a fraction", "difference of distributions [1]", series);
}

Json sampler_chart(const std::vector<SamplerCourse>& samplers) {
  const Json series = list_of_each(samplers, [](const SamplerCourse& sampler) {
    return curve_json(sampler.name, sampler.seconds, sampler.error, "both");
  });
  return with(
      lines_block("Error of the posterior mean over wall time, warm-up included. Lower left is "
                  "better; a line that stays high has not found the posterior",
                  "wall time [s]", "RMS error of the mean [posterior sds]", series),
      {{"log_x", true}, {"log_y", true}});
}

}  // namespace thenar
