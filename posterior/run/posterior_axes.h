#pragma once

/// Relative position of neighbouring joint axes, by the draws of a run: their angle, their
/// distance, and which of two is the distal one. The questions of the thumb literature.
/// Source: [Miller2005] figure 7, of axes that neither meet nor stand square.

#include <string>
#include <vector>

#include "posterior/run/sample_posterior.h"
#include "sampling/diagnostics/convergence.h"
#include "tendons/neighbouring_axes.h"

namespace thenar {

/// Two neighbouring axes of the population, or of one specimen.
struct PosteriorAxes {
  std::string whose;  // "H01", or empty: the population, or the only specimen
  NeighbouringAxes axes;
  Estimate angle;               // of AxisOffset [deg]
  Estimate distance, beyond;    // [mm]
  double second_distal;         // probability that the second axis lies distal of the first [1]
  double second_distal_before;  // the same by draws from the prior [1]
};

/// Computes the offsets of all pairs of which the run moves an axis: of the population, where there
/// are several specimens and it moves them, and of every specimen.
/// @param prior_count  draws from the prior [1]
[[nodiscard]] std::vector<PosteriorAxes> posterior_axes(const PosteriorRun& run,
                                                        int prior_count = 1000);

}  // namespace thenar
