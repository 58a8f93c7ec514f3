#pragma once

/// The test that would tell most: on which models that agree so far disagree most.

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

/// What one test of a pool promises.
struct RankedTest {
  int test = -1;            // of the pool; -1: none
  double disagreement = 0;  // mean over pairs of models of  min(|difference / sd|^2, 25)  [1]
};

/// Promises of all tests of a pool, best first. Pairs weigh  exp(-(misfit_a + misfit_b) / 2), less
/// the best's; the cap makes a test that splits many pairs better than one that splits one far.
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
