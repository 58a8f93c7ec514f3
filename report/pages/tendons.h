#pragma once

/// The tendons of a digit over its postures: the net in space, its slips, moment arms, tip force.

#include <string>

#include "report/blocks.h"
#include "tendons/net/posture_sweep.h"

namespace thenar {

/// A sweep to show.
struct TendonSweep {
  const DigitTendons& tendons;
  Eigen::VectorXd t;               // tension of each muscle [N] (muscles)
  std::vector<DigitPoint> points;  // in order, row after row
  std::vector<int> varied;         // coordinates; the last one varies along a row
  std::size_t row = 1;             // points a row
};

/// Scenes of the net at some of the postures, linked, bands coloured by tension.
[[nodiscard]] Json net_scenes(const TendonSweep& sweep, std::size_t most = 4);

/// Ratio of terminal to central slip over the angle that varies along a row, one line a row; and
/// the tension of every slip.
[[nodiscard]] Json slip_charts(const TendonSweep& sweep);

/// Sections of a report.
[[nodiscard]] Json tendon_page(const TendonSweep& sweep);

}  // namespace thenar
