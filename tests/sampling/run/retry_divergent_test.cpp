// Tests for sampling/run/retry_divergent.cpp.

#include "sampling/run/retry_divergent.h"

#include <cmath>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <unistd.h>

#include "base/error.h"
#include "tests/message_of.h"
#include "tests/sampling/known_posteriors.h"
#include "tests/sampling/thread_ranks.h"

namespace thenar {
namespace {

namespace fs = std::filesystem;

constexpr int kSize = 10;

/// Straight, diagonal coordinates: a learnt bend would make divergences rare.
RunOptions short_nuts() {
  RunOptions options;
  options.sampler.metric = Metric::kDiagonal;
  options.method = SamplingMethod::kNuts;
  options.groups = 4;
  options.sampler.warm_up = 200;
  options.sampler.seed = 7;
  options.draws = 300;
  options.threads = 1;
  options.fingerprint = "funnel";
  return options;
}

Eigen::MatrixXd ones(const RunOptions& options) {
  return Eigen::MatrixXd::Ones(kSize, options.groups);
}

RetriedDraws retried(const sample::KnownPosterior& posterior, const RunOptions& options,
                     const std::vector<double>& target_acceptances) {
  return retry_divergent(posterior.target, ones(options), options, target_acceptances,
                         *single_process());
}

long divergent_draws(const Draws& draws) {
  long sum = 0;
  for (const auto& chain : draws.stats)
    for (const StepStats& stats : chain) sum += stats.divergent ? 1 : 0;
  return sum;
}

testing::AssertionResult same_positions(const Draws& a, const Draws& b) {
  if (a.chains() != b.chains()) return testing::AssertionFailure() << "numbers of chains";
  for (std::size_t c = 0; c < a.x.size(); ++c)
    if (a.x[c] != b.x[c]) return testing::AssertionFailure() << "draws of chain " << c;
  return testing::AssertionSuccess();
}

class RetryDivergent : public testing::Test {
 protected:
  RetryDivergent() { fs::remove_all(folder_); }
  ~RetryDivergent() override { fs::remove_all(folder_); }

  const sample::KnownPosterior neck_ = sample::funnel(kSize, true),
                               round_ = sample::funnel(kSize, false);
  const std::string folder_ = testing::TempDir() + "thenar_retry_" + std::to_string(getpid());
};

// A normal density has no place where steps are too long.
TEST_F(RetryDivergent, LeavesChainsThatDoNotDivergeAsTheyAre) {
  RunOptions options = short_nuts();
  options.sampler.target_acceptance = 0.9;
  const RetriedDraws got = retried(round_, options, {0.95, 0.99});
  EXPECT_TRUE(got.abandoned.empty());
  EXPECT_EQ(got.target_acceptance, 0.9);
  EXPECT_TRUE(same_positions(got.draws, run_chains(round_.target, ones(options), options)));
}

// The neck of the centred funnel is too narrow for any step: every attempt meets it, in time.
TEST_F(RetryDivergent, EndsWithTheLastAttemptWhole) {
  RunOptions options = short_nuts();
  options.draws = 2000;
  const RetriedDraws got = retried(neck_, options, {0.9, 0.95});
  EXPECT_EQ(got.abandoned, (std::vector<double>{0.8, 0.9}));
  EXPECT_EQ(got.target_acceptance, 0.95);
  EXPECT_TRUE(got.draws.complete);
  EXPECT_FALSE(got.draws.ended_at_divergence);
  EXPECT_GT(divergent_draws(got.draws), 0);
  // The draws of the last attempt alone.
  RunOptions last = options;
  last.sampler.target_acceptance = 0.95;
  EXPECT_TRUE(same_positions(got.draws, run_chains(neck_.target, ones(options), last)));
}

// The banana bends everywhere by a bounded amount: small enough steps follow it.
TEST_F(RetryDivergent, StopsRetryingOnceNothingDiverges) {
  const auto shallow = sample::FunctionTarget(2, [](const Eigen::VectorXd& x, Eigen::VectorXd& by) {
    // Banana: x1 ~ N(x0^2, 0.1), x0 ~ N(1, 3.2).
    const double bend = x[1] - x[0] * x[0], off = x[0] - 1;
    by[0] = 20 * bend * x[0] - off / 10;
    by[1] = -10 * bend;
    return -5 * bend * bend - off * off / 20;
  });
  RunOptions options = short_nuts();
  const Eigen::MatrixXd starts = Eigen::MatrixXd::Ones(2, options.groups);
  const RetriedDraws got =
      retry_divergent(shallow, starts, options, {0.9, 0.999, 0.9999}, *single_process());
  EXPECT_GE(got.abandoned.size(), 1u) << "at 0.8 the ends of the banana diverge";
  EXPECT_LT(got.abandoned.size(), 3u);
  EXPECT_EQ(divergent_draws(got.draws), 0);
  EXPECT_TRUE(got.draws.complete);
}

TEST_F(RetryDivergent, GivesTheSameBitsWithAnyNumberOfRanks) {
  const RunOptions options = short_nuts();
  const RetriedDraws one = retried(neck_, options, {0.95});
  for (const int size : {2, 3}) {
    RetriedDraws first;
    sample::ThreadRanks::run(size, [&](const Communicator& ranks) {
      RetriedDraws mine = retry_divergent(neck_.target, ones(options), options, {0.95}, ranks);
      EXPECT_EQ(mine.abandoned, one.abandoned);
      if (ranks.rank() == 0) first = std::move(mine);
    });
    EXPECT_TRUE(same_positions(first.draws, one.draws)) << size << " ranks";
  }
}

// Stopped after each leg of steps, in all attempts; the abandoned ones are not run again.
TEST_F(RetryDivergent, StoppedAndResumedGivesTheSameBits) {
  RunOptions options = short_nuts();
  options.checkpoint_every = 0;
  const RetriedDraws whole = retried(neck_, options, {0.95});
  options.folder = folder_;
  int left = 0;  // polls before the next stop
  options.progress.stop_requested = [&] { return --left < 0; };
  RetriedDraws got;
  int runs = 0;
  for (; !got.draws.complete && runs < 2000; ++runs) {
    left = 40;
    got = retried(neck_, options, {0.95});
  }
  EXPECT_GT(runs, 3);
  EXPECT_EQ(got.abandoned, whole.abandoned);
  EXPECT_TRUE(same_positions(got.draws, whole.draws));
  EXPECT_TRUE(fs::exists(folder_ + "/acceptance_0.95/state.bin"));
}

TEST_F(RetryDivergent, SaysWhichAttemptItIsIn) {
  RunOptions options = short_nuts();
  std::string last;
  options.progress.report = [&](double, const std::string& what) { last = what; };
  (void)retried(neck_, options, {0.95});
  EXPECT_EQ(last.find("anew at target acceptance 0.95: sampling, draw 300 of 300"), 0u) << last;
}

TEST_F(RetryDivergent, TriesOnlyHigherAcceptances) {
  RunOptions options = short_nuts();
  options.sampler.target_acceptance = 0.97;
  const RetriedDraws got = retried(neck_, options, {0.9, 0.95});
  EXPECT_TRUE(got.abandoned.empty());
  EXPECT_TRUE(got.draws.complete);
}

TEST_F(RetryDivergent, RefusesAcceptancesThatDoNotAscend) {
  const RunOptions options = short_nuts();
  const auto with = [&](const std::vector<double>& next) {
    return message_of<InputError>([&] { (void)retried(round_, options, next); });
  };
  EXPECT_NE(with({0.99, 0.95}).find("got 0.99 0.95"), std::string::npos);
  EXPECT_NE(with({1.0}).find("between 0 and 1"), std::string::npos);
  EXPECT_NE(with({NAN}).find("between 0 and 1"), std::string::npos);
}

}  // namespace
}  // namespace thenar
