// Tests for studies/questions/study.cpp.

#include "studies/questions/study.h"

#include <gtest/gtest.h>

#include "base/error.h"

namespace thenar {
namespace {

TEST(ThumbStudyQuestion, CountsFitsWithWarningsAndNotThoseWithCautions) {
  ThumbStudy study;
  study.fits.resize(3);
  study.fits[0].run.convergence.warnings = {"R-hat of a is 1.2"};
  study.fits[1].run.convergence.cautions = {"2 of 4000 draws ended a divergent trajectory"};
  EXPECT_EQ(unconverged_fits(study), 1U);
}

TEST(ThumbStudyQuestion, StopsWithWhatIsFinished) {
  ThumbStudyRequest request;
  request.data = THENAR_DATA_DIR;
  request.quick = true;
  Progress progress;
  progress.stop_requested = [] { return true; };
  const ThumbStudyResult result = compute_thumb_study(request, progress);
  EXPECT_TRUE(result.outcome.stopped());
  EXPECT_FALSE(result.study.complete);
  EXPECT_FALSE(result.calibration);
}

TEST(ThumbStudyQuestion, NeedsData) {
  ThumbStudyRequest request;
  request.data = "/nowhere";
  EXPECT_THROW((void)compute_thumb_study(request), InputError);
}

}  // namespace
}  // namespace thenar
