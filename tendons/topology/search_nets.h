#pragma once

/// Topology by search: a population of nets that explain the measurements, and tests chosen to
/// discriminate between them.

#include <functional>
#include <random>
#include <vector>

#include "base/progress.h"
#include "tendons/topology/assess_bands.h"
#include "tendons/topology/net_search_stop.h"
#include "tendons/topology/rank_tests.h"

namespace thenar {

/// Options of search_nets().
struct NetSearchOptions {
  int population = 12;     // topologies that survive a round
  int generations = 2;     // generations per round
  int children = 10;       // children per generation
  int tests_a_round = 3;   // tests measured before the population is fitted again
  int max_tests = 36;      // total number of tests, initial ones included
  double enough = 1;       // disagreement of the best test below which the search ends [1]
  double price = 4;        // price of a band, in chi^2 [1]
  MeasurementNoise noise;  // noise of future readings
  AssessOptions weigh;
};

/// Tests and best misfit of one round.
struct NetSearchRound {
  std::vector<RankedTest> measured;  // tests measured in this round
  int tests = 0;                     // number of tests measured before
  double misfit = 0;                 // chi^2 of the best net before [1]
  int rivals = 0;                    // number of nets within `doubt` of it
};

/// Result of search_nets().
struct [[nodiscard]] NetSearchResult {
  NetSearchStop stop = NetSearchStop::kNothingHolds;
  std::vector<NetSearchRound> rounds;
  std::vector<RankedTest> next;  // tests most worth measuring next, best first
  InferredNet net;
};

/// Source of readings: an experiment, or a planted net.
using TestOracle = std::function<TendonRecord(const TendonTest& test)>;

/// Tests that may be measured during a search.
struct MeasurableTests {
  std::vector<TendonTest> pool;
  TestOracle oracle;  // empty: nothing is measured, the next tests are only named
};

/// Alternates estimation and exploration. Estimation: topologies change by single bands and by
/// crossover, each fitted to all records; the best by  chi^2 + price * bands  survive. Exploration:
/// the tests of the pool on which survivors disagree most are measured next. In the end the bands
/// are assessed.
/// @param records  known measurements; may be empty if there is an oracle
/// Source: [Bongard2005], [ValeroCuevas2007], [Saxena2012].
[[nodiscard]] NetSearchResult search_nets(const CandidateNet& candidate,
                                          std::vector<TendonRecord> records,
                                          const MeasurableTests& tests, std::mt19937& random,
                                          const NetSearchOptions& options = {},
                                          const Progress& progress = {});

}  // namespace thenar
