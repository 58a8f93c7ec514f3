// Tests for tendons/topology/assess_bands.cpp, fit_bands.cpp and tried_nets.cpp, on a knot whose
// bands share a pull in closed form.

#include "tendons/topology/assess_bands.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/matrix_near.h"
#include "tests/tendons/topology/tug.h"

namespace thenar {
namespace {

using Eigen::VectorXd;

VectorXd one(int bands) { return VectorXd::Ones(bands); }
/// Readings of a knot whose first band carries this share of 4 N, at 1 % noise.
std::vector<TendonRecord> share(double part) {
  const double full = tug::kArm * 4;
  return {tug::record(4, -part * full, 0.01 * full)};
}

InferredNet weigh(const CandidateNet& candidate, const std::vector<TendonRecord>& records) {
  BandFitter fitter(candidate, records, {1e-9, 0, 1, 100});
  FittedNets tried(fitter);
  const auto n = candidate.candidates.size();
  (void)tried.fit(Topology(n, true), one(static_cast<int>(n)));
  return assess_bands(tried);
}

// EA_0 / (EA_0 + EA_1) = 1/3 with EA_1 kept at twice EA_0.
TEST(FitBands, FindsTheRatioOfStiffnesses) {
  BandFitter fitter(tug::candidate(2), share(1.0 / 3), {1e-12, 0, 1, 100});
  const BandFit fit = fitter.fit({Presence::kYes, Presence::kYes}, one(2));
  EXPECT_NEAR(fit.s(1) / fit.s(0), 2, 1e-4);
  EXPECT_NEAR(fit.misfit, 0, 1e-8);
}

// The share nearest to 1 that two existing bands can make: 4 / (4 + 0.25).
TEST(FitBands, KeepsABandAtItsLeastIfItMustExist) {
  BandFitter fitter(tug::candidate(2), share(1), {1e-12, 0, 1, 100});
  const BandFit fit = fitter.fit({Presence::kYes, Presence::kYes}, one(2));
  EXPECT_TRUE(matrix_near(fit.s, Eigen::Vector2d(4, 0.25), 1e-6));
  EXPECT_NEAR(fit.misfit, std::pow((1 - 4 / 4.25) / 0.01, 2), 1e-3);
}

TEST(FitBands, SaysWhenTheNetDoesNotHold) {
  BandFitter fitter(tug::candidate(2), share(1));
  EXPECT_FALSE(fitter.fit({Presence::kNo, Presence::kNo}, one(2)).holds);
}

// All the pull through the first band: the second could take no less than 0.25 / 4.25 of it, which
// is 5.9 sd, so its chi^2 is larger by 34.6.
TEST(WeighBands, DeniesABandThatWouldHaveBeenSeen) {
  const InferredNet net = weigh(tug::candidate(2), share(1));
  EXPECT_EQ(net.verdicts[1].verdict, Verdict::kNo);
  EXPECT_NEAR(net.verdicts[1].evidence, -std::pow((0.25 / 4.25) / 0.01, 2), 0.1);
}

// Half the pull missing is 50 sd.
TEST(WeighBands, FindsABandByWhatItTakesAway) {
  const InferredNet net = weigh(tug::candidate(2), share(0.5));
  EXPECT_EQ(net.verdicts[1].verdict, Verdict::kYes);
  EXPECT_NEAR(net.verdicts[1].evidence, 2500, 1);
}

// Without the first band the hinge feels nothing, and without both nothing holds.
TEST(WeighBands, LeavesABandThatIsNeverFeltUndecided) {
  CandidateNet candidate = tug::candidate(2);
  candidate.net.bands[1].slack = 10 * tug::kLength;  // never taut
  const InferredNet net = weigh(candidate, share(1));
  EXPECT_EQ(net.verdicts[1].verdict, Verdict::kUndecided);
  EXPECT_NEAR(net.verdicts[1].evidence, 0, 1e-6);
}

// Bands 1 and 2 are side by side: one of them must exist, no data of the hinge say which.
TEST(WeighBands, GroupsBandsThatStandForEachOther) {
  const InferredNet net = weigh(tug::candidate(3), share(0.5));
  EXPECT_EQ(net.verdicts[0].verdict, Verdict::kYes);
  EXPECT_EQ(net.verdicts[1].verdict, Verdict::kUndecided);
  EXPECT_EQ(net.verdicts[2].verdict, Verdict::kUndecided);
  ASSERT_EQ(net.groups.size(), 1u);
  EXPECT_EQ(net.groups[0].bands, (std::vector<int>{1, 2}));
  EXPECT_EQ(net.groups[0].ways.size(), 3u);  // {1}, {2}, {1, 2}
  EXPECT_EQ(net.alike.size(), 3u);
}

// The hinge feels only the ratio of two stiffnesses: log EA along (1, 1) / sqrt 2 is blind.
TEST(WeighBands, NamesTheBlindDirection) {
  const InferredNet net = weigh(tug::candidate(2), share(0.5));
  ASSERT_EQ(net.blind.size(), 1u);
  EXPECT_NEAR(std::abs(net.blind[0].sum()), std::sqrt(2.0), 1e-4);
  EXPECT_TRUE(std::isinf(net.verdicts[0].EA_sd));
}

// Of their ratio the data tell 1 %, of EA alone nothing; where one is known, so is the other.
TEST(WeighBands, TellsAStiffnessThatTheDataDecide) {
  for (const BandVerdict& band : weigh(tug::candidate(2), share(0.5)).verdicts)
    EXPECT_FALSE(band.EA_determined);
  CandidateNet known = tug::candidate(2);
  known.candidates.pop_back();  // the second band exists and its EA is known
  const InferredNet net = weigh(known, share(0.5));
  EXPECT_TRUE(net.verdicts[0].EA_determined);
  // d log share / d log EA_0 = 1/2, and the share is known to 2 %.
  EXPECT_NEAR(net.verdicts[0].EA_sd, 0.04, 1e-3);
}

TEST(WeighBands, SaysWhereFitsEndedBeforeTheirTolerance) {
  EXPECT_TRUE(weigh(tug::candidate(2), share(0.3)).converged);
  BandFitter hasty(tug::candidate(2), share(0.3), {1e-12, 0, 1, 1});  // one step
  FittedNets tried(hasty);
  (void)tried.fit({true, true}, Eigen::Vector2d(1, 2));
  const InferredNet net = assess_bands(tried);
  EXPECT_FALSE(net.converged);
  EXPECT_FALSE(net.verdicts[0].converged);
}

// Two readings that contradict each other by 2 * 30 sd: the best lies between, chi^2 = 2 * 900.
TEST(ModelError, IsTheFactorThatMakesTheMisfitCredible) {
  std::vector<TendonRecord> records = share(0.2);
  records.push_back(share(0.8)[0]);
  records.push_back(share(0.8)[0]);
  records.push_back(share(0.2)[0]);
  BandFitter fitter(tug::candidate(2), records, {1e-9, 0, 1, 100});
  FittedNets tried(fitter);
  (void)tried.fit({true, true}, one(2));
  EXPECT_NEAR(model_error(tried), std::sqrt(4 * 900 / 2.0), 0.01);
}

}  // namespace
}  // namespace thenar
