// Tests for api/validate.cpp.

#include "api/validate.h"

#include <gtest/gtest.h>

#include "tests/data_folder.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

ValidateRequest things_for(const std::vector<std::string>& things, const std::string& subject) {
  return {things, subject, "", kData};
}

TEST(Validate, JudgesEachThingByItself) {
  const Validation found = validate(things_for({"winslow", "nobody", "barrett"}, ""));
  ASSERT_EQ(found.files.size(), 3U);
  EXPECT_TRUE(found.files[0].valid());
  EXPECT_FALSE(found.files[1].valid());
  EXPECT_NE(found.files[1].error.find("'nobody'"), std::string::npos);
  EXPECT_TRUE(std::holds_alternative<RobotSpec>(*found.files[2].thing));
  EXPECT_FALSE(found.valid());
}

TEST(Validate, HoldsExperimentsToASubject) {
  EXPECT_TRUE(validate(things_for({"synek2019_H01"}, "synek2019_middle")).valid());
  const Validation index = validate(things_for({"synek2019_H01"}, "an_chao_index"));
  EXPECT_TRUE(index.files[0].error.empty());
  EXPECT_EQ(index.files[0].check.misfits.size(), 1U);  // it has no middle finger
  EXPECT_FALSE(index.valid());
  EXPECT_EQ(message_of([] { (void)validate(things_for({"winslow"}, "an_chao_index")); }),
            "--subject is what experiments are held to; none of the files is an experiment");
}

}  // namespace
}  // namespace thenar
