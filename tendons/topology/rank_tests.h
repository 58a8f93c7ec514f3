#pragma once

/// Ranking of tests by how much models that fit so far disagree on them.

#include <vector>

#include "tendons/topology/fitted_nets.h"
#include "tendons/topology/net_forward_model.h"

namespace thenar {

/// Noise of a reading to come:  sd^2 = floor^2 + (relative |reading|)^2.
struct MeasurementNoise {
  double relative = 0.05;  // [1]
  double floor = 0.02;     // [N] or [N m], as the reading
};

/// @param value  the reading of one test (rows)
[[nodiscard]] Eigen::VectorXd reading_sd(const MeasurementNoise& noise,
                                         const Eigen::VectorXd& value);

/// Rank of one test of a pool.
struct RankedTest {
  int test = -1;            // of the pool; -1: none
  double disagreement = 0;  // mean over pairs of models of  min(|difference / sd|^2, 25)  [1]
};

/// Ranks all tests of a pool, best first. Pairs weigh  exp(-(misfit_a + misfit_b) / 2), relative to
/// the best pair's; the cap makes a test that splits many pairs better than one that splits one
/// far.
/// @param pool  predicts the tests of the pool, one after the other
/// @param tests  the pool
/// @param nets   that fit so far, with their misfits
/// Source: [Bongard2005] for the principle, [Saxena2012] for tendon networks.
[[nodiscard]] std::vector<RankedTest> rank_tests(NetForwardModel& pool,
                                                 const std::vector<TendonTest>& tests,
                                                 const std::vector<FittedNet>& nets,
                                                 const Eigen::VectorXd& typical,
                                                 const MeasurementNoise& noise);

}  // namespace thenar
