#pragma once

/// A sampler of a run with what is recorded of it.

#include <memory>
#include <vector>

#include "sampling/place.h"
#include "sampling/sampler.h"
#include "sampling/swap_temperatures.h"

namespace thenar::internal {

/// The sampler of one rung of one group. Only rung 0, whose temper is 1, is recorded.
struct SamplerSlot {
  int group = 0, rung = 0;
  std::unique_ptr<Sampler> sampler;
  SwapTally tally;               // of the group, since warm-up or the last change of the ladder
  std::vector<double> pending;   // draws not taken yet: columns of all its chains (draw_rows.h)
  std::vector<StepStats> since;  // the last draw: evaluations, broken, divergent (chains)
  long divergent = 0;            // steps after warm-up, of all its chains

  /// To be called after each step. Every `thin`-th after warm-up is a draw.
  void record(long warm_up, int thin);

  /// All pending draws (rows of a draw * chains, draws); none are pending afterwards.
  [[nodiscard]] Eigen::MatrixXd take();

  [[nodiscard]] std::vector<Place> places() const;

  /// Another temper, and swaps counted anew.
  void retemper(double temper);

  void save(StateWriter& to) const;
  void restore(StateReader& from);
};

}  // namespace thenar::internal
