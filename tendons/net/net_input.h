#pragma once

/// What can be changed about a net at rest, each as a rate.

#include <Eigen/Core>

#include "hand/chain.h"
#include "tendons/net/net.h"
#include "tendons/wrapping/tree_rate.h"

namespace thenar::internal {

/// How everything moves by one input, the floating nodes excepted.
struct NetInput : TreeRate {
  Eigen::VectorXd tension;  // of each band at a fixed length (bands)
};

/// Nothing moves and no tension changes.
[[nodiscard]] NetInput still(const Net& net, std::size_t links);

/// One joint coordinate turns by 1 rad.
[[nodiscard]] NetInput turning(const Net& net, const Tree<double>& tree,
                               const TreeState<double>& state, int coordinate);

}  // namespace thenar::internal
