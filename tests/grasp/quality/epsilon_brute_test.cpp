// Certified bounds against descents that know nothing of hulls.
// THENAR_GRASPS=10000 for all.

#include <cstdlib>
#include <string>

#include <gtest/gtest.h>

#include "grasp/quality/epsilon.h"
#include "tests/grasp/quality/brute_epsilon.h"

namespace thenar {
namespace {

int grasps() {
  const char* all = std::getenv("THENAR_GRASPS");
  return all == nullptr ? 200 : std::stoi(all);
}

/// Two to seven contacts, some of them soft, some without friction.
WrenchSet random_set(std::mt19937& rng, int most) {
  std::vector<Contact> contacts =
      random_contacts(rng, 2 + static_cast<int>(uniform(rng, 0, most - 1)));
  for (Contact& contact : contacts) {
    if (uniform(rng, 0, 1) < 0.1) contact.friction = 0;
    if (uniform(rng, 0, 1) < 0.2) contact.torsion = uniform(rng, 0, 0.3);
  }
  return wrench_set(contacts, Eigen::Vector3d::Zero(), std::exp(uniform(rng, -1, 1)));
}

/// @param starts  of descents; @param slack  what a descent may stay above the
/// least value
void enclose(ForceNorm limit, int most_contacts, int count) {
  constexpr int kMaxDescents = 500;
  constexpr double kSlack = 1e-4;  // of descents above the least value
  std::mt19937 rng(11);
  int closures = 0;
  for (int i = 0; i < count; ++i) {
    const WrenchSet set = random_set(rng, most_contacts);
    EpsilonOptions options;
    options.limit = limit;
    const Epsilon e = epsilon(set, options);
    EXPECT_TRUE(e.converged) << i << ": " << e.lower << " " << e.upper;
    // For kLinf without closure the value is that of kL1.
    const ForceNorm meant = e.force_closure ? limit : ForceNorm::kL1;
    EXPECT_LE(support(set, -e.worst_wrench, meant), e.upper + 1e-12) << i;
    const double brute = BruteEpsilon(set, meant)(rng, kMaxDescents, e.upper + kSlack);
    EXPECT_GE(brute, e.lower) << i;
    EXPECT_LE(brute, e.upper + kSlack) << i;
    closures += e.force_closure ? 1 : 0;
  }
  EXPECT_GT(closures, count / 4);
  EXPECT_LT(closures, count);
}

TEST(EpsilonBounds, EncloseTheLeastSupportFoundByDescents) { enclose(ForceNorm::kL1, 7, grasps()); }

TEST(EpsilonBounds, EncloseItForLimitsOfEachContact) { enclose(ForceNorm::kLinf, 5, grasps() / 5); }

}  // namespace
}  // namespace thenar
