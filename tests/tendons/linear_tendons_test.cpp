// Tests for tendons/linear_tendons.cpp.

#include "tendons/linear_tendons.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "base/error.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

using Eigen::VectorXd;

Subject middle_finger() { return read_subject(THENAR_DATA_DIR "/subjects/synek2019_middle.toml"); }

// The sum of arms times shares worked out by tip_statics is the reference.
TEST(LinearTendons, PullsWithTheArmsOfTheTipStatics) {
  const auto tendons = build_linear_tendons(middle_finger(), "middle");
  const VectorXd q = VectorXd::Constant(tendons->digit().model.coordinates, 0.3);
  const VectorXd t = VectorXd::LinSpaced(tendons->digit().names.muscles.size(), 1, 7);
  const TendonTorque pull = tendons->evaluate(q, t);
  const TipStatics statics = tip_statics(tendons->digit(), q);
  EXPECT_TRUE(matrix_near(pull.R, statics.R, 0));
  EXPECT_TRUE(matrix_near(pull.tau, VectorXd(statics.R.transpose() * t), 1e-15));
  EXPECT_EQ(pull.warning, "");
}

// 10 N of EDC: h c, then half of h (1 - c) in each band and both in the terminal slip, at the
// posture where c is stated.
TEST(LinearTendons, SharesTensionBetweenTheSlips) {
  Subject subject = middle_finger();
  subject.digits[0].hood->branches = {{"EDC", HoodSide::kBoth, 0.8, 0.75}};
  const auto tendons = build_linear_tendons(subject, "middle");
  VectorXd t = VectorXd::Zero(tendons->digit().names.muscles.size());
  for (Eigen::Index m = 0; m < t.size(); ++m)
    if (tendons->digit().names.muscles[m] == "EDC") t[m] = 10;
  const SlipTension slips =
      tendons->evaluate(VectorXd::Zero(tendons->digit().model.coordinates), t).slips;
  EXPECT_NEAR(slips.central, 6, 1e-14);   // [N] 10 x 0.8 x 0.75
  EXPECT_NEAR(slips.radial, 1, 1e-14);    // [N] 10 x 0.8 x 0.25 / 2
  EXPECT_NEAR(slips.ulnar, 1, 1e-14);     // [N]
  EXPECT_NEAR(slips.terminal, 2, 1e-14);  // [N]
}

TEST(LinearTendons, HasNoSlipsWithoutAHood) {
  const auto tendons = build_linear_tendons(
      middle_finger(), "middle", {Path::kViaPoint, Hood::kSeparate, {}, WristMode::kWelded});
  const VectorXd t = VectorXd::Ones(tendons->digit().names.muscles.size());
  EXPECT_EQ(tendons->evaluate(VectorXd::Zero(tendons->digit().model.coordinates), t).slips.terminal,
            0);
}

TEST(LinearTendons, RefusesATendonThatPushes) {
  const auto tendons = build_linear_tendons(middle_finger(), "middle");
  VectorXd t = VectorXd::Ones(tendons->digit().names.muscles.size());
  t[2] = -1;
  EXPECT_THROW((void)tendons->evaluate(VectorXd::Zero(tendons->digit().model.coordinates), t),
               InputError);
}

TEST(LinearTendons, RefusesAFloatingNet) {
  EXPECT_THROW(
      (void)build_linear_tendons(middle_finger(), "middle",
                                 {Path::kViaPoint, Hood::kFloatingNet, {}, WristMode::kWelded}),
      InputError);
}

Subject whole_hand() { return read_subject(THENAR_DATA_DIR "/subjects/mirakhorlo2016.toml"); }

/// Path rung, separate tendons.
TendonOptions rung(Path path) { return {path, Hood::kSeparate, {}, WristMode::kWelded}; }

// Flexors meet no surface and ride on nothing: their arms are those of the straight runs.
TEST(LinearTendons, WrapLikeStraightRunsWhereNothingIsInTheWay) {
  const auto wrapped = build_linear_tendons(whole_hand(), "middle", rung(Path::kWrapped));
  const auto straight = build_linear_tendons(whole_hand(), "middle", rung(Path::kViaPoint));
  const auto& muscles = wrapped->digit().names.muscles;
  const VectorXd q = VectorXd::Constant(wrapped->digit().model.coordinates, 0.3);
  const VectorXd t = VectorXd::Zero(muscles.size());
  const auto row = std::find(muscles.begin(), muscles.end(), "FDP3") - muscles.begin();
  EXPECT_TRUE(matrix_near(VectorXd(wrapped->evaluate(q, t).R.row(row)),
                          VectorXd(straight->evaluate(q, t).R.row(row)), 1e-16));
}

// Bent by 60 deg the straight run of EDC3 would cut through the knuckle's cylinder of 8.27 mm,
// whose axis is that of the joint to within 25 deg and 3 mm: over it, the arm keeps near that
// radius.
TEST(LinearTendons, KeepTheExtensorOnTheKnuckle) {
  const auto wrapped = build_linear_tendons(whole_hand(), "middle", rung(Path::kWrapped));
  const auto straight = build_linear_tendons(whole_hand(), "middle", rung(Path::kViaPoint));
  const TendonDigit& digit = wrapped->digit();
  VectorXd q = VectorXd::Zero(digit.model.coordinates);
  q[0] = 1;  // [rad]
  ASSERT_EQ(digit.names.coordinates[0], "MCP3_FE");
  const auto& muscles = digit.names.muscles;
  const auto row = std::find(muscles.begin(), muscles.end(), "EDC3") - muscles.begin();
  const VectorXd t = VectorXd::Zero(muscles.size());
  EXPECT_EQ(wrapped->evaluate(q, t).warning, "");
  EXPECT_NEAR(wrapped->evaluate(q, t).R(row, 0), -0.00827, 0.003);
  EXPECT_GT(straight->evaluate(q, t).R(row, 0), -0.004);
}

// Cylinders are left and met within the ranges, where a polynomial of order 8 rounds the corner.
TEST(LinearTendons, FitsStayNearTheWrappedPaths) {
  const auto wrapped = build_linear_tendons(whole_hand(), "middle", rung(Path::kWrapped));
  const auto fitted = build_linear_tendons(whole_hand(), "middle", rung(Path::kFitted));
  const VectorXd t = VectorXd::Zero(wrapped->digit().names.muscles.size());
  const VectorXd q = VectorXd::Constant(wrapped->digit().model.coordinates, 0.3);
  EXPECT_EQ(fitted->evaluate(q, t).warning, "");
  EXPECT_TRUE(matrix_near(fitted->evaluate(q, t).R, wrapped->evaluate(q, t).R, 2e-4));
  EXPECT_NE(fitted->evaluate(10 * q, t).warning, "");
}

// A joint that is frozen at an angle is posed there: all other arms are the same, those of the
// lumbrical, too, whose origin rides on a tendon that crosses the frozen joint.
TEST(LinearTendons, HaveTheArmsOfThePosedHandWhereAJointIsFrozen) {
  for (const char* name : {"mirakhorlo2016", "human_hand"}) {
    const Subject hand = read_subject(std::string(THENAR_DATA_DIR "/subjects/") + name + ".toml");
    const auto posed = build_linear_tendons(hand, "index", rung(Path::kWrapped));
    const TendonNames& all = posed->digit().names;
    VectorXd q = VectorXd::Constant(posed->digit().model.coordinates, 0.5);  // [rad]
    for (Eigen::Index j = 0; j < q.size(); ++j)
      if (all.coordinates[j] == "MCP2_AA") q[j] = 0.1;
    const Eigen::MatrixXd R = posed->evaluate(q, VectorXd::Zero(all.muscles.size())).R;
    for (Eigen::Index j = 0; j < q.size(); ++j) {
      TendonOptions options = rung(Path::kWrapped);
      options.frozen[all.coordinates[j]] = q[j];
      const auto frozen = build_linear_tendons(hand, "index", options);
      const TendonNames& some = frozen->digit().names;
      VectorXd left(q.size() - 1);
      left << q.head(j), q.tail(q.size() - 1 - j);
      const Eigen::MatrixXd found = frozen->evaluate(left, VectorXd::Zero(some.muscles.size())).R;
      for (Eigen::Index m = 0; m < found.rows(); ++m) {
        const auto row = std::find(all.muscles.begin(), all.muscles.end(), some.muscles[m]) -
                         all.muscles.begin();
        for (Eigen::Index k = 0; k < found.cols(); ++k)
          EXPECT_NEAR(found(m, k), R(row, k < j ? k : k + 1), 1e-11)
              << name << ": " << some.muscles[m] << ", " << all.coordinates[j] << " frozen";
      }
    }
  }
}

TEST(LinearTendons, SayThatTheyWrap) {
  const auto wrapped = build_linear_tendons(whole_hand(), "index", rung(Path::kWrapped));
  EXPECT_EQ(wrapped->digit().fidelity.path, Path::kWrapped);
}

TEST(DefaultPath, WrapsWhereATendonBendsOverASurface) {
  EXPECT_EQ(default_path(whole_hand()), Path::kWrapped);
  EXPECT_EQ(default_path(middle_finger()), Path::kViaPoint);
}

TEST(DefaultPath, RunsStraightBesideSurfacesThatNoTendonNames) {
  Subject finger = middle_finger();
  finger.surfaces = whole_hand().surfaces;
  EXPECT_EQ(default_path(finger), Path::kViaPoint);
}

TEST(DefaultPath, WrapsWhereATendonRidesOnAnother) {
  Subject hand = whole_hand();
  for (Strand& strand : hand.strands) {
    auto& path = strand.path;
    path.erase(std::remove_if(path.begin(), path.end(),
                              [](const PathPoint& point) { return !point.surface.empty(); }),
               path.end());
  }
  EXPECT_EQ(default_path(hand), Path::kWrapped);
  for (Strand& strand : hand.strands)
    if (!strand.path.empty()) strand.path.back().rides_on.clear();
  EXPECT_EQ(default_path(hand), Path::kViaPoint);
}

// Virtual work, of every digit of the subjects that state surfaces: R = -dL/dq. Central differences
// of 1e-5 rad leave some 1e-12 m/rad of the lengths' rounding and 1e-10 of their third derivatives;
// where a path jumps or has a step nearby, two differences disagree and the posture is left out.
TEST(LinearTendons, ArmsAreMinusSlopesOfLengths) {
  constexpr double kStep = 1e-5;   // [rad]
  constexpr double kAlike = 1e-8;  // of two differences [m/rad]
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(0.02, 0.98);
  int compared = 0, left_out = 0;
  for (const char* name : {"mirakhorlo2016", "human_hand", "myohand_thumb"}) {
    const Subject subject =
        read_subject(std::string(THENAR_DATA_DIR "/subjects/") + name + ".toml");
    for (const Digit& digit : subject.digits) {
      const auto tendons = build_linear_tendons(subject, digit.name, rung(default_path(subject)));
      ASSERT_EQ(tendons->digit().fidelity.path, Path::kWrapped);
      const auto& limits = tendons->digit().skeleton.limits;
      const VectorXd t = VectorXd::Zero(tendons->digit().names.muscles.size());
      for (int trial = 0; trial < 20; ++trial) {
        VectorXd q(tendons->digit().model.coordinates);
        for (Eigen::Index j = 0; j < q.size(); ++j)
          q[j] = limits[j].lower + share(random) * (limits[j].upper - limits[j].lower);
        const TendonTorque pull = tendons->evaluate(q, t);
        if (pull.status != TendonStatus::kValid) continue;
        for (Eigen::Index j = 0; j < q.size(); ++j) {
          const auto slope = [&](double h) -> VectorXd {
            const VectorXd step = h * VectorXd::Unit(q.size(), j);
            return (tendons->lengths(q - step, t, pull) - tendons->lengths(q + step, t, pull)) /
                   (2 * h);
          };
          const VectorXd once = slope(kStep), twice = slope(2 * kStep);
          for (Eigen::Index m = 0; m < t.size(); ++m) {
            if (std::abs(once[m] - twice[m]) > kAlike) {
              ++left_out;
              continue;
            }
            ++compared;
            EXPECT_NEAR(pull.R(m, j), once[m], kAlike)
                << name << " " << tendons->digit().names.muscles[m] << " about "
                << tendons->digit().names.coordinates[j];
          }
        }
      }
    }
  }
  EXPECT_GT(compared, 5000);
  EXPECT_LT(left_out, compared / 100);
}

}  // namespace
}  // namespace thenar
