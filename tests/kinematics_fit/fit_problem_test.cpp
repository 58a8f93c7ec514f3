// Tests for kinematics_fit/fit_problem.cpp: which experiments are refused, and which draw a
// warning.

#include "kinematics_fit/fit_problem.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/units.h"
#include "tests/kinematics_fit/fit_samples.h"

namespace thenar {
namespace {

using sample::FitSetup;
using sample::kAxes;
using sample::middle_finger;

// The published middle finger was calibrated on H01, H02 and B01, the normative one on nobody.
TEST(FitProblem, SaysWhichSpecimensItsSubjectHasSeen) {
  for (const char* specimen : {"H01", "H02", "B01"}) {
    const FitProblem seen = middle_finger(kAxes, specimen).problem();
    const std::string name = std::string("synek2019_") + specimen;
    EXPECT_EQ(seen.warnings(),
              std::vector<std::string>{"experiment '" + name + "': the subject has seen specimen " +
                                       specimen + ": it was calibrated on '" + name +
                                       "'. Errors of its forces, also left out, do not tell how "
                                       "well strangers are predicted"});
    const Eigen::VectorXd z = Eigen::VectorXd::Zero(seen.size());
    EXPECT_TRUE(predict_fitted(seen, z, 0).calibrated_on_specimen);

    const FitProblem unseen = middle_finger(kAxes, specimen, "an_chao_middle").problem();
    EXPECT_TRUE(unseen.warnings().empty());
    EXPECT_FALSE(predict_fitted(unseen, z, 0).calibrated_on_specimen);
  }
}

TEST(FitProblem, SaysThatMomentsAreNotFitted) {
  FitSetup setup = middle_finger(kAxes);
  setup.digit.calibrated_on.clear();
  setup.experiments.front().trials[2].moment = Eigen::Vector3d(0.1, 0, 0);
  EXPECT_EQ(setup.problem().warnings(),
            std::vector<std::string>{"experiment 'synek2019_H01': 1 measured moments are not "
                                     "fitted, only the forces are"});
}

TEST(FitProblem, SaysWhichAnglesAndTensionsNoFingerHas) {
  FitSetup setup = middle_finger(kAxes);
  setup.digit.calibrated_on.clear();
  setup.experiments.front().postures[1].angles["PIP3"] = 300 * kDegree;
  setup.experiments.front().trials[0].tension = {{"FDS", 950.0}};
  EXPECT_EQ(setup.problem().warnings(),
            (std::vector<std::string>{
                "experiment 'synek2019_H01': posture 'MajorFlex': PIP3 = 300.0 deg is beyond -15.6 "
                ".. 96.2 deg",
                "experiment 'synek2019_H01': FDS was pulled with 950.0 N, but can make 189.0 N"}));
}

// A fifth of a degree from straight at both joints: far from singular to rounding, and not to a
// goniometer.
TEST(FitProblem, SaysWhichPosturesAreNearlyStraight) {
  FitSetup setup = middle_finger(kAxes);
  setup.digit.calibrated_on.clear();
  auto& angles = setup.experiments.front().postures[1].angles;
  angles["PIP3"] = angles["DIP3"] = 0.2 * kDegree;
  const std::vector<std::string> warnings = setup.problem().warnings();
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_NE(warnings[0].find("posture 'MajorFlex' is nearly singular (condition "),
            std::string::npos)
      << warnings[0];
}

TEST(FitProblem, RefusesAnExperimentOfAnotherDigit) {
  FitSetup setup = middle_finger(kAxes);
  setup.experiments.front().digit = "index";
  try {
    (void)setup.problem();
    FAIL() << "expected InputError";
  } catch (const InputError& e) {
    EXPECT_STREQ(e.what(),
                 "experiment 'synek2019_H01' is of the index, but the digit built is the middle");
  }
}

TEST(FitProblem, RefusesWhenNothingIsFree) {
  try {
    (void)middle_finger("").problem();
    FAIL() << "expected InputError";
  } catch (const InputError& e) {
    EXPECT_STREQ(e.what(), "nothing to fit: every parameter is fixed");
  }
}

TEST(FitProblem, NamesTheMuscleThatTheDigitHasNot) {
  FitSetup setup = middle_finger(kAxes);
  setup.experiments.front().trials[0].tension = {{"FPL", 1.0}};
  try {
    (void)setup.problem();
    FAIL() << "expected InputError";
  } catch (const InputError& e) {
    EXPECT_STREQ(e.what(),
                 "no muscle 'FPL' pulls on this digit; there are EDC, FDP, FDS, RI, LU, UI");
  }
}

}  // namespace
}  // namespace thenar
