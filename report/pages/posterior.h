#pragma once

/// A posterior as sections of a report: whether to believe it, what was learnt, what it predicts.
///
/// Everything is plain numbers, so that any sampler, study or file can fill it; what is left empty
/// is left out of the page.

#include <optional>
#include <string>
#include <vector>

#include "data/io/experiment.h"
#include "posterior/run/posterior_summary.h"
#include "sampling/diagnostics/modes.h"
#include "report/scene/axis_cloud.h"
#include "report/draws/draws.h"

namespace thenar {

/// Simulation-based calibration: ranks of true values among draws of simulated data.
struct CalibrationRanks {
  std::vector<std::string> names;     // of the quantities (quantities)
  Eigen::MatrixXi rank;               // 0 .. draws (quantities, simulations)
  int draws = 0;                      // of each simulation
  std::vector<std::string> warnings;  // to doubt the sampler, as RankCalibration::warnings
};

/// Predicted and measured forces of one experiment.
struct PredictedForces {
  Experiment experiment;
  Eigen::MatrixXd replicated;  // with noise, one column a draw [N] (3 trials, draws)
  std::string what;            // "H01, in sample": the caption starts with it
};

/// The error of one sampler as it runs.
struct SamplerCourse {
  std::string name;
  std::vector<double> seconds;  // wall time, warm-up included [s] (points)
  std::vector<double> error;    // of the posterior mean, in posterior sds, RMS over entries [1]
};

/// All that is known of a posterior.
struct PosteriorPicture {
  std::string title;   // "H01 and H02"; heads the sections
  std::string prefix;  // of section ids, where a page shows several
  std::vector<Quantity> quantities;
  std::vector<std::string> warnings;  // of the experiments and of the subject
  Convergence convergence;            // its estimates are not used: quantities have them
  std::string run;                    // one sentence: sampler, chains, draws, seconds
  std::vector<std::string> corner;    // quantities to start the corner plot with
  std::optional<ModeTable> modes;
  std::optional<TendonDigit> digit;  // before the fit; absent: no scene
  Eigen::VectorXd posture;           // to draw it in [rad]
  std::vector<AxisCloud> clouds;
  std::optional<TendonModel<double>> truth;  // digit that simulated data were made with
  std::vector<PredictedForces> predicted;
  std::optional<LeftOutObservations> left_out;
  std::optional<CalibrationRanks> calibration;
  std::vector<SamplerCourse> samplers;
};

/// A banner that cannot be overlooked if the run has not converged, and a quiet line if it has.
[[nodiscard]] Json convergence_banner(const Convergence& convergence, const std::string& run);

/// Share of the draws in each mode, how often chains cross, and means of the quantities that tell
/// the modes apart best, in their units.
/// @param quantities  of the same draws and chains as the table
/// @param most        quantities shown
/// @throws InputError if a quantity has other draws than the table.
[[nodiscard]] Json mode_table(const ModeTable& modes, const std::vector<Quantity>& quantities,
                              std::size_t most = 4);

/// Measured components over posterior predictive 50 and 95 % intervals, by posture and tendon.
/// @throws InputError if `replicated` has not three rows a trial.
[[nodiscard]] Json predictive_block(const PredictedForces& predicted);

/// Pareto k of every observation, those above the limit by name.
/// @throws InputError if there is not one name for each.
[[nodiscard]] Json pareto_chart(const LeftOutObservations& left_out);

/// Empirical distribution of ranks less the uniform one, over the band that holds 95 % of such
/// curves whole. Curves that leave it are named, the others are drawn alike.
/// @throws InputError if names and ranks disagree.  Source: [Sailynoja2022].
[[nodiscard]] Json calibration_chart(const CalibrationRanks& calibration);

/// Error over time on logarithmic axes, one line a sampler.
[[nodiscard]] Json sampler_chart(const std::vector<SamplerCourse>& samplers);

/// The sections of a report. The first has the banner; if the run has not converged, all others say
/// so too.
[[nodiscard]] Json posterior_sections(const PosteriorPicture& picture);

}  // namespace thenar
