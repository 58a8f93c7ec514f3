// Tests for report/answers/validation.cpp.

#include "report/answers/validation.h"

#include <gtest/gtest.h>

#include "tests/data_folder.h"

namespace thenar {
namespace {

Validation of(const std::vector<std::string>& things, const std::string& subject = "") {
  return validate({things, subject, "", kData});
}

TEST(ValidationText, HasALineAFile) {
  EXPECT_EQ(text_of(of({"sphere_70", "nobody"})),
            kData +
                "/objects/sphere_70.toml: object 'sphere_70': 1 shape (sphere), material "
                "wood\nthere is no file 'nobody', nor a subject, experiment, world, scene, "
                "hand, object, pad or net of that name; `thenar list` shows all names\n");
}

TEST(ValidationText, TellsPadsOfAScene) {
  const std::string text = text_of(of({"pencil_pinch"}));
  EXPECT_NE(text.find("23 drives, 2 pads (soft-finger), 1.5 s\n"), std::string::npos) << text;
  EXPECT_NE(text.find("warning: pad 'index_pad' is assumed, not measured, in 10 numbers: "),
            std::string::npos);
  EXPECT_EQ(text_of(of({"pinch"})).find("pad"), std::string::npos);
}

TEST(ValidationText, SaysWhetherAnExperimentSuits) {
  const std::string path = kData + "/experiments/synek2019_H01.toml";
  EXPECT_NE(text_of(of({path}, "an_chao_index")).find(path + ": does not suit the subject of "),
            std::string::npos);
}

TEST(ValidationJson, TellsErrorsFromContents) {
  const OrderedJson json = json_of(of({"sphere_70", "nobody"}));
  EXPECT_TRUE(json[0]["valid"]);
  EXPECT_TRUE(json[0].contains("holds"));
  EXPECT_FALSE(json[1]["valid"]);
  EXPECT_TRUE(json[1].contains("error"));
  EXPECT_EQ(table_of(of({"sphere_70", "nobody"})).rows[1][1], "0");
}

}  // namespace
}  // namespace thenar
