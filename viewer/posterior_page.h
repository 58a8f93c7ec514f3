#pragma once

/// A posterior as sections of a report: whether to believe it, what was learnt, what it predicts.
///
/// Everything is plain numbers, so that any sampler, study or file can fill it; what is left empty
/// is left out of the page.

#include <optional>
#include <string>
#include <vector>

#include "data/io/experiment.h"
#include "viewer/axis_cloud.h"
#include "viewer/draw_blocks.h"

namespace thenar {

/// A mode as the mode table tells it.
struct ModeRow {
  std::string name;            // "1", "2": best first
  double log_density;          // at its peak, up to a constant [1]
  double mass;                 // share of the draws near it [1]
  double mcse_mass;            // Monte Carlo error of that [1]; NaN: not known
  std::vector<double> center;  // of the quantities named in PosteriorPicture::mode_quantities
};

/// How much leaving out one observation would change the posterior.
struct ParetoShape {
  std::string name;  // "H01 Hook FDP"
  double k;          // shape of the tail of its importance weights [1]
};

/// Leave-one-out in one word, as PSIS-LOO estimates it.
struct LeftOut {
  double elpd = 0, elpd_sd = 0;     // expected log predictive density and its standard error [1]
  double p_eff = 0;                 // effective number of parameters [1]
  std::vector<ParetoShape> shapes;  // of each observation
};

/// Simulation-based calibration of one quantity: F(r) - r of its ranks, r = 0..1.
struct CalibrationCurve {
  std::string name;
  std::vector<double>
      difference;  // of the empirical distribution from the uniform one [1] (points)
};

/// Calibration of a model: ranks of true values among draws of simulated data.
struct Calibration {
  int simulations = 0;
  std::vector<double> rank;       // where all curves stand, as a fraction [1] (points)
  std::vector<double> low, high;  // band that holds 95 % of whole curves [1] (points)
  std::vector<CalibrationCurve> curves;
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
  Convergence convergence;                   // its estimates are not used: quantities have them
  std::string run;                           // one sentence: sampler, chains, draws, seconds
  std::vector<std::string> corner;           // quantities to start the corner plot with
  std::vector<std::string> mode_quantities;  // columns of the mode table, with units
  std::vector<ModeRow> modes;
  std::optional<TendonDigit> digit;  // before the fit; absent: no scene
  Eigen::VectorXd posture;           // to draw it in [rad]
  std::vector<AxisCloud> clouds;
  std::optional<TendonModel<double>> truth;  // digit that simulated data were made with
  std::vector<PredictedForces> predicted;
  std::optional<LeftOut> left_out;
  std::optional<Calibration> calibration;
  std::vector<SamplerCourse> samplers;
};

/// A banner that cannot be overlooked if the run has not converged, and a quiet line if it has.
[[nodiscard]] Json convergence_banner(const Convergence& convergence, const std::string& run);

[[nodiscard]] Json mode_table(const std::vector<ModeRow>& modes,
                              const std::vector<std::string>& quantities);

/// Measured components over posterior predictive 50 and 95 % intervals, by posture and tendon.
/// @throws InputError if `replicated` has not three rows a trial.
[[nodiscard]] Json predictive_block(const PredictedForces& predicted);

/// Pareto k of every observation; above 0.7 the estimate without it is not to be trusted.
/// Source: [Vehtari2024].
[[nodiscard]] Json pareto_chart(const LeftOut& left_out);

/// Curves that leave the band are named, the others are drawn alike. Source: [Sailynoja2022].
[[nodiscard]] Json calibration_chart(const Calibration& calibration);

/// Error over time on logarithmic axes, one line a sampler.
[[nodiscard]] Json sampler_chart(const std::vector<SamplerCourse>& samplers);

/// The sections of a report, the banner in the first.
[[nodiscard]] Json posterior_sections(const PosteriorPicture& picture);

}  // namespace thenar
