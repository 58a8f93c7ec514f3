// A planted net of 14 candidate bands, 5 % noise: false and missed bands over some trials. The
// environment's THENAR_TRIALS sets how many (50 take minutes), THENAR_SEED the first seed.

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tendons/topology/assess_bands.h"
#include "tendons/topology/search_nets.h"
#include "tendons/topology/select_bands.h"
#include "tests/tendons/topology/planted_finger.h"

namespace thenar {
namespace {

unsigned asked(const char* name, unsigned otherwise) {
  const char* value = std::getenv(name);
  return value ? static_cast<unsigned>(std::atoi(value)) : otherwise;
}
/// Trials to do; few unless asked.
unsigned trials() { return asked("THENAR_TRIALS", 2); }
/// Seed of a trial.
unsigned seed_of(unsigned trial) { return asked("THENAR_SEED", 1) + trial; }
constexpr double kNoise = 0.05;

/// Verdicts over all trials.
struct Count {
  int right = 0, wrong_yes = 0, wrong_no = 0, undecided = 0;
  double shortfall = 0;  // largest chi^2 found, less that of the planted bands [1]
  void add(const InferredNet& net, const Eigen::VectorXd& planted, double planted_misfit) {
    shortfall = std::max(shortfall, net.misfit - planted_misfit);
    for (std::size_t c = 0; c < net.verdicts.size(); ++c) {
      const bool exists = planted(static_cast<Eigen::Index>(c)) > 0;
      if (net.verdicts[c].verdict == Verdict::kUndecided)
        ++undecided;
      else if ((net.verdicts[c].verdict == Verdict::kYes) == exists)
        ++right;
      else
        ++(exists ? wrong_no : wrong_yes);
    }
  }
  [[nodiscard]] int decided() const { return right + wrong_yes + wrong_no; }
};

/// A verdict is wrong with a chance of at most Phi(-sqrt 6) = 0.715 % (docs/theory/topology.md). Of
/// n verdicts more than this many are wrong with a chance below 0.1 %: mean plus 3.1 sd of a
/// Poisson count, rounded up.
int most_wrong(int verdicts) {
  const double mean = 0.00715 * verdicts;
  return static_cast<int>(std::ceil(mean + 3.1 * std::sqrt(mean)));
}

void report(const char* method, const Count& count) {
  fmt::print("{}: {} trials, {} right, {} false, {} missed, {} undecided, shortfall {:.3f}\n",
             method, trials(), count.right, count.wrong_yes, count.wrong_no, count.undecided,
             count.shortfall);
}

/// Least chi^2 of the planted bands, fitted from their own stiffness.
double planted_misfit(BandFitter& fitter, const Eigen::VectorXd& EA) {
  std::vector<bool> bands;
  for (double stiffness : EA) bands.push_back(stiffness > 0);
  return fitter.fit(topology_presences(bands), EA.cwiseQuotient(fitter.typical_EA())).misfit;
}

/// The best net of a search over topologies fits as well as the planted one: otherwise it stopped
/// in a local minimum, and no verdict of it means anything. chi^2; ten times what a fit stops at.
constexpr double kShortfall = 0.1;

void expect_recovery(const char* method, const Count& count) {
  report(method, count);
  EXPECT_LE(count.shortfall, kShortfall);
  EXPECT_LE(count.wrong_yes + count.wrong_no, most_wrong(count.decided()));
  EXPECT_GT(count.right, 0.7 * trials() * planted::candidate_finger().candidates.size());
}

TEST(PlantedNet, SparseSelectionRecoversItsBands) {
  const CandidateNet candidate = planted::candidate_finger();
  const std::vector<TendonTest> tests = planted::finger_tests();
  Count count;
  for (unsigned trial = 0; trial < trials(); ++trial) {
    std::mt19937 random(seed_of(trial));
    const Eigen::VectorXd EA = planted::plant(candidate, tests, random);
    BandFitter fitter(candidate, planted::measure(candidate, EA, tests, kNoise, random));
    FittedNets tried(fitter);
    (void)select_bands(tried);
    count.add(assess_bands(tried), EA, planted_misfit(fitter, EA));
  }
  expect_recovery("sparse", count);
}

TEST(PlantedNet, SearchRecoversItsBandsFromTestsOfItsChoice) {
  const CandidateNet candidate = planted::candidate_finger();
  const std::vector<TendonTest> pool = planted::finger_tests();
  Count count;
  for (unsigned trial = 0; trial < trials(); ++trial) {
    std::mt19937 random(seed_of(trial)), search(seed_of(trial) + 100000);
    const Eigen::VectorXd EA = planted::plant(candidate, pool, random);
    std::vector<TendonRecord> records;
    const auto oracle = [&](const TendonTest& test) {
      records.push_back(planted::measure(candidate, EA, {test}, kNoise, random)[0]);
      return records.back();
    };
    const InferredNet net = search_nets(candidate, {}, {pool, oracle}, search).net;
    BandFitter fitter(candidate, records);
    count.add(net, EA, planted_misfit(fitter, EA));
  }
  expect_recovery("search", count);
}

}  // namespace
}  // namespace thenar
