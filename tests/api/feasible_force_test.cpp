// Tests for api/feasible_force.cpp.

#include "api/feasible_force.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "base/units.h"
#include "tests/data_folder.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

struct Asked {
  std::string subject, digit;
  std::vector<double> posture_deg;
};

FeasibleForceRequest request_of(const Asked& asked) {
  FeasibleForceRequest request;
  request.digit.subject = asked.subject;
  request.digit.data = kData;
  request.digit.digit = asked.digit;
  request.digit.posture = {{}, asked.posture_deg, PostureUnit::kTyped};
  request.digit.passive = PassiveMoments::kOff;
  request.direction = Eigen::Vector3d(0, -1, 0);
  request.frame = DirectionFrame::kTip;
  return request;
}

class PricesOfF0 : public testing::TestWithParam<Asked> {};

// A price is the one-sided slope of the largest force over a muscle's F0: a concave function, made
// of straight pieces, so that differences over a small step are exact unless the step crosses a
// kink.
TEST_P(PricesOfF0, AreSlopesOfTheForce) {
  for (const double tolerance : {0.0, 0.1}) {
    FeasibleForceRequest request = request_of(GetParam());
    request.tolerance = tolerance;
    const DigitCase digit = build_digit(request.digit, TendonOptions().hood);
    const DigitAtPosture at = digit_at(digit, digit.grid.postures.front());
    const FeasibleForceResult answer = compute_feasible_force(request);
    const FeasibleForcePoint& point = answer.points.front();
    ASSERT_EQ(point.largest->status, Status::kSolved);
    const ForceLimitPrices& prices = point.largest->prices;
    ASSERT_EQ(prices.increase.size(), answer.max_tension.size());
    const Eigen::Vector3d direction = point.axes.to_world * *request.direction;
    const auto force_at = [&](Eigen::Index muscle, double F0) {
      TipStatics statics = at.statics;
      statics.max_tension(muscle) = F0;
      return max_tip_force(statics, direction, {tolerance}).component;
    };
    for (Eigen::Index i = 0; i < prices.increase.size(); ++i) {
      const double F0 = answer.max_tension(i), step = 1e-4 * F0;
      // Within a cone slopes bend: as much as the step, and the cone's own 1e-10 over the step.
      const double close = tolerance > 0 ? 1e-3 : 1e-6;
      EXPECT_NEAR((force_at(i, F0 + step) - force_at(i, F0)) / step, prices.increase(i), close)
          << answer.muscles[static_cast<std::size_t>(i)];
      EXPECT_NEAR((force_at(i, F0) - force_at(i, F0 - step)) / step, prices.decrease(i), close)
          << answer.muscles[static_cast<std::size_t>(i)];
    }
    // Strong duality: there is no passive torque in these subjects' statics.
    if (!prices.degenerate() && at.statics.tau_0.isZero(0)) {
      EXPECT_NEAR(prices.increase.dot(answer.max_tension), point.largest->component,
                  1e-6 * point.largest->component);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Postures, PricesOfF0,
                         testing::Values(Asked{"an_chao_index", "index", {45, 0, 45, 10}},
                                         Asked{"an_chao_index", "index", {20, 5, 60, 30}},
                                         Asked{"synek2019_middle", "middle", {20, 0, 30, 15}},
                                         Asked{"synek2019_middle", "middle", {50, -5, 40, 40}},
                                         Asked{"mirakhorlo2016", "index", {30, 0, 40, 20}},
                                         Asked{"arms_thumb", "thumb", {10, 10, 20, 20}}));

TEST(FeasibleForce, RefusesAWideToleranceInDegrees) {
  FeasibleForceRequest request = request_of({"an_chao_index", "index", {45, 0, 45, 10}});
  request.tolerance = 100 * kDegree;
  EXPECT_EQ(message_of([&] { (void)compute_feasible_force(request); }),
            "wanted a tolerance of 0 deg to below 90 deg, got 100 deg");
}

// Of this finger only FDP flexes the DIP joint, and a palmar force wants a flexor there: without
// FDP nothing is left of it.
TEST(FeasibleForceWithout, TakesThePalmarForceWithTheOnlyFlexorOfDip) {
  FeasibleForceRequest request = request_of({"synek2019_middle", "middle", {20, 0, 30, 15}});
  request.without = {"FDP"};
  const FeasibleForceResult answer = compute_feasible_force(request);
  const FeasibleForcePoint& point = answer.points.front();
  ASSERT_TRUE(point.loss);
  EXPECT_NEAR(point.loss->share, 1, 1e-9);
  EXPECT_GT(point.loss->intact.component, 30);  // 33.76 N, docs/theory/feasible_force.md
}

// A muscle without force of its own is a muscle that is paralysed: its price, one-sided, is what a
// newton of it would give, and the loss is the force that the whole of its F0 gives.
TEST(FeasibleForceWithout, LeavesTheOtherMusclesTheirForce) {
  FeasibleForceRequest request = request_of({"arms_thumb", "thumb", {10, 10, 20, 20}});
  request.tolerance = 20 * kDegree;
  const double intact = compute_feasible_force(request).points.front().largest->component;
  request.without = {"OPP", "APB"};
  const FeasibleForceResult answer = compute_feasible_force(request);
  const FeasibleForcePoint& point = answer.points.front();
  EXPECT_EQ(answer.without, (std::vector<std::string>{"APB", "OPP"}));  // in the digit's order
  for (std::size_t i = 0; i < answer.muscles.size(); ++i) {
    const bool paralysed = answer.muscles[i] == "APB" || answer.muscles[i] == "OPP";
    EXPECT_EQ(answer.max_tension[static_cast<Eigen::Index>(i)] == 0, paralysed);
    if (paralysed) {
      EXPECT_EQ(point.largest->tension[static_cast<Eigen::Index>(i)], 0);
    }
  }
  ASSERT_TRUE(point.loss);
  EXPECT_NEAR(point.loss->intact.component, intact, 1e-9 * intact);
  EXPECT_NEAR(point.loss->share, 1 - point.largest->component / intact, 1e-9);
}

// The largest force is concave in F0, with no force at none: half of FDP leaves at least half of
// it, and as long as the same muscles limit it, its price says how much.
TEST(FeasibleForceWithout, WeakenedMusclesPullWithWhatIsLeft) {
  FeasibleForceRequest request = request_of({"synek2019_middle", "middle", {20, 0, 30, 15}});
  const FeasibleForceResult intact = compute_feasible_force(request);
  const auto& muscles = intact.muscles;
  const auto fdp = std::find(muscles.begin(), muscles.end(), "FDP") - muscles.begin();
  const double most = intact.points.front().largest->component;
  const double lost =
      intact.points.front().largest->prices.decrease[fdp] * intact.max_tension[fdp] / 2;
  request.weakened = {{"FDP", intact.max_tension[fdp] / 2}};
  const FeasibleForceResult weak = compute_feasible_force(request);
  EXPECT_GE(weak.points.front().largest->component, most / 2);
  EXPECT_NEAR(weak.points.front().largest->component, most - lost, 1e-6);
  EXPECT_NEAR(weak.points.front().loss->share, lost / most, 1e-7);
  request.weakened = {{"FDP", 1e3}};  // stronger than it is: F0 stays
  EXPECT_NEAR(compute_feasible_force(request).points.front().loss->share, 0, 1e-12);
  request.weakened = {{"FDP", -1}};
  EXPECT_EQ(message_of([&] { (void)compute_feasible_force(request); }),
            "wanted a tension >= 0 of the weak 'FDP', got -1 N");
}

/// Key pinch of the human thumb, the wrist `wrist_deg` flexed.
FeasibleForceRequest key_pinch(WristLoad wrist, double wrist_deg = 0) {
  FeasibleForceRequest request = request_of({"human_hand", "thumb", {}});
  request.digit.posture.in_order.clear();
  request.digit.posture.named = {{"CMC1_FE", 5}, {"CMC1_AA", 10}, {"MCP1_FE", 26}, {"IP1", -3.8}};
  if (wrist != WristLoad::kHeld) request.digit.posture.named["WRIST_FE"] = wrist_deg;
  request.tolerance = 20 * kDegree;
  request.wrist = wrist;
  return request;
}

// The wrist's own extensors, 337 and 252 N at 15 and 17 mm, hold what the thumb's flexor pulls
// across it, 201 N at 4 mm: an intact wrist takes nothing of a pinch.
TEST(FeasibleForceWrist, IntactWristTakesNothingOfAPinch) {
  const double held =
      compute_feasible_force(key_pinch(WristLoad::kHeld)).points[0].largest->component;
  const FeasibleForceResult pinch = compute_feasible_force(key_pinch(WristLoad::kPinch));
  EXPECT_NEAR(pinch.points[0].largest->component, held, 1e-7 * held);
  // Muscles of the fingers would have fingers to balance.
  ASSERT_EQ(pinch.outcome.warnings.size(), 1u);
  EXPECT_EQ(pinch.outcome.warnings[0].rfind("left out, as they would have to balance joints", 0),
            0u);
  for (const std::string& muscle : pinch.muscles)
    EXPECT_FALSE(muscle.rfind("FD", 0) == 0 || muscle.rfind("ED", 0) == 0 || muscle == "EI")
        << muscle;
  EXPECT_EQ(pinch.muscles.size(), 17u);  // 11 of the thumb and 6 of the wrist
  EXPECT_EQ(pinch.max_tension.size(), 17);
}

// A wrist that bears the load of a thumb against the world has more to balance than one that is
// held; without muscles of its own there is nothing left to do it with.
TEST(FeasibleForceWrist, FreeWristBearsTheLoad) {
  const double held =
      compute_feasible_force(key_pinch(WristLoad::kHeld)).points[0].largest->component;
  FeasibleForceRequest request = key_pinch(WristLoad::kFree);
  EXPECT_LE(compute_feasible_force(request).points[0].largest->component, held * (1 + 1e-9));
  request.without = {"ECRL", "ECRB", "ECU", "FCR", "FCU", "PL"};
  const FeasibleForcePoint weak = compute_feasible_force(request).points[0];
  ASSERT_TRUE(weak.loss);
  EXPECT_GT(weak.loss->share, 0.2);
}

// Without extensors the wrist is held by 0.5 N m of its ligaments: the price is the slope over
// them, and the change by every joint, the wrist's too, is that of differences over 0.01 deg.
TEST(FeasibleForceWrist, LigamentsLimitThePinchOfADroppedWrist) {
  const auto ask = [](const std::string& joint, double more_deg, double most) {
    FeasibleForceRequest request = key_pinch(WristLoad::kPinch, 60);
    request.without = {"EPL", "EPB", "APL", "ECRL", "ECRB", "ECU", "FCR", "FCU", "PL"};
    request.stops = {{"WRIST_FE", most}};
    request.digit.frozen.named = {{"WRIST_AA", 0}};
    request.digit.frozen.unit = PostureUnit::kTyped;
    if (!joint.empty()) request.digit.posture.named[joint] += more_deg;
    return compute_feasible_force(request).points.at(0);
  };
  const FeasibleForcePoint point = ask("", 0, -0.5);
  ASSERT_EQ(point.stops.size(), 1u);
  EXPECT_EQ(point.stops[0].joint, "WRIST_FE");
  EXPECT_NEAR(point.stops[0].torque, -0.5, 1e-9);
  EXPECT_GT(point.loss->share, 0.2);
  const double more = ask("", 0, -0.501).largest->component;
  EXPECT_NEAR((more - point.largest->component) / 0.001, point.stops[0].price,
              1e-3 * point.stops[0].price);
  const std::vector<std::string> joints{"WRIST_FE", "CMC1_FE", "CMC1_AA", "MCP1_FE", "IP1"};
  ASSERT_EQ(point.change.size(), 5);
  for (std::size_t k = 0; k < joints.size(); ++k) {
    const double slope = (ask(joints[k], 0.01, -0.5).largest->component -
                          ask(joints[k], -0.01, -0.5).largest->component) /
                         (0.02 * kDegree);
    EXPECT_NEAR(point.change[static_cast<Eigen::Index>(k)], slope,
                1e-3 * std::max(1.0, std::abs(slope)))
        << joints[k];
  }
}

TEST(FeasibleForceWrist, NamesWhatItCannotDo) {
  FeasibleForceRequest request = key_pinch(WristLoad::kHeld);
  request.stops = {{"WRIST_FE", -0.5}};
  EXPECT_EQ(
      message_of([&] { (void)compute_feasible_force(request); }).rfind("no free joint 'WRIST_FE'"),
      0u);
  request.stops = {{"IP1", 0}};
  EXPECT_EQ(message_of([&] { (void)compute_feasible_force(request); }),
            "wanted a torque of the stop of 'IP1', got 0 N m");
  // Elsewhere than at the end of its range, -38.8 deg, a stop is a warning.
  request.stops = {{"IP1", 1}};
  const FeasibleForceResult answer = compute_feasible_force(request);
  ASSERT_EQ(answer.outcome.warnings.size(), 1u);
  EXPECT_EQ(answer.outcome.warnings[0],
            "the stop of IP1 is asked for at -3.8 deg, its range ends at -38.8 deg");
  FeasibleForceRequest finger = request_of({"an_chao_index", "index", {45, 0, 45, 10}});
  finger.wrist = WristLoad::kPinch;
  EXPECT_EQ(message_of([&] { (void)compute_feasible_force(finger); }),
            "subject 'an_chao_index' has no wrist joint: no free joint is shared by its digits");
}

TEST(FeasibleForceWithout, NamesWhatItDoesNotKnowOrNeed) {
  FeasibleForceRequest request = request_of({"mirakhorlo2016", "thumb", {0, 0, 0, 0}});
  request.without = {"ADPx"};
  EXPECT_EQ(message_of([&] { (void)compute_feasible_force(request); }).rfind("no muscle 'ADPx'", 0),
            0u);
  request.without = {"LU1", "ADPt"};
  const FeasibleForceResult answer = compute_feasible_force(request);
  EXPECT_EQ(answer.without, std::vector<std::string>{"ADPt"});
  EXPECT_EQ(answer.outcome.warnings.front(),
            "their paralysis changes nothing, as they cross no free joint of the digit: LU1");
}

// A posture of the grid is answered as if it had been asked alone.
TEST(FeasibleForce, AnswersAGridPostureByPosture) {
  FeasibleForceRequest request = request_of({"synek2019_middle", "middle", {20, 0, 30, 15}});
  const double alone = compute_feasible_force(request).points.front().largest->component;
  request.digit.vary = {{"PIP3", 20, 40, 10}};
  const FeasibleForceResult answer = compute_feasible_force(request);
  ASSERT_EQ(answer.points.size(), 3u);
  EXPECT_NEAR(answer.points[1].largest->component, alone, 1e-12 * alone);
}

}  // namespace
}  // namespace thenar
