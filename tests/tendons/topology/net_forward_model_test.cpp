// Tests for tendons/topology/net_forward_model.cpp and candidate_net.cpp.

#include "tendons/topology/net_forward_model.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "tests/matrix_near.h"
#include "tests/tendons/topology/tug.h"

namespace thenar {
namespace {

using Eigen::Vector2d;

TEST(PredictNet, SharesAPullByStiffness) {
  NetForwardModel forward(tug::candidate(2), {tug::test(4)});
  const NetPrediction got = forward.predict(Vector2d(50, 150), Sensitivities::kWithout);
  EXPECT_TRUE(got.holds);
  EXPECT_NEAR(got.value(0), -tug::kArm * 4 * 0.25, 1e-10);
}

// d/dEA_0 of EA_0 / (EA_0 + EA_1) is EA_1 / sum^2, by EA_1 it is -EA_0 / sum^2.
TEST(PredictNet, SlopesMatchTheClosedForm) {
  NetForwardModel forward(tug::candidate(2), {tug::test(4)});
  const NetPrediction got = forward.predict(Vector2d(50, 150), Sensitivities::kWith);
  const double scale = -tug::kArm * 4 / (200.0 * 200.0);
  EXPECT_TRUE(matrix_near(got.by_EA, Eigen::RowVector2d(150, -50) * scale, 1e-9));
}

TEST(PredictNet, LeavesOutBandsOfNoStiffness) {
  NetForwardModel forward(tug::candidate(2), {tug::test(4)});
  const NetPrediction got = forward.predict(Vector2d(100, 0), Sensitivities::kWith);
  EXPECT_NEAR(got.value(0), -tug::kArm * 4, 1e-10);
  EXPECT_EQ(got.by_EA(0, 1), 0);
}

TEST(PredictNet, SaysWhenNothingHoldsAMuscle) {
  NetForwardModel forward(tug::candidate(2), {tug::test(4)});
  EXPECT_FALSE(forward.predict(Vector2d(0, 0), Sensitivities::kWithout).holds);
}

TEST(PredictNet, AddsWhatIsNotInTheNetAndMapsTorque) {
  TendonTest test = tug::test(4);
  test.tau_own = Eigen::VectorXd::Constant(1, 0.5);
  test.map = Vector2d(2, -1);
  NetForwardModel forward(tug::candidate(1), {test});
  const double tau = 0.5 - tug::kArm * 4;
  EXPECT_TRUE(
      matrix_near(forward.predict(Eigen::VectorXd::Constant(1, 80), Sensitivities::kWithout).value,
                  Vector2d(2 * tau, -tau), 1e-10));
}

// Under 1 MN rounding alone leaves more than the solver's tolerance: such a net counts as one at
// rest, also for slopes, but not in silence.
TEST(PredictNet, SaysHowFarOutOfBalanceItsNetsAre) {
  CandidateNet candidate = tug::candidate(2);
  for (NetBand& band : candidate.net.bands) band.EA *= 1e6;
  for (CandidateBand& band : candidate.candidates) band.min_EA *= 1e6, band.max_EA *= 1e6;
  NetForwardModel strong(candidate, {tug::test(1e6)}), usual(tug::candidate(2), {tug::test(4)});
  const NetPrediction got = strong.predict(Vector2d(5e7, 1.5e8), Sensitivities::kWith);
  ASSERT_TRUE(got.holds);
  EXPECT_GT(got.residual, NetSolverOptions().tolerance);
  EXPECT_LT(got.residual, kMaxSettledResidual);
  EXPECT_LT(usual.predict(Vector2d(50, 150), Sensitivities::kWith).residual,
            NetSolverOptions().tolerance);
}

TEST(CandidateNet, RefusesAMusclesBand) {
  CandidateNet candidate = tug::candidate(1);
  candidate.candidates[0].band = 1;
  try {
    check_candidates(candidate);
    FAIL() << "expected InputError";
  } catch (const InputError& e) {
    EXPECT_STREQ(e.what(), "candidate pull is the band of a muscle");
  }
}

TEST(CandidateNet, RefusesABandThatMayHaveNoStiffness) {
  CandidateNet candidate = tug::candidate(1);
  candidate.candidates[0].min_EA = 0;
  EXPECT_THROW(check_candidates(candidate), InputError);
}

TEST(CandidateNet, RefusesATestOfTheWrongShape) {
  TendonTest test = tug::test(1);
  test.tension = Vector2d(1, 1);
  EXPECT_THROW(check_test(tug::candidate(1), test), InputError);
}

TEST(CandidateNet, RefusesARecordWithoutNoise) {
  EXPECT_THROW(check_record(tug::candidate(1), tug::record(1, 0, 0)), InputError);
}

}  // namespace
}  // namespace thenar
