#pragma once

/// Fit of slack lengths, for bands that should be just taut.

#include <vector>

#include <Eigen/Core>

#include "tendons/net/solve_net.h"

namespace thenar {

/// Computes the length of each band with every node at its start [m] (bands).
/// @throws InputError naming a band that starts inside the surface that it bends over.
[[nodiscard]] std::vector<double> start_lengths(const Net& net, const TreeState<double>& state);

/// Band whose slack length is fitted.
struct FittedBand {
  int band = 0;
  int like = -1;  // band whose strain it must have; -1: none, it must only not be slack
};

/// Fits slack lengths to a posture and a load: bands that are slack are shortened to their present
/// length; those with a model band are shortened or lengthened until both have the same strain.
/// @param load  pull of each muscle of the net [N] (muscles)
/// @return largest difference of strain after `rounds` [1]; infinite if the net has no equilibrium
/// under the load
[[nodiscard]] double fit_slack(Net& net, const TreeState<double>& state,
                               const Eigen::VectorXd& load, const std::vector<FittedBand>& bands,
                               int rounds = 1000);

}  // namespace thenar
