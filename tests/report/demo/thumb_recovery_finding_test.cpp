// Tests for the finding on a thumb that was found again, in report/demo/demo_findings.cpp.

#include "report/demo/demo_findings.h"

#include <algorithm>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "base/units.h"
#include "report/pages/measured_lessons.h"
#include "report/pages/thumb_recovery.h"
#include "tests/data_folder.h"

namespace thenar {
namespace {

// Its numbers are the largest error of an axis by either method, and what either kind of data
// leaves.
TEST(ThumbRecoveryFinding, TellsErrorsAndWhatIsLeft) {
  ThumbRecoveryRequest request;
  request.data = kData;
  request.draws = 300;
  request.weighed = 400;
  const ThumbRecoveryResult result = ask_thumb_recovery(request);
  ASSERT_FALSE(result.stopped);
  const Finding finding = thumb_recovery_finding(result);

  double off = 0;
  for (const RecoveredAxis& axis : result.recovery.axes) off = std::max(off, axis.fit_error);
  EXPECT_NE(finding.opening.learnt.find(fmt::format("by {:.1f} degrees", off / kDegree)),
            std::string::npos);
  const KeptAxes made_up = kept_axes(result.recovery);
  const ReweightedDraws& prior = result.lessons.reweighted.front();
  const KeptShares measured = kept_shares(prior, update_by_both(prior));
  for (const double share : {made_up.most, measured.rms})
    EXPECT_NE(finding.line.find(fmt::format("{:.0f} %", 100 * share)), std::string::npos);
}

}  // namespace
}  // namespace thenar
