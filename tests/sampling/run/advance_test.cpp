// Tests for sampling/run/advance.cpp.

#include "sampling/run/advance.h"

#include <gtest/gtest.h>

#include "tests/sampling/known_posteriors.h"

namespace thenar {
namespace {

/// Counts what a target is asked.
class Counted : public Target {
 public:
  explicit Counted(const Target& of) : of_(of) {}
  [[nodiscard]] int size() const override { return of_.size(); }
  [[nodiscard]] Densities evaluate(const Eigen::Ref<const Eigen::MatrixXd>& x,
                                   WithGradient want) const override {
    ++batches;
    points += x.cols();
    gradients = want == WithGradient::kYes;
    return of_.evaluate(x, want);
  }
  mutable long batches = 0, points = 0;
  mutable bool gradients = false;

 private:
  const Target& of_;
};

std::unique_ptr<Sampler> chain(SamplingMethod method, int number, int walkers = 1) {
  SamplerOptions options;
  options.warm_up = 30;
  options.first_chain = number;
  Eigen::MatrixXd starts(2, walkers);
  for (int k = 0; k < walkers; ++k) starts.col(k) << 0.3 * k * k - 1, 1 - 0.4 * k;
  return build_sampler(method, starts, options);
}

TEST(Advance, GivesTheSameDrawsAloneAndInCompany) {
  const auto target = sample::banana().target;
  for (const SamplingMethod method : {SamplingMethod::kNuts, SamplingMethod::kHmc}) {
    const auto a = chain(method, 0), b = chain(method, 1);
    const auto walkers = chain(SamplingMethod::kStretchMove, 2, 6);
    const auto alone = chain(method, 0);
    advance({b.get(), walkers.get(), a.get()}, target, 60);
    advance({alone.get()}, target, 60);
    EXPECT_EQ(a->positions(), alone->positions());
    EXPECT_NE(a->positions(), b->positions());
  }
}

TEST(Advance, StopsEachWhereItIsThereAndTellsOfEveryStep) {
  const auto known = sample::gaussian(2, 4);
  const Counted target(known.target);
  const auto a = chain(SamplingMethod::kNuts, 0), b = chain(SamplingMethod::kNuts, 1);
  std::vector<long> heard(2, 0);
  advance({a.get()}, target, 7);
  advance({a.get(), b.get()}, target, 20, [&](std::size_t i) { ++heard[i]; });
  EXPECT_EQ(a->steps(), 20);
  EXPECT_EQ(b->steps(), 20);
  EXPECT_EQ(heard, (std::vector<long>{13, 20}));
  EXPECT_LT(target.batches, target.points);  // some were shared
}

TEST(Advance, AsksForGradientsOnlyWhereSomebodyWantsThem) {
  const auto known = sample::gaussian(2, 4);
  const Counted target(known.target);
  const auto plain = chain(SamplingMethod::kAdaptiveMetropolis, 0);
  const auto steep = chain(SamplingMethod::kNuts, 1);
  advance({plain.get()}, target, 5);
  EXPECT_FALSE(target.gradients);
  advance({plain.get(), steep.get()}, target, 10);
  EXPECT_TRUE(target.gradients);
}

TEST(Advance, ReturnsWhenAskedToStop) {
  const auto known = sample::gaussian(2, 4);
  const Counted target(known.target);
  const auto a = chain(SamplingMethod::kNuts, 0);
  advance({a.get()}, target, 1000, {}, [&] { return target.batches == 10; });
  EXPECT_EQ(target.batches, 10);
  EXPECT_LT(a->steps(), 10);
}

}  // namespace
}  // namespace thenar
