#pragma once

/// Slack lengths of bands that are to be just taut.

#include <vector>

#include <Eigen/Core>

#include "tendons/net/solve_net.h"

namespace thenar {

/// Length of each band with every node at its start [m] (bands).
/// @throws InputError naming a band that starts inside the surface that it bends over.
[[nodiscard]] std::vector<double> start_lengths(const Net& net, const TreeState<double>& state);

/// A band whose slack length is to be found.
struct FittedBand {
  int band;
  int like = -1;  // band whose strain it shall have; -1: none, it shall only not hang slack
};

/// Fits slack lengths to a posture and a load: bands that hang slack are shortened to the length
/// that they have, those with a model band are shortened or lengthened until both strain alike.
/// @param load  pull of each muscle of the net [N] (muscles)
/// @return largest difference of strain that is left after `rounds` [1]; infinite if the net did
/// not come to rest under the load
[[nodiscard]] double fit_slack(Net& net, const TreeState<double>& state,
                               const Eigen::VectorXd& load, const std::vector<FittedBand>& bands,
                               int rounds = 1000);

}  // namespace thenar
