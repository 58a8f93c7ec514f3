#pragma once

/// Draws of a sampler against the known moments of a posterior.

#include <cstdlib>
#include <string>

#include <gtest/gtest.h>

#include "tests/sampling/collect_draws.h"
#include "tests/sampling/known_posteriors.h"

namespace thenar::sample {

/// How long tests that take many seconds shall be: the environment's THENAR_SAMPLES, 1 is enough
/// for them to pass; 0, if it is not set: they are left out.
inline int long_runs() {
  const char* wanted = std::getenv("THENAR_SAMPLES");
  return wanted == nullptr ? 0 : std::atoi(wanted);
}

struct Plan {
  int groups = 4, each = 1;  // samplers, and chains of each [1]
  long warm_up = 5000, draws = 2000;
  int thin = 20;        // steps a draw [1]
  double start_sd = 1;  // of the starts about zero
};

/// Starts from a normal, warms up, and draws.
inline Collected draw(SamplingMethod method, const Target& target, const Plan& plan,
                      const Eigen::MatrixXd& starts) {
  SamplerOptions options;
  options.warm_up = plan.warm_up;
  const auto groups = build_groups(method, starts, plan.each, options);
  (void)collect(groups, target, 1, static_cast<int>(plan.warm_up));
  return collect(groups, target, plan.draws, plan.thin);
}
inline Collected draw(SamplingMethod method, const Target& target, const Plan& plan) {
  return draw(method, target, plan,
              normal_starts(target.size(), plan.groups * plan.each, plan.start_sd));
}

/// Means and sds that are known, within 4 Monte Carlo standard errors, at R-hat below 1.01.
inline void expect_posterior(const std::vector<Eigen::MatrixXd>& x, const KnownPosterior& known) {
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double mean = known.mean[Eigen::Index(i)], sd = known.sd[Eigen::Index(i)];
    const double mcse = known.mcse[Eigen::Index(i)];
    EXPECT_LT(rank_r_hat(x[i]), 1.01) << known.name << ", entry " << i;
    if (std::isnan(mean)) continue;
    EXPECT_NEAR(x[i].mean(), mean, 4 * std::hypot(mean_mcse(x[i]), mcse)) << "entry " << i;
    EXPECT_NEAR(std::sqrt((x[i].array() - x[i].mean()).square().mean()), sd,
                4 * std::hypot(sd_mcse(x[i]), mcse))
        << "entry " << i;
  }
}

/// For the log of the test: what the draws cost.
inline void record_cost(const Collected& drawn) {
  const double ess = drawn.min_bulk_ess();
  testing::Test::RecordProperty("acceptance", std::to_string(drawn.acceptance));
  testing::Test::RecordProperty("least_bulk_ess", std::to_string(ess));
  testing::Test::RecordProperty("worst_r_hat", std::to_string(drawn.worst_r_hat()));
  testing::Test::RecordProperty("ess_per_evaluation",
                                std::to_string(ess / double(drawn.evaluations)));
}

/// Draws that meet what is known; for the log of the test, what they cost.
inline void expect_at_cost(SamplingMethod method, const KnownPosterior& known, const Plan& plan) {
  const Collected drawn = draw(method, known.target, plan);
  expect_posterior(drawn.x, known);
  record_cost(drawn);
}

/// One sampler of `each` chains learns until step 200, the last of its warm-up, and then no more.
/// @param numbers  that it has learnt and saves last, those of a matrix's shape among them [1]
inline void expect_nothing_learnt_after_warm_up(SamplingMethod method, int each,
                                                std::size_t numbers) {
  const auto known = gaussian(3, 100);
  SamplerOptions options;
  options.warm_up = 200;
  const auto groups = build_groups(method, normal_starts(3, each, 1), each, options);
  const auto learnt = [&](long steps) {
    advance({groups[0].get()}, known.target, steps);
    StateWriter writer;
    groups[0]->save(writer);
    return writer.bytes().substr(writer.bytes().size() - 8 * numbers);
  };
  const std::string early = learnt(199), last = learnt(200);
  EXPECT_NE(early, last);
  EXPECT_EQ(learnt(400), last);
}

}  // namespace thenar::sample
