#pragma once

/// What never changes while one net is solved: who is free, who is joined, in which order to
/// eliminate.

#include <vector>

#include "solvers/block_matrix.h"
#include "tendons/net/net.h"

namespace thenar::internal {

/// A band with its places in the stiffness matrix.
struct BandPlan {
  int ka, kb;     // rows of its ends; -1: not free
  int slot = -1;  // of the block that joins them
  bool flip;      // the block is (kb, ka), not (ka, kb)
};

struct NetPlan {
  /// @throws InputError naming the node or band that is wrong.
  explicit NetPlan(const Net& net);

  Net net;
  BlockPattern pattern;
  std::vector<int> row;                  // of each node; -1: not free
  std::vector<int> node;                 // of each row
  std::vector<BandPlan> bands;           // in the order of the net's
  std::vector<std::vector<int>> clasps;  // of each row: bands that end there and bend over a bone
};

}  // namespace thenar::internal
