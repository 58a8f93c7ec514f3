// A planted net of 14 candidate bands, 5 % noise: false and missed bands over some trials. The
// environment's THENAR_TRIALS sets how many: 50 take minutes.

#include <cmath>
#include <cstdlib>

#include <gtest/gtest.h>

#include "tendons/topology/explore_nets.h"
#include "tendons/topology/select_bands.h"
#include "tendons/topology/weigh_bands.h"
#include "tests/tendons/topology/planted_finger.h"

namespace thenar {
namespace {

/// Trials to do; few unless asked.
unsigned trials() {
  const char* asked = std::getenv("THENAR_TRIALS");
  return asked ? static_cast<unsigned>(std::atoi(asked)) : 3;
}
constexpr double kNoise = 0.05;

/// Verdicts over all trials.
struct Count {
  int right = 0, wrong_yes = 0, wrong_no = 0, undecided = 0;
  void add(const InferredNet& net, const Eigen::VectorXd& planted) {
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
  ::testing::Test::RecordProperty(std::string(method) + "_false", count.wrong_yes);
  ::testing::Test::RecordProperty(std::string(method) + "_missed", count.wrong_no);
  ::testing::Test::RecordProperty(std::string(method) + "_undecided", count.undecided);
}

TEST(PlantedNet, SparseSelectionRecoversItsBands) {
  const CandidateNet candidate = planted::candidate_finger();
  const std::vector<TendonTest> tests = planted::finger_tests();
  Count count;
  for (unsigned trial = 1; trial <= trials(); ++trial) {
    std::mt19937 random(trial);
    const Eigen::VectorXd EA = planted::plant(candidate, tests, random);
    BandFitter fitter(candidate, planted::measure(candidate, EA, tests, kNoise, random));
    TriedNets tried(fitter);
    (void)select_bands(tried);
    count.add(weigh_bands(tried), EA);
  }
  report("sparse", count);
  EXPECT_LE(count.wrong_yes + count.wrong_no, most_wrong(count.decided()));
  EXPECT_GT(count.right, 0.7 * trials() * candidate.candidates.size());
}

TEST(PlantedNet, SearchRecoversItsBandsFromTestsOfItsChoice) {
  const CandidateNet candidate = planted::candidate_finger();
  const std::vector<TendonTest> pool = planted::finger_tests();
  Count count;
  for (unsigned trial = 1; trial <= trials(); ++trial) {
    std::mt19937 random(trial), search(100 + trial);
    const Eigen::VectorXd EA = planted::plant(candidate, pool, random);
    const auto oracle = [&](const TendonTest& test) {
      return planted::measure(candidate, EA, {test}, kNoise, random)[0];
    };
    count.add(explore_nets(candidate, {}, pool, oracle, search).net, EA);
  }
  report("search", count);
  EXPECT_LE(count.wrong_yes + count.wrong_no, most_wrong(count.decided()));
  EXPECT_GT(count.right, 0.7 * trials() * candidate.candidates.size());
}

}  // namespace
}  // namespace thenar
