#pragma once

/// Ranking of tests by the disagreement of models that fit so far.

#include <vector>

#include "tendons/topology/fitted_nets.h"
#include "tendons/topology/net_forward_model.h"

namespace thenar {

/// Noise of a future reading:  sd^2 = floor^2 + (relative |reading|)^2.
struct MeasurementNoise {
  double relative = 0.05;  // [1]
  double floor = 0.02;     // [N] or [N m], as the reading
};

/// Computes the standard deviation of a reading. @param value  reading of one test (rows)
[[nodiscard]] Eigen::VectorXd reading_sd(const MeasurementNoise& noise,
                                         const Eigen::VectorXd& value);

/// Rank of one test of a pool.
struct RankedTest {
  int test = -1;            // index in the pool; -1: none
  double disagreement = 0;  // mean over pairs of models of  min(|difference / sd|^2, 25)  [1]
};

/// Ranks all tests of a pool, best first. Pairs have the weight  exp(-(misfit_a + misfit_b) / 2),
/// relative to the best pair's; the cap prefers a test that separates many pairs over one that
/// separates one pair far.
/// @param pool   model that predicts the tests of the pool in order
/// @param tests  the pool
/// @param nets   nets that fit so far, with their misfits
/// Source: [Bongard2005] for the principle, [Saxena2012] for tendon networks.
[[nodiscard]] std::vector<RankedTest> rank_tests(NetForwardModel& pool,
                                                 const std::vector<TendonTest>& tests,
                                                 const std::vector<FittedNet>& nets,
                                                 const Eigen::VectorXd& typical,
                                                 const MeasurementNoise& noise);

}  // namespace thenar
