#pragma once

/// The warm task of a net on bone: a sweep over postures, each started from its neighbour at rest.

#include <vector>

#include "bench/net_rivals/posed_net.h"
#include "tendons/net/solve_net.h"
#include "tests/tendons/net/head_net.h"

namespace thenar::bench {

/// One posture: what to solve, from where, and what is right.
struct WarmTask {
  TreeState<double> state;
  PosedNet posed;          // for the rivals
  Eigen::Matrix3Xd start;  // the neighbour at rest [m] (3, nodes)
  NetEquilibrium rest;     // of Newton's method
};

/// @param sample  outlives the tasks  @param step  between postures [rad]
[[nodiscard]] std::vector<WarmTask> warm_tasks(const SampleNet& sample, int count, double step);

/// Greatest difference of band tensions from the task's own [N]; infinite if not balanced.
[[nodiscard]] double tension_error(const WarmTask& task, const RivalRest& rest);

}  // namespace thenar::bench
