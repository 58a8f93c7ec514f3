// Tests for tendons/linear_tendons.cpp.

#include "tendons/linear_tendons.h"

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
  const TendonPull pull = tendons->pull(q, t);
  const TipStatics statics = tip_statics(tendons->digit(), q);
  EXPECT_TRUE(matrix_near(pull.R, statics.R, 0));
  EXPECT_TRUE(matrix_near(pull.tau, VectorXd(statics.R.transpose() * t), 1e-15));
  EXPECT_EQ(pull.trouble, "");
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
      tendons->pull(VectorXd::Zero(tendons->digit().model.coordinates), t).slips;
  EXPECT_NEAR(slips.central, 6, 1e-14);   // [N] 10 x 0.8 x 0.75
  EXPECT_NEAR(slips.radial, 1, 1e-14);    // [N] 10 x 0.8 x 0.25 / 2
  EXPECT_NEAR(slips.ulnar, 1, 1e-14);     // [N]
  EXPECT_NEAR(slips.terminal, 2, 1e-14);  // [N]
}

TEST(LinearTendons, HasNoSlipsWithoutAHood) {
  const auto tendons = build_linear_tendons(middle_finger(), "middle",
                                            {Path::kViaPoint, Hood::kSeparate, {}, Trunk::kWelded});
  const VectorXd t = VectorXd::Ones(tendons->digit().names.muscles.size());
  EXPECT_EQ(tendons->pull(VectorXd::Zero(tendons->digit().model.coordinates), t).slips.terminal, 0);
}

TEST(LinearTendons, RefusesATendonThatPushes) {
  const auto tendons = build_linear_tendons(middle_finger(), "middle");
  VectorXd t = VectorXd::Ones(tendons->digit().names.muscles.size());
  t[2] = -1;
  EXPECT_THROW((void)tendons->pull(VectorXd::Zero(tendons->digit().model.coordinates), t),
               InputError);
}

TEST(LinearTendons, RefusesAFloatingNet) {
  EXPECT_THROW(
      (void)build_linear_tendons(middle_finger(), "middle",
                                 {Path::kViaPoint, Hood::kFloatingNet, {}, Trunk::kWelded}),
      InputError);
}

}  // namespace
}  // namespace thenar
