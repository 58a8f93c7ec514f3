// Tests for the finding on a thumb that was found again, in studies/demo/demo_findings.cpp.

#include "studies/demo/demo_findings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/units.h"
#include "tests/data_folder.h"

namespace thenar {
namespace {

using testing::HasSubstr;

/// A result whose numbers are set by hand: axes that are off by up to 3 and 4 degrees and keep 0.2
/// to 0.6; ten tilts, of which nine keep half of their sd and one 0.95; all converged.
ThumbRecoveryResult with_known_numbers() {
  static const ThumbRecoveryResult short_one = [] {
    ThumbRecoveryRequest request;
    request.data = kData;
    request.draws = 300;
    request.weighed = 400;
    return compute_thumb_recovery(request);
  }();
  ThumbRecoveryResult result = short_one;
  for (RecoveredAxis& axis : result.recovery.axes) {
    axis.fit_error = kDegree;
    axis.drawn_error = 2 * kDegree;
    axis.drawn_left = 0.4;
  }
  result.recovery.axes[1].fit_error = 3 * kDegree;
  result.recovery.axes[2].drawn_error = 4 * kDegree;
  result.recovery.axes[3].drawn_left = 0.2;
  result.recovery.axes[4].drawn_left = 0.6;
  result.recovery.agreement.rms = 0.25;
  result.recovery.run.convergence.warnings.clear();
  result.recovery.fit->solution.status = Status::kSolved;
  DataUpdate& both = result.lessons.reweighted.front().updates[2];
  both.tilts.sd_ratio.setConstant(0.5);
  both.tilts.sd_ratio[3] = 0.95;
  both.weights.k = 0;
  return result;
}

// By hand: sqrt((9 0.25 + 0.9025) / 10) = 0.56.
TEST(ThumbRecoveryFinding, TellsErrorsAndWhatIsLeft) {
  const Finding finding = thumb_recovery_finding(with_known_numbers());
  const std::string left =
      "made-up forces and muscle activity leave 20 to 60 % of the prior's sd of an axis, what was "
      "measured in people 56 % (rms over 10 tilts, of which 1 keep more than 90 %)";
  EXPECT_EQ(finding.opening.learnt,
            "Least squares is off the true axes by 3.0 degrees at most, the mean of the chains by "
            "4.0; they differ by 0.25 posterior sds (rms). In sds, " +
                left + ".");
  EXPECT_EQ(finding.line, "Thumb, fitted as in [Miller2005]: " + left + ".");
}

// Each doubt that the page tells stands on the front page, too.
TEST(ThumbRecoveryFinding, TellsEveryDoubt) {
  const auto both_say = [](const ThumbRecoveryResult& result, const std::string& doubt) {
    const Finding finding = thumb_recovery_finding(result);
    EXPECT_THAT(finding.line, HasSubstr(doubt));
    EXPECT_THAT(finding.opening.learnt, HasSubstr(doubt));
  };
  ThumbRecoveryResult result = with_known_numbers();
  result.recovery.run.convergence.warnings = {"R-hat is 1.1"};
  both_say(result, "The chains have NOT converged.");
  result = with_known_numbers();
  result.recovery.fit->solution.status = Status::kLimit;
  both_say(result, "Least squares has NOT converged.");
  result = with_known_numbers();
  DataUpdate& both = result.lessons.reweighted.front().updates[2];
  both.weights.k = 2;
  both_say(result, "(NOT reliable: Pareto k is above its limit)");
  both = {both.added, "one draw takes all the weight", {}, {}};
  both_say(result, "is not known (one draw takes all the weight)");
}

TEST(ThumbRecoveryFinding, OfAStoppedStudyTellsThatItStopped) {
  EXPECT_EQ(thumb_recovery_finding({}).line,
            "Thumb, fitted as in [Miller2005]: stopped before it was finished.");
}

}  // namespace
}  // namespace thenar
