// Tests for grasp/quality/robustness.cpp.

#include "grasp/quality/robustness.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/error.h"
#include "tests/grasp/quality/pinch.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

/// Three soft fingers around a ball.
std::vector<Contact> three(double friction) {
  std::vector<Contact> contacts;
  for (int i = 0; i < 3; ++i) {
    const double turn = 2 * M_PI * i / 3;
    const Eigen::Vector3d outward(std::cos(turn), std::sin(turn), 0);
    contacts.push_back({kRadius * outward, -outward, friction, 0.002});
  }
  return contacts;
}

Robustness of(const std::vector<Contact>& contacts, const ContactUncertainty& uncertainty,
              unsigned seed, int draws = 200) {
  std::mt19937 rng(seed);
  RobustnessOptions options;
  options.draws = draws;
  options.torque_scale = kScale;
  return robustness([&](std::mt19937& r) { return disturb_contacts(contacts, uncertainty, r); },
                    rng, options);
}

// Wilson's formula by hand, z = 1.96: 8 of 10 is 0.490 to 0.943; none of 10 ends at
// z^2 / (n + z^2) = 0.278.
TEST(Robustness, IntervalIsWilsons) {
  EXPECT_NEAR(wilson_interval(8, 10).lower, 0.490, 5e-4);
  EXPECT_NEAR(wilson_interval(8, 10).upper, 0.943, 5e-4);
  EXPECT_EQ(wilson_interval(0, 10).lower, 0);
  EXPECT_NEAR(wilson_interval(0, 10).upper, 0.2775, 5e-4);
  EXPECT_EQ(wilson_interval(10, 10).upper, 1);
}

// Fisher's lady: 3 of 4 cups against 1 of 4 has (16 + 1) / 70 on each side, all right 1 / 70. The
// sums of 3 of 3 against 0 of 1 leave one more table, three times as likely.
TEST(Robustness, DifferenceOfSharesIsFishers) {
  EXPECT_NEAR(fisher_exact_p({3, 4}, {1, 4}), 34.0 / 70, 1e-12);
  EXPECT_NEAR(fisher_exact_p({4, 4}, {0, 4}), 2.0 / 70, 1e-12);
  EXPECT_NEAR(fisher_exact_p({3, 3}, {0, 1}), 0.25, 1e-12);
  EXPECT_EQ(fisher_exact_p({0, 9}, {0, 4}), 1);
  EXPECT_THROW((void)fisher_exact_p({1, 0}, {0, 4}), InputError);
}

TEST(Robustness, OfWhatIsKnownIsCertain) {
  const Robustness sure = of(three(0.5), {}, 1, 20);
  EXPECT_EQ(sure.closure, 1);
  EXPECT_EQ(sure.quantile(0), sure.quantile(1));
  EXPECT_EQ(of(pinch_contacts(0.5, 0), {}, 1, 20).closure, 0);
}

// Two soft fingers grasp if friction covers the angles a, b of their line with their normals. With
// one normal tilted by a normal angle of deviation sigma about each axis, a is Rayleigh:
// P(a <= atan mu) = 1 - exp(-atan(mu)^2 / (2 sigma^2)).
TEST(Robustness, ShareIsTheProbability) {
  const double mu = 0.4, sigma = 0.25;
  std::mt19937 rng(3);
  RobustnessOptions options;
  options.draws = 400;
  options.torque_scale = kScale;
  const Robustness found = robustness(
      [&](std::mt19937& r) {
        std::vector<Contact> contacts = pinch_contacts(mu, 0.01);
        contacts[0] = disturb_contacts({contacts[0]}, {0, 0, sigma}, r)[0];
        return contacts;
      },
      rng, options);
  const double expected = 1 - std::exp(-std::pow(std::atan(mu) / sigma, 2) / 2);
  EXPECT_LE(found.closure_lower, expected);
  EXPECT_GE(found.closure_upper, expected);
}

TEST(Robustness, SameSeedSameNumbers) {
  const ContactUncertainty unsure{0.3, 0.003, 0.2};
  EXPECT_EQ(of(three(0.4), unsure, 5).epsilon, of(three(0.4), unsure, 5).epsilon);
  EXPECT_NE(of(three(0.4), unsure, 5).epsilon, of(three(0.4), unsure, 6).epsilon);
}

// Every other draw misses: they come first, and no quantile below the half is a number.
TEST(Robustness, MissesAreWorseThanAnyGrasp) {
  std::mt19937 rng(1);
  RobustnessOptions options;
  options.draws = 10;
  options.torque_scale = kScale;
  const std::vector<Contact> one_side{pinch_contacts(0.5, 0)[0]};  // epsilon -1
  int drawn = 0;
  const Robustness found = robustness(
      [&](std::mt19937&) { return ++drawn % 2 == 0 ? one_side : std::vector<Contact>{}; }, rng,
      options);
  EXPECT_EQ(found.misses, 5);
  for (const double p : {0.0, 0.25, 0.5}) EXPECT_EQ(found.quantile(p), -HUGE_VAL);
  EXPECT_NEAR(found.quantile(1), -1, 1e-9);
  EXPECT_EQ(found.closure, 0);
}

// A square in a friction circle: the weakest side of three cones at 0.5 falls.
TEST(Robustness, OfPyramidsIsLessThanOfCones) {
  std::mt19937 rng(1);
  RobustnessOptions options;
  options.draws = 1;
  options.torque_scale = kScale;
  const auto draw = [](std::mt19937&) { return three(0.5); };
  const double cones = robustness(draw, rng, options).quantile(0);
  options.edges = 3;
  EXPECT_LT(robustness(draw, rng, options).quantile(0), cones - options.gap);
}

TEST(Robustness, RefusesNegativeDeviations) {
  std::mt19937 rng(1);
  EXPECT_EQ(message_of([&] {
              (void)disturb_contacts(three(0.5), {-1, 0, 0}, rng);
            }),
            "standard deviations must be >= 0, got -1, 0, 0");
}

}  // namespace
}  // namespace thenar
