#pragma once

/// A posterior as sections of a report: whether to believe it, what was learnt, what it predicts.
///
/// Everything is plain numbers, so that any sampler, study or file can fill it; what is left empty
/// is left out of the page.

#include <optional>
#include <string>
#include <vector>

#include "report/draws/charts.h"
#include "report/draws/draws.h"
#include "report/draws/modes.h"
#include "report/draws/predictive.h"
#include "report/scene/axis_cloud.h"

namespace thenar {

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

/// The sections of a report. The first has the banner; if the run has not converged, all others say
/// so too.
[[nodiscard]] Json posterior_sections(const PosteriorPicture& picture);

}  // namespace thenar
