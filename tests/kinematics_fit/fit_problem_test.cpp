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
using sample::kAxesAndPaths;
using sample::middle_finger;

// The published middle finger was calibrated on all specimens of its study, the normative one on
// nobody.
TEST(FitProblem, SaysWhichSpecimensItsSubjectHasSeen) {
  for (const char* specimen : {"H01", "H02", "B01"}) {
    const FitProblem seen = middle_finger(kAxesAndPaths, specimen).problem();
    const std::string name = std::string("synek2019_") + specimen;
    EXPECT_EQ(seen.warnings(),
              std::vector<std::string>{"experiment '" + name + "': the subject has seen specimen " +
                                       specimen +
                                       ": it was calibrated on all specimens of Synek2019. Errors "
                                       "of its forces, even left-out ones, do not show how "
                                       "well unseen specimens are predicted"});
    const Eigen::VectorXd z = Eigen::VectorXd::Zero(seen.size());
    EXPECT_TRUE(predict_fitted(seen, z, 0).calibrated_on_specimen);

    const FitProblem unseen = middle_finger(kAxesAndPaths, specimen, "an_chao_middle").problem();
    EXPECT_TRUE(unseen.warnings().empty());
    EXPECT_FALSE(predict_fitted(unseen, z, 0).calibrated_on_specimen);
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

}  // namespace
}  // namespace thenar
