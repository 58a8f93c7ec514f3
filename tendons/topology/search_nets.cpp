#include "tendons/topology/search_nets.h"

#include <algorithm>
#include <array>
#include <utility>

#include "base/enum_names.h"
#include "base/error.h"
#include "base/numbers.h"

namespace thenar {
namespace {

// Probability that a band is in a topology of the first population [1]
constexpr double kInitialPresence = 0.7;
constexpr double kCrossoverProbability = 0.4;  // probability that a child has two parents [1]

/// Topology with the stiffnesses from which its next fit starts.
struct Member {
  Topology bands;
  Eigen::VectorXd s;
};
using Population = std::vector<Member>;

Topology random_topology(std::size_t bands, std::mt19937& random) {
  std::bernoulli_distribution present(kInitialPresence);
  Topology out(bands);
  for (std::size_t c = 0; c < bands; ++c) out[c] = present(random);
  return out;
}

Member child_of(const std::vector<FittedNet>& parents, std::mt19937& random) {
  // Pick one parent, the better ones more often.
  std::uniform_int_distribution<std::size_t> pick(0, parents.size() - 1);
  const FittedNet& mother = parents[std::min(pick(random), pick(random))];
  Member child{mother.bands, mother.fit.s};
  std::uniform_int_distribution<std::size_t> band(0, child.bands.size() - 1);
  // Cross over: take each band from either parent.
  if (parents.size() > 1 && std::bernoulli_distribution(kCrossoverProbability)(random)) {
    const FittedNet& father = parents[pick(random)];
    std::bernoulli_distribution coin(0.5);
    for (std::size_t c = 0; c < child.bands.size(); ++c)
      if (coin(random)) {
        child.bands[c] = father.bands[c];
        child.s(static_cast<Eigen::Index>(c)) = father.fit.s(static_cast<Eigen::Index>(c));
      }
  }
  // Mutate one or two bands.
  const int changes = std::bernoulli_distribution(0.5)(random) ? 1 : 2;
  for (int i = 0; i < changes; ++i) {
    const std::size_t c = band(random);
    child.bands[c] = !child.bands[c];
  }
  return child;
}

/// Fits the population to the records and evolves it.
std::vector<FittedNet> estimate(FittedNets& tried, const Population& population,
                                std::mt19937& random, const NetSearchOptions& options,
                                const Progress& progress) {
  // Fit the population to the records.
  for (const Member& member : population)
    if (!progress.stop() || !tried.best()) (void)tried.fit(member.bands, member.s);
  std::vector<FittedNet> alive;
  // Fit the children of survivors in each generation.
  for (int g = 0; g <= options.generations; ++g) {
    if (!tried.best()) return {};
    const FittedNet& best = *tried.best();
    // Descend at the end from a best net that noise does not explain.
    if (g == options.generations && !noise_explains(best.fit))
      descend(tried, best.bands, best.fit.s, options.price);
    alive = best_by_score(tried.nets_within(kInfinity), options.price,
                          static_cast<std::size_t>(options.population));
    if (g == options.generations || progress.stop()) break;
    for (int i = 0; i < options.children; ++i) {
      const Member child = child_of(alive, random);
      (void)tried.fit(child.bands, child.s);
    }
  }
  return alive;
}

/// Returns the nets with misfits divided by the square of `error`, the noise that the best net
/// leaves.
std::vector<FittedNet> with_rescaled_misfits(std::vector<FittedNet> nets, double error) {
  for (FittedNet& net : nets) net.fit.misfit /= error * error;
  return nets;
}

/// Returns whether survivors may agree by chance: there are fewer than four values per band, or
/// noise does not explain the misfit.
bool may_agree_by_chance(FittedNets& tried) {
  const Eigen::Index bands = tried.fitter().typical_EA().size();
  return tried.fitter().rows() < 4 * bands || !noise_explains(tried.best()->fit);
}

/// Chooses unmeasured tests worth measuring, at most `count`; no two with the same posture if
/// possible.
std::vector<RankedTest> choose(const std::vector<RankedTest>& ranked,
                               const std::vector<TendonTest>& pool, double enough, int count) {
  std::vector<RankedTest> chosen;
  // Take the best tests first, one per posture.
  for (const RankedTest& promise : ranked) {
    if (static_cast<int>(chosen.size()) == count || promise.disagreement < enough) break;
    const bool posture_taken = std::any_of(chosen.begin(), chosen.end(), [&](const RankedTest& c) {
      return pool[c.test].q.isApprox(pool[promise.test].q);
    });
    if (!posture_taken) chosen.push_back(promise);
  }
  return chosen;
}

/// State of the search that changes from round to round.
struct Search {
  Population population;
  std::vector<TendonRecord> records;
  std::vector<bool> used;  // measured tests of the pool

  void measure(const std::vector<RankedTest>& chosen, const std::vector<TendonTest>& pool,
               const TestOracle& oracle) {
    for (const RankedTest& promise : chosen) {
      records.push_back(oracle(pool[promise.test]));
      used[promise.test] = true;
    }
  }
};

Search begin(const CandidateNet& candidate, std::vector<TendonRecord> records,
             const std::vector<TendonTest>& pool, const TestOracle& oracle, std::mt19937& random,
             const NetSearchOptions& options) {
  Search search{{}, std::move(records), std::vector<bool>(pool.size(), false)};
  // Start with the full topology, and random ones.
  const std::size_t n = candidate.candidates.size();
  const Eigen::VectorXd one = Eigen::VectorXd::Ones(static_cast<Eigen::Index>(n));
  search.population.push_back({Topology(n, true), one});
  for (int i = 1; i < 2 * options.population; ++i)
    search.population.push_back({random_topology(n, random), one});
  // Measure two random tests if there are no records.
  while (search.records.size() < 2 && oracle) {
    std::uniform_int_distribution<int> pick(0, static_cast<int>(pool.size()) - 1);
    const int test = pick(random);
    if (!search.used[test]) search.measure({{test, 0}}, pool, oracle);
  }
  return search;
}

/// Returns the tests of the pool that are not used yet, best first.
std::vector<RankedTest> open_tests(const std::vector<RankedTest>& ranked,
                                   const std::vector<bool>& used) {
  std::vector<RankedTest> open;
  for (const RankedTest& promise : ranked)
    if (!used[promise.test]) open.push_back(promise);
  return open;
}

/// Returns the reason why the search ends. @param left  number of tests that may still be measured
NetSearchStop reason(const Progress& progress, const std::vector<RankedTest>& next, int left,
                     double enough) {
  if (progress.stop()) return NetSearchStop::kAsked;
  if (left == 0 || next.empty()) return NetSearchStop::kTests;
  return next.front().disagreement < enough ? NetSearchStop::kAgreed : NetSearchStop::kNoOracle;
}

}  // namespace

std::string to_string(NetSearchStop stop) {
  constexpr std::array kWords{
      EnumName{NetSearchStop::kAgreed, "no test sets the nets that are left apart"},
      EnumName{NetSearchStop::kTests, "no test is left to measure"},
      EnumName{NetSearchStop::kNoOracle, "more tests would tell the nets apart that are left"},
      EnumName{NetSearchStop::kAsked, "stopped"},
      EnumName{NetSearchStop::kNothingHolds, "no net carries the loads"}};
  return name_in(kWords, stop);
}

NetSearchResult search_nets(const CandidateNet& candidate, std::vector<TendonRecord> records,
                            const MeasurableTests& tests, std::mt19937& random,
                            const NetSearchOptions& options, const Progress& progress) {
  const std::vector<TendonTest>& pool = tests.pool;
  const TestOracle& oracle = tests.oracle;
  require(records.size() >= 2 || (oracle && pool.size() >= 2),
          "wanted two records, or an oracle and two tests, got {} and {}", records.size(),
          pool.size());
  Search search = begin(candidate, std::move(records), pool, oracle, random, options);
  NetForwardModel forecast(candidate, pool);
  NetSearchResult out;
  for (;;) {
    const int measured = static_cast<int>(search.records.size());
    progress(0.9 * measured / std::max(options.max_tests, measured),
             fmt::format("{} tests", measured));
    // Fit the population to all records.
    BandFitter fitter(candidate, search.records);
    FittedNets tried(fitter);
    const std::vector<FittedNet> alive =
        estimate(tried, search.population, random, options, progress);
    if (alive.empty()) return out;
    // With an oracle, answer a bad fit by more tests, not by more noise.
    const double error = oracle ? 1 : model_error(tried);
    // Rank the remaining tests by the disagreement of survivors.
    out.next = open_tests(
        rank_tests(forecast, pool, with_rescaled_misfits(alive, error), fitter.typical_EA(),
                   {error * options.noise.relative, error * options.noise.floor}),
        search.used);
    // Choose as many as a round allows.
    const int left = oracle ? std::clamp(options.max_tests - measured, 0, options.tests_a_round)
                            : options.tests_a_round;
    const std::vector<RankedTest> chosen =
        choose(out.next, pool, may_agree_by_chance(tried) ? 0 : options.enough, left);
    const int rivals =
        static_cast<int>(tried.nets_within(error * error * options.weigh.doubt).size());
    out.rounds.push_back({chosen, measured, tried.best()->fit.misfit, rivals});
    out.stop = reason(progress, out.next, left, options.enough);
    // Assess the bands if nothing more is measured.
    if (progress.stop() || chosen.empty() || !oracle) {
      const FittedNet& best = alive.front();
      if (!progress.stop()) descend(tried, best.bands, best.fit.s, options.price);
      out.net = assess_bands(tried, options.weigh, progress);
      return out;
    }
    // Measure, and continue with the survivors.
    search.measure(chosen, pool, oracle);
    search.population.clear();
    for (const FittedNet& net : alive) search.population.push_back({net.bands, net.fit.s});
  }
}

}  // namespace thenar
