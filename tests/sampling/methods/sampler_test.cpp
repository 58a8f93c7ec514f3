// What every sampler owes to its driver: tests for sampling/methods/sampler.cpp and all that it
// builds.

#include "sampling/methods/sampler.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/numbers.h"
#include "tests/sampling/collect_draws.h"
#include "tests/sampling/known_posteriors.h"

namespace thenar {
namespace {

using sample::build_groups;
using sample::collect;
using sample::Collected;
using sample::normal_starts;

/// Prior and likelihood, each with its gradient, of one point.
class SplitTarget : public Target {
 public:
  using Part = std::function<double(const Eigen::VectorXd& x, Eigen::VectorXd& gradient)>;
  SplitTarget(int n, Part prior, Part likelihood)
      : n_(n), prior_(std::move(prior)), likelihood_(std::move(likelihood)) {}

  [[nodiscard]] int size() const override { return n_; }
  [[nodiscard]] Densities evaluate(const Eigen::Ref<const Eigen::MatrixXd>& x,
                                   WithGradient want) const override {
    Densities at{Eigen::VectorXd(x.cols()), Eigen::VectorXd(x.cols()), x, x};
    for (Eigen::Index k = 0; k < x.cols(); ++k) {
      Eigen::VectorXd by = Eigen::VectorXd::Zero(n_);
      at.log_prior[k] = prior_(x.col(k), by);
      at.prior_gradient.col(k) = by;
      by.setZero();
      at.log_likelihood[k] = likelihood_(x.col(k), by);
      at.likelihood_gradient.col(k) = by;
    }
    if (want == WithGradient::kNo) at.prior_gradient = at.likelihood_gradient = {};
    return at;
  }

 private:
  int n_;
  Part prior_, likelihood_;
};

double flat(const Eigen::VectorXd&, Eigen::VectorXd&) { return 0; }
double standard_normal(const Eigen::VectorXd& x, Eigen::VectorXd& by) {
  by = -x;
  return -0.5 * x.squaredNorm();
}

/// Standard normal likelihood; beyond x_0 = 1 the model gives `there` instead.
SplitTarget cut_normal(int n, double there) {
  return {n, flat, [there](const Eigen::VectorXd& x, Eigen::VectorXd& by) {
            return x[0] > 1 ? there : standard_normal(x, by);
          }};
}

class EverySampler : public testing::TestWithParam<SamplingMethod> {
 protected:
  [[nodiscard]] int each() const {
    return GetParam() == SamplingMethod::kStretchMove ? 8
           : GetParam() == SamplingMethod::kDreamZs   ? 4
                                                      : 1;
  }
  [[nodiscard]] std::vector<std::unique_ptr<Sampler>> build(const Target& target,
                                                            const SamplerOptions& options,
                                                            int groups = 1) const {
    return build_groups(GetParam(), normal_starts(target.size(), groups * each(), 0.5), each(),
                        options);
  }
  [[nodiscard]] bool hamiltonian() const {
    return GetParam() == SamplingMethod::kHmc || GetParam() == SamplingMethod::kNuts;
  }
  /// 1000 draws of each of some chains after warm-up, from far more steps where steps are short.
  [[nodiscard]] Collected draw(const Target& target, SamplerOptions options = {},
                               int longer = 1) const {
    options.warm_up = hamiltonian() ? 500 : 2000;
    const int groups = each() == 1 ? 4 : 2, thin = hamiltonian() ? 1 : each() == 1 ? 20 : 10;
    const auto samplers = build(target, options, groups);
    (void)collect(samplers, target, options.warm_up);
    return collect(samplers, target, 1000, longer * thin);
  }
};

std::string test_name(const testing::TestParamInfo<SamplingMethod>& test) {
  std::string name = name_of(test.param);
  for (char& c : name)
    if (c == '-') c = '_';
  return name;
}

INSTANTIATE_TEST_SUITE_P(Samplers, EverySampler,
                         testing::Values(SamplingMethod::kAdaptiveMetropolis,
                                         SamplingMethod::kDreamZs, SamplingMethod::kStretchMove,
                                         SamplingMethod::kHmc, SamplingMethod::kNuts),
                         test_name);

void expect_mean(const Eigen::MatrixXd& x, double mean) {
  EXPECT_LT(rank_r_hat(x), 1.01);
  EXPECT_NEAR(x.mean(), mean, 4 * mean_mcse(x));
}

void expect_moments(const Eigen::MatrixXd& x, double mean, double sd) {
  expect_mean(x, mean);
  EXPECT_NEAR(std::sqrt((x.array() - x.mean()).square().mean()), sd, 4 * sd_mcse(x));
}

TEST(SamplingMethods, HaveNames) {
  EXPECT_EQ(sampling_method("dream-zs"), SamplingMethod::kDreamZs);
  for (const char* name : {"adaptive-metropolis", "dream-zs", "stretch", "hmc", "nuts"})
    EXPECT_EQ(name_of(sampling_method(name)), name);
  EXPECT_THROW((void)sampling_method("gibbs"), InputError);
}

TEST_P(EverySampler, RefusesNonsense) {
  const Eigen::MatrixXd starts = normal_starts(2, each(), 1);
  SamplerOptions hot, odd, non_finite;
  hot.beta = 1.5;
  odd.covariance = Eigen::MatrixXd::Identity(3, 3);
  non_finite.covariance = -Eigen::MatrixXd::Identity(2, 2);
  EXPECT_THROW((void)build_sampler(GetParam(), starts, hot), InputError);
  EXPECT_THROW((void)build_sampler(GetParam(), starts, odd), InputError);
  if (GetParam() != SamplingMethod::kStretchMove) {  // which has no use for it
    EXPECT_THROW((void)build_sampler(GetParam(), starts, non_finite), InputError);
  }
  EXPECT_THROW((void)build_sampler(GetParam(), kNaN * starts, {}), InputError);
}

TEST(EnsembleSamplers, WantEnoughWalkers) {
  for (const int walkers : {2, 5})
    EXPECT_THROW(
        (void)build_sampler(SamplingMethod::kStretchMove, normal_starts(3, walkers, 1), {}),
        InputError);
  EXPECT_THROW((void)build_sampler(SamplingMethod::kDreamZs, normal_starts(3, 2, 1), {}),
               InputError);
}

TEST_P(EverySampler, DrawsDependOnSeedAndChainNumberAlone) {
  const auto known = sample::gaussian(3, 10);
  SamplerOptions options;
  options.warm_up = 50;
  const auto together = build(known.target, options, 3), alone = build(known.target, options, 3);
  (void)collect(together, known.target, 120);
  for (const auto& sampler : alone) advance({sampler.get()}, known.target, 120);
  for (std::size_t g = 0; g < 3; ++g)
    EXPECT_EQ(together[g]->positions(), alone[g]->positions()) << g;

  // The same starts with another seed, or as other chains, go elsewhere.
  options.seed = 2;
  const auto other_seed = build(known.target, options);
  options.seed = 1;
  options.first_chain = each();
  const auto other_chain = build_sampler(GetParam(), normal_starts(3, each(), 0.5), options);
  advance({other_seed[0].get(), other_chain.get()}, known.target, 120);
  EXPECT_NE(other_seed[0]->positions(), alone[0]->positions());
  EXPECT_NE(other_chain->positions(), alone[0]->positions());
}

// Before the first density, within warm-up, at its end, and later.
TEST_P(EverySampler, GoesOnAfterRestoreAsIfNothingHappened) {
  const auto known = sample::banana();
  SamplerOptions options;
  options.warm_up = 60;
  for (const long at : {0, 37, 60, 80}) {
    const auto whole = build(known.target, options), first = build(known.target, options),
               second = build(known.target, options);
    advance({whole[0].get()}, known.target, 150);
    advance({first[0].get()}, known.target, at);
    StateWriter saved;
    first[0]->save(saved);
    StateReader reader(saved.bytes());
    second[0]->restore(reader);
    EXPECT_TRUE(reader.at_end());
    EXPECT_EQ(second[0]->steps(), at);
    EXPECT_EQ(second[0]->positions(), first[0]->positions());
    EXPECT_EQ(second[0]->asks(), first[0]->asks());
    advance({second[0].get()}, known.target, 150);
    EXPECT_EQ(second[0]->positions(), whole[0]->positions()) << at;
    StateWriter end, expected;
    second[0]->save(end);
    whole[0]->save(expected);
    EXPECT_EQ(end.bytes(), expected.bytes()) << at;
  }
}

// Counts and shapes are the words of a saved state that are small as integers; each is made another
// one in turn, and neighbours change places, as of a matrix that was transposed.
TEST_P(EverySampler, RefusesStatesOfOtherShapesOrReadsThem) {
  const auto known = sample::gaussian(3, 4);
  SamplerOptions options;
  options.warm_up = 60;
  const auto early = build(known.target, options);
  advance({early[0].get()}, known.target, 37);
  StateWriter saved;
  early[0]->save(saved);
  const std::string& good = saved.bytes();
  const auto word = [](const std::string& bytes, std::size_t at) {
    std::int64_t value;
    std::memcpy(&value, bytes.data() + at, sizeof value);
    return value;
  };
  int tried = 0, refused = 0;
  const auto attempt = [&](const std::string& bytes) {
    ++tried;
    const auto late = build(known.target, options);
    StateReader reader(bytes);
    try {
      late[0]->restore(reader);
      advance({late[0].get()}, known.target, late[0]->steps() + 3);
    } catch (const InputError&) {
      ++refused;
    }
  };
  for (std::size_t at = 0; at + 8 <= good.size(); at += 8) {
    const std::int64_t value = word(good, at);
    if (value <= 0 || value > 1000) continue;
    for (const std::int64_t other : {value + 1, value - 1, std::int64_t{0}, std::int64_t{-1}}) {
      std::string bytes = good;
      std::memcpy(&bytes[at], &other, sizeof other);
      attempt(bytes);
    }
    if (at + 16 > good.size() || word(good, at + 8) == value) continue;
    std::string bytes = good;
    std::swap_ranges(&bytes[at], &bytes[at] + 8, &bytes[at + 8]);
    attempt(bytes);
  }
  // Positions and their densities alone have six lengths, each of which is made four others.
  EXPECT_GE(refused, 24) << tried;
}

// The number of steps stands first in the saved state. Of 2^32 steps the last that has random
// numbers of its own is refused, too: those of the next are wanted as soon as it is made.
TEST_P(EverySampler, RefusesStepsWhoseRandomNumbersWouldRepeat) {
  constexpr std::int64_t kAll = std::int64_t{1} << 32;
  const auto known = sample::gaussian(2, 4);
  SamplerOptions options;
  options.warm_up = kAll;
  EXPECT_THROW((void)build(known.target, options), InputError);
  options.warm_up = 10;
  const auto early = build(known.target, options), late = build(known.target, options);
  advance({early[0].get()}, known.target, 20);
  StateWriter saved, number;
  early[0]->save(saved);
  number.write(kAll - 2);
  StateReader reader(number.bytes() + saved.bytes().substr(number.bytes().size()));
  late[0]->restore(reader);
  advance({late[0].get()}, known.target, kAll - 1);
  EXPECT_EQ(late[0]->steps(), kAll - 1);
  EXPECT_THROW(advance({late[0].get()}, known.target, kAll), InputError);
}

TEST_P(EverySampler, TellsTheDensityOfWhereItIs) {
  const auto known = sample::gaussian(2, 4);
  const auto groups = build(known.target, {});
  advance({groups[0].get()}, known.target, 20);
  const Densities all = known.target.evaluate(groups[0]->positions(), WithGradient::kYes);
  for (int k = 0; k < each(); ++k) {
    EXPECT_EQ(groups[0]->density(k).log_likelihood[0], all.log_likelihood[k]);
    EXPECT_EQ(groups[0]->stats()[k].log_likelihood, all.log_likelihood[k]);
    EXPECT_EQ(groups[0]->stats()[k].log_prior, all.log_prior[k]);
  }
}

// Swaps of tempering: a chain that is put where it is goes on as before; one that is put
// elsewhere starts from there, with the density that came along.
TEST_P(EverySampler, CanBeMovedBetweenSteps) {
  const auto known = sample::gaussian(2, 4);
  const auto stays = build(known.target, {}), moves = build(known.target, {});
  advance({stays[0].get(), moves[0].get()}, known.target, 20);
  moves[0]->move(0, moves[0]->positions().col(0), moves[0]->density(0));
  advance({stays[0].get(), moves[0].get()}, known.target, 40);
  EXPECT_EQ(stays[0]->positions(), moves[0]->positions());

  const Eigen::Vector2d elsewhere(0.3, -0.2);
  const WithGradient want = moves[0]->wants();
  moves[0]->move(0, elsewhere, known.target.evaluate(elsewhere, want));
  EXPECT_EQ(moves[0]->positions().col(0), elsewhere);
  EXPECT_EQ(moves[0]->density(0).log_likelihood[0],
            known.target.evaluate(elsewhere, want).log_likelihood[0]);
  EXPECT_EQ(moves[0]->steps(), 40);
  StateWriter at;
  moves[0]->save(at);
  const auto again = build(known.target, {});
  StateReader reader(at.bytes());
  again[0]->restore(reader);
  EXPECT_EQ(again[0]->asks(), moves[0]->asks());
  EXPECT_NE(moves[0]->asks(), stays[0]->asks());
}

// N(0, 1)^beta = N(0, 1 / beta).
TEST_P(EverySampler, TempersTheLikelihood) {
  const SplitTarget target(2, flat, standard_normal);
  SamplerOptions options;
  options.beta = 0.25;
  const Collected drawn = draw(target, options);
  for (const Eigen::MatrixXd& x : drawn.x) expect_moments(x, 0, 2);
}

// A ladder that moves in warm-up: whoever goes on at another beta goes on like one that was built
// with it and put in the same state.
TEST_P(EverySampler, GoesOnAtAnotherTemper) {
  const SplitTarget target(2, flat, standard_normal);
  SamplerOptions options;
  options.warm_up = 60;
  const auto cold = build(target, options);
  advance({cold[0].get()}, target, 30);
  StateWriter state;
  cold[0]->save(state);
  cold[0]->set_beta(0.25);
  options.beta = 0.25;
  const auto hot = build(target, options);
  StateReader reader(state.bytes());
  hot[0]->restore(reader);
  advance({cold[0].get(), hot[0].get()}, target, 100);
  EXPECT_EQ(cold[0]->positions(), hot[0]->positions());
}

TEST_P(EverySampler, DrawsFromThePriorAtTemperZero) {
  const auto tight = [](const Eigen::VectorXd& x, Eigen::VectorXd& by) {
    by = -1e6 * x;
    return -0.5e6 * x.squaredNorm();
  };
  SamplerOptions options;
  options.beta = 0;
  const Collected drawn = draw(SplitTarget(2, standard_normal, tight), options);
  for (const Eigen::MatrixXd& x : drawn.x) expect_moments(x, 0, 1);
}

// A standard normal below 1:  mean -phi(1) / Phi(1), variance 1 - phi / Phi - (phi / Phi)^2.
TEST_P(EverySampler, NeverGoesWhereTheModelBreaksAndCountsIt) {
  const double ratio = std::exp(-0.5) / std::sqrt(2 * M_PI) / (0.5 * std::erfc(-std::sqrt(0.5)));
  for (const double there : {kNaN, kInfinity, -kInfinity}) {
    const Collected drawn = draw(cut_normal(2, there));
    EXPECT_LE(drawn.x[0].maxCoeff(), 1);
    EXPECT_EQ(drawn.non_finite > 0, there != -kInfinity) << there;
    expect_moments(drawn.x[0], -ratio, std::sqrt(1 - ratio - ratio * ratio));
    expect_moments(drawn.x[1], 0, 1);
  }
}

// A box of +-3 about zero as prior, NaN outside, and a start beyond. Metropolis chains find their
// way in; an ensemble only if one of its walkers is in. A Hamiltonian chain has no slope to follow:
// it stays, calls every step divergent, and waits for a swap.
TEST_P(EverySampler, StaysOutsideTheSupportUntilItFindsIt) {
  const auto box = [](const Eigen::VectorXd& x, Eigen::VectorXd&) {
    return x.cwiseAbs().maxCoeff() < 3 ? 0 : -kInfinity;
  };
  const auto model = [](const Eigen::VectorXd& x, Eigen::VectorXd& by) {
    return x.cwiseAbs().maxCoeff() < 3 ? standard_normal(x, by) : kNaN;
  };
  const SplitTarget target(2, box, model);
  SamplerOptions options;
  options.warm_up = 500;
  Eigen::MatrixXd starts = normal_starts(2, each(), 0.1, 7, 4.5);
  if (GetParam() == SamplingMethod::kStretchMove) starts.col(0).setZero();
  const auto sampler = build_sampler(GetParam(), starts, options);
  int left = 0;
  for (long step = 1; step <= 500; ++step) {
    advance({sampler.get()}, target, step);
    left = 0;
    for (int k = 0; k < each(); ++k) {
      const bool in = sampler->positions().col(k).cwiseAbs().maxCoeff() < 3;
      EXPECT_TRUE(in || sampler->positions().col(k) == starts.col(k));
      EXPECT_EQ(sampler->stats()[k].non_finite, 0);  // outside the prior nothing can break
      EXPECT_EQ(sampler->stats()[k].divergent, hamiltonian());
      left += in ? 0 : 1;
    }
  }
  EXPECT_EQ(left, hamiltonian() ? 1 : 0);
  if (!hamiltonian()) return;
  const Eigen::Vector2d inside(0.5, 0);
  sampler->move(0, inside, target.evaluate(inside, WithGradient::kYes));
  advance({sampler.get()}, target, 520);
  EXPECT_NE(sampler->positions().col(0), inside);
}

// Only x_0 + x_1 acts: with y = 1 +- 0.1 and priors N(0, 1), the sum is N(2 / 2.01, 0.02 / 2.01)
// and the difference N(0, 2).
TEST_P(EverySampler, BearsDuplicatedParameters) {
  const auto sum = [](const Eigen::VectorXd& x, Eigen::VectorXd& by) {
    const double off = x[0] + x[1] - 1;
    by.head<2>().setConstant(-100 * off);
    return -50 * off * off;
  };
  const Collected drawn = draw(SplitTarget(3, standard_normal, sum));
  expect_moments(drawn.x[0] + drawn.x[1], 2 / 2.01, std::sqrt(0.02 / 2.01));
  expect_moments(drawn.x[0] - drawn.x[1], 0, std::sqrt(2));
  expect_moments(drawn.x[2], 0, 1);
}

// The data say nothing of x_1, its prior is flat between -10 and 10.
TEST_P(EverySampler, BearsADirectionOfFlatPrior) {
  const auto box = [](const Eigen::VectorXd& x, Eigen::VectorXd&) {
    return std::abs(x[1]) < 10 ? 0 : -kInfinity;
  };
  const auto one = [](const Eigen::VectorXd& x, Eigen::VectorXd& by) {
    by[0] = -x[0];
    return -0.5 * x[0] * x[0];
  };
  // The walls of the box end trajectories of one length, and their steps become short.
  const int longer = GetParam() == SamplingMethod::kHmc ? 4 : 1;
  const Collected drawn = draw(SplitTarget(2, box, one), {}, longer);
  expect_moments(drawn.x[0], 0, 1);
  expect_moments(drawn.x[1], 0, 10 / std::sqrt(3.0));
}

// No posterior at all in x_1: the chains drift ever on, and their R-hat says so.
TEST_P(EverySampler, StaysFiniteWithoutAPosterior) {
  const auto one = [](const Eigen::VectorXd& x, Eigen::VectorXd& by) {
    by[0] = -x[0];
    return -0.5 * x[0] * x[0];
  };
  const Collected drawn = draw(SplitTarget(2, flat, one));
  EXPECT_TRUE(drawn.x[0].allFinite() && drawn.x[1].allFinite());
  EXPECT_GT(rank_r_hat(drawn.x[1]), 1.01);
}

}  // namespace
}  // namespace thenar
