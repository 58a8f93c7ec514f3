// Tests for dynamics/mechanism/joint_turns.h.

#include "dynamics/mechanism/joint_turns.h"

#include <gtest/gtest.h>

#include <limits>

namespace thenar::internal {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

/// Largest difference from the C library's sines and cosines.
double miss(const std::vector<double>& angles) {
  JointTurns<double> turns(angles.size());
  for (std::size_t i = 0; i < angles.size(); ++i) turns.set(i, angles[i]);
  turns.compute();
  double most = 0;
  for (std::size_t i = 0; i < angles.size(); ++i)
    most = std::max({most, std::abs(turns.sine(i) - std::sin(angles[i])),
                     std::abs(turns.cosine(i) - std::cos(angles[i]))});
  return most;
}

TEST(JointTurns, AreThoseOfTheCLibrary) {
  std::vector<double> angles;
  for (double angle = -20; angle < 20; angle += 0.0137) angles.push_back(angle);
  EXPECT_LE(miss(angles), kEpsilon);
  angles.pop_back();  // once even, once odd
  EXPECT_LE(miss(angles), kEpsilon);
}

// Three parts of pi/2 do for angles up to a bound; one beyond it asks for the library's.
TEST(JointTurns, HoldForAnglesOfAnySize) {
  EXPECT_EQ(miss({1e9, 0.1, -3e12}), 0);
  EXPECT_LE(miss({9.9e4, -9.9e4, 0}), kEpsilon);
}

}  // namespace
}  // namespace thenar::internal
