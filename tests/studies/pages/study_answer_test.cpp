// Tests for studies/pages/study_answer.cpp.

#include "studies/pages/study_answer.h"

#include <gtest/gtest.h>

namespace thenar {
namespace {

/// Two fits without draws, one of them with a warning.
ThumbStudyResult two_fits() {
  ThumbStudyResult result;
  result.study.fits.resize(2);
  result.study.fits[1].settings.skewed = false;
  result.study.fits[1].run.convergence.warnings = {"R-hat of a is 1.2"};
  return result;
}

TEST(StudyAnswer, MarksFitsThatHaveNotConverged) {
  const Table table = table_of(two_fits());
  ASSERT_EQ(table.rows.size(), 2U);
  EXPECT_EQ(table.rows[0].back(), "yes");
  EXPECT_EQ(table.rows[1].back(), "NO");
  EXPECT_EQ(table.rows[1].front(), describe_fit(two_fits().study.fits[1].settings));
  EXPECT_EQ(study_complaint(two_fits()).substr(0, 31), "1 of 2 fits have NOT converged;");
}

TEST(StudyAnswer, NamesItsFiles) {
  ThumbStudyResult result = two_fits();
  result.study.inputs.truth = {"truth.toml", "true"};
  result.study.inputs.criteria = {"criteria.toml", ""};
  const FileDigests files = files_of(result);
  EXPECT_EQ(files.at("truth.toml"), sha256("true"));
  EXPECT_EQ(files.count("criteria.toml"), 1U);
}

TEST(StudyAnswer, ComplainsOfNothingWhereAllHave) {
  ThumbStudyResult good = two_fits();
  good.study.fits.pop_back();
  EXPECT_EQ(study_complaint(good), "");
}

TEST(StudyAnswer, TellsTypesBesideThoseBeforeTheForces) {
  ThumbStudyResult result = two_fits();
  EXPECT_EQ(text_of(result).find("Which type"), std::string::npos);
  result.study.fits[0].types = {{{true, false}, 0.25, 0.75, 0.01},
                                {{false, true}, 0.75, 0.25, 0.01}};
  const std::string text = text_of(result);
  EXPECT_NE(text.find("Which type of thumb it may be"), std::string::npos);
  EXPECT_NE(text.find("flexion distal, ulnar"), std::string::npos);
  EXPECT_NE(text.find("75.0 +- 1.0"), std::string::npos);
}

}  // namespace
}  // namespace thenar
