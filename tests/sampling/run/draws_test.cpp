// Tests for sampling/run/draws.cpp.

#include "sampling/run/draws.h"

#include <vector>

#include <gtest/gtest.h>

#include "base/error.h"

namespace thenar {
namespace {

TEST(Draws, ComeBackFromAColumnOfNumbers) {
  const StepStats stats{-1.5, -2.5, 0.75, 0.125, 3.5, 4, 15, 2, true};
  std::vector<double> numbers;
  internal::put_draw(stats, Eigen::Vector2d(7, -8), numbers);
  ASSERT_EQ(static_cast<Eigen::Index>(numbers.size()), internal::rows_of_draw(2));
  const Eigen::VectorXd column =
      Eigen::Map<const Eigen::VectorXd>(numbers.data(), internal::rows_of_draw(2));
  EXPECT_EQ(internal::position_of(column), Eigen::Vector2d(7, -8));
  const StepStats back = internal::stats_of(column);
  EXPECT_EQ(back.log_prior, -1.5);
  EXPECT_EQ(back.log_likelihood, -2.5);
  EXPECT_EQ(back.acceptance, 0.75);
  EXPECT_EQ(back.step_size, 0.125);
  EXPECT_EQ(back.energy, 3.5);
  EXPECT_EQ(back.depth, 4);
  EXPECT_EQ(back.evaluations, 15);
  EXPECT_EQ(back.non_finite, 2);
  EXPECT_TRUE(back.divergent);
}

TEST(Draws, GiveOneCoordinateOfAllChains) {
  Draws draws;
  draws.x = {(Eigen::Matrix2d() << 1, 2, 3, 4).finished(),
             (Eigen::Matrix2d() << 5, 6, 7, 8).finished()};
  EXPECT_EQ(draws.coordinate(1), (Eigen::Matrix2d() << 3, 7, 4, 8).finished());
  EXPECT_THROW((void)draws.coordinate(2), InputError);
  draws.x[1].conservativeResize(2, 1);
  EXPECT_THROW((void)draws.coordinate(1), InputError);
}

}  // namespace
}  // namespace thenar
