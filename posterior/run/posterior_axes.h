#pragma once

/// Relative position of neighbouring joint axes in the draws of a run: their angle, their distance,
/// and which of the two is distal, as discussed in the literature on the thumb. Source:
/// [Miller2005] figure 7, on axes that neither intersect nor are orthogonal.

#include <string>
#include <vector>

#include "posterior/run/sample_posterior.h"
#include "sampling/diagnostics/convergence.h"
#include "tendons/neighbouring_axes.h"

namespace thenar {

/// Two neighbouring axes of the population, or of one specimen.
struct PosteriorAxes {
  std::string whose;  // specimen "H01"; empty: the population, or the only specimen
  NeighbouringAxes axes;
  Estimate angle;                  // angle between the axes, see AxisOffset [deg]
  Estimate distance, beyond;       // distance, and offset beyond, see AxisOffset [mm]
  double second_distal = 0;        // probability that the second axis lies distal of the first [1]
  double second_distal_prior = 0;  // prior probability of the same [1]
};

/// Computes the offsets of all pairs with an axis that the run moves: of the population if there
/// are several specimens and the run moves it, and of every specimen.
/// @param prior_count  number of prior draws [1]
[[nodiscard]] std::vector<PosteriorAxes> posterior_axes(const PosteriorRun& run,
                                                        int prior_count = 1000);

}  // namespace thenar
