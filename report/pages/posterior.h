#pragma once

/// Posterior as sections of a report: reliability, information gain, predictions.
///
/// It is plain numbers, so that any sampler, study or file can fill it; empty parts are left out of
/// the page.

#include <optional>
#include <string>
#include <vector>

#include "api/posterior.h"
#include "report/draws/charts.h"
#include "report/draws/draws.h"
#include "report/draws/modes.h"
#include "report/draws/predictive.h"
#include "report/picture/axis_cloud.h"

namespace thenar {

/// Content of a page about a posterior.
struct PosteriorPicture {
  std::string title;  // "H01 and H02"; title of the sections
  std::vector<Quantity> quantities;
  std::vector<std::string> warnings;  // warnings about the experiments, the subject, and noise
                                      // that is far larger than stated
  std::vector<std::string> advice;    // sentences on possible remedies
  Convergence convergence;            // diagnostics; estimates are taken from quantities
  std::string run;                    // one sentence on the run: sampler, chains, draws, seconds
  std::optional<ModeTable> modes;
  std::optional<TendonDigit> digit;  // before the fit; absent: no scene
  Eigen::VectorXd posture;           // posture of the drawing [rad]
  std::vector<AxisCloud> clouds;
  std::vector<PredictedForces> predicted;
  std::optional<LeftOutObservations> left_out;
};

/// Options of the picture of a sampled posterior.
struct PictureOptions {
  std::string title;                // title of the sections
  std::size_t max_quantities = 64;  // those with the largest information gain, and the eight with
                                    // the largest R-hat
};

/// Returns the content of a page about a sampled posterior, for posterior_sections().
[[nodiscard]] PosteriorPicture posterior_picture(const PosteriorRun& run,
                                                 const PictureOptions& options = {});

/// Returns a prominent banner if the run has not converged, a yellow one with cautions, else a
/// single line.
[[nodiscard]] Json convergence_banner(const Convergence& convergence, const std::string& run);

/// Returns the sections of a report. The first has the banner; if the run has not converged, all
/// others say so too.
[[nodiscard]] Json posterior_sections(const PosteriorPicture& picture);

/// Returns the page of a posterior.
[[nodiscard]] Json page_of(const PosteriorResult& result);

/// Returns the page of predictions by draws, which first states whether they may be used.
[[nodiscard]] Json page_of(const PosteriorPrediction& result);

}  // namespace thenar
