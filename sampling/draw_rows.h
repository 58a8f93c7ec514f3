#pragma once

/// One draw of one chain as a column of numbers: its statistics, then its position.

#include <vector>

#include <Eigen/Core>

#include "sampling/sampler.h"

namespace thenar::internal {

/// Rows of a draw of `size` coordinates.
[[nodiscard]] Eigen::Index rows_of_draw(Eigen::Index size);

/// Appends a draw. @param to  numbers of a stream
void put_draw(const StepStats& stats, const Eigen::Ref<const Eigen::VectorXd>& x,
              std::vector<double>& to);

/// The statistics of a draw, from its first rows.
[[nodiscard]] StepStats stats_of(const Eigen::Ref<const Eigen::VectorXd>& draw);

/// The position of a draw (size).
[[nodiscard]] Eigen::VectorXd position_of(const Eigen::Ref<const Eigen::VectorXd>& draw);

}  // namespace thenar::internal
