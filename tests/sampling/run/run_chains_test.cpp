// Tests for sampling/run/run_chains.cpp and what it is made of.

#include "sampling/run/run_chains.h"

#include <algorithm>
#include <filesystem>

#include <gtest/gtest.h>
#include <unistd.h>

#include "base/error.h"
#include "base/random_stream.h"
#include "sampling/methods/parallel_tempering.h"
#include "sampling/run/advance.h"
#include "tests/message_of.h"
#include "tests/sampling/known_posteriors.h"
#include "tests/sampling/thread_ranks.h"

namespace thenar {
namespace {

namespace fs = std::filesystem;

/// A run of one method that takes some milliseconds, on a posterior of 2 modes.
struct Case {
  SamplingMethod method;
  int groups, walkers, temperatures;
};

std::ostream& operator<<(std::ostream& out, const Case& a) {
  return out << name_of(a.method) << ", " << a.groups << " x " << a.walkers << " x "
             << a.temperatures;
}

const sample::FunctionTarget& target() {
  static const sample::KnownPosterior posterior = sample::two_modes(2);
  return posterior.target;
}

RunOptions options_of(const Case& a) {
  RunOptions options;
  options.method = a.method;
  options.groups = a.groups;
  options.walkers = a.walkers;
  options.temperatures = a.temperatures;
  options.min_beta = 0.01;
  options.swap_every = 2;
  options.sampler.warm_up = 41;
  options.sampler.seed = 7;
  options.draws = 30;
  options.thin = 3;
  options.threads = 1;
  options.fingerprint = "two modes";
  return options;
}

Eigen::MatrixXd starts_of(const Case& a) {
  Eigen::MatrixXd starts(2, a.groups * a.walkers);
  for (int c = 0; c < starts.cols(); ++c) {
    RandomStream random(3, static_cast<std::uint32_t>(c), 0);
    starts.col(c) << -5 + random.normal(), -5 + random.normal();
  }
  return starts;
}

Draws run(const Case& a, const RunOptions& options) {
  return run_chains(target(), starts_of(a), options);
}

bool same(const StepStats& a, const StepStats& b) {
  return a.log_prior == b.log_prior && a.log_likelihood == b.log_likelihood &&
         a.acceptance == b.acceptance && a.step_size == b.step_size && a.energy == b.energy &&
         a.depth == b.depth && a.evaluations == b.evaluations && a.non_finite == b.non_finite &&
         a.divergent == b.divergent;
}

testing::AssertionResult same_draws(const Draws& a, const Draws& b) {
  if (a.chains() != b.chains() || a.draws() != b.draws() || a.group != b.group)
    return testing::AssertionFailure() << a.chains() << " x " << a.draws() << " draws against "
                                       << b.chains() << " x " << b.draws();
  for (std::size_t c = 0; c < a.x.size(); ++c) {
    if (a.x[c] != b.x[c]) return testing::AssertionFailure() << "chain " << c << " differs";
    for (std::size_t k = 0; k < a.stats[c].size(); ++k)
      if (!same(a.stats[c][k], b.stats[c][k]))
        return testing::AssertionFailure() << "statistics of draw " << k << " of chain " << c;
  }
  if (a.beta != b.beta || (a.beta.size() > 1 && a.swap_rate != b.swap_rate))
    return testing::AssertionFailure() << "rates of swaps";
  return testing::AssertionSuccess();
}

class RunChains : public testing::TestWithParam<Case> {
 protected:
  RunChains() { fs::remove_all(folder_); }
  ~RunChains() override { fs::remove_all(folder_); }

  // In memory where that is possible: a sync costs nothing there.
  const std::string folder_ = (fs::exists("/dev/shm") ? "/dev/shm/" : testing::TempDir()) +
                              "thenar_run_chains_" + std::to_string(getpid());
};

TEST_P(RunChains, GivesTheSameBitsWithAnyNumberOfThreads) {
  RunOptions options = options_of(GetParam());
  const Draws one = run(GetParam(), options);
  EXPECT_TRUE(one.complete);
  EXPECT_EQ(one.draws(), 30);
  for (const int threads : {2, 3, 8}) {
    options.threads = threads;
    EXPECT_TRUE(same_draws(run(GetParam(), options), one)) << threads << " threads";
  }
}

TEST_P(RunChains, GivesTheSameBitsWithAnyNumberOfRanks) {
  const RunOptions options = options_of(GetParam());
  const Draws one = run(GetParam(), options);
  for (const int size : {2, 3, 7}) {
    Draws first;
    sample::ThreadRanks::run(size, [&](const Communicator& ranks) {
      Draws mine = run_chains(target(), starts_of(GetParam()), options, ranks);
      if (ranks.rank() == 0)
        first = std::move(mine);
      else
        EXPECT_EQ(mine.chains(), 0);
    });
    EXPECT_TRUE(same_draws(first, one)) << size << " ranks";
  }
}

// Stopped after every leg of steps, in warm-up too, and resumed by other numbers of ranks.
TEST_P(RunChains, StoppedAndResumedGivesTheSameBits) {
  RunOptions options = options_of(GetParam());
  const Draws undisturbed = run(GetParam(), options);
  options.folder = folder_;
  options.progress.stop_requested = [] { return true; };
  Draws draws;
  int runs = 0;
  for (long at = -1; !draws.complete && runs < 200; ++runs)
    sample::ThreadRanks::run(1 + runs % 3, [&](const Communicator& ranks) {
      Draws mine = run_chains(target(), starts_of(GetParam()), options, ranks);
      if (ranks.rank() != 0) return;
      draws = std::move(mine);
      EXPECT_GE(draws.draws(), at);
      at = draws.draws();
    });
  EXPECT_EQ(runs, 41 + 90) << "one step a run";
  EXPECT_TRUE(same_draws(draws, undisturbed));
}

TEST_P(RunChains, FromAFolderGivesWhatMemoryGives) {
  RunOptions options = options_of(GetParam());
  const Draws memory = run(GetParam(), options);
  options.folder = folder_;
  options.checkpoint_every = 0;
  EXPECT_TRUE(same_draws(run(GetParam(), options), memory));
  EXPECT_TRUE(same_draws(run(GetParam(), options), memory)) << "a complete run is only read";
}

INSTANTIATE_TEST_SUITE_P(Methods, RunChains,
                         testing::Values(Case{SamplingMethod::kAdaptiveMetropolis, 3, 1, 1},
                                         Case{SamplingMethod::kAdaptiveMetropolis, 1, 1, 4},
                                         Case{SamplingMethod::kDreamZs, 2, 4, 1},
                                         Case{SamplingMethod::kDreamZs, 2, 4, 3},
                                         Case{SamplingMethod::kStretchMove, 2, 6, 1},
                                         Case{SamplingMethod::kStretchMove, 1, 6, 5},
                                         Case{SamplingMethod::kHmc, 2, 1, 1},
                                         Case{SamplingMethod::kHmc, 2, 1, 3},
                                         Case{SamplingMethod::kNuts, 4, 1, 1},
                                         Case{SamplingMethod::kNuts, 3, 1, 3}));

const Case kCase{SamplingMethod::kAdaptiveMetropolis, 2, 1, 1};
using RunChainsOnce = RunChains;

// By hand: each chain alone, every third step after warm-up.
TEST(RunChainsPlain, DrawsAreEveryThirdStepOfTheSamplers) {
  const RunOptions options = options_of(kCase);
  const Draws draws = run(kCase, options);
  for (int chain = 0; chain < 2; ++chain) {
    SamplerOptions alone = options.sampler;
    alone.first_chain = chain;
    const auto sampler = build_sampler(options.method, starts_of(kCase).col(chain), alone);
    for (int k = 0; k < 30; ++k) {
      int evaluations = 0;
      for (int i = 0; i < 3; ++i) {
        advance({sampler.get()}, target(), 41 + 3 * k + i + 1);
        evaluations += sampler->stats()[0].evaluations;
      }
      EXPECT_EQ(draws.x[std::size_t(chain)].col(k), sampler->positions().col(0));
      const StepStats& stats = draws.stats[std::size_t(chain)][std::size_t(k)];
      EXPECT_EQ(stats.log_likelihood, sampler->stats()[0].log_likelihood);
      EXPECT_EQ(stats.evaluations, evaluations) << "of all steps since the last draw";
    }
  }
}

// By hand: two rungs that swap every second step, as decide_swaps() says.
TEST(RunChainsPlain, RungsSwapAsDecided) {
  const Case tempered{SamplingMethod::kAdaptiveMetropolis, 1, 1, 2};
  RunOptions options = options_of(tempered);
  options.min_beta = 0.3;
  const Draws draws = run(tempered, options);
  std::vector<std::unique_ptr<Sampler>> rungs;
  for (int t = 0; t < 2; ++t) {
    SamplerOptions alone = options.sampler;
    alone.first_chain = t;
    alone.beta = t == 0 ? 1 : 0.3;
    rungs.push_back(build_sampler(options.method, starts_of(tempered), alone));
  }
  double tried = 0, accepted = 0;
  for (long step = 1; step <= 41 + 90; ++step) {
    for (const auto& rung : rungs) advance({rung.get()}, target(), step);
    if (step > 41 && (step - 41) % 3 == 0) {
      EXPECT_EQ(draws.x[0].col((step - 41) / 3 - 1), rungs[0]->positions().col(0)) << step;
    }
    if (step % 2 != 0) continue;
    const Densities cold = rungs[0]->density(0), hot = rungs[1]->density(0);
    const Swaps swaps = decide_swaps(
        Eigen::Vector2d(1, 0.3), Eigen::RowVector2d(cold.log_likelihood[0], hot.log_likelihood[0]),
        7, 0, static_cast<std::uint32_t>(step / 2));
    if (step > 41) {
      tried += swaps.tried(0, 0) ? 1 : 0;
      accepted += swaps.exchange(0, 0) ? 1 : 0;
    }
    if (!swaps.exchange(0, 0)) continue;
    const Eigen::VectorXd x = rungs[0]->positions().col(0), y = rungs[1]->positions().col(0);
    rungs[0]->move(0, y, hot);
    rungs[1]->move(0, x, cold);
  }
  EXPECT_GT(accepted, 0);
  EXPECT_EQ(draws.swap_rate(0, 0), accepted / tried);
}

// All start in the lesser mode. P(x > 0) = 2/3; batches of 500 draws tell the standard error.
TEST(RunChainsPlain, TemperedChainsFindTheWeightsOfTheModes) {
  const Case tempered{SamplingMethod::kAdaptiveMetropolis, 2, 1, 6};
  RunOptions options = options_of(tempered);
  options.swap_every = 1;
  options.sampler.warm_up = 2000;
  options.draws = 20000;
  options.thin = 1;
  const Draws draws = run(tempered, options);
  const Eigen::MatrixXd x = draws.coordinate(0);
  const Eigen::MatrixXd right = (x.array() > 0).cast<double>().matrix();
  const Eigen::VectorXd batches =
      Eigen::Map<const Eigen::MatrixXd>(right.data(), 500, right.size() / 500)
          .colwise()
          .mean()
          .transpose();
  const double mean = batches.mean();
  const double error = std::sqrt((batches.array() - mean).square().sum() /
                                 double(batches.size() - 1) / double(batches.size()));
  EXPECT_NEAR(mean, 2.0 / 3, 4 * error);
  EXPECT_LT(error, 0.03);
}

// From a normal prior of sd 10 in 8 dimensions to a normal of sd 1, by a ladder that is uneven.
TEST(RunChainsPlain, WarmUpEvensOutTheSwaps) {
  const sample::FunctionTarget narrow(
      8,
      [](const Eigen::VectorXd& x, Eigen::VectorXd& by) {
        by = -x;
        return 0.5 * x.dot(by);
      },
      10);
  RunOptions options = options_of({SamplingMethod::kNuts, 2, 1, 8});
  options.min_beta = 0;
  options.swap_every = 1;
  options.thin = 1;
  options.draws = 4000;
  const auto rates = [&](long warm_up) -> Eigen::VectorXd {
    options.sampler.warm_up = warm_up;
    const Draws draws = run_chains(narrow, Eigen::MatrixXd::Zero(8, 2), options);
    EXPECT_EQ(draws.beta[0], 1);
    EXPECT_EQ(draws.beta[7], 0);
    return draws.swap_rate.rowwise().mean();
  };
  const Eigen::VectorXd uneven = rates(30), even = rates(4000);  // 30: too few swaps to learn
  EXPECT_GT(uneven.maxCoeff() - uneven.minCoeff(), 0.3) << uneven.transpose();
  EXPECT_LT(even.maxCoeff() - even.minCoeff(), 0.1) << even.transpose();
  EXPECT_GT(even.minCoeff(), uneven.minCoeff()) << even.transpose();
}

TEST_F(RunChainsOnce, MoreDrawsGoOnAndFewerAreTheFirst) {
  RunOptions options = options_of(kCase);
  options.draws = 50;
  const Draws fifty = run(kCase, options);
  options.folder = folder_;
  options.draws = 20;
  (void)run(kCase, options);
  options.draws = 50;
  EXPECT_TRUE(same_draws(run(kCase, options), fifty));
  options.draws = 10;
  const Draws ten = run(kCase, options);
  EXPECT_TRUE(ten.complete);
  EXPECT_EQ(ten.x[1], fifty.x[1].leftCols(10));
}

TEST_F(RunChainsOnce, CheckpointOfAnotherRunIsRefused) {
  RunOptions options = options_of(kCase);
  options.folder = folder_;
  (void)run(kCase, options);
  options.sampler.seed = 8;
  options.fingerprint = "three modes";
  EXPECT_EQ(message_of([&] { (void)run(kCase, options); }),
            "the checkpoint in '" + folder_ +
                "' belongs to another run; what differs: seed (was 7, is 8), "
                "target (was two modes, is three modes)");
  // All ranks throw alike: none waits for another.
  sample::ThreadRanks::run(2, [&](const Communicator& ranks) {
    EXPECT_THROW((void)run_chains(target(), starts_of(kCase), options, ranks), InputError);
  });
}

TEST(RunChainsPlain, ProgressRisesToTheEndAndNamesThePhase) {
  RunOptions options = options_of(kCase);
  std::vector<double> fractions;
  std::vector<std::string> texts;
  options.progress.report = [&](double fraction, const std::string& what) {
    fractions.push_back(fraction);
    texts.push_back(what);
  };
  (void)run(kCase, options);
  EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
  EXPECT_EQ(texts.front(), "warm-up, step 1 of 41, 0 s left");
  EXPECT_EQ(fractions.back(), 1);
  EXPECT_EQ(texts.back(), "sampling, draw 30 of 30, 0 s left");
}

TEST(RunChainsPlain, ProgressCountsDivergences) {
  const sample::KnownPosterior funnel = sample::funnel(10, true);
  RunOptions options = options_of({SamplingMethod::kNuts, 4, 1, 1});
  options.sampler.warm_up = 100;
  options.draws = 300;
  options.thin = 1;
  std::string last;
  options.progress.report = [&](double, const std::string& what) { last = what; };
  const Draws draws = run_chains(funnel.target, Eigen::MatrixXd::Ones(10, 4), options);
  long divergent = 0;
  for (const auto& chain : draws.stats)
    for (const StepStats& stats : chain) divergent += stats.divergent ? 1 : 0;
  ASSERT_GT(divergent, 0) << "the neck of a funnel is too narrow for any step";
  EXPECT_NE(last.find(", " + std::to_string(divergent) + " divergent"), std::string::npos) << last;
}

/// A target that fails, as none should.
class Throwing : public Target {
 public:
  [[nodiscard]] int size() const override { return 2; }
  [[nodiscard]] Densities evaluate(const Eigen::Ref<const Eigen::MatrixXd>&,
                                   WithGradient) const override {
    throw InputError("no density here");
  }
};

TEST(RunChainsPlain, WhatAThreadThrowsArrives) {
  RunOptions options = options_of(kCase);
  options.threads = 2;
  EXPECT_EQ(message_of([&] { (void)run_chains(Throwing(), starts_of(kCase), options); }),
            "no density here");
}

TEST(RunChainsPlain, RefusesOptionsThatDoNotFit) {
  const auto refusal = [](const std::function<void(RunOptions&)>& change) {
    RunOptions options = options_of(kCase);
    change(options);
    return message_of([&] { (void)run(kCase, options); });
  };
  EXPECT_EQ(refusal([](RunOptions& o) { o.groups = 3; }),
            "wanted a start for each of 3 groups of 1 walkers, got 2");
  EXPECT_EQ(refusal([](RunOptions& o) { o.thin = 0; }), "steps a draw must be >= 1, got 0");
  EXPECT_EQ(refusal([](RunOptions& o) { o.swap_every = 0; }),
            "steps between swaps must be >= 1, got 0");
  EXPECT_EQ(refusal([](RunOptions& o) { o.temperatures = 0; }), "temperatures must be >= 1, got 0");
  EXPECT_EQ(refusal([](RunOptions& o) { o.draws = -1; }), "draws must be >= 0, got -1");
}

}  // namespace
}  // namespace thenar
