// Tests for sampling/diagnostics/convergence.cpp.

#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "sampling/diagnostics/convergence.h"
#include "tests/sampling/diagnostics/reference_chains.h"

namespace thenar {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// Two coordinates of four independent chains without fault.
Draws good_draws(int draws = 1000) {
  const Eigen::MatrixXd a = sample::autoregressive(0, draws, 4, 1),
                        b = sample::autoregressive(0.3, draws, 4, 2);
  Draws all;
  for (int chain = 0; chain < 4; ++chain) {
    Eigen::MatrixXd x(2, draws);
    x << a.col(chain).transpose(), b.col(chain).transpose();
    all.x.push_back(x);
    all.stats.emplace_back(draws);
    all.group.push_back(chain);
  }
  all.complete = true;
  return all;
}

TEST(Assess, GoodDrawsAreBelieved) {
  const Convergence result = assess(good_draws(), {"a", "b"});
  EXPECT_THAT(result.warnings, IsEmpty());
  ASSERT_EQ(result.estimates.size(), 2U);
  EXPECT_EQ(result.estimates[1].name, "b");
  EXPECT_EQ(result.worst_r_hat, std::max(result.estimates[0].r_hat, result.estimates[1].r_hat));
  EXPECT_EQ(result.min_bulk_ess,
            std::min(result.estimates[0].bulk_ess, result.estimates[1].bulk_ess));
}

TEST(Assess, NamesTheQuantityThatDisagrees) {
  Draws draws = good_draws();
  draws.x[3].row(1).array() += 100;
  const auto warnings = assess(draws, {"a", "b"}).warnings;
  ASSERT_EQ(warnings.size(), 3U);  // its effective sizes are small, too
  EXPECT_THAT(warnings[0], testing::HasSubstr("R-hat of b is "));
  EXPECT_THAT(warnings[0], testing::HasSubstr(", above 1.01: chains disagree"));
  EXPECT_THAT(warnings[1], testing::HasSubstr("bulk effective sample size of b is "));
  EXPECT_THAT(warnings[1], testing::HasSubstr(", below 400"));
  EXPECT_THAT(warnings[2], testing::HasSubstr("tail effective sample size of b is "));
}

TEST(Assess, ShortRunsAreNotEnough) {
  const auto warnings = assess(good_draws(60), {"a", "b"}).warnings;
  EXPECT_THAT(warnings, testing::Contains(testing::HasSubstr("below 400 (as is that of 1 more)")));
}

TEST(Assess, FewDivergencesAreACautionAndManyAreNotAllowed) {
  Draws draws = good_draws();
  draws.stats[2][7].divergent = draws.stats[0][1].divergent = true;
  draws.stats[1][3].non_finite = 5;
  draws.stats[1][4].depth = 10;
  ConvergenceLimits limits;
  const Convergence result = assess(draws, {"a", "b"}, limits);
  EXPECT_EQ(result.divergent, 2);
  EXPECT_EQ(result.non_finite, 5);
  EXPECT_EQ(result.depth_limit, 1);
  EXPECT_THAT(result.warnings, IsEmpty());
  EXPECT_THAT(result.cautions,
              ElementsAre("2 of 4000 draws ended a divergent trajectory (0.05 %): a narrow part of "
                          "the density there may have too few draws"));
  limits.divergent_share = 0;
  const Convergence strict = assess(draws, {"a", "b"}, limits);
  EXPECT_THAT(strict.warnings,
              ElementsAre("2 of 4000 draws ended a divergent trajectory (0.05 %, allowed 0 %): the "
                          "sampler cannot follow the density there"));
  EXPECT_THAT(strict.cautions, IsEmpty());
}

TEST(Assess, BrokenAndStillQuantitiesAreNamed) {
  Draws draws = good_draws();
  for (auto& x : draws.x) x.row(0).setConstant(0.1);
  draws.x[1](1, 10) = std::numeric_limits<double>::quiet_NaN();
  const Convergence result = assess(draws, {"a", "b"});
  EXPECT_THAT(result.warnings, ElementsAre("there are draws that are not finite, of b",
                                           "all draws of a are alike: no chain has moved there"));
  EXPECT_TRUE(std::isnan(result.worst_r_hat));
  EXPECT_TRUE(std::isnan(result.min_tail_ess));
}

TEST(Assess, OneChainCannotShowThatItIsStuck) {
  Draws draws = good_draws();
  draws.group = {0, 0, 0, 0};
  EXPECT_THAT(assess(draws, {"a", "b"}).warnings,
              ElementsAre("independent chains or ensembles: 1; one that is stuck shows only beside "
                          "another, so 2 are needed"));
}

TEST(Assess, RareSwapsAreAReason) {
  Draws draws = good_draws();
  draws.swap_rate = Eigen::MatrixXd::Constant(3, 4, 0.3);
  draws.swap_rate(1, 2) = 0.02;
  EXPECT_THAT(assess(draws, {"a", "b"}).warnings,
              ElementsAre("temperatures 2 and 3 of group 3 swap in 2 % of attempts, below 5 %: hot "
                          "chains do not help cold ones"));
}

TEST(Assess, NothingYetIsNoThrow) {
  const auto warnings = assess(good_draws(3), {"a", "b"}).warnings;
  ASSERT_FALSE(warnings.empty());
  EXPECT_EQ(warnings[0], "there are 3 draws a chain, diagnostics need 4");
}

TEST(Assess, WantsANameForEveryCoordinate) {
  EXPECT_THROW((void)assess(good_draws(), {"a"}), InputError);
}

/// Two coordinates, of which "b" creeps: its effective size is below 400, chains hardly disagree.
Draws creeping_draws() {
  Draws draws = good_draws(2000);
  const Eigen::MatrixXd slow = sample::autoregressive(0.98, 2000, 4, 3);
  for (std::size_t chain = 0; chain < 4; ++chain)
    draws.x[chain].row(1) = slow.col(static_cast<Eigen::Index>(chain)).transpose();
  return draws;
}

std::vector<Estimate> answers_of(const Draws& draws, int coordinate) {
  return {estimate("force", draws.coordinate(coordinate), draws.group)};
}

TEST(SettledByAnswers, ANuisanceDoesNotForbidWhatHasConverged) {
  const Draws draws = creeping_draws();
  const Convergence before = assess(draws, {"a", "b"});
  ASSERT_FALSE(before.warnings.empty());
  EXPECT_TRUE(before.draws_may_help);
  EXPECT_THAT(before.unsettled, ElementsAre("b"));
  ASSERT_LT(before.worst_r_hat, ConvergenceLimits{}.nuisance_r_hat);

  const Convergence settled = settled_by_answers(before, answers_of(draws, 0), "forces", 4);
  EXPECT_THAT(settled.warnings, IsEmpty());
  EXPECT_THAT(settled.unsettled, ElementsAre("b"));
  ASSERT_EQ(settled.cautions.size(), 1U);
  EXPECT_THAT(settled.cautions[0], testing::HasSubstr("effective sample size of b is "));
  EXPECT_THAT(settled.cautions[0], testing::HasSubstr("the forces have converged all the same"));
  EXPECT_THAT(settled.cautions[0], testing::EndsWith("use them, but not b"));
}

// An answer that creeps itself, no answer, chains that are apart, and divergent steps: no excuse.
TEST(SettledByAnswers, NothingElseIsExcused) {
  const Draws draws = creeping_draws();
  const Convergence of = assess(draws, {"a", "b"});
  EXPECT_EQ(settled_by_answers(of, answers_of(draws, 1), "forces", 4).warnings, of.warnings);
  EXPECT_EQ(settled_by_answers(of, {}, "forces", 4).warnings, of.warnings);

  Draws apart = draws;
  apart.x[3].row(1).array() += 100;
  EXPECT_FALSE(settled_by_answers(assess(apart, {"a", "b"}), answers_of(draws, 0), "forces", 4)
                   .warnings.empty());
  Draws divergent = draws;
  for (int i = 0; i < 200; ++i) divergent.stats[0][i].divergent = true;
  const Convergence broken = assess(divergent, {"a", "b"});
  EXPECT_FALSE(broken.draws_may_help);
  EXPECT_EQ(settled_by_answers(broken, answers_of(draws, 0), "forces", 4).warnings,
            broken.warnings);
}

}  // namespace
}  // namespace thenar
